/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"
#include "formats/table/table_columns.h"

#include <pcl/indoor/exports.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The endings of names of tables, such as ".xyz". */
const std::vector<std::string>&
tableEndings();

/** \brief Is a file a table of points, a row of numbers each (XYZ, TXT, CSV, PTS)? By
 * the ending of its name, else by its first rows.
 * \param[in] beginning of the file, 512 bytes if it has as many
 */
PCL_INDOOR_EXPORTS bool
isTable(const std::string& path, const std::string& beginning);

/** \brief How many points a table has: the number before its rows, else about as many
 * as its length and that of its first row let expect. */
std::uint64_t
tablePointCount(const std::string& path, const std::string& beginning);

/** \brief Read a table of points.
 *
 * Numbers are separated by blanks and tabs, by commas or by semicolons; decimals may
 * have commas where these separate nothing. Lines that begin with # or // are left out,
 * unless they name the columns; a line may name the columns, one may hold the number of
 * points. Coordinates are doubles, rgb packed as in PCD files, labels unsigned
 * integers, all else floats, see columnsOf() and columnsByValues().
 * Parts that follow each other, each behind the number of its points, are scans from
 * several stations: they get the field station, from 1, unless a column has its name.
 * \param[in,out] file gets the points, the stations of several parts, which have no
 * positions, and notes on how the table was taken
 * \throws ToolError naming the line that cannot be read
 */
void
loadTable(CloudFile& file, const TableColumns& columns);

} // namespace pcl::indoor::tool
