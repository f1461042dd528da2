/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cctype>
#include <filesystem>
#include <string>

namespace pcl::indoor::tool {

/** \brief The ending of a file's name in small letters, with its dot. */
inline std::string
fileEnding(const std::string& path)
{
  auto ending = std::filesystem::path(path).extension().string();
  for (char& letter : ending)
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return ending;
}

} // namespace pcl::indoor::tool
