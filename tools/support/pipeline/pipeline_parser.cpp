/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pipeline/pipeline_parser.h"

#include "command_line/cloud_options.h"
#include "command_line/preset.h"
#include "command_line/scene_options.h"

namespace pcl::indoor::tool {
namespace {

/** How rooms and objects are found and named. */
void
addSegmentation(OptionParser& parser, PipelineOptions& options)
{
  auto& rooms = options.thesis_rooms ? options.thesis_rooms->shared : options.rooms;
  parser
      .number("-voxel_size",
              rooms.voxel_size,
              "side of a voxel of the rooms, 0 = automatic: 0.1, more where surfaces "
              "have holes",
              "m",
              Range::atLeast(0))
      .number(
          "-min_area", rooms.map.min_area, "smallest room", "m^2", Range::atLeast(0))
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
      .text(
          "-network",
          options.network,
          "where a network of voxels votes on what is floor, wall or ceiling, on "
          "what is one object and on names of the bundled model; auto: in rooms whose "
          "ceiling was not seen",
          {"auto", "all", "none"});
}

/** What is written besides. */
void
addResults(OptionParser& parser, PipelineOptions& options)
{
  parser
      .text("-report",
            options.report,
            "file of the report, a page for browsers; folder = report.html beside the "
            "other results, none = no report")
      .flag("-ifc", options.ifc, "write building.ifc, a building model (IFC4), too")
      .flag("-map",
            options.map,
            "write map.pgm and map.yaml of each storey, without furniture and with it, "
            "and route graphs, for robots, too")
      .flag("-geojson",
            options.geojson,
            "write building.geojson with rooms, walls, openings and objects, too")
      .number("-epsg",
              options.epsg,
              "EPSG code of the coordinate system of the scan, 0 = not known; for -ifc "
              "and -geojson",
              "",
              Range::between(0, 1e6));
}

/** What is done with the points first. */
void
addPreparation(OptionParser& parser, PipelineOptions& options)
{
  parser
      .number(
          "-points_at_once",
          options.points_at_once,
          "scans with more points are read from disk in parts, so memory depends on "
          "the largest rooms only; 0 = always load all",
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
            "their object is 0");
}

} // namespace

PipelineOptions
pipelineOptions(int argc, const char* const* argv)
{
  PipelineOptions options;
  if (presetOf(argc, argv) == "thesis")
    static_cast<SceneOptions&>(options) = thesisSceneOptions();
  return options;
}

OptionParser
pipelineParser(PipelineOptions& options)
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
                   std::string(scan_files) +
                       "; several, or a folder of them, are the stations of one "
                       "building")
      .positional(
          "output_dir", options.folder, "folder for the results, made if missing");
  addSegmentation(parser, options);
  addResults(parser, options);
  addPreparation(parser, options);
  parser
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
  addOptions(parser, options.stations);
  options.memory.addOption(parser);
  addOptions(parser, options.scan);
  parser.expert({"-voxel_resolution",
                 "-seed_resolution",
                 "-partition",
                 "-preset",
                 "-ignore_normals",
                 "-normals",
                 "-double",
                 "-points_at_once",
                 single_process_option,
                 "-memory_limit"});
  return parser;
}

} // namespace pcl::indoor::tool
