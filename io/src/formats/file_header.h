/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <Eigen/Core>

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The text in front of a cloud file's points. */
struct FileHeader {
  std::vector<std::vector<std::string>> lines; ///< their words; none empty, no comments
  Eigen::Vector3d offset = Eigen::Vector3d::Zero(); ///< of a comment, see offsetText()
  std::uintmax_t body_begin = 0; ///< bytes from the beginning of the file
};

std::vector<std::string>
wordsOf(const std::string& line);

/** \brief Read the lines up to and including the one that begins with the word \a
 * last.
 * \throws ToolError if there is none
 */
FileHeader
readFileHeader(std::istream& stream, const std::string& last, const std::string& path);

/** \brief The text of a comment that says what has to be added to x, y and z of the
 * points: "offset 691234 5334567 0". */
std::string
offsetText(const Eigen::Vector3d& offset);

/** \brief The shortest text that is read back as the same number. */
PCL_INDOOR_EXPORTS std::string
shortestText(float value);
PCL_INDOOR_EXPORTS std::string
shortestText(double value);

/** \brief A whole number of a header, at most 2^31 - 1.
 * \param[in] what the line that it stands in, for the message
 * \throws ToolError if the word is none
 */
std::uint64_t
headerCount(const std::string& word, const std::string& what, const std::string& path);

/** \brief Complain that a file's points cannot be read. */
[[noreturn]] void
throwDamaged(const std::string& path);

/** \brief Complain that a file has less than its header promises. */
[[noreturn]] void
throwTruncated(const std::string& path,
               std::uint64_t promised,
               std::uint64_t found,
               const std::string& unit);

} // namespace pcl::indoor::tool
