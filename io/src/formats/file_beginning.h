/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstddef>
#include <fstream>
#include <string>

namespace pcl::indoor::tool {

/** \brief The first bytes of a file, by which its format is told, or fewer if the file
 * is shorter or cannot be read. */
inline std::string
beginningOf(const std::string& path, std::size_t bytes = 512)
{
  std::string beginning(bytes, '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(stream.gcount()));
  return beginning;
}

} // namespace pcl::indoor::tool
