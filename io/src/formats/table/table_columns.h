/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief What is said of the columns of a table of points: the option -columns. */
struct TableColumns {
  std::string names; ///< such as "x,y,z,_,r,g,b"; empty: as the file says
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

/** \brief The columns that a list of names or a header tells. */
struct NamedColumns {
  std::vector<TableColumn> columns;
  std::vector<std::string> units; ///< of x, y and z as the names tell, each once
  bool are_plain = true;          ///< x, y and z have just these names
};

/** \brief The columns of some names, as headers have them: x, y, z, or what exporters
 * call these, such as Easting; r, g, b or red, green, blue; nx or normal_x; intensity;
 * label. Others are fields of these names, and _ is left out. Capitals and units in
 * brackets do not matter.
 */
NamedColumns
columnsOf(const std::vector<std::string>& names);

/** \brief Why columns do not tell the place of a point, such as " names no column 'x'";
 * empty if there is one x, y and z. */
std::string
placeProblem(const std::vector<TableColumn>& columns);

/** \brief What -columns could say of a table of which \a columns says too little.
 * \param[in] are_numbers which columns hold numbers
 * \return empty if these are too few for x, y and z
 */
std::string
columnsProposal(const std::vector<TableColumn>& columns,
                const std::vector<bool>& are_numbers);

/** \brief Columns as -columns has them. */
std::string
listOf(const std::vector<TableColumn>& columns);

/** \brief Does a text name a unit of length, as -unit or in words? */
bool
isUnit(const std::string& text);

/** \brief What to say of the units that a header names; empty if these are metres. */
std::string
unitNote(const std::vector<std::string>& units);

/** \brief The words of a list with commas. */
PCL_INDOOR_EXPORTS std::vector<std::string>
listedNames(const std::string& list);

/** \brief Such as "column_4" of the fourth, 3. */
std::string
numberedName(std::size_t column);

} // namespace pcl::indoor::tool
