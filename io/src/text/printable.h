/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <cstddef>
#include <exception>
#include <string>

namespace pcl::indoor::tool {

/** \brief A character of UTF-8; one byte, and no code, where there is none. */
struct Character {
  std::size_t size = 1;
  bool is_valid = false;
  unsigned long code = 0;
};

/** \brief The character that begins at a byte of a text. */
PCL_INDOOR_EXPORTS Character
characterAt(const std::string& text, std::size_t at);

/** \brief A text as one line for a terminal.
 *
 * Names and words of files may hold anything. UTF-8 stays; line feeds become blanks,
 * and bytes that a terminal could act on, or that are no text, become "\x1b" and so on.
 * \param[in] most bytes; of a longer text the middle is left out
 */
PCL_INDOOR_EXPORTS std::string
printable(const std::string& text, std::size_t most = 1000);

/** \brief A number with so many digits behind the point, whatever the locale. */
PCL_INDOOR_EXPORTS std::string
fixedText(double value, int digits);

/** \brief A number with so many digits in all, or fewer. */
PCL_INDOOR_EXPORTS std::string
shortText(double value, int digits);

/** \brief What an exception says to a user: without the names of functions, source
 * files and exceptions that libraries put in front. */
PCL_INDOOR_EXPORTS std::string
messageOf(const std::exception& error);

/** \brief Print what is wrong as one line on stderr: "[program] text". */
PCL_INDOOR_EXPORTS void
printComplaint(const std::string& program, const std::string& text);

/** \brief Print "Warning: " and the text, printable, as one line on stderr. */
PCL_INDOOR_EXPORTS void
printWarning(const std::string& text);

} // namespace pcl::indoor::tool
