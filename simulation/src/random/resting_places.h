/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/furniture.h>
#include <pcl/simulation/polygon.h>

#include <vector>

namespace pcl::indoor {

/** \brief Where objects can stand on and in a piece of furniture, found by rays. */
class RestingPlaces {
public:
  explicit RestingPlaces(const FurnitureModel& model);

  /** \brief Heights at which an object would rest, ascending: tops, seats, boards.
   * \param[in] footprint of the object in the frame of the piece, four corners, metres
   * \param[in] height of the object: so much is free above
   * \param[in] give how much what carries it may be uneven, metres
   */
  std::vector<double>
  levels(const Polygon& footprint, double height, double give) const;

  /** \brief True if nothing is in the way from the floor up to a height. */
  bool
  isFreeBelow(const Polygon& footprint, double height) const;

private:
  double top_;
  RayTracer tracer_;
  std::vector<bool> is_level_; // of each triangle
};

} // namespace pcl::indoor
