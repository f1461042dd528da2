/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "building/scene_settings.h"
#include "command_line/options.h"
#include "command_line/preset.h"
#include "command_line/progress_report.h"
#include "files/cloud_file.h"
#include "pipeline/pipeline_parser.h"
#include "pipeline/pipeline_stages.h"
#include "pipeline/shared_rooms.h"
#include "scene/room_json.h" // for inputOf
#include "scene/scene_summary.h"
#include "scene/understood_scan.h"
#include "text/printable.h"

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;

namespace {

using Options = PipelineOptions;

/** Sizes of voxels that are given hold. */
void
settleSizes(SceneOptions& options)
{
  options = checkedOptions(options);
}

/** The settings that a result tells: how large scans are read, only of these. */
FileSettings
fileSettings(const Options& options, const ScanContent& scan)
{
  return {options.columns.names,
          options.stations,
          scan.stream ? options.points_at_once : 0,
          options.report,
          options.colors.wanted,
          options.coordinates.doubles};
}

std::string
workFolder(const Options& options)
{
  return options.folder + "/.unfinished";
}

UnderstoodScan
understand(const Options& options, const ScanContent& scan, Progress& progress)
{
  auto understood =
      understand(scan.file,
                 options.scan,
                 scan.pointCount(),
                 {options.ignore_normals, options.check && options.network != "none"});
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
  const auto scan = readScan(options, progress);
  progress.summary(scan.file.path + ": " +
                   verdictOf(understand(options, scan, progress)));
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

TextTable
timesOf(const std::vector<Progress::Stage>& stages)
{
  TextTable times({"stage", "seconds>"});
  double all = 0.0;
  for (const auto& stage : stages) {
    times.add({stage.name, fixedText(stage.seconds, 1)});
    all += stage.seconds;
  }
  times.add({"all", fixedText(all, 1)});
  return times;
}

/** What a process does that mpirun has started beside the first one. Of the same
 * command the first one says what is wrong; here it is enough to wait for the end. */
int
help(Ranks& ranks, int argc, char** argv)
{
  auto options = pipelineOptions(argc, argv);
  auto parser = pipelineParser(options);
  try {
    parser.parse(argc, argv);
  } catch (const ToolError&) {
  }
  try {
    finishSharedRooms(ranks, workFolder(options), [&] {
      settleSizes(options);
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
  auto options = pipelineOptions(argc, argv);
  auto parser = pipelineParser(options);
  const int status = parser.run(argc, argv, [&](Progress& progress) {
    if (options.check)
      return check(options, progress);
    requireWritableResults(options);
    if (options.model == "none" && options.colors.wanted == "class")
      throw ToolError("-colour class: there are no classes with -model none");
    auto scan = readScan(options, progress);
    settleSizes(options);
    const auto understood = understand(options, scan, progress);

    auto work = roomWork(options);
    WorkFolder folder(workFolder(options), keyOfRun(options, parser.settings()));
    folder.lock();
    folder.removeOutdated();
    RoomsInFiles store(folder);
    ProgressReport report(progress);
    ObjectSearch search = {
        std::move(work), store, report, options.threads, options.ignore_normals};
    auto building = findBuilding(options, scan, understood, search);
    auto& scene = building.scene;
    auto cloud = completedCloud(options, search, folder, ranks, scan, building);
    sayIfEmpty(scan.file.path, scene);
    scene.input = inputOf(scan.file);
    scene.settings = settingsOf(options, fileSettings(options, scan));
    progress.start("Saving to " + options.folder);
    const auto texts = describe(options, scene, *building.upright);
    save(options.folder, texts, std::move(cloud));
    folder.remove();
    Progress::conclude([&] {
      progress.done(namesOf(texts));
      progress.summary(options.folder + ": " + summaryOf(scene));
      for (const auto& table : tablesOf(scene))
        progress.table(table);
      progress.table(timesOf(progress.stages()));
    });
  });
  ranks.dismissAll();
  return status;
}
