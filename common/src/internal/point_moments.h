/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

namespace pcl::indoor {

/** \brief Sums over positions, near 0: floats suffice for small offsets. */
struct PointMoments {
  float count = 0;
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  float xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0; // of the products

  void
  add(const Eigen::Vector3f& p)
  {
    count += 1;
    sum += p;
    xx += p.x() * p.x();
    xy += p.x() * p.y();
    xz += p.x() * p.z();
    yy += p.y() * p.y();
    yz += p.y() * p.z();
    zz += p.z() * p.z();
  }

  /** \brief REQUIRES: a position. */
  Eigen::Matrix3d
  covariance() const
  {
    const Eigen::Vector3d mean = sum.cast<double>() / count;
    Eigen::Matrix3f squares;
    squares << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    return squares.cast<double>() / count - mean * mean.transpose();
  }
};

} // namespace pcl::indoor
