/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cloud_formats.h"

#include "files/cloud_check.h"
#include "files/sampled_surface.h"
#include "files/tool_error.h"
#include "files/usual_fields.h"
#include "formats/e57/e57_file.h"
#include "formats/file_beginning.h"
#include "formats/file_ending.h"
#include "formats/file_header.h"
#include "formats/foreign_format.h"
#include "formats/las_file.h"
#include "formats/mesh_file.h"
#include "formats/pcd_body.h"
#include "formats/pcd_header.h"
#include "formats/ply_file.h"
#include "formats/ptx_file.h"
#include "formats/silent_pcl.h"
#include "formats/table_file.h"

#include <pcl/io/pcd_io.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>
#include <sstream>

namespace pcl::indoor::tool {
namespace {

/** PCL's reader gets the header alone: it would take lines of the body for more of it,
 * and the memory that these ask for. */
bool
readPcd(const CheckedPcd& checked, CloudFile& file)
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
    // Two counts of bytes, packed and not, which checkPcdFile() found right.
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

/** Fields of other programs with PCL's names. */
void
nameFields(CloudFile& file)
{
  auto& cloud = file.cloud;
  if (cloud.data.size() <
      static_cast<std::size_t>(cloud.width) * cloud.height * cloud.point_step)
    throw ToolError(file.path + ": the file is damaged, points are missing");
  const UsualFields fields(
      cloud, [&cloud]() -> const auto& { return cloud; });
  cloud = fields.of(std::move(cloud));
  file.notes.insert(file.notes.end(), fields.notes().begin(), fields.notes().end());
}

[[noreturn]] void
refuseDamaged(const std::string& path)
{
  throw ToolError(path + ": the file is damaged, its points cannot be read");
}

void
loadPcd(CloudFile& file, const TableColumns& /*columns*/)
{
  const auto checked = checkPcdFile(file.path);
  if (!readPcd(checked, file))
    refuseDamaged(file.path);
  file.notes = checked.notes;
  nameFields(file);
  file.pose.offset = checked.header.offset;
  readPose(checked.header, file.pose);
}

void
loadPly(CloudFile& file, const TableColumns& /*columns*/)
{
  file.pose.offset =
      readPly(file.path, file.cloud, file.pose.origin, file.pose.orientation);
  nameFields(file);
}

void
loadLas(CloudFile& file, const TableColumns& /*columns*/)
{
  file.cloud = readLas(file.path, file.notes);
}

void
loadMesh(CloudFile& file, const TableColumns& /*columns*/)
{
  drawPoints(readMesh(file.path), file);
}

void
loadTable(CloudFile& file, const TableColumns& columns)
{
  file.cloud = readTable(file.path, columns, file.notes, file.stations);
}

/** The points of a file that can be read in parts. */
void
loadParts(const CloudFormat& format, CloudFile& file)
{
  const auto stream = format.open(file.path);
  file.cloud = stream->layout();
  file.pose = stream->pose();
  file.stations = stream->stations();
  file.notes = stream->notes();
  file.cloud.data.reserve(stream->pointCount() * file.cloud.point_step);
  stream->forEachPart([&file](std::uint64_t /*first*/, const PCLPointCloud2& part) {
    file.cloud.data.insert(file.cloud.data.end(), part.data.begin(), part.data.end());
  });
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

bool
isPcd(const std::string& /*path*/, const std::string& beginning)
{
  const auto first = firstWord(beginning);
  return first == "VERSION" || first == "FIELDS" || first == "COLUMNS";
}

bool
isPly(const std::string& /*path*/, const std::string& beginning)
{
  const auto words =
      wordsOf(beginning.substr(0, std::min<std::size_t>(64, beginning.find('\n'))));
  return !words.empty() && words[0] == "ply";
}

std::uint64_t
pcdPointCount(const std::string& path, const std::string& /*beginning*/)
{
  std::ifstream stream(path, std::ios::binary);
  auto header = readFileHeader(stream, "DATA", path);
  return readPcdHeader(header, path).points;
}

std::uint64_t
plyPointCount(const std::string& path, const std::string& /*beginning*/)
{
  std::ifstream stream(path, std::ios::binary);
  for (const auto& words : readFileHeader(stream, "end_header", path).lines)
    if (words.size() == 3 && words[0] == "element" && words[1] == "vertex")
      return headerCount(words[2], words[0], path);
  return 0;
}

std::unique_ptr<CloudStream>
noStream(const std::string& /*path*/)
{
  return nullptr;
}

/** Of two that fit, the earlier one is meant. A format is a line here. */
const std::vector<CloudFormat>&
cloudFormats()
{
  static const std::vector<CloudFormat> formats = {
      {"PCD", {".pcd"}, isPcd, pcdPointCount, openRecords, loadPcd},
      {"PLY", {".ply"}, isPly, plyPointCount, openRecords, loadPly},
      {"LAS", {".las", ".laz"}, isLas, lasPointCount, openRecords, loadLas},
      {"E57", {".e57"}, isE57, e57PointCount, openE57, nullptr},
      {"PTX", {".ptx"}, isPtx, ptxPointCount, openPtx, nullptr},
      {"mesh",
       {},
       [](const auto& path, const auto& beginning) {
         return meshFormat(path, beginning).has_value();
       },
       [](const auto& /*path*/, const auto& /*beginning*/) { return std::uint64_t{0}; },
       noStream,
       loadMesh},
      {"table", tableEndings(), isTable, tablePointCount, noStream, loadTable},
      {"PCD", // after a long comment
       {},
       [](const auto& /*path*/, const auto& beginning) {
         return firstWord(beginning).empty() && beginning[0] == '#';
       },
       pcdPointCount,
       openRecords,
       loadPcd}};
  return formats;
}

const CloudFormat*
formatOf(const std::string& path, const std::string& beginning)
{
  const auto& formats = cloudFormats();
  const auto found =
      std::find_if(formats.begin(), formats.end(), [&](const auto& format) {
        return format.is(path, beginning);
      });
  return found == formats.end() ? nullptr : &*found;
}

/** \throws ToolError if the file cannot be read or is of no format that is read */
const CloudFormat&
requireFormat(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    throw ToolError(path + ": no such file");
  if (std::filesystem::is_directory(path, error))
    throw ToolError(path + ": a folder; give one of its files, or the folder to "
                           "pcl_indoor_pipeline, which takes all scans in it");
  if (!std::filesystem::is_regular_file(path, error))
    throw ToolError(path + ": not a file");
  if (!std::ifstream(path, std::ios::binary))
    throw ToolError(path + ": the file cannot be read");
  const auto beginning = beginningOf(path);
  const auto* const format = formatOf(path, beginning);
  if (format != nullptr)
    return *format;
  const auto other = describeForeignFormat(path, beginning);
  throw ToolError(
      path + ": not a " + cloudFormatNames() + " file" +
      (other.empty() ? ", nor a mesh or table of points" : " but " + other));
}

} // namespace

const CloudFormat*
cloudFormatOf(const std::string& path)
{
  return formatOf(path, beginningOf(path));
}

void
readCloud(CloudFile& file, const TableColumns& columns)
{
  const auto& format = requireFormat(file.path);
  if (!columns.names.empty() && format.load != loadTable)
    throw ToolError(file.path + ": names its fields, '" + columns.names +
                    "' is for tables");
  const SilentPcl silence;
  try {
    if (format.load != nullptr)
      format.load(file, columns);
    else
      loadParts(format, file);
  } catch (const ToolError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    refuseDamaged(file.path); // the readers' own texts name neither file nor reason
  }
}

std::uint64_t
promisedPoints(const std::string& path)
{
  const auto beginning = beginningOf(path);
  const auto* const format = formatOf(path, beginning);
  try {
    return format != nullptr ? format->promisedPoints(path, beginning) : 0;
  } catch (const ToolError&) { // said better by what reads the points
    return 0;
  }
}

bool
hasCloudEnding(const std::string& path)
{
  const auto& formats = cloudFormats();
  return std::any_of(
      formats.begin(), formats.end(), [ending = fileEnding(path)](const auto& format) {
        return std::count(format.endings.begin(), format.endings.end(), ending) > 0;
      });
}

std::string
cloudEndings()
{
  std::string endings;
  for (const auto& format : cloudFormats())
    for (const auto& ending : format.endings)
      endings += (endings.empty() ? "" : ", ") + ending;
  return endings;
}

std::string
cloudFormatNames()
{
  std::vector<std::string> names;
  for (const auto& format : cloudFormats())
    if (format.load != loadMesh && format.load != loadTable && !format.endings.empty())
      names.emplace_back(format.name);
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
  return text;
}

} // namespace pcl::indoor::tool
