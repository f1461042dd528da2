/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "simulation/simulation_options.h"

#include "files/cloud_writer.h"

namespace pcl::indoor::tool {

OptionParser
simulationParser(SimulationOptions& options)
{
  OptionParser parser(
      "pcl_scan_simulation",
      "Builds the rooms and furniture of a plan file and scans them with "
      "a moving range sensor; every point gets the fields room, object, "
      "part and category.");
  parser
      .positional(
          "plan.json",
          options.plan_file,
          "plan of the building, or random:home:SEED, random:office:SEED, "
          "random:table:SEED, with :cluttered behind it for many small objects, "
          "or :lived_in for belongings and furniture of all shapes")
      .positional("output.pcd|ply", options.output_file, "the scan");
  addScannerOptions(parser, options.scanner);
  parser
      .number("-leaf",
              options.leaf_size,
              "keep one point per cube of this edge, 0 = all",
              "m",
              Range::atLeast(0.0))
      .number("-lean",
              options.lean,
              "angle of all that leans in the plan, -1 = as the plan says",
              "degrees",
              Range::between(-1.0, 45.0))
      .number("-lean_towards",
              options.lean_towards,
              "direction in which the whole building leans, counter-clockwise from +x, "
              "-1 = the walls that the plan names lean",
              "degrees",
              Range::between(-1.0, 360.0))
      .text(
          "-view",
          options.view,
          "X,Y,Z in m, where a depth camera stands: what it sees at once, an organised "
          "cloud in its frame; random: from one of the positions, drawn by -seed, to "
          "an object; options of the moving sensor's rays do not count")
      .text(
          "-target", options.target, "X,Y,Z in m, in the middle of the view from X,Y,Z")
      .text("-json", options.json_file, "file for the names of rooms and objects")
      .text(
          "-stations_out",
          options.stations_file,
          "file for the positions of the sensor, x y z in each line, as -stations of "
          "other tools takes them; the field station tells from 1 from which of them a "
          "point was measured");
  parser.expert({"-lean", "-lean_towards", "-view", "-target"});
  return parser;
}

void
requireUsable(const SimulationOptions& options)
{
  if (options.leaf_size > 0 && options.leaf_size < 0.001)
    throw ToolError("-leaf must be 0 or at least 0.001 m, not " +
                    std::to_string(options.leaf_size) + " m");
  for (const double angle : {options.lean, options.lean_towards})
    if (angle < 0 && angle != -1)
      throw ToolError("-lean and -lean_towards must be -1 or at least 0 degrees, not " +
                      std::to_string(angle) + " degrees");
  if (options.lean_towards >= 0 && options.lean < 0)
    throw ToolError("-lean_towards needs -lean");
  if (options.scanner.name != "sphere" && !options.view.empty())
    throw ToolError("-view looks with a camera, not with -scanner " +
                    options.scanner.name);
  if (!options.stations_file.empty() &&
      (!options.view.empty() || options.scanner.name == hand_camera))
    throw ToolError("-stations_out has no positions of a camera");
  requireWritableCloud(options.output_file);
  if (!options.json_file.empty())
    requireWritable(options.json_file);
  if (!options.stations_file.empty())
    requireWritable(options.stations_file);
}

} // namespace pcl::indoor::tool
