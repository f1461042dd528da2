/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cloud_check.h"

#include "command_line/options.h" // for ToolError
#include "files/file_header.h"
#include "files/foreign_format.h"
#include "files/las_file.h"
#include "files/table_file.h"

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

struct PcdHeader {
  std::vector<std::uint64_t> sizes, counts;
  std::vector<std::string> types;
  std::size_t fields = 0;
  std::uint64_t width = 0, height = 1, points = 0;
  bool has_points = false;
  std::string data;

  std::uint64_t
  valuesPerPoint() const
  {
    std::uint64_t sum = 0;
    for (const auto count : counts)
      sum += count;
    return sum;
  }

  std::uint64_t
  bytesPerPoint() const
  {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i)
      sum += sizes[i] * counts[i];
    return sum;
  }
};

PcdHeader
parsePcdHeader(const FileHeader& header, const std::string& path)
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

void
checkPcd(const std::string& content, const std::string& path, CheckedCloud& checked)
{
  MemoryStream stream(content.data(), content.size());
  stream.exceptions(std::ios::badbit); // memory that lacks is no end of the file
  const auto header = readFileHeader(stream, "DATA", path);
  const auto pcd = parsePcdHeader(header, path);
  requireUsable(pcd, path);
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
}

/** A PCD file begins with comments or with one of the words of its header. */
bool
isPcd(const std::string& path, const std::string& beginning)
{
  std::istringstream stream(beginning);
  bool is_comment = false;
  for (std::string line; std::getline(stream, line); is_comment = true) {
    const auto words = wordsOf(line.substr(0, 64));
    const std::string first = words.empty() ? "" : words[0];
    if (first == "VERSION" || first == "FIELDS" || first == "COLUMNS")
      return true;
    if (first[0] != '#')
      break;
  }
  return is_comment && !isTable(path, beginning);
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
  if (isPcd(path, beginning))
    return CloudFormat::PCD;
  if (isTable(path, beginning))
    return CloudFormat::Table;
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
    return {*format, 0, {}, ""};
  if (format) {
    CheckedCloud checked{CloudFormat::PCD, 0, {}, std::string(file_size, '\0')};
    stream.read(checked.content.data(), static_cast<std::streamsize>(file_size));
    checked.content.resize(static_cast<std::size_t>(stream.gcount()));
    checkPcd(checked.content, path, checked);
    return checked;
  }
  const auto other = describeForeignFormat(path, beginning);
  throw ToolError(path + ": not a PCD, PLY or LAS file" +
                  (other.empty() ? ", nor a table of points" : " but " + other));
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
    if (format == CloudFormat::PCD)
      return parsePcdHeader(readFileHeader(stream, "DATA", path), path).points;
    if (format == CloudFormat::PLY)
      for (const auto& words : readFileHeader(stream, "end_header", path).lines)
        if (words.size() == 3 && words[0] == "element" && words[1] == "vertex")
          return headerCount(words[2], words[0], path);
  } catch (const ToolError&) { // said better by what reads the points
  }
  return 0;
}

} // namespace pcl::indoor::tool
