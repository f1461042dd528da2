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
addOption(OptionParser& parser, PointCoordinates& coordinates)
{
  parser.flag("-double",
              coordinates.doubles,
              "write x, y, z as doubles, which PCL itself does not read; else doubles "
              "become floats relative to an offset, which the output tells");
}

} // namespace pcl::indoor::tool
