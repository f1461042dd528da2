/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/progress.h"
#include "objects/labelled_objects.h"

#include <string>

namespace pcl::indoor::tool {

/** \brief loadLabelledObjects(), as a step of a tool. */
LabelledObjects
loadedObjects(const std::string& folder,
              int neighbor_count,
              unsigned int number_of_threads,
              Progress& progress);

} // namespace pcl::indoor::tool
