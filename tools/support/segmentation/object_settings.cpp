/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "segmentation/object_settings.h"

#include "command_line/cloud_options.h"
#include "command_line/preset.h"
#include "command_line/scene_options.h"

#include <sstream>
#include <utility>

namespace pcl::indoor::tool {
namespace {

/** For example "edge of a voxel; 0 = 0.03 for rooms, 0.005 for a single view". */
std::string
withPresets(const std::string& meaning, double room, double single_view)
{
  std::ostringstream text;
  text << meaning << "; 0 = " << room << " for rooms, " << single_view
       << " for a single view";
  return text.str();
}

/** The options that a preset stands for.
 * \param[in] is_table what auto is for a table */
thesis::ObjectOptions
presetOptions(const std::string& preset, bool is_table)
{
  if (preset == "thesis")
    return thesisOptions();
  if (preset == "thesis_kinect")
    return thesisKinectOptions();
  thesis::ObjectOptions options;
  if (preset == "parts")
    options.shared = partsOptions();
  if (preset == "single_view" || (preset == "auto" && is_table))
    options.shared = singleViewOptions();
  return options;
}

bool
isThesis(const std::string& preset)
{
  return preset == "thesis" || preset == "thesis_kinect";
}

void
addLengths(OptionParser& parser, ObjectSettings& settings)
{
  const auto room = withSizes(ObjectSegmentationOptions());
  const auto view = withSizes(singleViewOptions());
  parser
      .text("-preset",
            settings.preset,
            "what is wanted; objects: whole ones in a room; parts: seats, backs and "
            "arms apart; single_view: a table with small objects; thesis, "
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
addPartition(OptionParser& parser, ObjectSettings& settings)
{
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
              "for -partition graph: probability of being one object from which pieces "
              "are joined; higher gives smaller segments; -1 = where that gives whole "
              "objects, in single views 0.9",
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
              Range::atLeast(0));
}

void
addWeights(OptionParser& parser, ObjectSettings& settings)
{
  parser
      .number("-spatial_weight",
              settings.others.spatial_weight,
              "weight of distance, over the distance of supervoxels",
              "",
              Range::between(0, 1e6))
      .number("-normal_weight",
              settings.others.normal_weight,
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
              Range::between(0, 1e6));
}

/** Sizes of segments, and how the thesis's ways to join supervoxels are tuned. */
void
addJoining(OptionParser& parser, ObjectSettings& settings)
{
  parser
      .number("-min_segment",
              settings.min_segment,
              withPresets("smallest segment",
                          ObjectSegmentationOptions().min_segment_size,
                          singleViewOptions().min_segment_size),
              "supervoxels",
              Range::atLeast(0))
      .number("-min_points",
              settings.others.fewest_points,
              "for -partition graph: segments of fewer points, or smaller than a "
              "supervoxel, are the remainder",
              "points")
      .number("-graph_scale",
              settings.edges.graph_scale,
              "for -partition felzenszwalb; higher gives larger segments",
              "",
              Range::atLeast(0))
      .number("-concavity_tolerance",
              settings.edges.concavity_tolerance_degrees,
              "for -partition felzenszwalb and lccp: bend up to which concave edges "
              "count as convex",
              "degrees",
              Range::between(0, 180));
}

void
addOthers(OptionParser& parser, ObjectSettings& settings)
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
  settings.scan.unit = "m";
  parser.text("-unit",
              settings.scan.unit,
              "unit of the coordinates; lengths of options are in metres",
              {"m", "cm", "mm", "ft", "in"});
  addUpOption(parser, settings.scan);
  addOption(parser, settings.colors, {"object"});
  addOption(parser, settings.coordinates);
  addOption(parser, settings.columns);
  settings.memory.addOption(parser);
  parser.expert({"-double", "-memory_limit"});
}

/** Whether a preset or a partition is one of pieces, not of the thesis. */
bool
hasPieces(const ObjectSettings& settings)
{
  return settings.partition == "graph" ||
         (settings.partition == "auto" && !isThesis(settings.preset));
}

/** The options to segment with; where there are pieces, the shared ones. */
thesis::ObjectOptions
chosenOptions(const ObjectSettings& settings, bool is_table)
{
  auto options = presetOptions(settings.preset, is_table);
  const auto preset = options.shared;
  auto& shared = options.shared = settings.others;
  const bool given = settings.voxel_resolution > 0 || settings.seed_resolution > 0;
  shared.voxel_size = given ? settings.voxel_resolution : preset.voxel_size;
  shared.seed_size = given ? settings.seed_resolution : preset.seed_size;
  shared.min_segment_size =
      settings.min_segment > 0 ? settings.min_segment : preset.min_segment_size;
  shared.pieces.scale = preset.pieces.scale;
  if (settings.level >= 0)
    shared.pieces.joining_level = static_cast<float>(settings.level);
  shared.orientation = settings.orientation == "auto"    ? NormalOrientation::Automatic
                       : settings.orientation == "graph" ? NormalOrientation::Graph
                       : settings.orientation == "viewpoint"
                           ? NormalOrientation::Viewpoint
                           : NormalOrientation::FreeSpace;
  options.edges = settings.edges;
  if (settings.partition == "lccp")
    options.edges.partition = thesis::EdgePartition::Lccp;
  if (options.on_points)
    options.on_points = settings.on_points;
  return options;
}

} // namespace

ObjectSettings
objectSettings(int argc, const char* const* argv)
{
  ObjectSettings settings;
  const auto preset = presetOptions(presetOf(argc, argv), false);
  settings.others = preset.shared;
  settings.edges = preset.edges;
  settings.on_points = preset.on_points.value_or(settings.on_points);
  return settings;
}

void
requireFitting(const ObjectSettings& settings)
{
  if (settings.level < 0 && settings.level != -1)
    throw ToolError("-level: must be -1 or from 0 to 1");
  const bool as_thesis = isThesis(settings.preset);
  const auto& on_points = settings.on_points;
  const std::pair<const char*, double> of_thesis[] = {
      {"-ransac_share", on_points.ransac_share},
      {"-colour_weight", on_points.color_weight},
      {"-fpfh_weight", on_points.fpfh_weight}};
  for (const auto& [option, value] : of_thesis)
    if (!as_thesis && value > 0)
      throw ToolError(std::string(option) + ": needs -preset thesis or thesis_kinect");
  if (as_thesis && settings.partition == "graph")
    throw ToolError("-partition graph: the thesis's presets have no pieces");
}

void
addOptions(OptionParser& parser, ObjectSettings& settings)
{
  addLengths(parser, settings);
  addPartition(parser, settings);
  addWeights(parser, settings);
  addJoining(parser, settings);
  addOthers(parser, settings);
}

ObjectChoices
choicesOf(const ObjectSettings& settings)
{
  ObjectChoices choices;
  choices.scan = settings.scan;
  choices.asks_for_tables = settings.preset == "auto";
  choices.options = [&settings](bool is_table) {
    return chosenOptions(settings, is_table);
  };
  choices.has_pieces = hasPieces(settings);
  if (settings.camera != "auto")
    choices.is_single_view = settings.camera == "single";
  choices.ignore_normals = settings.ignore_normals;
  choices.remove_outliers = settings.remove_outliers;
  return choices;
}

} // namespace pcl::indoor::tool
