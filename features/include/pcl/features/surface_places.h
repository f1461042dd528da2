/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/oriented_point.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief Number of bins of the distance from the middle of an object, along its
 * longest, its middle and its shortest principal axis; one that is 0: no places. */
struct PlaceBins {
  int longest = 0;
  int middle = 0;
  int shortest = 0;

  /** \brief Each place has a bin for each of six directions of the surface. */
  std::size_t
  size() const
  {
    return static_cast<std::size_t>(longest) * middle * shortest * 6;
  }
};

/** \brief The own axes of an object, which turn with it. */
struct PrincipalFrame {
  Eigen::Vector3d center; ///< the points' mean
  Eigen::Matrix3d axes;   ///< rows: unit vectors, the longest axis first; either sign
};

/** \brief The principal axes of points, at least one. */
PrincipalFrame
principalFrame(const std::vector<OrientedPoint>& points);

/** \brief Histogram of where the surface of an object lies and where it faces.
 *
 * A point counts in the bins of its distances from the middle along the three principal
 * axes, 0 ... scale / 2 each, farther ones in the last; between two bins it is shared
 * linearly. Of that, the share n_a^2 of its normal n goes to axis a, into the bin of
 * "outward" if n, turned away from the centre, points away from the middle along that
 * axis, too, else of "inward". Unlike angles between points, this is told by points
 * with much noise, too. Signs of axes and of normals do not matter. Where two axes
 * are of one length, as in a cube, the points decide by chance which one is longer.
 *
 * The bin is ((i1 * middle + i2) * shortest + i3) * 6 + 2 a + inward. Time: linear.
 * \param[in] points at least one, with normals of unit length
 * \param[in] scale metres, above 0
 * \param[in] bins each above 0
 * \param[in] number_of_threads 0 meaning all; the result does not depend on it
 * \return values that add up to 1
 */
std::vector<double>
surfacePlaces(const std::vector<OrientedPoint>& points,
              double scale,
              const PlaceBins& bins,
              unsigned int number_of_threads = 1);

} // namespace indoor
} // namespace pcl
