/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/oriented_point.h>
#include <pcl/features/pair_sampling.h>
#include <pcl/indoor/exports.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor {

/** \brief Parameters of surfletPairHistogram(). */
struct SurfletPairOptions {
  int bin_count = 5;              ///< bins of each of the four features, 1 to 16
  std::size_t pair_count = 20000; ///< pairs drawn, at least 1
  double scale = 0.0;         ///< metres that the distance spreads over; 0: the extent
  std::uint32_t seed = 5489u; ///< same seed, same pairs
  unsigned int number_of_threads = 1; ///< 0: as many as the machine has
  PairSampling sampling = PairSampling::Uniform;
};

/** \brief The four features of two surflets: alpha, beta, gamma, delta.
 *
 * The origin is the surflet whose normal is the more upright one to the line between
 * the two, so that the frame u = n1, v = (d x u) / |d x u|, w = u x v exists wherever
 * it can: alpha = atan2(w.n2, u.n2), beta = v.n2, gamma = u.d / |d|, delta = |d|. Where
 * both normals lie along the line, the turn around it is undefined and alpha = beta =
 * 0.
 * \param[in] one,two at different positions
 */
PCL_INDOOR_EXPORTS std::array<float, 4>
surfletPairFeatures(const OrientedPoint& one, const OrientedPoint& two);

/** \brief The surflet-pair-relation histogram of an object.
 *
 * E. Wahl, U. Hillenbrand, G. Hirzinger, "Surflet-pair-relation histograms: a
 * statistical 3D-shape representation for rapid classification", 3DIM 2003. The bin of
 * a pair is ((alpha * n + beta) * n + gamma) * n + delta. The same options give the
 * same bits for any number of threads.
 * \param[in] points finite points with normals of unit length, near the origin
 * \param[in] options see SurfletPairOptions
 * \return bin_count^4 values that add up to 1; all NaN if fewer than two points differ
 * in position
 * \throws pcl::BadArgumentException if an option is out of its range
 */
PCL_INDOOR_EXPORTS std::vector<float>
surfletPairHistogram(const std::vector<OrientedPoint>& points,
                     const SurfletPairOptions& options);

/** \brief Say what is wrong with options: "" if nothing, else parameter, value and
 * range. */
PCL_INDOOR_EXPORTS std::string
findProblem(const SurfletPairOptions& options);

} // namespace pcl::indoor
