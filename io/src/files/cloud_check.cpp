/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cloud_check.h"

#include "files/tool_error.h"
#include "formats/file_header.h"
#include "formats/pcd_header.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

namespace pcl::indoor::tool {
namespace {

bool
isNumber(std::string_view word)
{
  if (!word.empty() && (word.front() == '+' || word.front() == '-'))
    word.remove_prefix(1);
  double value = 0.0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), value);
  // too small or too large for a double still is a number: the reader rounds it
  return !word.empty() && read.ec != std::errc::invalid_argument &&
         read.ptr == word.data() + word.size();
}

/** Every line of an ASCII body must hold \a columns numbers; at least \a promised
 * lines. */
void
checkAsciiBody(std::istream& stream,
               std::uint64_t promised,
               std::uint64_t columns,
               const std::string& path)
{
  std::uint64_t rows = 0;
  for (std::string line; rows < promised && std::getline(stream, line);) {
    const std::string_view text = line;
    std::uint64_t words = 0;
    for (std::size_t begin = text.find_first_not_of(" \t\r"); begin != text.npos;) {
      const std::size_t end = std::min(text.find_first_of(" \t\r", begin), text.size());
      const auto word = text.substr(begin, end - begin);
      if (!isNumber(word))
        throw ToolError(path + ": '" + std::string(word.substr(0, 20)) + "' in point " +
                        std::to_string(rows) + " is not a number");
      ++words;
      begin = text.find_first_not_of(" \t\r", end);
    }
    if (words == 0)
      continue;
    if (words != columns)
      throw ToolError(path + ": point " + std::to_string(rows) + " has " +
                      std::to_string(words) + " values, the header promises " +
                      std::to_string(columns));
    ++rows;
  }
  if (rows < promised)
    throwTruncated(path, promised, rows, "points");
}

void
checkPcd(const std::string& content, const std::string& path, CheckedPcd& checked)
{
  MemoryStream stream(content.data(), content.size());
  stream.exceptions(std::ios::badbit); // memory that lacks is no end of the file
  auto header = readFileHeader(stream, "DATA", path);
  auto pcd = readPcdHeader(header, path);
  const std::uint64_t body =
      content.size() - std::min<std::uint64_t>(header.body_begin, content.size());
  const std::uint64_t bytes = pcd.points * pcd.bytesPerPoint();
  if (pcd.data == "ascii") {
    checkAsciiBody(stream, pcd.points, pcd.valuesPerPoint(), path);
  }
  else if (pcd.data == "binary") {
    if (body < bytes)
      throwTruncated(path, bytes, body, "bytes of points");
    pcd.noteBytes(body);
  }
  else if (pcd.data == "binary_compressed") {
    std::uint32_t sizes[2] = {0, 0}; // compressed, uncompressed
    if (!stream.read(reinterpret_cast<char*>(sizes), sizeof(sizes)))
      throwTruncated(path, sizeof(sizes), body, "bytes of points");
    if (body < sizeof(sizes) + sizes[0])
      throwTruncated(path, sizeof(sizes) + sizes[0], body, "bytes of points");
    if (sizes[1] != bytes)
      throw ToolError(path + ": the compressed points are " + std::to_string(sizes[1]) +
                      " bytes, the header promises " + std::to_string(bytes));
  }
  else {
    throw ToolError(path + ": unknown kind of DATA '" + pcd.data + "' in the header");
  }
  checked.bytes = bytes;
  checked.header = header;
  checked.notes = pcd.notes;
}

} // namespace

CheckedPcd
checkPcdFile(const std::string& path)
{
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  std::ifstream stream(path, std::ios::binary);
  if (!stream || error)
    throw ToolError(path + ": the file cannot be read");
  CheckedPcd checked;
  checked.content.resize(size);
  stream.read(checked.content.data(), static_cast<std::streamsize>(size));
  checked.content.resize(static_cast<std::size_t>(stream.gcount()));
  checkPcd(checked.content, path, checked);
  return checked;
}

} // namespace pcl::indoor::tool
