/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/export_options.h"
#include "command_line/options.h"
#include "export/saved_scene.h"
#include "export/scene_files.h"
#include "files/output_file.h"
#include "text/printable.h"

using namespace pcl::indoor::tool;

namespace {

struct Options : ExportOptions {
  std::string scene, output;
};

OptionParser
makeParser(Options& options)
{
  OptionParser parser(
      "pcl_indoor_export",
      "Writes a scene for other programs; the ending of the output says the format: "
      ".ifc, a building model (IFC4); .glb, 3D (glTF); .geojson; .dxf and .svg, plans; "
      ".pgm, maps and route graphs for robots (Nav2).");
  parser
      .positional(
          "scene.json", options.scene, "the scene, as pcl_indoor_pipeline writes it")
      .positional("output",
                  options.output,
                  "the file; of map.pgm also map.yaml, map_furnished.pgm, "
                  "map_furnished.yaml, map_route.geojson, and of storeys above the "
                  "lowest map_storey1.pgm and so on");
  addOptions(parser, options);
  return parser;
}

/** What a scene of an older version lacks. */
void
sayWhatLacks(const std::string& path, const SavedScene& scene)
{
  if (scene.version == 1)
    printWarning(path + ": a scene of version 1 has no walls and windows; doors are "
                        "openings of at most 1.3 m");
}

/** All of them are put in place together, the one that was asked for the last. */
void
save(const std::vector<std::pair<std::string, std::string>>& texts)
{
  std::vector<OutputFile> files;
  for (const auto& [path, bytes] : texts)
    files.push_back(writtenBeside(path, bytes));
  commitTogether(files);
}

} // namespace

int
main(int argc, char** argv)
{
  Options options;
  auto parser = makeParser(options);
  return parser.run(argc, argv, [&](Progress& progress) {
    requireExportFormat(options.output);
    requireWritable(options.output);
    const auto scene = readSavedScene(options.scene);
    sayWhatLacks(options.scene, scene);
    std::vector<std::pair<std::string, std::string>> files;
    try {
      files = exportedFiles(scene, options.output, options);
    } catch (const ToolError& problem) {
      throw ToolError(options.scene + ": " + problem.what());
    }
    progress.start("Saving to " + options.output);
    save(files);
    progress.done();
  });
}
