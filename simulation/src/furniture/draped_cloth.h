/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/furniture.h>

namespace pcl::indoor {

/** \brief Lay a cloth over what stands below it.
 *
 * It lies on what it covers, hangs down beside it, and ends at the piece's lowest
 * point. Folds run over it.
 * \param[in] supports triangles in the frame of the piece, metres
 * \param[in] size width, depth and height of the piece: the cloth covers its footprint
 * \param[in] seed of its thickness and folds
 * \return the cloth; no part if nothing holds it
 */
FurnitureModel
drapeCloth(const std::vector<Triangle>& supports,
           const Eigen::Vector3d& size,
           std::uint32_t seed);

} // namespace pcl::indoor
