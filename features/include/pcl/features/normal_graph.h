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

/** \brief Measure how far two normals agree about the side of the surface (Eq. (2.7)).
 *
 * On a smooth surface this is n1.n2. To be right over edges, too, the first normal is
 * carried over to the second position by reflection at the plane midway between them,
 * which turns it along a circle. Carrying tells nothing if the step from one position
 * to the other goes along the normals, as between two layers of noise: the agreement
 * then counts less.
 * \param[in] normal_1, normal_2 unit length, or zero or NaN where there is none
 * \return -1 (different sides) to 1 (same side); 0 if nothing is known
 */
PCL_INDOOR_EXPORTS float
sideAgreement(const Eigen::Vector3f& position_1,
              const Eigen::Vector3f& normal_1,
              const Eigen::Vector3f& position_2,
              const Eigen::Vector3f& normal_2);

/** \brief Turn normals so that neighbours agree about the side of the surface: the
 * graph formulation of Sec. 2.1.5.2, Eq. (2.7). It decides each connected surface but
 * for the side of the whole; that is the one from which most of it faces the viewpoint.
 *
 * Minimises the agreement that is missing, summed over all pairs of neighbours, see
 * findSigns(): exact where neighbours do not contradict each other.
 * \param[in] neighbors which positions lie side by side
 * \param[in] viewpoint one, or none for the middle of the positions, which suits a room
 * seen from within
 * \param[in,out] normals one per position
 * \throws pcl::BadArgumentException if sizes differ
 */
PCL_INDOOR_EXPORTS void
orientConsistently(const std::vector<Eigen::Vector3f>& positions,
                   const Adjacency& neighbors,
                   const std::vector<Eigen::Vector3f>& viewpoint,
                   std::vector<Eigen::Vector3f>& normals);

} // namespace pcl::indoor
