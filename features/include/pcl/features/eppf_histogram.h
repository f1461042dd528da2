/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/oriented_point.h>
#include <pcl/features/pair_sampling.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief How the two surface angles of a pair become one feature, Sec. 5.2.1
 * and 5.3.2. */
enum class SurfaceAngleRule {
  Maximum,               ///< the larger one, Eq. (5.6)
  Minimum,               ///< the smaller one
  Mean,                  ///< their mean
  RandomOne,             ///< one of the two, drawn at random
  BothInsteadOfOccupancy ///< the first here, the second in place of the occupancy, Eq.
                         ///< (5.13)
};

/** \brief Number of bins of each feature. */
struct EPPFBins {
  int distance = 20;     ///< of f1, N_f1 of the thesis
  int surface_angle = 4; ///< of f2, N_f2
  int normal_angle = 5;  ///< of f3, N_f3
  int occupancy = 3;     ///< of f4, N_f4

  std::size_t
  size() const
  {
    return static_cast<std::size_t>(distance) * surface_angle * normal_angle *
           occupancy;
  }
};

/** \brief A switch per feature; one that is off falls into the first bin always. */
struct EPPFFeatures {
  bool distance = true;
  bool surface_angle = true;
  bool normal_angle = true;
  bool occupancy = true;
};

/** \brief Parameters of eppfHistogram(). */
struct EPPFOptions {
  EPPFBins bins;                  ///< each at least 1
  EPPFFeatures features;          ///< which features are used
  std::size_t pair_count = 20000; ///< pairs drawn, at least 1
  double scale = 0.0;         ///< metres that f1 spreads over; 0: the object's extent
  std::uint32_t seed = 5489u; ///< same seed, same pairs
  unsigned int number_of_threads = 1; ///< 0: as many as the machine has
  double weighting_constant = 1.2;    ///< c of Eq. (5.11), above 1
  bool weighting = true;              ///< whether Eq. (5.11) is applied at all
  SurfaceAngleRule surface_angle_rule = SurfaceAngleRule::Maximum;
  bool oriented_normals = false; ///< whether the sign of a normal means something
  PairSampling sampling = PairSampling::Uniform;
  int grid_size =
      0; ///< voxels per edge of the occupancy grid, 2 to 64; 0: see automaticGridSize()
};

/** \brief The enhanced point pair feature (EPPF) histogram of an object, Sec. 5.2.
 *
 * The bin of a pair is ((i1 * N_f2 + i2) * N_f3 + i3) * N_f4 + i4. Time is linear in
 * pairs and points. The same options give the same bits for any number of threads.
 * \param[in] points finite points with normals of unit length, near the origin
 * \param[in] options see EPPFOptions
 * \return options.bins.size() values that add up to 1; all NaN if fewer than two points
 * differ in position
 * \throws pcl::BadArgumentException if an option is out of its range
 */
std::vector<float>
eppfHistogram(const std::vector<OrientedPoint>& points, const EPPFOptions& options);

/** \brief Voxels per edge for a number of points: sqrt(point_count / 2), within 8
 * ... 64.
 *
 * The surface of an object crosses about 2 * N^2 voxels of a grid of N^3. With this N
 * there is about one point for each of them: in a finer grid the surface has holes that
 * the occupancy takes for free space, and in a coarser one it is blurred.
 */
int
automaticGridSize(std::size_t point_count);

/** \brief Say what is wrong with options: "" if nothing, else parameter, value and
 * range. */
std::string
whatIsWrong(const EPPFOptions& options);

} // namespace indoor
} // namespace pcl
