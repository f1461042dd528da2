/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "segmentation/room_settings.h"

#include "command_line/cloud_options.h"
#include "command_line/preset.h"
#include "command_line/scene_options.h"

namespace pcl::indoor::tool {
namespace {

/** Options of the thesis's method, Sec. 3.2.3. */
void
addFieldOptions(OptionParser& parser, thesis::RoomOptions& rooms)
{
  auto& field = rooms.field;
  const auto weight =
      [&parser](const char* name, double& variable, const char* meaning) {
        parser.number(name, variable, meaning, "", Range::atLeast(0));
      };
  parser.number(
      "-interior_voxel_size",
      rooms.shared.interior.voxel_size,
      "side of a voxel of the interior space and of -method field, rounded to "
      "a multiple of -voxel_size",
      "m",
      Range::positive());
  weight("-euclidean_weight",
         field.distance.euclidean_weight,
         "field: weight of the Euclidean distance; 0 = much slower");
  weight("-field_weight",
         field.distance.field_weight,
         "field: weight of the distance through the potential field");
  weight("-visibility_weight",
         field.distance.visibility_weight,
         "field: weight of the difference of what is visible");
  const auto area = [&parser](const char* name, double& variable, const char* meaning) {
    parser.number(name, variable, meaning, "m^2", Range::positive());
  };
  area("-min_cluster_area", field.min_cluster_area, "field: smallest cluster");
  area(
      "-sample_area",
      field.sample_area,
      "field: neighbourhood of a pixel's core distance; larger leaves out more pixels");
  parser.number("-landmark_spacing",
                field.landmark_spacing,
                "field: between the places that visibility looks for; 0 = every pixel",
                "m",
                Range::atLeast(0));
  parser.flag("-single_cluster",
              field.allow_single_cluster,
              "field: HDBSCAN may find one room only");
  parser.number("-dbscan_distance",
                field.dbscan_distance,
                "field: 0 = HDBSCAN; else DBSCAN* with this weighted distance",
                "",
                Range::atLeast(0));
}

/** The weights of Eq. (3.1), by which interior space is found. */
void
addInteriorOptions(OptionParser& parser, EnclosureWeights& weights)
{
  const auto weight =
      [&parser](const char* name, double& variable, const char* meaning) {
        parser.number(name, variable, meaning, "", Range::between(0, 80));
      };
  weight("-floor_weight",
         weights.below,
         "evidence for the interior: something below (w1 of the thesis)");
  weight("-ceiling_weight", weights.above, "the same: something above (w2)");
  weight("-height_weight", weights.vertical, "the same: both (w3)");
  weight("-wall_weight",
         weights.horizontal,
         "the same: on both sides in all directions of the walls (w4 + w5)");
  weight("-exterior_weight", weights.exterior, "evidence for the exterior");
}

/** Sizes of the rooms, and how a map is divided into them. */
void
addMapOptions(OptionParser& parser, BuildingRoomsOptions& rooms)
{
  auto& map = rooms.map;
  parser
      .number("-voxel_size",
              rooms.voxel_size,
              "side of a voxel, 0 = automatic: 0.1, more where surfaces have holes",
              "m",
              Range::atLeast(0))
      .number("-min_area", map.min_area, "smallest room", "m^2", Range::atLeast(0))
      .number("-min_width", map.min_width, "narrowest room", "m", Range::atLeast(0))
      .number("-persistence",
              map.persistence,
              "widest passage between rooms, as share of the narrower one's width",
              "",
              Range::between(0, 1))
      .number("-open_share",
              map.merging.open_share,
              "most open border between rooms, as share of its area",
              "",
              Range::between(0, 1))
      .number("-habitable_area",
              map.open_plan.habitable_area,
              "smallest room of an open plan, without a door to the next",
              "m^2",
              Range::atLeast(0));
}

} // namespace

RoomSettings
roomSettings(int argc, const char* const* argv)
{
  RoomSettings options;
  if (presetOf(argc, argv) == "thesis") {
    options.rooms = thesisRoomOptions();
    options.method = "field";
  }
  return options;
}

void
requireLegal(const RoomSettings& options)
{
  const auto problem = findProblem(options.rooms);
  if (!problem.empty())
    throw ToolError(options.input + ": " + problem);
}

RoomSegmentation<PointXYZ>
segmentationBy(const RoomSettings& options)
{
  RoomSegmentation<PointXYZ> segmentation;
  segmentation.setThesisOptions(options.rooms);
  segmentation.setMethod(options.method == "slab" ? RoomMethod::CeilingSlab
                                                  : RoomMethod::PotentialField);
  return segmentation;
}

OptionParser
roomParser(RoomSettings& options)
{
  auto& rooms = options.rooms.shared;
  OptionParser parser("pcl_room_segmentation",
                      "Segment the scan of a building into rooms with "
                      "pcl::RoomSegmentation; adds the field room.");
  parser.positional("input", options.input, scan_files)
      .positional(
          "output.pcd|ply", options.output, "the input with the field room, 0 = none")
      .text("-preset",
            options.preset,
            "thesis: the method of the thesis with its parameters, and no more; the "
            "other options start from it",
            {"default", "thesis"})
      .text("-map",
            options.map,
            "beginning of the names of pictures: _rooms.png, _rooms.svg and _plan.png "
            "with "
            "numbers and doors, _field.png")
      .text("-dxf", options.dxf, "file for a drawing of the plan for CAD programs")
      .text("-json",
            options.json,
            "file for area, volume, footprint and neighbours of each room");
  addMapOptions(parser, rooms);
  parser
      .text("-method",
            options.method,
            "slab: walls below the ceiling; field: potential field and HDBSCAN, as in "
            "the thesis",
            {"slab", "field"})
      .number(
          "-threads", rooms.threads, "threads, 0 = automatic", "", Range::atLeast(0));
  addOptions(parser, options.scan);
  parser.flag("-check",
              options.check,
              "say what is understood of the scan and stop, without output: will it "
              "work?");
  parser.lastMayBeMissing(options.check);
  addOption(parser, options.colors, {"room"});
  addOption(parser, options.coordinates);
  addOption(parser, options.columns);
  addOptions(parser, options.stations);
  options.memory.addOption(parser);
  addFieldOptions(parser, options.rooms);
  addInteriorOptions(parser, rooms.interior.weights);
  parser.expert({"-double",          "-memory_limit",        "-min_width",
                 "-persistence",     "-open_share",          "-habitable_area",
                 "-method",          "-interior_voxel_size", "-euclidean_weight",
                 "-field_weight",    "-visibility_weight",   "-min_cluster_area",
                 "-sample_area",     "-landmark_spacing",    "-single_cluster",
                 "-dbscan_distance", "-floor_weight",        "-ceiling_weight",
                 "-height_weight",   "-wall_weight",         "-exterior_weight"});
  return parser;
}

} // namespace pcl::indoor::tool
