/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/structure/plane_shadow.h"
#include "objects/structure/room_structure.h"

#include <Eigen/Geometry>

#include <cmath>

namespace pcl::indoor {

/** Cells of a plane, a voxel wide, along two directions of the room. */
class PlaneFrame {
public:
  PlaneFrame(const StructurePlane& plane, const Eigen::Matrix3d& axes, double cell_size)
  : normal_(plane.normal)
  , offset_(plane.offset)
  , cell_size_(cell_size)
  {
    int across = 0;
    (axes.transpose() * normal_).cwiseAbs().maxCoeff(&across);
    const Eigen::Vector3d along = axes.col((across + 1) % 3);
    u_ = (along - along.dot(normal_) * normal_).normalized();
    v_ = normal_.cross(u_);
  }

  /** In front of the plane, voxels. */
  double
  heightOf(const Eigen::Vector3f& point) const
  {
    return (normal_.dot(point.cast<double>()) - offset_) / cell_size_;
  }

  PlaneCell
  cellOf(const Eigen::Vector3f& point) const
  {
    return {indexOf(u_, point), indexOf(v_, point)};
  }

  /** The side of the cells at which another plane stands.
   * \param[in] normal of that plane, into the room */
  PlaneShadow::Side
  sideOf(const Eigen::Vector3d& normal) const
  {
    const double u = u_.dot(normal), v = v_.dot(normal);
    if (std::abs(u) > std::abs(v))
      return u > 0 ? PlaneShadow::LowColumns : PlaneShadow::HighColumns;
    return v > 0 ? PlaneShadow::LowRows : PlaneShadow::HighRows;
  }

  /** The middle of a cell, in the plane. */
  Eigen::Vector3d
  placeOf(const PlaneCell& cell) const
  {
    return offset_ * normal_ + cell_size_ * ((static_cast<double>(cell[0]) + 0.5) * u_ +
                                             (static_cast<double>(cell[1]) + 0.5) * v_);
  }

private:
  std::int64_t
  indexOf(const Eigen::Vector3d& direction, const Eigen::Vector3f& point) const
  {
    return static_cast<std::int64_t>(
        std::floor(direction.dot(point.cast<double>()) / cell_size_));
  }

  Eigen::Vector3d normal_, u_, v_;
  double offset_, cell_size_;
};

} // namespace pcl::indoor
