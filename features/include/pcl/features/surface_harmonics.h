/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/oriented_point.h>
#include <pcl/indoor/exports.h>

#include <cstddef>
#include <vector>

namespace pcl::indoor {

/** \brief How many values surfaceHarmonics() gives, and of what; all 0: none. */
struct HarmonicBins {
  int shells = 0;    ///< around the middle of an object, 0 ... 64
  int degree = 0;    ///< of the finest spherical harmonics, 0 ... 8
  int distances = 0; ///< finer shells, for the distance from the middle alone, 0 ... 64

  /** \brief Spherical harmonics of a shell. */
  std::size_t
  functionCount() const
  {
    return static_cast<std::size_t>((degree + 1) * (degree + 1));
  }

  /** \brief Each function has a bin for each of three axes that the surface faces, and
   * one for all of the surface. */
  std::size_t
  size() const
  {
    return 4 * static_cast<std::size_t>(shells) * functionCount() + distances;
  }
};

/** \brief The own axes of an object, which turn with it. */
struct PrincipalFrame {
  Eigen::Vector3d center;
  Eigen::Matrix3d axes; ///< rows: unit vectors, the longest axis first; either sign
};

/** \brief The principal axes of points, at least one.
 * \param[in] middle_share the centre lies that share of the way from the points' mean
 * to the middle of their extents along the axes, 0 ... 1. The middle depends less on
 * how many points each side has, the mean less on single points.
 */
PCL_INDOOR_EXPORTS PrincipalFrame
principalFrame(const std::vector<OrientedPoint>& points, double middle_share = 0.0);

/** \brief Where the surface of an object lies and which way it faces, by magnitudes of
 * spherical harmonics.
 *
 * Points count in shells around the centre that reach from 0 to 0.6 scales, linearly
 * shared between neighbouring ones; farther ones in the last. The mean over all points
 * of share * n_a^2 * Y_lm(direction from the centre) is a coefficient for each shell,
 * axis a of the frame and real spherical harmonic Y_lm (mean square 1 over the sphere);
 * n is the normal, whose squares along the axes add up to 1, so that the sum over the
 * axes is that of the surface without its normals. As every Y_lm is either even or odd
 * when an axis is turned over, the magnitude of a coefficient does not depend on the
 * signs of the axes, and there is no need to choose them, although coefficients of odd
 * functions tell what is not symmetric. They are smooth functions of the points: noise
 * lowers those of high degree in all objects alike.
 *
 * The bin of (shell, a, l, m) is (4 * shell + a) * functionCount() + l^2 + l + m, of
 * the sum over the axes that of a = 3; cosines are m >= 0, sines m < 0, around the
 * shortest axis. Then the distances follow: the share of the points in each of these
 * shells. To each value 0.002 is added, a tenth of what chance gives with 2,000 points:
 * the ratio of smaller values tells nothing. Where two axes are of one length the
 * points decide by chance which one is longer. Time: linear.
 * \param[in] points at least one, with normals of unit length
 * \param[in] frame see principalFrame()
 * \param[in] scale metres, above 0
 * \param[in] bins at least one
 * \param[in] number_of_threads 0 meaning all; the result does not depend on it
 * \return bins.size() values that add up to 1
 */
PCL_INDOOR_EXPORTS std::vector<double>
surfaceHarmonics(const std::vector<OrientedPoint>& points,
                 const PrincipalFrame& frame,
                 double scale,
                 const HarmonicBins& bins,
                 unsigned int number_of_threads = 1);

} // namespace pcl::indoor
