/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/options.h"

#include <string>
#include <vector>

namespace pcl::indoor::python {

/** \brief Options as a tool's command line has them, so that names, ranges and messages
 * are the tool's. */
class Arguments {
public:
  /** \param[in] options for example {"-voxel_size", "0.1"}
   * \param[in] files that the tool's command line has before them */
  explicit Arguments(const std::vector<std::string>& options, std::size_t files = 0)
  : words_(1 + files, "points")
  {
    words_.insert(words_.end(), options.begin(), options.end());
    for (const auto& word : words_)
      pointers_.push_back(word.c_str());
  }

  int
  count() const
  {
    return static_cast<int>(pointers_.size());
  }

  const char* const*
  words() const
  {
    return pointers_.data();
  }

  /** \throws InputError on the first one that is wrong */
  void
  readBy(tool::OptionParser parser) const
  {
    parser.parse(count(), words());
  }

  Arguments(const Arguments&) = delete;
  Arguments&
  operator=(const Arguments&) = delete;

private:
  std::vector<std::string> words_;
  std::vector<const char*> pointers_;
};

} // namespace pcl::indoor::python
