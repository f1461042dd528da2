/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "segmentation/segmented_objects.h"

#include "files/tool_error.h"
#include "scene/table_view.h"
#include "text/pcl_errors.h"

#include <pcl/filters/scan_outlier_removal.h>
#include <pcl/indoor/middle_point.h>
#include <pcl/indoor/usable_point.h>
#include <pcl/segmentation/noise_resilient_lccp.h>
#include <pcl/segmentation/objects/table_top.h>
#include <pcl/segmentation/rooms/vertical.h>
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

/** Whether a cloud is a table: one camera's view of it, or a scan from any side, which
 * a line says. */
bool
isTable(const ObjectSettings& settings, const Cloud::ConstPtr& cloud, const Say& warn)
{
  if (settings.preset != "auto")
    return false;
  if (isTableView(cloud))
    return true;
  std::vector<Eigen::Vector3f> points;
  for (const auto& point : *cloud)
    if (isUsablePoint(point))
      points.push_back(point.getVector3fMap());
  moveToMiddle(points);
  const auto up = settings.frame.up == "auto" ? findVertical(points).upAxis()
                                              : settings.frame.upAxis().normalized();
  if (!isTableTop(points, up))
    return false;
  warn(settings.input +
       ": The scan is no larger than what stands on a table: small things are "
       "told apart (-preset single_view); for one thing set -preset objects.");
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
segmentationOf(const ObjectSettings& settings,
               const CloudFile& file,
               const Cloud::ConstPtr& points,
               const Say& warn)
{
  NoiseResilientLCCP<PointXYZ> segmentation;
  segmentation.setOptions(chosenOptions(settings, isTable(settings, points, warn)));
  if (settings.frame.up != "auto")
    segmentation.setUpAxis(settings.frame.upAxis());
  if (settings.camera != "auto")
    segmentation.setUseSingleCameraTransform(settings.camera == "single");
  const auto& origin = points->sensor_origin_;
  if (settings.orientation == "viewpoint")
    segmentation.setViewPoint(origin.x(), origin.y(), origin.z());
  segmentation.setInputCloud(points);
  if (settings.remove_outliers)
    segmentation.setIndices(
        indicesWithoutOutliers(file, points, settings.others.threads));
  if (file.has_normals && !settings.ignore_normals)
    segmentation.setInputNormals(readNormals(file));
  if (settings.on_points.color_weight > 0)
    segmentation.setInputColors(readColors(file));
  return segmentation;
}

} // namespace

SegmentedObjects
segmentObjects(const ObjectSettings& settings, const CloudFile& file, const Say& warn)
{
  const double metres = settings.frame.metresPerUnit();
  auto segmentation =
      segmentationOf(settings, file, pointsInMetres(file, metres), warn);
  SegmentedObjects found;
  const auto step = stepWarning(file.coordinate_step * metres,
                                withSizes(segmentation.getOptions()).voxel_size);
  if (!step.empty())
    warn(file.path + ": " + step);
  const auto problem = problemOf([&] { segmentation.segment(found.object_of_point); });
  for (const auto& line : segmentation.getReport().warnings)
    warn(file.path + ": " + line);
  if (found.object_of_point.empty())
    throw ToolError(file.path + ": " + problem);
  found.structure_of_point = segmentation.getStructure();
  found.count =
      *std::max_element(found.object_of_point.begin(), found.object_of_point.end());
  return found;
}

} // namespace pcl::indoor::tool
