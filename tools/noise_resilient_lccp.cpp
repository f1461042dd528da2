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

/** What the command line sets; 0 in lengths, angles and sizes stands for the preset's
 * value. */
struct Settings {
  std::string input, output;
  std::string preset = "auto", partition = "auto", camera = "auto";
  std::string orientation = "auto", structure = "auto", things = "auto", gaps = "auto",
              seams = "auto", bars = "auto", frames = "auto", racks = "auto",
              uprights = "auto", shadows = "auto", doors = "auto";
  double union_air = -1;
  std::uint32_t min_segment = 0;
  double voxel_resolution = 0, seed_resolution = 0, bend_threshold = 0;
  bool ignore_normals = false, remove_outliers = false;
  ObjectSegmentationOptions others;
};

std::string
numberText(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

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
          "defaults for what was scanned; auto: single_view if the input is organised, "
          "else room; laser_scan: fewer and larger segments of a room; thesis: the "
          "graph segmentation of the thesis with its parameters",
          {"auto", "room", "laser_scan", "single_view", "thesis"})
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

/** What is joined or apart because of its shape. */
void
addShapes(OptionParser& parser, Settings& settings)
{
  const auto add = [&parser](const std::string& name,
                             std::string& variable,
                             const std::string& meaning,
                             const std::string& of_rooms) {
    parser.text(name,
                variable,
                meaning + "; auto: " + of_rooms + " for rooms",
                {"auto", "apart", "joined"});
  };
  add("-structure",
      settings.structure,
      "floor, ceiling and walls; apart: nothing is joined through them",
      "apart");
  add("-things",
      settings.things,
      "flat things, up to about 0.12 m high, and the horizontal surface they lie on (z "
      "is up)",
      "apart");
  add("-gaps",
      settings.gaps,
      "both sides of a narrow upright gap without points (z is up)",
      "apart");
  add("-seams",
      settings.seams,
      "closed bodies that stand against each other, as kitchen cabinets (z is up)",
      "apart");
  add("-bars",
      settings.bars,
      "straight level bars and the things that they run through, as a rail and its "
      "posts (z is up)",
      "apart");
  add("-racks",
      settings.racks,
      "the boards of racks and of bookcases without a back (z is up)",
      "joined");
  add("-uprights",
      settings.uprights,
      "legs, end boards and backs of what is level (z is up)",
      "joined");
  add("-frames",
      settings.frames,
      "jambs and heads of doors, bars of windows (z is up)",
      "joined");
  add("-shadows",
      settings.shadows,
      "fronts that the shadow of something before them cuts in two (z is up)",
      "joined");
  add("-doors",
      settings.doors,
      "the open leaf of a door and its frame (z is up)",
      "joined");
}

void
addPartition(OptionParser& parser, Settings& settings)
{
  auto& options = settings.others;
  parser
      .text("-partition",
            settings.partition,
            "how supervoxels are joined: by whole borders, by the thesis's graph "
            "segmentation, or over all convex edges; auto: graph, for -preset thesis "
            "felzenszwalb",
            {"auto", "graph", "felzenszwalb", "lccp"})
      .number(
          "-union_air",
          settings.union_air,
          "for -partition graph: segments are joined if the hull of both adds at most "
          "this much air for their contact, 0 = never; higher gives larger segments; "
          "-1 = " +
              numberText(ObjectSegmentationOptions().max_union_air) +
              " for rooms, 0 for the others",
          "",
          Range::between(-1, 1000))
      .number("-min_segment",
              settings.min_segment,
              withPresets("smallest segment",
                          ObjectSegmentationOptions().min_segment_size,
                          pcl::indoor::singleViewOptions().min_segment_size),
              "supervoxels",
              Range::atLeast(0))
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
presetOptions(const std::string& preset, bool organised)
{
  if (preset == "thesis")
    return pcl::indoor::thesisOptions();
  if (preset == "laser_scan")
    return pcl::indoor::laserScanOptions();
  if (preset == "single_view" || (preset == "auto" && organised))
    return pcl::indoor::singleViewOptions();
  return {};
}

ObjectSegmentationOptions
chosenOptions(const Settings& settings, bool organised)
{
  const auto preset = presetOptions(settings.preset, organised);
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
  options.plane_tolerance = preset.plane_tolerance;
  options.min_segment_size =
      settings.min_segment > 0 ? settings.min_segment : preset.min_segment_size;
  const auto is = [](const std::string& given, const char* word, bool of_preset) {
    return given == "auto" ? of_preset : given == word;
  };
  options.separate_structure =
      is(settings.structure, "apart", preset.separate_structure);
  options.separate_things = is(settings.things, "apart", preset.separate_things);
  options.separate_gaps = is(settings.gaps, "apart", preset.separate_gaps);
  options.separate_seams = is(settings.seams, "apart", preset.separate_seams);
  options.separate_bars = is(settings.bars, "apart", preset.separate_bars);
  options.join_racks = is(settings.racks, "joined", preset.join_racks);
  options.join_uprights = is(settings.uprights, "joined", preset.join_uprights);
  options.join_frames = is(settings.frames, "joined", preset.join_frames);
  options.join_shadowed = is(settings.shadows, "joined", preset.join_shadowed);
  options.join_doors = is(settings.doors, "joined", preset.join_doors);
  options.max_union_air =
      settings.union_air < 0 ? preset.max_union_air : settings.union_air;
  options.adapt_to_resolution = !(settings.voxel_resolution > 0);
  options.partition = settings.partition == "auto"   ? preset.partition
                      : settings.partition == "lccp" ? Partition::Lccp
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
  addPartition(parser, settings);
  addShapes(parser, settings);
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
