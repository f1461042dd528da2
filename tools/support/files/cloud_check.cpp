/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cloud_check.h"

#include "command_line/options.h" // for ToolError
#include "formats/file_header.h"
#include "formats/foreign_format.h"
#include "formats/las_file.h"
#include "formats/mesh_file.h"
#include "formats/pcd_header.h"
#include "formats/table_file.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
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
checkPcd(const std::string& content, const std::string& path, CheckedCloud& checked)
{
  MemoryStream stream(content.data(), content.size());
  stream.exceptions(std::ios::badbit); // memory that lacks is no end of the file
  auto header = readFileHeader(stream, "DATA", path);
  const auto pcd = readPcdHeader(header, path);
  const std::uint64_t body =
      content.size() - std::min<std::uint64_t>(header.body_begin, content.size());
  const std::uint64_t bytes = pcd.points * pcd.bytesPerPoint();
  if (pcd.data == "ascii") {
    checkAsciiBody(stream, pcd.points, pcd.valuesPerPoint(), path);
  }
  else if (pcd.data == "binary") {
    if (body < bytes)
      throwTruncated(path, bytes, body, "bytes of points");
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

/** The first word that is in no comment. */
std::string
firstWord(const std::string& beginning)
{
  std::istringstream stream(beginning);
  for (std::string line; std::getline(stream, line);) {
    const auto words = wordsOf(line.substr(0, 64));
    if (!words.empty() && words[0][0] != '#')
      return words[0];
  }
  return "";
}

std::optional<CloudFormat>
formatOf(const std::string& path, const std::string& beginning)
{
  const auto words =
      wordsOf(beginning.substr(0, std::min<std::size_t>(64, beginning.find('\n'))));
  if (!words.empty() && words[0] == "ply")
    return CloudFormat::PLY;
  if (isLas(beginning))
    return CloudFormat::LAS;
  const auto first = firstWord(beginning);
  if (first == "VERSION" || first == "FIELDS" || first == "COLUMNS")
    return CloudFormat::PCD;
  if (meshFormat(path, beginning))
    return CloudFormat::Mesh;
  if (isTable(path, beginning))
    return CloudFormat::Table;
  if (first.empty() && beginning[0] == '#') // a long comment
    return CloudFormat::PCD;
  return {};
}

std::string
beginningOf(std::istream& stream)
{
  std::string beginning(512, '\0');
  stream.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(stream.gcount()));
  stream.clear();
  stream.seekg(0);
  return beginning;
}

} // namespace

CheckedCloud
checkCloudFile(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    throw ToolError(path + ": no such file");
  if (!std::filesystem::is_regular_file(path, error))
    throw ToolError(path + ": not a file");
  const auto file_size = std::filesystem::file_size(path, error);
  std::ifstream stream(path, std::ios::binary);
  if (!stream || error)
    throw ToolError(path + ": the file cannot be read");
  const auto beginning = beginningOf(stream);
  const auto format = formatOf(path, beginning);
  if (format && *format != CloudFormat::PCD)
    return {*format, 0, {}, "", {}};
  if (format) {
    CheckedCloud checked{CloudFormat::PCD, 0, {}, std::string(file_size, '\0'), {}};
    stream.read(checked.content.data(), static_cast<std::streamsize>(file_size));
    checked.content.resize(static_cast<std::size_t>(stream.gcount()));
    checkPcd(checked.content, path, checked);
    return checked;
  }
  const auto other = describeForeignFormat(path, beginning);
  throw ToolError(
      path + ": not a PCD, PLY or LAS file" +
      (other.empty() ? ", nor a mesh or table of points" : " but " + other));
}

std::uint64_t
promisedPoints(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  const auto beginning = beginningOf(stream);
  const auto format = formatOf(path, beginning);
  if (format == CloudFormat::LAS)
    return lasPointCount(beginning);
  if (format == CloudFormat::Table)
    return tablePointCount(path, beginning);
  try {
    if (format == CloudFormat::PCD) {
      auto header = readFileHeader(stream, "DATA", path);
      return readPcdHeader(header, path).points;
    }
    if (format == CloudFormat::PLY)
      for (const auto& words : readFileHeader(stream, "end_header", path).lines)
        if (words.size() == 3 && words[0] == "element" && words[1] == "vertex")
          return headerCount(words[2], words[0], path);
  } catch (const ToolError&) { // said better by what reads the points
  }
  return 0;
}

} // namespace pcl::indoor::tool
