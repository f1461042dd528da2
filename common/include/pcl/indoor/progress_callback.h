/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <functional>

namespace pcl::indoor {

/** \brief Is told what share of the work is done, 0 ... 1 and never less than before,
 * and what comes next; returns whether to go on. */
using ProgressCallback = std::function<bool(double share, const char* stage)>;

} // namespace pcl::indoor
