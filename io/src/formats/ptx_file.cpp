/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Facts of the format: Leica Geosystems, "Cyclone PTX format".
#include "formats/ptx_file.h"

#include "files/field_value.h" // for appendTo
#include "files/joined_clouds.h"
#include "files/tool_error.h"
#include "formats/file_beginning.h"
#include "formats/file_ending.h"
#include "formats/file_header.h" // for throwTruncated
#include "formats/line_reader.h"
#include "formats/table/table_words.h"

#include <pcl/PCLPointField.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <limits>
#include <utility>
#include <vector>

namespace pcl::indoor::tool {
namespace {

constexpr std::size_t points_between_marks = 4096;
constexpr std::size_t header_lines = 10;
constexpr std::array<std::size_t, header_lines> header_words = {
    1, 1, 3, 3, 3, 3, 4, 4, 4, 4};
constexpr std::size_t most_words = 7;

using Words = std::array<double, most_words>;

/** The numbers of a line.
 * \return how many; more than there is room for if one is none, or if there are more */
std::size_t
numbersOf(std::string_view line, Words& numbers)
{
  const auto is_blank = [](char letter) {
    return letter == ' ' || letter == '\t' || letter == '\r';
  };
  std::size_t count = 0;
  const char* at = line.data();
  const char* const end = at + line.size();
  for (at = std::find_if_not(at, end, is_blank); at != end;
       at = std::find_if_not(at, end, is_blank)) {
    const char* const begin = at;
    at = std::find_if(at, end, is_blank);
    const std::string_view word(begin, static_cast<std::size_t>(at - begin));
    if (count == most_words || !readNumber(word, numbers[count]))
      return most_words + 1;
    ++count;
  }
  return count;
}

bool
isZero(const Words& numbers)
{
  return numbers[0] == 0 && numbers[1] == 0 && numbers[2] == 0;
}

/** Is it a line of a point that saw no return? */
bool
sawNothing(std::string_view line)
{
  const auto first = line.find_first_not_of(" \t");
  if (std::string_view("0.+-").find(line[first]) == std::string_view::npos)
    return false; // as nearly all lines tell
  Words numbers{};
  const auto count = numbersOf(line, numbers);
  return count >= 3 && count <= most_words && isZero(numbers);
}

/** One scan of a file. */
struct PtxScan {
  std::uint64_t columns = 0, rows = 0;
  Eigen::Affine3d pose = Eigen::Affine3d::Identity(); ///< of its points
  Eigen::Vector3d station = Eigen::Vector3d::Zero();
  std::size_t words = 0;                ///< of a line of a point
  std::vector<LineReader::Place> marks; ///< of every 4096th point
  std::uint64_t nothing = 0;            ///< points that saw no return

  bool
  hasIntensity() const
  {
    return words == 4 || words == 7;
  }

