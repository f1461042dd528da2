/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/table/table_columns.h"

#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief What the columns of a table are that does not name them, as their values say.
 *
 * The first three are x, y, z, after a column that only counts the rows or has seconds
 * since 1970 or 1980, if one does.
 * Behind them are normals, if nearly all have the length 1; colours, if all are of 0 to
 * 1, or whole numbers of 0 to 255 or 65535; an intensity beside nothing, normals or
 * colours. Others get numbers.
 * \param[in] columns those that hold no numbers are skipped
 * \param[in] values row by row
 */
std::vector<TableColumn>
columnsByValues(const std::vector<TableColumn>& columns,
                const std::vector<double>& values);

/** \brief Whether the first column, a coordinate with more than two beside it, rises
 * and never falls, as times do and coordinates of sorted points.
 * \param[in] values row
 * by row
 */
bool
isFirstLikeTime(const std::vector<TableColumn>& columns,
                const std::vector<double>& values);

/** \brief Make the colours of a table whole numbers of 0 to 255: those of 0 to 1 where
 * one is a fraction, and those of 0 to 65535 where one exceeds 255.
 * \param[in,out] values row by row; of columns of colours, of 0 to 65535
 * \return what was done, for a note; empty if they had this range
 */
std::string
scaleColors(const std::vector<TableColumn>& columns, std::vector<double>& values);

} // namespace pcl::indoor::tool
