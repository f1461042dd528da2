/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "command_line/cloud_options.h"
#include "command_line/memory_limit.h"
#include "command_line/options.h"
#include "command_line/preset.h"
#include "command_line/scene_options.h"
#include "files/cloud_file.h"
#include "files/point_coordinates.h"
#include "files/sampled_surface.h"
#include "scene/point_colors.h"
#include "scene/scan_frame.h"
#include "scene/table_view.h"
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
#include <sstream>

using namespace pcl::indoor::tool;
using pcl::indoor::ObjectSegmentationOptions;
using pcl::indoor::Partition;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr double bytes_per_point = 350; // that are in use at once, measured

/** What the command line sets; 0 in lengths, angles and sizes stands for the preset's
 * value. */
struct Settings {
  std::string input, output;
  std::string preset = "auto", partition = "auto", camera = "auto";
  std::string orientation = "auto";
  double level = -1;
  std::uint32_t min_segment = 0;
  double voxel_resolution = 0, seed_resolution = 0;
  bool ignore_normals = false, remove_outliers = false;
  ObjectSegmentationOptions others;
  pcl::indoor::PointOptions on_points; // for the thesis's presets
  PointColors colors;
  PointCoordinates coordinates;
  TableColumns columns;
  MemoryLimit memory;
  ScanFrame frame; // of which the unit counts
};

/** For example "edge of a voxel; 0 = 0.03 for rooms, 0.005 for a single view". */
std::string
withPresets(const std::string& meaning, double room, double single_view)
{
  std::ostringstream text;
  text << meaning << "; 0 = " << room << " for rooms, " << single_view
       << " for a single view";
  return text.str();
}

void
addLengths(OptionParser& parser, Settings& settings)
{
  const auto room = withSizes(ObjectSegmentationOptions());
  const auto view = withSizes(pcl::indoor::singleViewOptions());
  parser
      .text("-preset",
            settings.preset,
            "what is wanted; objects: whole things in a room; parts: seats, backs and "
            "arms apart; single_view: a table with small things; thesis, "
            "thesis_kinect: the method of the thesis with its parameters for laser "
            "scans or the Kinect, and no more; auto: single_view if one camera saw a "
            "table, at most 1.4 m away, up to 2 m if most of it is small, or if all is "
            "within 0.7 m of height and 1.5 m across; else objects",
            {"auto", "objects", "parts", "single_view", "thesis", "thesis_kinect"})
      .number("-voxel_resolution",
              settings.voxel_resolution,
              withPresets("edge of a voxel", room.voxel_size, view.voxel_size) +
                  ", the former raised for sparse scans",
              "m",
              Range::atLeast(0))
      .number("-seed_resolution",
              settings.seed_resolution,
              withPresets("distance of supervoxels", room.seed_size, view.seed_size) +
                  ", and if only one of the two is given, a seed is four voxels",
              "m",
              Range::atLeast(0));
}

void
addPartition(OptionParser& parser, Settings& settings)
{
  auto& options = settings.others;
  parser
      .text(
          "-partition",
          settings.partition,
          "how supervoxels are joined: by whole borders to pieces, and these by what "
          "was learned, by the thesis's graph segmentation, or over all convex edges; "
          "auto: graph, for the thesis's presets felzenszwalb",
          {"auto", "graph", "felzenszwalb", "lccp"})
      .number("-level",
              settings.level,
              "for -partition graph: probability of being one thing from which pieces "
              "are joined; higher gives smaller segments; -1 = where that gives whole "
              "things, in single views 0.9",
              "",
              Range::between(-1, 1))
      .number("-ransac_share",
              settings.on_points.ransac_share,
              "for the thesis's presets: planes of at least this share of all points "
              "are taken off by RANSAC, as floor, walls and ceiling; 0 = none",
              "",
              Range::between(0, 1))
      .number("-removal_radius",
              settings.on_points.removal_radius,
              "for the thesis's presets: neighbourhood of normals and of the points "
              "that are counted; 0 = 2.5 times the distance of points",
              "m",
              Range::atLeast(0))
      .number("-spatial_weight",
              options.spatial_weight,
              "weight of distance, over the distance of supervoxels",
              "",
              Range::between(0, 1e6))
      .number("-normal_weight",
              options.normal_weight,
              "weight of the difference of normals, 0 to 1",
              "",
              Range::between(0, 1e6))
      .number("-colour_weight",
              settings.on_points.color_weight,
              "for the thesis's presets: weight of the difference of colours (CIELab), "
              "1 for black and white; needs points with colours",
              "",
              Range::between(0, 1e6))
      .number("-fpfh_weight",
              settings.on_points.fpfh_weight,
              "for the thesis's presets: weight of the difference of FPFH, 0 to 1",
              "",
              Range::between(0, 1e6))
      .number("-min_segment",
              settings.min_segment,
              withPresets("smallest segment",
                          ObjectSegmentationOptions().min_segment_size,
                          pcl::indoor::singleViewOptions().min_segment_size),
              "supervoxels",
              Range::atLeast(0))
      .number("-min_points",
              options.fewest_points,
              "for -partition graph: segments of fewer points, or smaller than a "
              "supervoxel, are the remainder",
              "points")
      .number("-graph_scale",
              options.edges.graph_scale,
              "for -partition felzenszwalb; higher gives larger segments",
              "",
              Range::atLeast(0))
      .number("-concavity_tolerance",
              options.edges.concavity_tolerance_degrees,
              "for -partition felzenszwalb and lccp: bend up to which concave edges "
              "count as convex",
              "degrees",
              Range::between(0, 180));
}

