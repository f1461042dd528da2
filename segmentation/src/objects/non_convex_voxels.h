/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/structure/object_scene.h"

#include <pcl/segmentation/object_segmentation.h>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Flag the voxels of concave and noisy regions, Eq. (4.2): the points of the
 * voxels around are counted. Those of the structure are not looked at. */
std::vector<std::uint8_t>
findNonConvexVoxels(const ObjectScene& scene, const ObjectSegmentationOptions& options);

} // namespace pcl::indoor
