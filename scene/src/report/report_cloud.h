/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "scene/scene_json.h"

#include <nlohmann/json.hpp>

#include <cstddef>

namespace pcl::indoor::tool {

constexpr std::size_t most_report_points = 260000;

/** \brief A thinned cloud for a page: what is in a room or an object, a point per
 * voxel, whose size follows the number of points.
 *
 * Members: points, their number; spacing of the points, metres; lower and step per
 * axis; data, five lists of 16-bit numbers (little-endian, base64), one after the
 * other: x, y, z in steps from lower, room, object. Numbers that do not fit are 0.
 * \param[in] upright points of the scene, z up, metres
 * \param[in] most points at most
 */
nlohmann::ordered_json
thinnedCloud(const Scene& scene,
             const PointCloud<PointXYZ>& upright,
             std::size_t most = most_report_points);

} // namespace pcl::indoor::tool