void
addOthers(OptionParser& parser, Settings& settings)
{
  auto& options = settings.others;
  parser
      .number("-curvature_threshold",
              options.curvature_threshold,
              "curvature above which points are taken out if not convex",
              "",
              Range::between(0, 1.0 / 3))
      .number("-ratio_threshold",
              options.ratio_threshold,
              "ratio of points in front of and behind the surface that is not convex",
              "",
              Range::between(0, 1))
      .text("-camera",
            settings.camera,
            "voxels grow with the distance from one camera along z or -z; auto: if the "
            "input is the view of a table",
            {"auto", "single", "none"})
      .text("-orientation",
            settings.orientation,
            "which way estimated normals are turned: to the file's sensor origin, as "
            "their neighbours, or to the free space; auto: viewpoint for one camera, "
            "else free_space",
            {"auto", "viewpoint", "graph", "free_space"})
      .flag("-ignore_normals",
            settings.ignore_normals,
            "estimate normals although the input has some")
      .flag("-remove_outliers",
            settings.remove_outliers,
            "leave out points that lie alone (pcl::ScanOutlierRemoval); their object "
            "is 0")
      .number("-threads", options.threads, "threads, 0 = automatic")
      .expert({"-min_segment",
               "-min_points",
               "-ransac_share",
               "-removal_radius",
               "-spatial_weight",
               "-normal_weight",
               "-colour_weight",
               "-fpfh_weight",
               "-graph_scale",
               "-concavity_tolerance",
               "-curvature_threshold",
               "-ratio_threshold",
               "-camera",
               "-orientation"});
  settings.frame.unit = "m";
  parser.text("-unit",
              settings.frame.unit,
              "unit of the coordinates; lengths of options are in metres",
              {"m", "cm", "mm", "ft", "in"});
  addUpOption(parser, settings.frame);
  addOption(parser, settings.colors, {"object"});
  addOption(parser, settings.coordinates);
  addOption(parser, settings.columns);
  settings.memory.addOption(parser);
  parser.expert({"-double", "-memory_limit"});
}

ObjectSegmentationOptions
presetOptions(const std::string& preset, bool is_table)
{
  if (preset == "thesis")
    return pcl::indoor::thesisOptions();
  if (preset == "thesis_kinect")
    return pcl::indoor::thesisKinectOptions();
  if (preset == "parts")
    return pcl::indoor::partsOptions();
  if (preset == "single_view" || (preset == "auto" && is_table))
    return pcl::indoor::singleViewOptions();
  return {};
}

ObjectSegmentationOptions
chosenOptions(const Settings& settings, bool is_table)
{
  const auto preset = presetOptions(settings.preset, is_table);
  auto options = settings.others;
  const bool given = settings.voxel_resolution > 0 || settings.seed_resolution > 0;
  options.voxel_size = given ? settings.voxel_resolution : preset.voxel_size;
  options.seed_size = given ? settings.seed_resolution : preset.seed_size;
  if (preset.on_points)
    options.on_points = settings.on_points;
  options.min_segment_size =
      settings.min_segment > 0 ? settings.min_segment : preset.min_segment_size;
  options.pieces.scale = preset.pieces.scale;
  if (settings.level >= 0)
    options.pieces.joining_level = static_cast<float>(settings.level);
  options.partition = settings.partition == "auto"   ? preset.partition
                      : settings.partition == "lccp" ? Partition::Lccp
                      : settings.partition == "graph"
                          ? Partition::Pieces
                          : Partition::FelzenszwalbHuttenlocher;
  using pcl::indoor::NormalOrientation;
  options.orientation = settings.orientation == "auto"    ? NormalOrientation::Automatic
                        : settings.orientation == "graph" ? NormalOrientation::Graph
                        : settings.orientation == "viewpoint"
                            ? NormalOrientation::Viewpoint
                            : NormalOrientation::FreeSpace;
  return options;
}

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
isTable(const Settings& settings, const Cloud::ConstPtr& cloud)
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
  Settings settings;
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
  addLengths(parser, settings);
  addPartition(parser, settings);
  addOthers(parser, settings);
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
