/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

namespace pcl::indoor {

/** \brief Mean and covariance of vectors, kept as sums, so that those of two sets can
 * be added. */
struct VectorMoments {
  double count = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero(); ///< sum of v * v^T

  void
  add(const Eigen::Vector3d& vector, double weight = 1)
  {
    count += weight;
    sum += weight * vector;
    squares += weight * vector * vector.transpose();
  }

  VectorMoments&
  operator+=(const VectorMoments& other)
  {
    count += other.count;
    sum += other.sum;
    squares += other.squares;
    return *this;
  }

  /** \brief Get the mean; zero if there are none. */
  Eigen::Vector3d
  mean() const
  {
    return count > 0 ? Eigen::Vector3d(sum / count) : Eigen::Vector3d(0, 0, 0);
  }

  /** \brief Get the covariance; zero if there are none. */
  Eigen::Matrix3d
  covariance() const
  {
    if (!(count > 0))
      return Eigen::Matrix3d::Zero();
    const Eigen::Vector3d middle = mean();
    return squares / count - middle * middle.transpose();
  }
};

} // namespace pcl::indoor
