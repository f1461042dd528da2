/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/file_header.h"

#include "files/tool_error.h"
#include "text/words.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace pcl::indoor::tool {
namespace {

constexpr std::size_t longest_header = 1 << 20; // bytes; a header without end is none

template <typename T>
std::string
textOf(T value)
{
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof(text), value).ptr);
}

/** Takes the offset from a comment's words, "#" or "comment" the first of them, if that
 * is what it says. */
void
readOffset(const std::vector<std::string>& words, Eigen::Vector3d& offset)
{
  if (words.size() != 5 || words[1] != "offset")
    return;
  Eigen::Vector3d value;
  for (int axis = 0; axis < 3; ++axis) {
    if (!readWord(words[axis + 2], value[axis]) || !std::isfinite(value[axis]))
      return;
  }
  offset = value;
}

} // namespace

std::vector<std::string>
wordsOf(const std::string& line)
{
  std::vector<std::string_view> words;
  splitWords(line, words);
  return {words.begin(), words.end()};
}

FileHeader
readFileHeader(std::istream& stream, const std::string& last, const std::string& path)
{
  FileHeader header;
  for (std::string line; std::getline(stream, line);) {
    header.body_begin += line.size() + 1;
    if (header.body_begin > longest_header)
      break;
    auto words = wordsOf(line);
    if (words.empty())
      continue;
    if (words[0][0] == '#' || words[0] == "comment") {
      readOffset(words, header.offset);
      continue;
    }
    header.lines.push_back(std::move(words));
    if (header.lines.back()[0] == last)
      return header;
  }
  throw ToolError(path + ": the file ends within its header (no line " + last + ")");
}

std::string
offsetText(const Eigen::Vector3d& offset)
{
  return "offset " + shortestText(offset.x()) + " " + shortestText(offset.y()) + " " +
         shortestText(offset.z());
}

std::string
shortestText(float value)
{
  return textOf(value);
}

std::string
shortestText(double value)
{
  return textOf(value);
}

std::uint64_t
headerCount(const std::string& word, const std::string& what, const std::string& path)
{
  std::uint64_t value = 0;
  if (!readWord(word, value) || value > 0x7fffffffu)
    throw ToolError(path + ": " + what + " '" + word +
                    "' in the header is not a usable number");
  return value;
}

void
throwDamaged(const std::string& path)
{
  throw ToolError(path + ": the file is damaged, its points cannot be read");
}

void
throwTruncated(const std::string& path,
               std::uint64_t promised,
               std::uint64_t found,
               const std::string& unit)
{
  throw ToolError(path + ": the file is truncated, its header promises " +
                  std::to_string(promised) + " " + unit + ", it has " +
                  std::to_string(found));
}

} // namespace pcl::indoor::tool
