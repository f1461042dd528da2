/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/export_options.h"

namespace pcl::indoor::tool {

void
addOptions(OptionParser& parser, ExportOptions& options)
{
  parser
      .number("-epsg",
              options.epsg,
              "EPSG code of the coordinate system of the scan, 0 = not known; for .ifc "
              "and .geojson",
              "",
              Range::between(0, 1e6))
      .number("-resolution",
              options.resolution,
              "side of a cell of the maps",
              "m",
              Range::between(0.005, 1.0));
  parser.expert({"-resolution"});
}

} // namespace pcl::indoor::tool
