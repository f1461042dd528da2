/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "command_line/options.h"
#include "command_line/preset.h"
#include "files/cloud_file.h"
#include "files/sampled_surface.h"
#include "scene/scan_frame.h"
#include "scene/table_view.h"
#include "segmentation/object_settings.h"
#include "text/pcl_errors.h"
#include "text/printable.h"

#include <pcl/filters/scan_outlier_removal.h>
#include <pcl/indoor/middle_point.h>
#include <pcl/indoor/usable_point.h>
#include <pcl/segmentation/noise_resilient_lccp.h>
#include <pcl/segmentation/objects/table_top.h>
#include <pcl/segmentation/rooms/vertical.h>
#include <pcl/segmentation/scan_warnings.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

using namespace pcl::indoor::tool;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr double bytes_per_point = 350; // that are in use at once, measured

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
isTable(const ObjectSettings& settings, const Cloud::ConstPtr& cloud)
{
  if (settings.preset != "auto")
    return false;
  if (isTableView(cloud))
    return true;
  std::vector<Eigen::Vector3f> points;
  for (const auto& point : *cloud)
    if (pcl::indoor::isUsablePoint(point))
      points.push_back(point.getVector3fMap());
  pcl::indoor::moveToMiddle(points);
  const auto up = settings.frame.up == "auto"
                      ? pcl::indoor::findVertical(points).upAxis()
                      : settings.frame.upAxis().normalized();
  if (!pcl::indoor::isTableTop(points, up))
    return false;
  printWarning(settings.input +
               ": The scan is no larger than what stands on a table: small things are "
               "told apart (-preset single_view); for one thing set -preset objects.");
  return true;
}

pcl::IndicesPtr
indicesWithoutOutliers(const CloudFile& file,
                       const Cloud::ConstPtr& points,
                       unsigned threads)
{
  pcl::ScanOutlierRemoval<pcl::PointXYZ> removal;
  removal.setInputCloud(points);
  removal.setNumberOfThreads(threads);
  const auto kept = pcl::make_shared<pcl::Indices>();
  removal.filter(*kept);
  if (kept->empty())
    throw ToolError(file.path + ": all points are outliers");
  return kept;
}

} // namespace

int
main(int argc, char** argv)
{
  ObjectSettings settings;
  settings.others = presetOptions(presetOf(argc, argv), false);
  settings.on_points = settings.others.on_points.value_or(settings.on_points);
  OptionParser parser("pcl_noise_resilient_lccp",
                      "Segment the scan of a room into objects with "
                      "pcl::NoiseResilientLCCP; adds the fields object and structure.");
  parser.positional("input", settings.input, "PCD, PLY or LAS file or table")
      .positional("output.pcd|ply",
                  settings.output,
                  "the input with the fields object, 0 = not finite or an outlier, and "
                  "structure: 1 floor, 2 wall, 3 ceiling, 4 remainder (too small to be "
                  "told), 0 anything else");
  addOptions(parser, settings);
  return parser.run(argc, argv, [&](Progress& progress) {
    requireWritableCloud(settings.output);
    if (settings.level < 0 && settings.level != -1)
      throw ToolError("-level: must be -1 or from 0 to 1");
    const bool as_thesis = settings.others.on_points.has_value();
    const auto& on_points = settings.on_points;
    const std::pair<const char*, double> of_thesis[] = {
        {"-ransac_share", on_points.ransac_share},
        {"-colour_weight", on_points.color_weight},
        {"-fpfh_weight", on_points.fpfh_weight}};
    for (const auto& [option, value] : of_thesis)
      if (!as_thesis && value > 0)
        throw ToolError(std::string(option) +
                        ": needs -preset thesis or thesis_kinect");
    if (as_thesis && settings.partition == "graph")
      throw ToolError("-partition graph: the thesis's presets have no pieces");
    settings.memory.require(settings.input, bytes_per_point);
    progress.start("Loading " + settings.input);
    CloudFile file = loadSurface(settings.input, settings.columns);
    printNotes(file);
    progress.done(std::to_string(file.points->size()) + " points");

    progress.start("Segmenting objects");
    const auto points = pointsInMetres(file, settings.frame.metresPerUnit());
    pcl::NoiseResilientLCCP<pcl::PointXYZ> segmentation;
    segmentation.setOptions(chosenOptions(settings, isTable(settings, points)));
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
    if (on_points.color_weight > 0)
      segmentation.setInputColors(readColors(file));
    std::vector<std::uint32_t> objects;
    const auto step =
        pcl::indoor::stepWarning(file.coordinate_step * settings.frame.metresPerUnit(),
                                 withSizes(segmentation.getOptions()).voxel_size);
    if (!step.empty())
      printWarning(file.path + ": " + step);
    const auto problem = problemOf([&] { segmentation.segment(objects); });
    for (const auto& line : segmentation.getReport().warnings)
      printWarning(file.path + ": " + line);
    if (objects.empty())
      throw ToolError(file.path + ": " + problem);
    const auto count = *std::max_element(objects.begin(), objects.end());
    progress.done(std::to_string(count) + " objects");

    appendField(file.cloud, "object", objects);
    appendField(file.cloud, "structure", segmentation.getStructure());
    settings.colors.apply(file, "object");
    settings.coordinates.apply(file, settings.output);
    progress.start("Saving " + settings.output);
    saveCloud(settings.output, file.cloud, file.frame);
    Progress::conclude([&] {
      progress.done();
      progress.summary(settings.output + ": " + std::to_string(count) + " objects");
    });
  });
}
