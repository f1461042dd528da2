/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "cloud_file.h"
#include "options.h"

#include <pcl/filters/scan_outlier_removal.h>
#include <pcl/segmentation/noise_resilient_lccp.h>

#include <algorithm>
#include <sstream>

using namespace pcl::indoor::tool;
using pcl::indoor::ObjectSegmentationOptions;
using pcl::indoor::Partition;

namespace {

/** What the command line sets; 0 in lengths and angles stands for the preset's value.
 */
struct Settings {
  std::string input, output;
  std::string preset = "auto", partition = "graph", camera = "auto";
  std::string orientation = "auto";
  double voxel_resolution = 0, seed_resolution = 0, bend_threshold = 0;
  bool ignore_normals = false, remove_outliers = false;
  ObjectSegmentationOptions others;
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
  const ObjectSegmentationOptions room, view = pcl::indoor::singleViewOptions();
  parser
      .text(
          "-preset",
          settings.preset,
          "defaults for what was scanned; auto: single_view if the input is organised",
          {"auto", "room", "single_view"})
      .number("-voxel_resolution",
              settings.voxel_resolution,
              withPresets("edge of a voxel", room.voxel_size, view.voxel_size) +
                  ", the former raised for sparse scans",
              "m",
              Range::atLeast(0))
      .number("-seed_resolution",
              settings.seed_resolution,
              withPresets("distance of supervoxels", room.seed_size, view.seed_size),
              "m",
              Range::atLeast(0))
      .number("-bend_threshold",
              settings.bend_threshold,
              withPresets("mean concave bend that parts objects",
                          room.bend_threshold_degrees,
                          view.bend_threshold_degrees),
              "degrees",
              Range::between(0, 180));
}

void
addOthers(OptionParser& parser, Settings& settings)
{
  auto& options = settings.others;
  parser
      .text("-partition",
            settings.partition,
            "how supervoxels are joined: by whole borders, by the thesis's graph "
            "segmentation, or over all convex edges",
            {"graph", "felzenszwalb", "lccp"})
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
      .number("-min_segment",
              options.min_segment_size,
              "smallest segment",
              "supervoxels",
              Range::atLeast(1))
      .number("-graph_scale",
              options.graph_scale,
              "for -partition felzenszwalb; higher gives larger segments",
              "",
              Range::atLeast(0))
      .number("-concavity_tolerance",
              options.concavity_tolerance_degrees,
              "for -partition felzenszwalb and lccp: bend up to which concave edges "
              "count as convex",
              "degrees",
              Range::between(0, 180))
      .text("-camera",
            settings.camera,
            "voxels grow with the distance from one camera along z; auto: if the input "
            "is organised",
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
      .number("-threads", options.threads, "threads, 0 = automatic");
}

ObjectSegmentationOptions
chosenOptions(const Settings& settings, bool organised)
{
  const bool single_view =
      settings.preset == "single_view" || (settings.preset == "auto" && organised);
  const auto preset =
      single_view ? pcl::indoor::singleViewOptions() : ObjectSegmentationOptions();
  auto options = settings.others;
  const auto either = [](double given, double other) {
    return given > 0 ? given : other;
  };
  options.voxel_size = either(settings.voxel_resolution, preset.voxel_size);
  options.seed_size =
      either(settings.seed_resolution,
             settings.voxel_resolution > 0 ? 4 * options.voxel_size : preset.seed_size);
  options.bend_threshold_degrees = static_cast<float>(
      either(settings.bend_threshold, preset.bend_threshold_degrees));
  options.bend = preset.bend;
  options.adapt_to_resolution = !(settings.voxel_resolution > 0);
  options.partition = settings.partition == "lccp" ? Partition::Lccp
                      : settings.partition == "graph"
                          ? Partition::Graph
                          : Partition::FelzenszwalbHuttenlocher;
  using pcl::indoor::NormalOrientation;
  options.orientation = settings.orientation == "auto"    ? NormalOrientation::Automatic
                        : settings.orientation == "graph" ? NormalOrientation::Graph
                        : settings.orientation == "viewpoint"
                            ? NormalOrientation::Viewpoint
                            : NormalOrientation::FreeSpace;
  return options;
}

pcl::IndicesPtr
indicesWithoutOutliers(const CloudFile& file, unsigned threads)
{
  pcl::ScanOutlierRemoval<pcl::PointXYZ> removal;
  removal.setInputCloud(file.points);
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
  OptionParser parser("pcl_noise_resilient_lccp",
                      "Segment the scan of a room into objects with "
                      "pcl::NoiseResilientLCCP; adds the field object.");
  parser.positional("input", settings.input, "PCD or PLY file, metres")
      .positional("output.pcd",
                  settings.output,
                  "the input with the field object, 0 = not finite or an outlier");
  addLengths(parser, settings);
  addOthers(parser, settings);
  return parser.run(argc, argv, [&](Progress& progress) {
    requireWritable(settings.output);
    progress.start("Loading " + settings.input);
    CloudFile file = loadCloud(settings.input);
    progress.done(std::to_string(file.points->size()) + " points");

    progress.start("Segmenting objects");
    pcl::NoiseResilientLCCP<pcl::PointXYZ> segmentation;
    segmentation.setOptions(chosenOptions(settings, file.points->height > 1));
    if (settings.camera != "auto")
      segmentation.setUseSingleCameraTransform(settings.camera == "single");
    file.points->sensor_origin_.head<3>() =
        (file.origin.head<3>().cast<double>() - file.offset).cast<float>();
    const auto& origin = file.points->sensor_origin_;
    if (settings.orientation == "viewpoint")
      segmentation.setViewPoint(origin.x(), origin.y(), origin.z());
    segmentation.setInputCloud(file.points);
    if (settings.remove_outliers)
      segmentation.setIndices(indicesWithoutOutliers(file, settings.others.threads));
    if (file.has_normals && !settings.ignore_normals)
      segmentation.setInputNormals(readNormals(file));
    std::vector<std::uint32_t> objects;
    segmentation.segment(objects);
    if (objects.empty())
      throw AlreadyReported();
    const auto count = *std::max_element(objects.begin(), objects.end());
    progress.done(std::to_string(count) + " objects");

    progress.start("Saving " + settings.output);
    appendField(file.cloud, "object", objects);
    saveCloud(settings.output, file.cloud, file.origin, file.orientation);
    progress.done();
  });
}
