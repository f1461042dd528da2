/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/options.h"
#include "command_line/printable.h"
#include "files/cloud_file.h"
#include "pipeline/pipeline_results.h"
#include "pipeline/pipeline_stages.h"
#include "pipeline/shared_rooms.h"
#include "scene/scene_summary.h"

#include <cstdlib>
#include <exception>
#include <string>

using namespace pcl::indoor::tool;

namespace {

using Options = PipelineOptions;

constexpr double bytes_per_point = 400; // that are in use at once, measured

OptionParser
makeParser(Options& options)
{
  OptionParser parser(
      "pcl_indoor_pipeline",
      "Finds the rooms of a building's scan, the objects in each room "
      "and the class of each object; writes cloud.pcd with the fields "
      "room, object, structure, category and confidence, scene.json, report.html, "
      "plan.svg, plan.png, plan.dxf, rooms.png, potential_field.png and classes.png.");
  parser.positional("input", options.input, "PCD or PLY file")
      .positional(
          "output_dir", options.folder, "folder for the results, made if missing")
      .number(
          "-voxel_size",
          options.rooms.voxel_size,
          "side of a voxel of the rooms, 0 = automatic: 0.1, more for sparse points",
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
      .flag("-ignore_normals",
            options.ignore_normals,
            "estimate normals although there are some")
      .number("-threads",
              options.threads,
              "threads, 0 = automatic",
              "",
              Range::between(0, 1024));
  options.colors.addOption(parser, {"class", "object", "room"});
  options.coordinates.addOption(parser);
  options.memory.addOption(parser);
  options.frame.addOptions(parser);
  parser.expert({"-voxel_resolution",
                 "-seed_resolution",
                 "-partition",
                 "-ignore_normals",
                 "-double",
                 "-memory_limit"});
  return parser;
}

/** Sizes that are given hold, and each gives the other; if none is, the library raises
 * both where points are sparse. */
void
chooseResolution(Options& options)
{
  auto& objects = options.objects;
  const double seeds_per_voxel = objects.seed_size / objects.voxel_size;
  const double voxel = options.voxel_resolution, seed = options.seed_resolution;
  if (voxel == 0.0 && seed == 0.0)
    return;
  objects.adapt_to_resolution = false;
  objects.voxel_size = voxel > 0.0 ? voxel : seed / seeds_per_voxel;
  objects.seed_size = seed > 0.0 ? seed : seeds_per_voxel * voxel;
  if (objects.seed_size < objects.voxel_size)
    throw ToolError("-seed_resolution: '" + std::to_string(seed) +
                    "' is less than -voxel_resolution, " + std::to_string(voxel));
}

std::string
workFolder(const Options& options)
{
  return options.folder + "/.unfinished";
}

/** What a process does that mpirun has started beside the first one. Of the same
 * command the first one says what is wrong; here it is enough to wait for the end. */
int
help(Ranks& ranks, int argc, char** argv)
{
  Options options;
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
  Ranks ranks;
  if (!ranks.isFirst())
    return help(ranks, argc, argv);
  Options options;
  auto parser = makeParser(options);
  const int status = parser.run(argc, argv, [&](Progress& progress) {
    requireUsable(options);
    options.memory.require(options.input, bytes_per_point);
    progress.start("Loading " + options.input);
    CloudFile file = loadCloud(options.input);
    progress.done(std::to_string(file.points->size()) + " points");
    chooseResolution(options);

    auto work = roomWork(options);
    WorkFolder folder(workFolder(options), keyOfRun(options, parser.settings()));
    folder.removeOutdated();
    Scene scene = findRooms(options, file, folder, progress);
    work.pose = scene.building_pose;
    const auto standing = standingPoints(file, work, scene);
    findObjects(options, file, *standing, work, folder, ranks, scene, progress);
    complete(options, scene, file);
    progress.start("Saving to " + options.folder);
    const auto texts = describe(options, parser.settings(), scene, *standing, file);
    progress.done(save(options.folder, texts, file));
    folder.remove();
    progress.summary(options.folder + ": " + summaryOf(scene));
    for (const auto& table : tablesOf(scene, progress.stages()))
      progress.table(table);
  });
  ranks.dismissAll();
  return status;
}
