/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/cloud_endings.h"

#include "formats/file_ending.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <array>
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

bool
hasCloudEnding(const std::string& path)
{
  return std::find(endings.begin(), endings.end(), fileEnding(path)) != endings.end();
}

bool
hasTableEnding(const std::string& path)
{
  return std::find(endings.begin() + first_table, endings.end(), fileEnding(path)) !=
         endings.end();
}

std::string
cloudEndings()
{
  return boost::algorithm::join(
      std::vector<std::string>(endings.begin(), endings.end()), ", ");
}

} // namespace pcl::indoor::tool
