/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cloud_formats.h"

#include "files/sampled_surface.h"
#include "files/tool_error.h"
#include "formats/e57/e57_file.h"
#include "formats/file_beginning.h"
#include "formats/file_ending.h"
#include "formats/file_header.h" // for throwDamaged
#include "formats/foreign_format.h"
#include "formats/las/las_file.h"
#include "formats/mesh_file.h"
#include "formats/pcd/pcd_file.h"
#include "formats/ply/ply_file.h"
#include "formats/ptx_file.h"
#include "formats/silent_pcl.h"
#include "formats/table/table_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <new>

namespace pcl::indoor::tool {
namespace {

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

bool
isMesh(const std::string& path, const std::string& beginning)
{
  return meshFormat(path, beginning).has_value();
}

/** Of two that fit, the earlier one is meant. A format is a line here. */
const std::vector<CloudFormat>&
cloudFormats()
{
  static const std::vector<CloudFormat> formats = {
      {"PCD", {".pcd"}, isPcd, pcdPointCount, openPcd, loadPcd},
      {"PLY", {".ply"}, isPly, plyPointCount, openPly, loadPly},
      {"LAS", {".las", ".laz"}, isLas, lasPointCount, openLasFile, loadLas},
      {"E57", {".e57"}, isE57, e57PointCount, openE57, nullptr},
      {"PTX", {".ptx"}, isPtx, ptxPointCount, openPtx, nullptr},
      {"mesh", {}, isMesh, nullptr, nullptr, loadMesh},
      {"table", tableEndings(), isTable, tablePointCount, nullptr, loadTable},
      {"PCD", {}, isCommentedPcd, pcdPointCount, openPcd, loadPcd}};
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
    throwDamaged(file.path); // the readers' own texts name neither file nor reason
  }
}

std::uint64_t
promisedPoints(const std::string& path)
{
  const auto beginning = beginningOf(path);
  const auto* const format = formatOf(path, beginning);
  try {
    return format != nullptr && format->promisedPoints != nullptr
               ? format->promisedPoints(path, beginning)
               : 0;
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
