/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <string>

namespace pcl::indoor::tool {

/** \brief The version of this project, for example "0.1.0". */
std::string
programVersion();

} // namespace pcl::indoor::tool
