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
#include "pictures/plan_dxf.h"
#include "pictures/plan_png.h"
#include "pictures/plan_svg.h"
#include "pictures/room_picture.h"
#include "scene/point_colors.h"
#include "scene/room_json.h"
#include "scene/scan_frame.h"
#include "scene/understood_scan.h"
#include "text/printable.h"

#include <pcl/segmentation/room_segmentation.h>

#include <algorithm>
#include <utility>

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
  bool check = false;
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
  addOptions(parser, options.frame);
  parser.flag("-check",
              options.check,
              "say what is understood of the scan and stop, without output: will it "
              "work?");
  parser.lastMayBeMissing(options.check);
  addOption(parser, options.colors, {"room"});
  addOption(parser, options.coordinates);
  addOption(parser, options.columns);
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

struct FoundRooms : SegmentedRooms {
  UnderstoodScan understood;
};

/** What is known of the rooms; not yet in place. */
std::vector<OutputFile>
describe(const Options& options,
         const std::string& parameters,
         const Segmentation& segmentation,
         const FoundRooms& found,
         const CloudFile& file)
{
  std::vector<OutputFile> files;
  const auto& building = segmentation.getBuilding();
  if (!options.json.empty()) {
    auto json = inputJson(file, found.room_of_point);
    json["parameters"] = parameters;
    addReportJson(json, options.frame, found.report);
    json["overview"] = overviewJson(found.understood);
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
    if (const auto picture = planPicture(svg))
      save("_plan.png", *picture);
  }
  return files;
}

/** A result without rooms is no error, but not what was wanted. */
void
sayIfEmpty(const std::string& path, const Segmentation& segmentation, FoundRooms& found)
{
  const auto& rooms = found.room_of_point;
  const auto in_none = std::count(rooms.begin(), rooms.end(), 0u);
  const auto line = emptinessOf(found.understood,
                                segmentation.getRooms().size(),
                                rooms.size() - static_cast<std::size_t>(in_none));
  if (line.empty())
    return;
  printComplaint("pcl_room_segmentation", path + ": " + line);
  found.report.warnings.push_back(line);
}

/** Adds the room of each point to the cloud.
 * \return a summary, and what describes the rooms */
std::pair<std::string, std::vector<OutputFile>>
segment(Options& options,
        const OptionParser& parser,
        const UnderstoodScan& understood,
        CloudFile& file,
        Progress& progress)
{
  progress.start("Segmenting rooms");
  Segmentation segmentation;
  segmentation.setOptions(options.rooms);
  segmentation.setProgressCallback([&progress](double share, const char*) {
    progress.update(static_cast<std::size_t>(100.0 * share), 100);
    return true;
  });
  FoundRooms found{segmentRooms(file, options.frame, understood.frame, segmentation),
                   understood};
  options.frame.settle(found.report);
  progress.done(summaryOf(segmentation));
  sayIfEmpty(file.path, segmentation, found);
  appendField(file.cloud, "room", found.room_of_point);
  options.colors.apply(file, "room", options.frame.upAxis());
  options.coordinates.apply(file, options.output);
  return {summaryOf(segmentation),
          describe(options, parser.values(), segmentation, found, file)};
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
    if (!options.check)
      requireWritableResults(options);
    options.memory.require(options.input, bytes_per_point);
    progress.start("Loading " + options.input);
    CloudFile file = loadSurface(options.input, options.columns);
    printNotes(file);
    progress.done(std::to_string(file.points->size()) + " points");

    options.rooms.map.method = options.method == "slab"
                                   ? pcl::indoor::RoomMethod::CeilingSlab
                                   : pcl::indoor::RoomMethod::PotentialField;
    const auto problem = findProblem(options.rooms);
    if (!problem.empty())
      throw ToolError(options.input + ": " + problem);
    const auto understood = understand(file, options.frame, file.points->size());
    progress.say(paragraphOf(file.path, understood));
    if (options.check) {
      const auto lacks = consequencesOf(understood);
      return progress.summary(
          file.path + ": " +
          (lacks.empty() ? "all is there that rooms are found from" : lacks[0]));
    }
    auto [summary, files] = segment(options, parser, understood, file, progress);
    file.points.reset(); // saving a large cloud needs the memory

    progress.start("Saving " + options.output);
    files.push_back(cloudBeside(options.output, file.cloud, file.frame));
    commitTogether(files);
    Progress::conclude([&] {
      progress.done();
      progress.summary(options.output + ": " + summary);
    });
  });
}
