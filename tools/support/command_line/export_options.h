/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/options.h"
#include "export/scene_files.h"

namespace pcl::indoor::tool {

/** \brief The options of how a scene is written for other programs. */
void
addOptions(OptionParser& parser, ExportOptions& options);

} // namespace pcl::indoor::tool
