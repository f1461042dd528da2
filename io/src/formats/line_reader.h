/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

namespace pcl::indoor::tool {

/** \brief Reads the lines of a text file from any of them on, without blank ones. Holds
 * a piece of the file. */
class LineReader {
public:
  /** A line: where it begins, and which of the file it is, from 1. */
  struct Place {
    std::uint64_t byte = 0, line = 1;
  };

  /** \throws ToolError if the file cannot be read */
  explicit LineReader(const std::string& path);

  const std::string&
  path() const
  {
    return path_;
  }

  /** \brief The next line that is not blank, without its end; valid until the next
   * call.
   * \return false behind the last one
   * \throws ToolError if it is longer than any
   * line of numbers */
  bool
  next(std::string_view& line);

  /** \brief Where the line is that next() gave. */
  const Place&
  place() const
  {
    return place_;
  }

  /** \brief Go on with a line. */
  void
  seek(const Place& place);

private:
  /** \return false if all of the file was read */
  bool
  refill();

  std::string path_;
  std::ifstream stream_;
  std::string buffer_;
  std::size_t at_ = 0; ///< of the next line in the buffer
  Place place_, next_;
};

} // namespace pcl::indoor::tool
