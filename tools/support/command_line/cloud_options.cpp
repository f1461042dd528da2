/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/cloud_options.h"

namespace pcl::indoor::tool {

void
addOption(OptionParser& parser, TableColumns& columns)
{
  parser.text(
      "-columns",
      columns.names,
      "columns of a table (XYZ, CSV, PTS), such as x,y,z,_,r,g,b, of which _ is "
      "left out; without, as its header says, or by their number");
}

void
addOptions(OptionParser& parser, StationChoice& stations)
{
  parser.text(
      "-stations",
      stations.file,
      "file with the positions of the scanner, x y z in each line, in frame and "
      "unit of the scan; without, as E57, PTX and VIEWPOINT of several files "
      "tell them");
  parser.flag("-ignore_stations",
              stations.is_ignored,
              "do as if it were not known where the scanner stood");
}

void
addOption(OptionParser& parser, PointCoordinates& coordinates)
{
  parser.flag("-double",
              coordinates.doubles,
              "write x, y, z as doubles, which PCL itself does not read; else doubles "
              "become floats relative to an offset, which the output tells");
}

} // namespace pcl::indoor::tool
