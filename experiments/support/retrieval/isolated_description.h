/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Describe objects in a child process that may be killed by an assertion.
 *
 * PCL's OUR-CVFH aborts on some objects. The child then is started again after the
 * object that ended it, whose histogram stays empty; so it does if \a describe throws.
 * \param[in] describe gives the histogram of object k
 * \return one histogram per object
 * \throws ToolError if no process can be started
 */
std::vector<std::vector<float>>
describeIsolated(std::size_t object_count,
                 const std::function<std::vector<float>(std::size_t k)>& describe);

} // namespace pcl::indoor::tool
