/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/cloud_endings.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <vector>

namespace pcl::indoor::tool {
namespace {

constexpr std::size_t first_table = 3;
constexpr std::array<const char*, 11> endings = {".pcd",
                                                 ".ply",
                                                 ".las",
                                                 ".xyz",
                                                 ".txt",
                                                 ".csv",
                                                 ".asc",
                                                 ".pts",
                                                 ".tsv",
                                                 ".xyzn",
                                                 ".xyzrgb"};

} // namespace

std::string
endingOf(const std::string& path)
{
  auto ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return ending;
}

bool
hasCloudEnding(const std::string& path)
{
  return std::find(endings.begin(), endings.end(), endingOf(path)) != endings.end();
}

bool
hasTableEnding(const std::string& path)
{
  return std::find(endings.begin() + first_table, endings.end(), endingOf(path)) !=
         endings.end();
}

std::string
cloudEndings()
{
  return boost::algorithm::join(
      std::vector<std::string>(endings.begin(), endings.end()), ", ");
}

} // namespace pcl::indoor::tool
