/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/graph/supervoxel_growing.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace pcl::indoor {

constexpr unsigned recovery_rounds = 20; ///< S of Algorithm 1

/** \brief Spread labels to the places without one, along the surface (Sec. 4.2.3,
 * Algorithm 1). In each round every place without label that touches labelled ones
 * proposes the label of the nearest by Eq. (4.4); the best 80 % (P_r) of the proposals
 * are accepted. All are in the last of 20 rounds (S) and after it, until nothing
 * changes, or until that last round only. Places that touch no labelled one keep none.
 * \param[in] positions one per place
 * \param[in] normals one per place
 * \param[in] neighbors which places touch
 * \param[in,out] labels one per place, Supervoxels::none for places without
 * \param[in] most_rounds no round follows so many
 */
void
recoverLabels(const std::vector<Eigen::Vector3f>& positions,
              const std::vector<Eigen::Vector3f>& normals,
              const Adjacency& neighbors,
              const SurfaceDistance& distance,
              std::vector<std::uint32_t>& labels,
              unsigned most_rounds = std::numeric_limits<unsigned>::max());

/** \brief Give each connected group of places without label a new label of its own.
 * \param[in] next the label of the first group; those after it are used, too
 */
void
labelRemainder(const Adjacency& neighbors,
               std::uint32_t next,
               std::vector<std::uint32_t>& labels);

} // namespace pcl::indoor
