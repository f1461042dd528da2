/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

class OptionParser;

/** \brief What is said of the columns of a table of points: the option -columns. */
struct TableColumns {
  std::string names; ///< such as "x,y,z,_,r,g,b"; empty: as the file says

  void
  addOption(OptionParser& parser);
};

/** \brief What becomes of a column of a table. */
struct TableColumn {
  enum class Kind {
    Coordinate, ///< a double
    Real,       ///< a float
    Label,      ///< a whole number of 0 to 2^32 - 1
    Color,      ///< one of the fields r, g, b, a whole number of 0 to 255
    Skipped
  };

  std::string field;
  Kind kind = Kind::Real;
};

/** \brief The columns of some names, as headers have them: x, y, z; r, g, b or red,
 * green, blue; nx or normal_x; intensity; label. Others are fields of these names, and
 * _ is left out. Capitals do not matter.
 * \param[in] where they stand, for the message: "cloud.xyz: line 1"
 * \throws ToolError if there is not one x, y and z
 */
std::vector<TableColumn>
columnsOf(const std::vector<std::string>& names, const std::string& where);

/** \brief The columns of a table that does not name them: x, y, z and what their number
 * says.
 * \param[in] colors whether the last three columns could be colours
 */
std::vector<TableColumn>
columnsByNumber(std::size_t count, bool colors);

/** \brief The words of a list with commas. */
std::vector<std::string>
listedNames(const std::string& list);

} // namespace pcl::indoor::tool