  bool
  hasColors() const
  {
    return words >= 6;
  }
};

[[noreturn]] void
refuse(const LineReader& lines, const std::string& problem)
{
  throw ToolError(lines.path() + ": line " + std::to_string(lines.place().line) + ": " +
                  problem);
}

/** \param[in] numbers of the lines of a header */
void
takeHeader(const LineReader& lines,
           const std::array<Words, header_lines>& numbers,
           PtxScan& scan)
{
  constexpr double most_points = 0x7fffffff;
  for (std::size_t k = 0; k < 2; ++k)
    if (!(numbers[k][0] >= 0 && numbers[k][0] <= most_points) ||
        numbers[k][0] != static_cast<double>(static_cast<std::uint64_t>(numbers[k][0])))
      refuse(lines, "the header above has no number of columns and rows");
  if (numbers[0][0] * numbers[1][0] > most_points)
    refuse(lines, "the header above promises more than 2^31 - 1 points");
  scan.columns = static_cast<std::uint64_t>(numbers[0][0]);
  scan.rows = static_cast<std::uint64_t>(numbers[1][0]);
  Eigen::Matrix4d matrix;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      matrix(column, row) =
          numbers[6 + static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
  if (!matrix.allFinite() || matrix.row(3) != Eigen::RowVector4d(0, 0, 0, 1))
    refuse(lines, "the matrix above moves no points, its last column is not 0 0 0 1");
  scan.pose.matrix() = matrix;
  const Eigen::Vector3d told(numbers[2][0], numbers[2][1], numbers[2][2]);
  scan.station = matrix.isIdentity() ? told : scan.pose.translation();
}

/** \return false behind the last scan */
bool
readHeader(LineReader& lines, PtxScan& scan)
{
  std::array<Words, header_lines> numbers{};
  std::string_view line;
  for (std::size_t k = 0; k < header_lines; ++k) {
    if (!lines.next(line)) {
      if (k == 0)
        return false;
      throw ToolError(lines.path() + ": the file ends within the header of a scan");
    }
    if (numbersOf(line, numbers[k]) != header_words[k])
      refuse(lines,
             "the header of a scan has " + std::to_string(header_words[k]) +
                 (header_words[k] == 1 ? " number here" : " numbers here"));
  }
  takeHeader(lines, numbers, scan);
  return true;
}

/** Look at the lines of a scan's points. */
void
lookAtPoints(LineReader& lines, PtxScan& scan)
{
  const auto count = scan.columns * scan.rows;
  std::string_view line;
  for (std::uint64_t i = 0; i < count; ++i) {
    if (!lines.next(line))
      throwTruncated(lines.path(), count, i, "points of a scan");
    if (i % points_between_marks == 0)
      scan.marks.push_back(lines.place());
    if (i == 0) {
      Words numbers{};
      scan.words = numbersOf(line, numbers);
      if (scan.words < 3 || scan.words == 5 || scan.words > most_words)
        refuse(lines, "a point has 3, 4, 6 or 7 numbers");
    }
    scan.nothing += sawNothing(line) ? 1 : 0;
  }
}

/** The points of one scan. */
class ScanStream : public CloudStream {
public:
  ScanStream(std::shared_ptr<LineReader> lines, PtxScan scan, const std::string& name)
  : lines_(std::move(lines))
  , scan_(std::move(scan))
  {
    for (const char* axis : {"x", "y", "z"})
      appendTo(layout_, axis, PCLPointField::FLOAT64);
    if (scan_.hasIntensity())
      appendTo(layout_, "intensity", PCLPointField::FLOAT32);
    if (scan_.hasColors())
      appendTo(layout_, "rgb", PCLPointField::FLOAT32);
    appendTo(layout_, "row", PCLPointField::UINT32);
    appendTo(layout_, "column", PCLPointField::UINT32);
    layout_.width = static_cast<std::uint32_t>(scan_.columns * scan_.rows);
    layout_.height = 1;
    layout_.row_step = layout_.point_step * layout_.width;
    setStation(name, scan_.station, scan_.pose.linear());
  }

  PCLPointCloud2
  read(std::uint64_t first, std::size_t count) override
  {
    auto part = emptyPart(layout_, count);
    part.data.resize(count * part.point_step);
    lines_->seek(scan_.marks[first / points_between_marks]);
    std::string_view line;
    for (std::uint64_t skipped = first % points_between_marks; skipped > 0; --skipped)
      lines_->next(line);
    for (std::size_t i = 0; i < count; ++i) {
      if (!lines_->next(line))
        throw ToolError(lines_->path() + ": the file can no longer be read");
      put(line, first + i, &part.data[i * part.point_step]);
    }
    return part;
  }

private:
  std::uint32_t
  colorOf(const Words& numbers) const
  {
    std::uint32_t rgb = 0;
    for (std::size_t k = scan_.words - 3; k < scan_.words; ++k) {
      if (!(numbers[k] >= 0 && numbers[k] <= 255))
        refuse(*lines_, "a colour is not a number of 0 to 255");
      rgb = rgb << 8 | static_cast<std::uint32_t>(numbers[k]);
    }
    return rgb;
  }

  void
  put(std::string_view line, std::uint64_t number, std::uint8_t* to) const
  {
    Words numbers{};
    if (numbersOf(line, numbers) != scan_.words)
      refuse(*lines_,
             "'" + std::string(line.substr(0, 40)) + "' are not " +
                 std::to_string(scan_.words) + " numbers, as the first point has");
    Eigen::Vector3d point(numbers[0], numbers[1], numbers[2]);
    point = isZero(numbers)
                ? Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN())
                : scan_.pose * point;
    const auto write = [&to](const auto& value) {
      std::memcpy(to, &value, sizeof(value));
      to += sizeof(value);
    };
    for (const double coordinate : {point.x(), point.y(), point.z()})
      write(coordinate);
    if (scan_.hasIntensity())
      write(static_cast<float>(numbers[3]));
    if (scan_.hasColors())
      write(colorOf(numbers));
    write(static_cast<std::uint32_t>(number % scan_.rows));
    write(static_cast<std::uint32_t>(number / scan_.rows));
  }

  std::shared_ptr<LineReader> lines_; ///< of the file, for all of its scans
  PtxScan scan_;
};

} // namespace

bool
isPtx(const std::string& path, const std::string& beginning)
{
  if (fileEnding(path) == ".ptx")
    return true;
  constexpr std::size_t enough = 3; // lines: two numbers alone, then three
  std::size_t seen = 0;
  std::string_view text = beginning;
  for (auto end = text.find('\n'); end != text.npos && seen < header_lines;
       end = text.find('\n')) {
    Words numbers{};
    if (numbersOf(text.substr(0, end), numbers) != header_words[seen])
      return false;
    ++seen;
    text.remove_prefix(end + 1);
  }
  return seen >= enough;
}

std::uint64_t
ptxPointCount(const std::string& path, const std::string& /*beginning*/)
{
  const auto text = beginningOf(path, 1 << 16);
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (text.empty() || error)
    return 0;
  const auto lines =
      static_cast<std::uint64_t>(std::count(text.begin(), text.end(), '\n'));
  return size / text.size() * lines + size % text.size() * lines / text.size();
}

std::unique_ptr<CloudStream>
openPtx(const std::string& path)
{
  const auto lines = std::make_shared<LineReader>(path);
  std::vector<std::unique_ptr<CloudStream>> streams;
  std::vector<std::string> names;
  std::uint64_t nothing = 0, number = 0;
  for (PtxScan scan; readHeader(*lines, scan); scan = PtxScan()) {
    lookAtPoints(*lines, scan);
    ++number;
    if (scan.columns * scan.rows == 0)
      continue;
    nothing += scan.nothing;
    names.push_back("scan " + std::to_string(number));
    streams.push_back(
        std::make_unique<ScanStream>(lines, std::move(scan), names.back()));
  }
  if (streams.empty())
    throw ToolError(path + ": the cloud is empty (0 points)");
  auto cloud = streams.size() == 1 ? std::move(streams[0])
                                   : joinedStream(std::move(streams), names);
  if (nothing > 0)
    cloud->addNote("points at 0 0 0 saw no return and are left out: " +
                   std::to_string(nothing));
  return cloud;
}

} // namespace pcl::indoor::tool
