/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/segmented_objects.h"

#include "files/tool_error.h"
#include "scene/single_view.h"
#include "text/pcl_errors.h"

#include <pcl/filters/scan_outlier_removal.h>
#include <pcl/indoor/middle_point.h>
#include <pcl/indoor/usable_point.h>
#include <pcl/segmentation/noise_resilient_lccp.h>
#include <pcl/segmentation/object_segmentation.h>
#include <pcl/segmentation/scan_overview.h>
#include <pcl/segmentation/scan_warnings.h>

#include <algorithm>

namespace pcl::indoor::tool {
namespace {

using Cloud = PointCloud<PointXYZ>;
using Say = std::function<void(const std::string&)>;

/** The points of a file in metres. */
Cloud::ConstPtr
pointsInMetres(const CloudFile& file, double metres_per_unit)
{
  if (metres_per_unit == 1)
    return file.points;
  const auto scale = static_cast<float>(metres_per_unit);
  auto points = pcl::make_shared<Cloud>(*file.points);
  for (auto& point : *points)
    point.getVector3fMap() *= scale;
  points->sensor_origin_.head<3>() *= scale;
  return points;
}

/** One line if rooms cannot be so high in the unit: nothing would be found in its size.
 * \param[in] vertical of the points in metres
 * \param[in] said what was said of the points already; a camera's view tells its unit
 */
std::string
unitLine(const CoordinateOptions& scan,
         Vertical vertical,
         const std::vector<std::string>& said)
{
  constexpr double room = 2.0; // metres; lower is what stands on a table
  const bool is_told = std::any_of(said.begin(), said.end(), [](const auto& line) {
    return line.find("(-unit") != std::string::npos;
  });
  if (is_told || vertical.room_height < room)
    return {};
  const double unit = scan.metresPerUnit();
  vertical.room_height /= unit;
  return unitWarning(vertical, unit);
}

/** Whether a cloud is a table: one camera's view of it, or a scan from any side, which
 * a line says.
 * \param[out] vertical of anything but a view
 */
bool
isTable(const ObjectChoices& choices,
        const std::string& path,
        const Cloud::ConstPtr& cloud,
        Vertical& vertical,
        const Say& warn)
{
  if (choices.asks_for_tables && isSingleView(cloud))
    return true;
  const auto& scan = choices.scan;
  std::vector<Eigen::Vector3f> points;
  for (const auto& point : *cloud)
    if (isUsablePoint(point))
      points.push_back(point.getVector3fMap());
  moveToMiddle(points);
  vertical =
      scan.up == "auto" ? findVertical(points) : verticalAlong(scan.upAxis(), points);
  const auto up = scan.up == "auto" ? vertical.upAxis() : scan.upAxis().normalized();
  if (!choices.asks_for_tables || !isTableTop(points, up))
    return false;
  warn(path + ": The scan is no larger than what stands on a table: small objects are "
              "told apart (-preset single_view); for one object set -preset objects.");
  return true;
}

IndicesPtr
indicesWithoutOutliers(const CloudFile& file,
                       const Cloud::ConstPtr& points,
                       unsigned threads)
{
  ScanOutlierRemoval<PointXYZ> removal;
  removal.setInputCloud(points);
  removal.setNumberOfThreads(threads);
  const auto kept = pcl::make_shared<Indices>();
  removal.filter(*kept);
  if (kept->empty())
    throw ToolError(file.path + ": all points are outliers");
  return kept;
}

/** The class with everything that it is given. */
NoiseResilientLCCP<PointXYZ>
segmentationOf(const ObjectChoices& choices,
               const CloudFile& file,
               const Cloud::ConstPtr& points,
               Vertical& vertical,
               const Say& warn)
{
  NoiseResilientLCCP<PointXYZ> segmentation;
  const bool is_table = isTable(choices, file.path, points, vertical, warn);
  const auto options = choices.options(is_table);
  if (choices.has_pieces)
    segmentation.setOptions(options.shared);
  else
    segmentation.setThesisOptions(options);
  if (choices.scan.up != "auto")
    segmentation.setUpAxis(choices.scan.upAxis());
  if (choices.is_single_view)
    segmentation.setUseSingleCameraTransform(*choices.is_single_view);
  const auto& origin = points->sensor_origin_;
  if (options.shared.orientation == NormalOrientation::Viewpoint)
    segmentation.setViewPoint(origin.x(), origin.y(), origin.z());
  segmentation.setInputCloud(points);
  if (choices.remove_outliers)
    segmentation.setIndices(
        indicesWithoutOutliers(file, points, options.shared.threads));
  if (file.has_normals && !choices.ignore_normals)
    segmentation.setInputNormals(readNormals(file));
  if (options.on_points && options.on_points->color_weight > 0)
    segmentation.setInputColors(readColors(file));
  return segmentation;
}

} // namespace

SegmentedObjects
segmentObjects(const ObjectChoices& choices, const CloudFile& file, const Say& warn)
{
  const double metres = choices.scan.metresPerUnit();
  Vertical vertical;
  auto segmentation =
      segmentationOf(choices, file, pointsInMetres(file, metres), vertical, warn);
  SegmentedObjects found;
  const auto step = stepWarning(file.coordinate_step * metres,
                                withSizes(segmentation.getOptions()).voxel_size);
  if (!step.empty())
    warn(file.path + ": " + step);
  const auto problem = problemOf([&] { segmentation.segment(found.object_of_point); });
  auto lines = segmentation.getReport().warnings;
  if (const auto line = unitLine(choices.scan, vertical, lines); !line.empty())
    lines.push_back(line);
  for (const auto& line : lines)
    warn(file.path + ": " + line);
  if (found.object_of_point.empty())
    throw ToolError(file.path + ": " + problem);
  found.structure_of_point = segmentation.getStructure();
  found.count =
      *std::max_element(found.object_of_point.begin(), found.object_of_point.end());
  return found;
}

} // namespace pcl::indoor::tool
