/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/io/input_error.h>

namespace pcl::indoor::tool {

using ToolError = InputError;

} // namespace pcl::indoor::tool
