/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/options.h"
#include "files/point_coordinates.h"
#include "files/station_choice.h"
#include "formats/table/table_columns.h"

namespace pcl::indoor::tool {

/** \brief What the tools read, as -h says it. */
constexpr const char* scan_files =
    "scan (PCD, PLY, LAS, LAZ, E57, PTX or table) or mesh, which may be packed";

/** \brief The option -columns. */
void
addOption(OptionParser& parser, TableColumns& columns);

/** \brief The options -stations and -ignore_stations. */
void
addOptions(OptionParser& parser, StationChoice& stations);

/** \brief The option -double. */
void
addOption(OptionParser& parser, PointCoordinates& coordinates);

} // namespace pcl::indoor::tool
