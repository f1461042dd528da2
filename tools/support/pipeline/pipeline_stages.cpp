/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pipeline/pipeline_stages.h"

#include "building/labelled_cloud.h"
#include "command_line/progress_report.h"
#include "files/digest.h"
#include "files/opened_scan.h"
#include "files/scan_files.h"
#include "pipeline/shared_rooms.h"
#include "scan/scan.h"
#include "scene/object_classes.h" // for modelFile

#include <pcl/ml/bundled_model.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace pcl::indoor::tool {
namespace {

/** Does a setting say only what the scene is written as besides? */
bool
isOfExports(const Setting& setting)
{
  const auto& name = setting.name;
  return name == "-ifc" || name == "-map" || name == "-geojson" || name == "-epsg";
}

/** Whether rooms and their objects depend on it: what is done with them at the end is
 * done anew by each run. */
bool
changesRooms(const Setting& setting)
{
  const auto& name = setting.name;
  return !isOfExports(setting) && name != "-colour" && name != "-report" &&
         name != "-double";
}

/** \throws ToolError if one of several scans would be replaced by the results */
void
requireOthersThanResults(const std::vector<std::string>& files,
                         const std::string& results)
{
  std::error_code error;
  for (const auto& file : files)
    if (files.size() > 1 &&
        std::filesystem::equivalent(file, results + "/cloud.pcd", error))
      throw ToolError(file + ": the results would replace this scan, give another "
                             "folder for them");
}

} // namespace

ScanContent
readScan(const PipelineOptions& options, Progress& progress)
{
  constexpr double bytes_per_point = 400; // that are in use at once, measured
  constexpr std::uint64_t enough_to_check = 4000000; // points: read in about a second
  const auto part = options.points_at_once > 0 && options.check
                        ? enough_to_check
                        : options.points_at_once;
  auto opened = openScan(options.inputs, part);
  if (!options.check)
    requireOthersThanResults(opened.files, options.folder);
  const bool in_parts = opened.isLargerThan(part);
  options.memory.require(
      opened.name, bytes_per_point, in_parts ? part + opened.in_memory : opened.count);
  progress.start((!in_parts       ? "Loading "
                  : options.check ? "Reading some points of "
                                  : "Reading in parts ") +
                 opened.name);
  auto scan = in_parts ? readLater(std::move(opened), options.columns)
                       : readWhole(std::move(opened), options.columns);
  choose(options.stations, scan.file);
  ProgressReport report(progress);
  if (in_parts && options.check)
    drawFewPoints(scan);
  else if (in_parts)
    drawSample(options, options.points_at_once, scan, report);
  printNotes(scan.file);
  const auto points = std::to_string(scan.file.points->size());
  progress.done(scan.stream ? std::to_string(scan.stream->pointCount()) + " points, " +
                                  points + " for the rooms"
                            : points + " points");
  return scan;
}

std::uint64_t
keyOfRun(const PipelineOptions& options, const std::vector<Setting>& settings)
{
  auto text = programVersion() + "\n";
  for (const auto& setting : settings)
    if (changesRooms(setting))
      text += setting.name + " " + setting.value + "\n";
  const auto model = modelFile(options);
  if (!model.empty())
    text += std::to_string(digestOfFile(model)) + "\n";
  if (options.network != "none")
    text += std::to_string(digestOfFile(bundledNetworkFile())) + "\n";
  std::uint64_t key = 0;
  for (const auto& file : scanFiles(options.inputs).paths) {
    text += std::filesystem::path(file).filename().string() + "\n";
    key = digestOf(std::to_string(digestOfFile(file)), key);
  }
  return digestOf(text, key);
}

OutputFile
completedCloud(const PipelineOptions& options,
               ObjectSearch search,
               WorkFolder& folder,
               Ranks& ranks,
               ScanContent& scan,
               FoundBuilding& building)
{
  if (ranks.count() > 1)
    search.share = [&](const auto& source, const auto& order, const auto& is_done) {
      shareRooms(order, source, search.work, folder, ranks, is_done);
    };
  auto& report = search.report;
  std::optional<RoomFiles> files;
  if (scan.stream)
    files = findObjectsInParts(search, folder, scan, building);
  else
    findObjects(search, scan.file, building);
  report.start("Completing the cloud");
  const CloudLook look = {options.folder + "/cloud.pcd",
                          options.colors,
                          options.coordinates,
                          options.scan.upAxis(),
                          options.threads};
  const auto is_done = [&](std::size_t done, std::size_t all) {
    report.update(done, all);
  };
  auto cloud =
      files ? completeCloudInParts(look, *files, folder, scan, building.scene, is_done)
            : completeCloud(look, building.scene, scan.file);
  report.done();
  return cloud;
}

} // namespace pcl::indoor::tool
