/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/structure/object_scene.h"

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Part flat objects from the horizontal surface that they lie on: keyboards,
 * stacks of paper, the foot of a monitor. No step of the thesis.
 *
 * Such objects are only a few voxels high, too little to show in the normals. But the
 * mean height of the points in a cell tells them from the surface around them. Only the
 * largest horizontal surface of each segment is looked at; one whose box holds more
 * than 2^22 cells is left as it is. The cost is that of sorting heights.
 *
 * \param[in] segment_of_voxel numbered from 0; segments of floor, walls and ceiling
 * stay whole
 * \return one segment per point; the objects follow the segments that were there
 */
std::vector<std::uint32_t>
partFlatObjects(const ObjectScene& scene,
                const std::vector<std::uint32_t>& segment_of_voxel);

} // namespace pcl::indoor
