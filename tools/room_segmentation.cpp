/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "command_line/options.h"
#include "files/cloud_file.h"
#include "files/sampled_surface.h"
#include "pictures/plan_dxf.h"
#include "pictures/plan_svg.h"
#include "pictures/room_picture.h"
#include "pictures/svg_raster.h"
#include "scene/room_json.h"
#include "scene/segmented_rooms.h"
#include "scene/understood_scan.h"
#include "segmentation/room_settings.h"
#include "text/printable.h"

#include <pcl/segmentation/room_segmentation.h>

#include <utility>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;
using Segmentation = pcl::RoomSegmentation<pcl::PointXYZ>;

namespace {

constexpr double bytes_per_point = 200; // that are in use at once, measured

/** The pictures that are drawn. */
std::vector<std::string>
picturePaths(const RoomSettings& options)
{
  if (options.map.empty())
    return {};
  return {options.map + "_rooms.png",
          options.map + "_field.png",
          options.map + "_plan.png"};
}

void
requireWritableResults(const RoomSettings& options)
{
  requireWritableCloud(options.output);
  if (!options.json.empty())
    requireWritable(options.json);
  if (!options.dxf.empty())
    requireWritable(options.dxf);
  for (const auto& path : picturePaths(options))
    requireWritable(path);
  if (!options.map.empty())
    requireWritable(options.map + "_rooms.svg");
}

struct FoundRooms : SegmentedRooms {
  UnderstoodScan understood;
};

/** What is known of the rooms; not yet in place. */
std::vector<OutputFile>
describe(const RoomSettings& options,
         const std::string& parameters,
         const Segmentation& segmentation,
         const FoundRooms& found,
         const CloudFile& file)
{
  std::vector<OutputFile> files;
  const auto& building = segmentation.getBuilding();
  if (!options.json.empty()) {
    auto json = inputJson(inputOf(file));
    json["points"] = file.points->size();
    json["finite_points"] = file.finite_count;
    json["points_in_rooms"] = pointsInRooms(found.room_of_point);
    json["parameters"] = parameters;
    addReportJson(json, found.report, found.report.outside.size());
    json["overview"] = overviewJson(found.understood);
    json["storeys"] = building.maps.size();
    json["rooms"] = roomsJson(
        segmentation.getRooms(), segmentation.getOpenings(), found.frame.offset);
    files.push_back(writtenBeside(options.json, jsonText(json)));
  }
  auto plan = floorPlan(building);
  plan.origin = found.frame.originInFile().head<2>();
  if (!options.dxf.empty())
    files.push_back(writtenBeside(options.dxf, planDxf(plan)));
  if (!options.map.empty()) {
    const auto svg = planSvg(plan);
    const auto paths = picturePaths(options);
    auto pictures = rasterised({{paths[0], drawRooms(building).str(), 1.0},
                                {paths[1], drawPotentialField(building).str(), 1.0},
                                {paths[2], svg}});
    files.push_back(writtenBeside(options.map + "_rooms.svg", svg));
    for (const auto& [path, bytes] : pictures.get())
      files.push_back(writtenBeside(path, bytes));
  }
  return files;
}

/** A result without rooms is no error, but not what was wanted. */
void
sayIfEmpty(const std::string& path, const Segmentation& segmentation, FoundRooms& found)
{
  const auto line = emptinessOf(found.understood,
                                segmentation.getRooms().size(),
                                pointsInRooms(found.room_of_point));
  if (line.empty())
    return;
  printComplaint("pcl_room_segmentation", path + ": " + line);
  found.report.warnings.push_back(line);
}

/** Adds the room of each point to the cloud.
 * \return a summary, and what describes the rooms */
std::pair<std::string, std::vector<OutputFile>>
segment(RoomSettings& options,
        const OptionParser& parser,
        const UnderstoodScan& understood,
        CloudFile& file,
        Progress& progress)
{
  progress.start("Segmenting rooms");
  auto segmentation = segmentationBy(options);
  segmentation.setProgressCallback([&progress](double share, const char*) {
    progress.update(static_cast<std::size_t>(100.0 * share), 100);
    return true;
  });
  FoundRooms found{
      segmentRooms(
          file, options.scan, understood.coordinates, true, segmentation, printWarning),
      understood};
  options.scan.settle(found.report);
  found.understood.settle(found.report);
  progress.done(summaryOf(segmentation));
  sayIfEmpty(file.path, segmentation, found);
  appendField(file.cloud, "room", found.room_of_point);
  options.colors.apply(file, "room", options.scan.upAxis());
  options.coordinates.apply(file, options.output);
  return {summaryOf(segmentation),
          describe(options, parser.values(), segmentation, found, file)};
}

} // namespace

int
main(int argc, char** argv)
{
  auto options = roomSettings(argc, argv);
  auto parser = roomParser(options);
  return parser.run(argc, argv, [&](Progress& progress) {
    if (!options.check)
      requireWritableResults(options);
    options.memory.require(options.input, bytes_per_point);
    progress.start("Loading " + options.input);
    CloudFile file = loadSurface(options.input, options.columns);
    choose(options.stations, file);
    printNotes(file);
    progress.done(std::to_string(file.points->size()) + " points");

    requireLegal(options);
    const auto understood =
        understand(file, options.scan, file.points->size(), {false, options.check});
    progress.say(paragraphOf(file.path, understood));
    if (options.check)
      return progress.summary(file.path + ": " + verdictOf(understood));
    auto [summary, files] = segment(options, parser, understood, file, progress);
    file.points.reset(); // saving a large cloud needs the memory

    progress.start("Saving " + options.output);
    files.push_back(cloudBeside(
        options.output, file.cloud, file.pose, options.rooms.shared.threads));
    commitTogether(files, picturePaths(options));
    Progress::conclude([&] {
      progress.done();
      progress.summary(options.output + ": " + summary);
    });
  });
}
