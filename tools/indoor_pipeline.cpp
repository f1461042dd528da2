/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/cloud_options.h"
#include "command_line/options.h"
#include "command_line/preset.h"
#include "command_line/scene_options.h"
#include "files/cloud_file.h"
#include "pipeline/pipeline_results.h"
#include "pipeline/pipeline_stages.h"
#include "pipeline/result_tables.h"
#include "pipeline/shared_rooms.h"
#include "scene/scene_summary.h"
#include "scene/understood_scan.h"
#include "text/printable.h"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

using namespace pcl::indoor::tool;

namespace {

using Options = PipelineOptions;

constexpr const char* points_option = "-points_at_once";
constexpr const char* single_process_option = "-single_process";

/** The defaults, which the option -preset changes. */
Options
optionsOfPreset(int argc, char** argv)
{
  Options options;
  if (presetOf(argc, argv) == "thesis") {
    options.rooms = pcl::indoor::thesisRoomOptions();
    options.objects = pcl::indoor::thesisOptions();
  }
  return options;
}

OptionParser
makeParser(Options& options)
{
  OptionParser parser(
      "pcl_indoor_pipeline",
      "Finds the rooms of a building's scan, the objects in each room "
      "and the class of each object; writes cloud.pcd with the fields "
      "room, object, structure, category and confidence, scene.json, report.html, "
      "plan.svg, plan.png, plan.dxf, rooms.png, potential_field.png and classes.png.");
  parser
      .positionals("input",
                   options.inputs,
                   "PCD, PLY or LAS file or table; several, or a folder of them, are "
                   "the stations of one building")
      .positional(
          "output_dir", options.folder, "folder for the results, made if missing")
      .number("-voxel_size",
              options.rooms.voxel_size,
              "side of a voxel of the rooms, 0 = automatic: 0.1, more where surfaces "
              "have holes",
              "m",
              Range::atLeast(0))
      .number("-min_area",
              options.rooms.map.min_area,
              "smallest room",
              "m^2",
              Range::atLeast(0))
      .number("-voxel_resolution",
              options.voxel_resolution,
              "edge of a voxel of the objects, 0 = automatic: 0.03, more in rooms with "
              "sparse points",
              "m",
              Range::atLeast(0))
      .number(
          "-seed_resolution",
          options.seed_resolution,
          "distance of supervoxels, at least -voxel_resolution, 0 = automatic: four "
          "times that",
          "m",
          Range::atLeast(0))
      .text("-preset",
            options.preset,
            "thesis: rooms and objects by the methods of the thesis with their "
            "parameters, and no more",
            {"default", "thesis"})
      .text("-partition",
            options.partition,
            "how supervoxels are joined",
            {"graph", "lccp"})
      .text("-model",
            options.model,
            "file of a classifier that pcl_eppf_train has made; bundled = furniture, "
            "doors and windows, none = no classes")
      .text("-report",
            options.report,
            "file of the report, a page for browsers; folder = report.html beside the "
            "other results, none = no report")
      .number(
          points_option,
          options.points_at_once,
          "of larger scans the rooms are found from a point per cell, and the points "
          "are read in parts: memory follows the rooms; 0 = never",
          "points")
      .flag("-ignore_normals",
            options.ignore_normals,
            "estimate normals although there are some")
      .text("-normals",
            options.preparation.normals,
            "how normals are estimated where the input has none; voxels: planes of the "
            "objects' voxels; rrht: Robust Randomized Hough Transform; multi_scale: "
            "planes at several scales",
            {"voxels", "rrht", "multi_scale"})
      .flag("-remove_outliers",
            options.preparation.removes_outliers,
            "leave out points of a room that lie alone (pcl::ScanOutlierRemoval); "
            "their object is 0")
      .number("-threads",
              options.threads,
              "threads, 0 = automatic",
              "",
              Range::between(0, 1024))
      .flag(single_process_option,
            options.single_process,
            "share the rooms with no other process: for runs that a program starts "
            "which was itself started by mpirun")
      .flag("-check",
            options.check,
            "say what is understood of the scan and stop, in a second or two and "
            "without output_dir: will it work?")
      .lastMayBeMissing(options.check);
  addOption(parser, options.colors, {"class", "object", "room"});
  addOption(parser, options.coordinates);
  addOption(parser, options.columns);
  options.memory.addOption(parser);
  addOptions(parser, options.frame);
  parser.expert({"-voxel_resolution",
                 "-seed_resolution",
                 "-partition",
                 "-preset",
                 "-ignore_normals",
                 "-normals",
                 "-double",
                 points_option,
                 single_process_option,
                 "-memory_limit"});
  return parser;
}

/** Sizes that are given hold. */
void
chooseResolution(Options& options)
{
  auto& objects = options.objects;
  const double voxel = options.voxel_resolution, seed = options.seed_resolution;
  if (voxel == 0.0 && seed == 0.0)
    return;
  objects.voxel_size = voxel;
  objects.seed_size = seed;
  objects = withSizes(objects);
  if (objects.seed_size < objects.voxel_size)
    throw ToolError("-seed_resolution: '" + std::to_string(seed) +
                    "' is less than -voxel_resolution, " + std::to_string(voxel));
}

/** The settings that a result tells: how large scans are read, only of these. */
std::vector<Setting>
settingsOf(const OptionParser& parser, const Scan& scan)
{
  auto settings = parser.settings();
  if (!scan.stream)
    settings.erase(
        std::remove_if(settings.begin(),
                       settings.end(),
                       [](const Setting& s) { return s.name == points_option; }),
        settings.end());
  return settings;
}

std::string
workFolder(const Options& options)
{
  return options.folder + "/.unfinished";
}

UnderstoodScan
understand(const Options& options, const Scan& scan, Progress& progress)
{
  auto understood =
      understand(scan.file, options.frame, scan.pointCount(), options.ignore_normals);
  progress.say(paragraphOf(scan.file.path, understood));
  return understood;
}

/** Says whether there is what rooms are found from. */
void
check(Options options, Progress& progress)
{
  namespace fs = std::filesystem;
  // what would be the folder of the results may be a scan, where there are to be none
  const bool is_result = !fs::exists(options.folder) || fs::is_empty(options.folder) ||
                         fs::exists(fs::path(options.folder) / "scene.json");
  if (!is_result)
    options.inputs.push_back(options.folder);
  const auto scan = loadScan(options, progress);
  const auto lacks = consequencesOf(understand(options, scan, progress));
  progress.summary(
      scan.file.path + ": " +
      (lacks.empty() ? "all is there that rooms are found from" : lacks[0]));
}

/** A result without rooms is no error, but not what was wanted. */
void
sayIfEmpty(const std::string& path, Scene& scene)
{
  const auto line =
      emptinessOf(scene.understood, scene.rooms.size(), scene.counts.in_rooms);
  if (line.empty())
    return;
  printComplaint("pcl_indoor_pipeline", path + ": " + line);
  scene.report.warnings.push_back(line);
}

/** What a process does that mpirun has started beside the first one. Of the same
 * command the first one says what is wrong; here it is enough to wait for the end. */
int
help(Ranks& ranks, int argc, char** argv)
{
  auto options = optionsOfPreset(argc, argv);
  auto parser = makeParser(options);
  try {
    parser.parse(argc, argv);
  } catch (const ToolError&) {
  }
  try {
    finishSharedRooms(ranks, workFolder(options), [&] {
      chooseResolution(options);
      return roomWork(options);
    });
  } catch (const std::exception& error) {
    printWarning("a process beside the first one ends the work: " + messageOf(error));
    ranks.endAll();
  }
  return EXIT_SUCCESS;
}

} // namespace

