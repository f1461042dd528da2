/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <algorithm>
#include <string>

namespace pcl::indoor::tool {

/** \brief What an option names, or nothing: it is known before all other options are
 * read, so that their defaults, also in the text of -h, are those that it chooses. */
inline std::string
givenText(int argc, const char* const* argv, const std::string& option)
{
  for (int i = 1; i + 1 < argc; ++i)
    if (argv[i] == option)
      return argv[i + 1];
  return {};
}

/** \brief What -preset names, or nothing. */
inline std::string
presetOf(int argc, const char* const* argv)
{
  return givenText(argc, argv, "-preset");
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
