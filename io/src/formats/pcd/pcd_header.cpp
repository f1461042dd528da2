/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/pcd/pcd_header.h"

#include "files/tool_error.h"

#include <algorithm>

namespace pcl::indoor::tool {
namespace {

PcdHeader
parse(const FileHeader& header, const std::string& path)
{
  PcdHeader pcd;
  const auto numbers = [&path](const std::vector<std::string>& words) {
    std::vector<std::uint64_t> values;
    for (std::size_t i = 1; i < words.size(); ++i)
      values.push_back(headerCount(words[i], words[0], path));
    return values;
  };
  for (const auto& words : header.lines) {
    if (words.size() < 2)
      throw ToolError(path + ": the header's line " + words[0] + " has no value");
    if (words[0] == "FIELDS" || words[0] == "COLUMNS")
      pcd.fields.assign(words.begin() + 1, words.end());
    else if (words[0] == "SIZE")
      pcd.sizes = numbers(words);
    else if (words[0] == "TYPE")
      pcd.types.assign(words.begin() + 1, words.end());
    else if (words[0] == "COUNT")
      pcd.counts = numbers(words);
    else if (words[0] == "WIDTH")
      pcd.width = headerCount(words[1], words[0], path);
    else if (words[0] == "HEIGHT")
      pcd.height = headerCount(words[1], words[0], path);
    else if (words[0] == "POINTS") {
      pcd.points = headerCount(words[1], words[0], path);
      pcd.has_points = true;
    }
    else if (words[0] == "DATA")
      pcd.data = words[1];
    else if (words[0] != "VERSION" && words[0] != "VIEWPOINT")
      throw ToolError(path + ": '" + words[0].substr(0, 20) +
                      "' in the header is no line of a PCD"); // PCL would end it there
  }
  if (pcd.counts.empty())
    pcd.counts.assign(pcd.fields.size(), 1);
  if (!pcd.has_points)
    pcd.points = pcd.width * pcd.height;
  return pcd;
}

/** A field's number of bytes must be one that numbers of its type can have. */
bool
isUsable(const std::string& type, std::uint64_t size, std::uint64_t count)
{
  const bool real = type == "F" && (size == 4 || size == 8);
  const bool whole = (type == "I" || type == "U") &&
                     (size == 1 || size == 2 || size == 4 || size == 8);
  return (real || whole) && count > 0 && count <= 1000000;
}

void
requireUsable(const PcdHeader& pcd, const std::string& path)
{
  const std::size_t count = pcd.fields.size();
  if (count == 0 || pcd.sizes.size() != count || pcd.types.size() != count ||
      pcd.counts.size() != count)
    throw ToolError(path +
                    ": FIELDS, SIZE, TYPE and COUNT of the header differ in number");
  for (std::size_t i = 0; i < count; ++i)
    if (!isUsable(pcd.types[i], pcd.sizes[i], pcd.counts[i]))
      throw ToolError(path + ": SIZE, TYPE or COUNT of the field '" +
                      pcd.fields[i].substr(0, 20) + "' in the header is not usable");
  constexpr std::uint64_t most_bytes = 1 << 24;
  if (pcd.bytesPerPoint() > most_bytes)
    throw ToolError(path + ": a point of the header has " +
                    std::to_string(pcd.bytesPerPoint()) + " bytes, more than " +
                    std::to_string(most_bytes));
  if (pcd.width != 0 && pcd.width * pcd.height != pcd.points)
    throw ToolError(path + ": WIDTH times HEIGHT in the header is not POINTS");
  if (pcd.points == 0)
    throw ToolError(path + ": the cloud is empty (0 points)");
}

void
dropEmptyFields(const std::vector<std::uint64_t>& counts, FileHeader& header)
{
  for (auto& words : header.lines) {
    if (words[0] != "FIELDS" && words[0] != "COLUMNS" && words[0] != "SIZE" &&
        words[0] != "TYPE" && words[0] != "COUNT")
      continue;
    for (std::size_t i = std::min(counts.size(), words.size() - 1); i-- > 0;)
      if (counts[i] == 0)
        words.erase(words.begin() + static_cast<std::ptrdiff_t>(i + 1));
  }
}

} // namespace

std::uint64_t
PcdHeader::bytesPerPoint() const
{
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i)
    sum += sizes[i] * counts[i];
  return sum;
}

void
PcdHeader::noteBytes(std::uint64_t body)
{
  const auto found = body / std::max<std::uint64_t>(bytesPerPoint(), 1);
  if (found > points)
    notes.push_back("the header promises " + std::to_string(points) +
                    " points, the file holds " + std::to_string(found) +
                    ": those behind the promised ones are left out");
}

PcdHeader
readPcdHeader(FileHeader& header, const std::string& path)
{
  auto pcd = parse(header, path);
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < std::min(pcd.counts.size(), pcd.fields.size()); ++i)
    if (pcd.counts[i] == 0)
      notes.push_back("its field '" + pcd.fields[i] + "' has COUNT 0 and is left out");
  if (!notes.empty()) {
    dropEmptyFields(pcd.counts, header);
    pcd = parse(header, path);
    pcd.notes = notes;
  }
  requireUsable(pcd, path);
  return pcd;
}

std::string
pcdHeaderText(const FileHeader& header, bool one_point)
{
  std::string text;
  for (const auto& words : header.lines) {
    const bool is_count =
        words[0] == "WIDTH" || words[0] == "HEIGHT" || words[0] == "POINTS";
    text += words[0];
    for (std::size_t i = 1; i < words.size(); ++i)
      text += " " + (one_point && is_count ? "1" : words[i]);
    text += "\n";
  }
  return text;
}

} // namespace pcl::indoor::tool
