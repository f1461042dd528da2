/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/pcd_header.h"

#include "command_line/options.h" // for ToolError

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
      pcd.fields = words.size() - 1;
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
    pcd.counts.assign(pcd.fields, 1);
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
  if (pcd.fields == 0 || pcd.sizes.size() != pcd.fields ||
      pcd.types.size() != pcd.fields || pcd.counts.size() != pcd.fields)
    throw ToolError(path +
                    ": FIELDS, SIZE, TYPE and COUNT of the header differ in number");
  for (std::size_t i = 0; i < pcd.fields; ++i)
    if (!isUsable(pcd.types[i], pcd.sizes[i], pcd.counts[i]))
      throw ToolError(path + ": SIZE, TYPE or COUNT of field " + std::to_string(i + 1) +
                      " in the header is not usable");
  if (pcd.width != 0 && pcd.width * pcd.height != pcd.points)
    throw ToolError(path + ": WIDTH times HEIGHT in the header is not POINTS");
  if (pcd.points == 0)
    throw ToolError(path + ": the cloud is empty (0 points)");
}

} // namespace

std::uint64_t
PcdHeader::valuesPerPoint() const
{
  std::uint64_t sum = 0;
  for (const auto count : counts)
    sum += count;
  return sum;
}

std::uint64_t
PcdHeader::bytesPerPoint() const
{
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i)
    sum += sizes[i] * counts[i];
  return sum;
}

PcdHeader
readPcdHeader(const FileHeader& header, const std::string& path)
{
  const auto pcd = parse(header, path);
  requireUsable(pcd, path);
  return pcd;
}

} // namespace pcl::indoor::tool
