/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/objects/object_scene.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief Part flat things from the horizontal surface that they lie on: keyboards,
 * stacks of paper, the foot of a monitor. They are lower than a few voxels, so that
 * their sides bend no normals; but the mean height of the many points of a cell tells
 * them from the surface. They lie on it: it goes on around them, and is larger. The
 * largest horizontal surface of each segment is looked at; one whose box holds more
 * than 2^22 cells is left as it is. No step of the thesis. The cost is linear in the
 * number of points, but for a sort of heights.
 * \param[in] segment_of_voxel numbered from 0; segments of floor, walls and ceiling
 * stay whole \return one segment per point; the things follow the segments that were
 * there \throws pcl::BadArgumentException if sizes differ
 */
std::vector<std::uint32_t>
partFlatThings(const ObjectScene& scene,
               const std::vector<std::uint32_t>& segment_of_voxel);

} // namespace indoor
} // namespace pcl
