/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <string>

namespace pcl::indoor::tool {

/** \brief Is the ending of a file's name that of a cloud: PCD, PLY, LAS or a table? */
bool
hasCloudEnding(const std::string& path);

/** \brief Is it that of a table of points? */
bool
hasTableEnding(const std::string& path);

/** \brief The endings of clouds, for messages: ".pcd, .ply, ...". */
std::string
cloudEndings();

} // namespace pcl::indoor::tool
