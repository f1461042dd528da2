/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <string>
#include <string_view>
#include <vector>

namespace pcl::indoor::tool {

/** \brief What separates the words of a line: ';', or ',' unless the line is numbers
 * with decimal commas between blanks, or a tab if there are words with blanks between
 * tabs, else ' ' for blanks and tabs. */
char
separatorOf(std::string_view line);

/** \brief The words of a line, without quotes, in which a separator separates nothing,
 * nor does one at the end. */
void
splitLine(std::string_view line, char separator, std::vector<std::string_view>& words);

/** \brief The value of a word; nan and inf are values, too.
 * \param[in] decimal '.', or ',' for numbers that have such a comma between digits
 * \return whether all of it is a number
 */
PCL_INDOOR_EXPORTS bool
readNumber(std::string_view word, double& value, char decimal = '.');

/** \brief Is it a number, with a point or a comma? */
bool
isNumber(std::string_view word);

/** \brief Is it digits, behind a minus perhaps? */
bool
isWhole(std::string_view word);

/** \brief The names of a header; a unit in brackets belongs to the name before it. */
PCL_INDOOR_EXPORTS std::vector<std::string>
namesOf(const std::vector<std::string_view>& words);

/** \brief Without the blanks around it. */
std::string_view
trimmed(std::string_view text);

/** \brief Does it hold bytes that are no text? Tabs are, and the end of a line. */
bool
hasControlCharacter(std::string_view line);

} // namespace pcl::indoor::tool
