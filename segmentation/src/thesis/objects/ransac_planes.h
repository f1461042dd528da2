/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/structure/room_structure.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Find planes by RANSAC, one after the other, each among the points that those
 * before it left (Sec. 4.3.1.1). A plane goes through three points drawn at random; of
 * 1,000 the one with most points is taken and fitted to them. The result is the same
 * every time.
 * \param[in] distance of a point from its plane, at most, metres
 * \param[in] share the last plane holds at least this share of all points (above 0)
 * \param[out] plane_of_point the number of each point's plane, from 1; 0 = none
 * \return planes whose normals point to where most points are; their voxels are empty
 */
std::vector<StructurePlane>
ransacPlanes(const std::vector<Eigen::Vector3f>& points,
             double distance,
             double share,
             std::vector<std::uint32_t>& plane_of_point);

} // namespace pcl::indoor
