/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/pcd/pcd_file.h"

#include "files/record_stream.h"
#include "files/tool_error.h"
#include "files/usual_fields.h" // for nameFields
#include "formats/file_header.h"
#include "formats/pcd/pcd_body.h"
#include "formats/pcd/pcd_header.h"
#include "formats/silent_pcl.h"
#include "formats/table/table_words.h" // for readNumber
#include "text/words.h"

#include <pcl/io/pcd_io.h>

#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/stream.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

namespace pcl::indoor::tool {
namespace {

/** Reads bytes in memory. */
using MemoryStream = boost::iostreams::stream<boost::iostreams::array_source>;

/** A PCD file whose header fits what follows it. */
struct CheckedPcd {
  std::uint64_t bytes = 0; ///< of all points in memory
  FileHeader header;
  /** All of the file: whatever happens to it afterwards does not matter, as it would to
   * the pages that PCL's reader maps. */
  std::string content;
  std::vector<std::string> notes; ///< see CloudFile::notes
};

/** Is it a number that a field can hold? */
using FitsField = bool (*)(std::string_view word);

bool
fitsReal(std::string_view word)
{
  double value = 0.0; // too small or too large for it still is a number: it is rounded
  return readNumber(word, value);
}

/** PCL's reader takes the digits before a point or an exponent, and wraps. */
template <typename T>
bool
fitsWhole(std::string_view word)
{
  double value = 0.0;
  T digits{};
  if (!word.empty() && word.front() == '+')
    word.remove_prefix(1);
  return readNumber(word, value) &&
         std::from_chars(word.data(), word.data() + word.size(), digits).ec ==
             std::errc() &&
         value == static_cast<double>(digits);
}

FitsField
checkOf(const std::string& type, std::uint64_t size)
{
  if (type == "F")
    return fitsReal;
  if (type == "I")
    return size == 1   ? fitsWhole<std::int8_t>
           : size == 2 ? fitsWhole<std::int16_t>
           : size == 4 ? fitsWhole<std::int32_t>
                       : fitsWhole<std::int64_t>;
  return size == 1   ? fitsWhole<std::uint8_t>
         : size == 2 ? fitsWhole<std::uint16_t>
         : size == 4 ? fitsWhole<std::uint32_t>
                     : fitsWhole<std::uint64_t>;
}

/** The check of each value of a point. */
std::vector<FitsField>
checksOf(const PcdHeader& pcd)
{
  std::vector<FitsField> checks;
  for (std::size_t f = 0; f < pcd.fields.size(); ++f)
    checks.insert(checks.end(), pcd.counts[f], checkOf(pcd.types[f], pcd.sizes[f]));
  return checks;
}

[[noreturn]] void
throwNoValue(std::string_view word, std::uint64_t point, const std::string& path)
{
  throw ToolError(
      path + ": '" + std::string(word.substr(0, 20)) + "' in point " +
      std::to_string(point) +
      (fitsReal(word) ? " does not fit the type of its field" : " is not a number"));
}

/** Every line of an ASCII body must hold a number for each value of a point; there must
 * be a line for each point. */
void
checkAsciiBody(std::istream& stream, const PcdHeader& pcd, const std::string& path)
{
  const auto checks = checksOf(pcd);
  std::uint64_t rows = 0;
  std::vector<std::string_view> words;
  for (std::string line; rows < pcd.points && std::getline(stream, line);) {
    splitWords(line, words);
    if (words.empty())
      continue;
    for (std::size_t k = 0; k < words.size(); ++k)
      if (!(k < checks.size() ? checks[k] : fitsReal)(words[k]))
        throwNoValue(words[k], rows, path);
    if (words.size() != checks.size())
      throw ToolError(path + ": point " + std::to_string(rows) + " has " +
                      std::to_string(words.size()) + " values, the header promises " +
                      std::to_string(checks.size()));
    ++rows;
  }
  if (rows < pcd.points)
    throwTruncated(path, pcd.points, rows, "points");
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
    checkAsciiBody(stream, pcd, path);
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
    constexpr std::uint64_t most_unpacked = 88; // bytes of one: 264 are packed into 3
    if (sizes[1] > most_unpacked * sizes[0])
      throw ToolError(path + ": the compressed points are " + std::to_string(sizes[0]) +
                      " bytes, too few for the " + std::to_string(sizes[1]) +
                      " that are promised");
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

/** Compare the header of a file with what follows it: PCL's reader trusts the header,
 * reads past the end of a short file or allocates what a wrong number asks for.
 * \throws ToolError if its header contradicts itself, or if it has no points, or fewer
 * bytes or lines than its header promises */
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

/** The sensor's pose, and the offset; the unit pose where the header tells none by
 * seven finite numbers. */
CloudPose
poseOf(const FileHeader& header)
{ // not as PCL has read it: by a stream that hides a lack of memory, and that leaves
  // what is no number as memory has it
  CloudPose pose;
  pose.offset = header.offset;
  for (const auto& words : header.lines) {
    if (words[0] != "VIEWPOINT" || words.size() < 8)
      continue;
    float numbers[7];
    for (std::size_t k = 0; k < 7; ++k) {
      if (!readWord(words[k + 1], numbers[k]) || !std::isfinite(numbers[k]))
        return pose;
    }
    pose.origin = Eigen::Vector4f(numbers[0], numbers[1], numbers[2], 0);
    pose.orientation =
        Eigen::Quaternionf(numbers[3], numbers[4], numbers[5], numbers[6]);
  }
  return pose;
}

/** PCL's reader gets the header alone: it would take lines of the body for more of it,
 * and the memory that these ask for. */
bool
readPoints(const CheckedPcd& checked, CloudFile& file)
{
  const auto& content = checked.content;
  const auto body = std::min<std::size_t>(checked.header.body_begin, content.size());
  const auto text = pcdHeaderText(checked.header, false);
  PCDReader reader;
  MemoryStream header(text.data(), text.size());
  header.exceptions(std::ios::badbit); // PCL would wait for the end for ever
  int version = 0, encoding = 0;       // 0: ASCII, 2: compressed
  unsigned int body_begin = 0;
  // with room for the fields that tools add, which costs nothing before it is used
  file.cloud.data.reserve(checked.bytes + checked.bytes / 2);
  if (reader.readHeader(header,
                        file.cloud,
                        file.pose.origin,
                        file.pose.orientation,
                        version,
                        encoding,
                        body_begin) != 0 ||
      file.cloud.data.size() != checked.bytes || body_begin != text.size())
    return false;
  const auto* bytes = reinterpret_cast<const unsigned char*>(content.data());
  if (encoding == 2) {
    // Two counts of bytes, packed and not, which checkPcd() found right.
    std::uint32_t packed = 0;
    std::memcpy(&packed, bytes + body, sizeof(packed));
    return unpackPoints(bytes + body + 2 * sizeof(packed), packed, file.cloud);
  }
  if (encoding != 0)
    return reader.readBodyBinary(
               bytes, file.cloud, version, false, static_cast<unsigned int>(body)) == 0;
  MemoryStream points(content.data() + body, content.size() - body);
  points.exceptions(std::ios::badbit);
  return reader.readBodyASCII(points, file.cloud, version) == 0;
}

/** PCL's reading of a header of one point. */
bool
readLayout(std::istream& header, PCLPointCloud2& layout)
{
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
  int version = 0, encoding = 0;
  unsigned int body_begin = 0;
  const SilentPcl silence;
  return PCDReader().readHeader(
             header, layout, origin, orientation, version, encoding, body_begin) == 0;
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

} // namespace

bool
isPcd(const std::string& /*path*/, const std::string& beginning)
{
  const auto first = firstWord(beginning);
  return first == "VERSION" || first == "FIELDS" || first == "COLUMNS";
}

bool
isCommentedPcd(const std::string& /*path*/, const std::string& beginning)
{
  return firstWord(beginning).empty() && beginning[0] == '#';
}

std::uint64_t
pcdPointCount(const std::string& path, const std::string& /*beginning*/)
{
  std::ifstream stream(path, std::ios::binary);
  auto header = readFileHeader(stream, "DATA", path);
  return readPcdHeader(header, path).points;
}

std::unique_ptr<CloudStream>
openPcd(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  auto header = readFileHeader(file, "DATA", path);
  auto pcd = readPcdHeader(header, path);
  if (pcd.data != "binary")
    return nullptr;
  std::error_code error; // of what is no plain file the size is not known
  if (const auto size = std::filesystem::file_size(path, error);
      !error && size > header.body_begin)
    pcd.noteBytes(size - header.body_begin);
  const auto text = pcdHeaderText(header, true);
  MemoryStream stream(text.data(), text.size());
  CloudRecords records;
  auto& layout = records.layout;
  if (!readLayout(stream, layout) || layout.point_step != pcd.bytesPerPoint())
    return nullptr;
  layout.data.clear();
  layout.width = static_cast<std::uint32_t>(pcd.width);
  layout.height = static_cast<std::uint32_t>(pcd.height);
  layout.row_step = layout.point_step * layout.width;
  records.pose = poseOf(header);
  records.body_begin = header.body_begin;
  records.record_size = layout.point_step;
  records.notes = pcd.notes;
  records.points = [layout](const std::string& bytes, std::size_t count) {
    auto part = emptyPart(layout, count);
    part.data.assign(bytes.begin(), bytes.end());
    return part;
  };
  return recordStream(path, std::move(records));
}

void
loadPcd(CloudFile& file, const TableColumns& /*columns*/)
{
  const auto checked = checkPcdFile(file.path);
  if (!readPoints(checked, file))
    throwDamaged(file.path);
  file.notes = checked.notes;
  nameFields(file);
  file.pose = poseOf(checked.header);
}

} // namespace pcl::indoor::tool