int
main(int argc, char** argv)
{
  Ranks ranks(isGiven(argc, argv, single_process_option));
  if (!ranks.isFirst())
    return help(ranks, argc, argv);
  auto options = optionsOfPreset(argc, argv);
  auto parser = makeParser(options);
  const int status = parser.run(argc, argv, [&](Progress& progress) {
    if (options.check)
      return check(options, progress);
    requireUsable(options);
    auto scan = loadScan(options, progress);
    chooseResolution(options);
    const auto understood = understand(options, scan, progress);

    auto work = roomWork(options);
    WorkFolder folder(workFolder(options), keyOfRun(options, parser.settings()));
    folder.lock();
    folder.removeOutdated();
    auto scene = findRooms(options, scan.file, understood, folder, progress);
    work.setFrame(scene.building_pose, scene.report.metres_per_unit);
    options.frame.settle(scene.report);
    scene.understood = understood;
    const auto standing = standingPoints(scan.file, work, scene);
    auto cloud =
        findObjects(options, scan, *standing, work, folder, ranks, scene, progress);
    sayIfEmpty(scan.file.path, scene);
    progress.start("Saving to " + options.folder);
    const auto texts =
        describe(options, settingsOf(parser, scan), scene, *standing, scan.file);
    save(options.folder, texts, std::move(cloud));
    folder.remove();
    Progress::conclude([&] {
      progress.done(namesOf(texts));
      progress.summary(options.folder + ": " + summaryOf(scene));
      for (const auto& table : tablesOf(scene, progress.stages()))
        progress.table(table);
    });
  });
  ranks.dismissAll();
  return status;
}
