/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "command_line/cloud_options.h"
#include "command_line/options.h"
#include "files/cloud_file.h"
#include "files/sampled_surface.h"
#include "segmentation/object_settings.h"
#include "text/printable.h"

#include <string>

using namespace pcl::indoor::tool;

namespace {

constexpr double bytes_per_point = 350; // that are in use at once, measured

} // namespace

int
main(int argc, char** argv)
{
  auto settings = objectSettings(argc, argv);
  OptionParser parser("pcl_noise_resilient_lccp",
                      "Segment the scan of a room into objects with "
                      "pcl::NoiseResilientLCCP; adds the fields object and structure.");
  parser.positional("input", settings.input, scan_files)
      .positional("output.pcd|ply",
                  settings.output,
                  "the input with the fields object, 0 = not finite or an outlier, and "
                  "structure: 1 floor, 2 wall, 3 ceiling, 4 remainder (too small to be "
                  "told), 0 anything else");
  addOptions(parser, settings);
  return parser.run(argc, argv, [&](Progress& progress) {
    requireWritableCloud(settings.output);
    requireFitting(settings);
    settings.memory.require(settings.input, bytes_per_point);
    progress.start("Loading " + settings.input);
    CloudFile file = loadSurface(settings.input, settings.columns);
    printNotes(file);
    progress.done(std::to_string(file.points->size()) + " points");

    progress.start("Segmenting objects");
    const auto found = segmentObjects(choicesOf(settings), file, printWarning);
    progress.done(std::to_string(found.count) + " objects");

    appendField(file.cloud, "object", found.object_of_point);
    appendField(file.cloud, "structure", found.structure_of_point);
    settings.colors.apply(file, "object");
    settings.coordinates.apply(file, settings.output);
    progress.start("Saving " + settings.output);
    saveCloud(settings.output, file.cloud, file.pose);
    Progress::conclude([&] {
      progress.done();
      progress.summary(settings.output + ": " + std::to_string(found.count) +
                       " objects");
    });
  });
}
