/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/options.h"
#include "scene/coordinate_options.h"
#include "scene/point_colors.h"

#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The option -colour.
 * \param[in] labels for example room, object; the first is what auto means where the
 * input has no colours */
void
addOption(OptionParser& parser,
          PointColors& colors,
          const std::vector<std::string>& labels);

/** \brief The options -unit and -up. */
void
addOptions(OptionParser& parser, CoordinateOptions& coordinates);

/** \brief The option -up alone. */
void
addUpOption(OptionParser& parser, CoordinateOptions& coordinates);

} // namespace pcl::indoor::tool
