/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "command_line/options.h"
#include "command_line/preset.h"
#include "files/cloud_file.h"
#include "files/memory_limit.h"
#include "files/point_colors.h"
#include "files/point_coordinates.h"
#include "pictures/plan_dxf.h"
#include "pictures/plan_png.h"
#include "pictures/plan_svg.h"
#include "pictures/room_picture.h"
#include "scene/room_json.h"
#include "scene/scan_frame.h"

#include <pcl/segmentation/room_segmentation.h>

using namespace pcl::indoor::tool;
using Segmentation = pcl::RoomSegmentation<pcl::PointXYZ>;

namespace {

constexpr double bytes_per_point = 200; // that are in use at once, measured

struct Options {
  std::string input, output, map, json, dxf;
  std::string method = "slab", preset = "default";
  ScanFrame frame;
  pcl::indoor::BuildingRoomsOptions rooms;
  PointColors colors;
  PointCoordinates coordinates;
  TableColumns columns;
  MemoryLimit memory;
};

/** Options of the thesis's method, Sec. 3.2.3. */
void
addFieldOptions(OptionParser& parser, pcl::indoor::BuildingRoomsOptions& rooms)
{
  auto& field = rooms.map.field_rooms;
  const auto weight =
      [&parser](const char* name, double& variable, const char* meaning) {
        parser.number(name, variable, meaning, "", Range::atLeast(0));
      };
  parser.number(
      "-interior_voxel_size",
      rooms.interior.voxel_size,
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
addInteriorOptions(OptionParser& parser, pcl::indoor::EnclosureWeights& weights)
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

OptionParser
makeParser(Options& options)
{
  auto& map = options.rooms.map;
  OptionParser parser("pcl_room_segmentation",
                      "Segment the scan of a building into rooms with "
                      "pcl::RoomSegmentation; adds the field room.");
  parser.positional("input", options.input, "PCD, PLY or LAS file or table")
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
            "file for area, volume, footprint and neighbours of each room")
      .number("-voxel_size",
              options.rooms.voxel_size,
              "side of a voxel, 0 = automatic: 0.1, more for sparse points",
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
              Range::atLeast(0))
      .text("-method",
            options.method,
            "slab: walls below the ceiling; field: potential field and HDBSCAN, as in "
            "the thesis",
            {"slab", "field"})
      .number("-threads",
              options.rooms.threads,
              "threads, 0 = automatic",
              "",
              Range::atLeast(0));
  options.frame.addOptions(parser);
  options.colors.addOption(parser, {"room"});
  options.coordinates.addOption(parser);
  options.columns.addOption(parser);
  options.memory.addOption(parser);
  addFieldOptions(parser, options.rooms);
  addInteriorOptions(parser, options.rooms.interior.weights);
  parser.expert({"-double",          "-memory_limit",        "-min_width",
                 "-persistence",     "-open_share",          "-habitable_area",
                 "-method",          "-interior_voxel_size", "-euclidean_weight",
                 "-field_weight",    "-visibility_weight",   "-min_cluster_area",
                 "-sample_area",     "-landmark_spacing",    "-single_cluster",
                 "-dbscan_distance", "-floor_weight",        "-ceiling_weight",
                 "-height_weight",   "-wall_weight",         "-exterior_weight"});
  return parser;
}

void
requireWritableResults(const Options& options)
{
  requireWritableCloud(options.output);
  if (!options.json.empty())
    requireWritable(options.json);
  if (!options.dxf.empty())
    requireWritable(options.dxf);
  if (!options.map.empty())
    for (const char* name : {"_rooms.png", "_rooms.svg", "_plan.png", "_field.png"})
      requireWritable(options.map + name);
}

/** What is known of the rooms; not yet in place. */
std::vector<OutputFile>
describe(const Options& options,
         const std::string& parameters,
         const Segmentation& segmentation,
         const std::vector<std::uint32_t>& rooms,
         const CloudFile& file)
{
  std::vector<OutputFile> files;
  const auto& building = segmentation.getBuilding();
  if (!options.json.empty()) {
    auto json = inputJson(file, rooms);
    json["parameters"] = parameters;
    addReportJson(json, options.frame, segmentation.getReport());
    json["storeys"] = building.maps.size();
    json["rooms"] =
        roomsJson(segmentation.getRooms(), segmentation.getOpenings(), file.offset);
    files.push_back(writtenBeside(options.json, jsonText(json)));
  }
  auto plan = floorPlan(building);
  plan.origin = originOf(file, options.frame, segmentation.getBuildingPose());
  if (!options.dxf.empty())
    files.push_back(writtenBeside(options.dxf, planDxf(plan)));
  if (!options.map.empty()) {
    const auto save = [&](const std::string& name, const std::string& bytes) {
      files.push_back(writtenBeside(options.map + name, bytes));
    };
    save("_rooms.png", pngBytes(drawRooms(building)));
    save("_field.png", pngBytes(drawPotentialField(building)));
    const auto svg = planSvg(plan);
    save("_rooms.svg", svg);
    if (canDrawPlans())
      save("_plan.png", drawnAsPng(svg));
  }
  return files;
}

/** Adds the room of each point to the cloud; returns what describes the rooms. */
std::vector<OutputFile>
segment(const Options& options,
        const std::string& parameters,
        CloudFile& file,
        Progress& progress,
        std::string& summary)
{
  progress.start("Segmenting rooms");
  Segmentation segmentation;
  segmentation.setOptions(options.rooms);
  segmentation.setProgressCallback([&progress](double share, const char*) {
    progress.update(static_cast<std::size_t>(100.0 * share), 100);
    return true;
  });
  const auto rooms = segmentRooms(file, options.frame, segmentation);
  summary = summaryOf(segmentation);
  progress.done(summary);
  appendField(file.cloud, "room", rooms);
  options.colors.apply(file, "room", options.frame.upAxis());
  options.coordinates.apply(file, options.output);
  return describe(options, parameters, segmentation, rooms, file);
}

} // namespace

int
main(int argc, char** argv)
{
  Options options;
  if (presetOf(argc, argv) == "thesis") {
    options.rooms = pcl::indoor::thesisRoomOptions();
    options.method = "field";
  }
  auto parser = makeParser(options);
  return parser.run(argc, argv, [&](Progress& progress) {
    requireWritableResults(options);
    options.memory.require(options.input, bytes_per_point);
    progress.start("Loading " + options.input);
    CloudFile file = loadCloud(options.input, options.columns);
    printNotes(file);
    progress.done(std::to_string(file.points->size()) + " points");

    options.rooms.map.method = options.method == "slab"
                                   ? pcl::indoor::RoomMethod::CeilingSlab
                                   : pcl::indoor::RoomMethod::PotentialField;
    std::string summary;
    auto files = segment(options, parser.values(), file, progress, summary);
    file.points.reset(); // saving a large cloud needs the memory

    progress.start("Saving " + options.output);
    files.push_back(cloudBeside(options.output, file.cloud, file.frame));
    commitTogether(files);
    progress.done();
    progress.summary(options.output + ": " + summary);
  });
}
