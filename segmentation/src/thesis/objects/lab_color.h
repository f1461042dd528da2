/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

namespace pcl {
namespace indoor {

/** \brief Convert a colour of the standard sRGB (IEC 61966-2-1) to CIELab with the
 * white D65: white is (100, 0, 0). \param[in] rgb red, green and blue, 0 to 255
 */
Eigen::Vector3f
labOfRgb(const Eigen::Vector3f& rgb);

} // namespace indoor
} // namespace pcl
