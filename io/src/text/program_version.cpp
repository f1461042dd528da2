/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "text/program_version.h"

namespace pcl::indoor::tool {

std::string
programVersion()
{
  return PCL_INDOOR_VERSION;
}

} // namespace pcl::indoor::tool
