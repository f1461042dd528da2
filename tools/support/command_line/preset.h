/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <algorithm>
#include <string>

namespace pcl::indoor::tool {

/** \brief What -preset names, or nothing: it is known before all other options are
 * read, so that their defaults, also in the text of -h, are those of the preset. */
inline std::string
presetOf(int argc, const char* const* argv)
{
  for (int i = 1; i + 1 < argc; ++i)
    if (std::string(argv[i]) == "-preset")
      return argv[i + 1];
  return {};
}

/** \brief Whether a flag is given: known before all other options are read. */
inline bool
isGiven(int argc, const char* const* argv, const std::string& flag)
{
  return std::any_of(argv + 1, argv + std::max(argc, 1), [&](const char* word) {
    return flag == word;
  });
}

} // namespace pcl::indoor::tool
