/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

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

} // namespace pcl::indoor::tool
