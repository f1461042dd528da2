/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/indoor/point_cells.h> // for Adjacency

#include <Eigen/Core>

#include <vector>

namespace pcl::indoor {

/** \brief Turn normals towards a viewpoint (Eq. (2.6)).
 * \param[in,out] normals one per position
 */
PCL_INDOOR_EXPORTS void
orientTowards(const Eigen::Vector3f& viewpoint,
              const std::vector<Eigen::Vector3f>& positions,
              std::vector<Eigen::Vector3f>& normals);

/** \brief Which side of a surface normals are turned to. */
enum class NormalOrientation {
  Automatic, ///< Viewpoint if one is known, else FreeSpace
  Viewpoint, ///< towards the sensor, Eq. (2.6)
  Graph,     ///< as their neighbours, Eq. (2.7), see orientConsistently()
  FreeSpace  ///< towards the free space between the surfaces
};

struct FreeSpaceOptions {
  double cell_size = 0.06; ///< resolution at which sight is blocked, metres (> 0)
  /** how many places in the free space look at a surface, the nearest ones (>= 1);
   * there are as many for every 60 cubic metres */
  unsigned viewpoints = 12;
  unsigned sample_stride = 3; ///< sight is tested for every n-th position (>= 1)
  unsigned threads = 0;       ///< 0 = automatic; the result does not depend on it
};

/** \brief Turn normals towards the free space that the surfaces were seen from, where
 * the poses of the sensor are not known. Places in the free space vote for the side
 * from which they see a position; votes spread over smooth surfaces (Eq. (2.7)),
 * so that a surface is turned as a whole. Cost is linear in the number of positions
 * times viewpoints.
 * \param[in] positions metres, local frame
 * \param[in] neighbors which positions lie side by side
 * \param[in,out] normals one per position
 */
PCL_INDOOR_EXPORTS void
orientTowardsFreeSpace(const std::vector<Eigen::Vector3f>& positions,
                       const Adjacency& neighbors,
                       const FreeSpaceOptions& options,
                       std::vector<Eigen::Vector3f>& normals);

/** \brief Turn normals in one of these ways.
 * \param[in] viewpoint one, or none if it is not known
 * \throws pcl::BadArgumentException if NormalOrientation::Viewpoint has no viewpoint,
 * or as the ways themselves do
 */
PCL_INDOOR_EXPORTS void
orientNormals(NormalOrientation orientation,
              const std::vector<Eigen::Vector3f>& positions,
              const Adjacency& neighbors,
              const std::vector<Eigen::Vector3f>& viewpoint,
              const FreeSpaceOptions& free_space,
              std::vector<Eigen::Vector3f>& normals);

} // namespace pcl::indoor
