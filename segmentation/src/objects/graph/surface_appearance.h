/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

namespace pcl::indoor {

/** \brief What places of a surface look like beside position and normal: the other
 * parts of Eq. (2.18). One column per place; a part that is not used has none. */
struct SurfaceAppearance {
  Eigen::Matrix3Xf colors; ///< L, a and b of CIELab
  Eigen::MatrixXf shapes;  ///< 33 rows: FPFH, not negative, of the sum 1
};

} // namespace pcl::indoor
