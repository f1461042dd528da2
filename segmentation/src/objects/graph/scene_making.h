/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/object_segmentation.h>

namespace pcl {
namespace indoor {

/** \brief Gather the points into voxels with normals, and keep floor, walls and
 * ceiling apart from all else. */
ObjectScene
makeObjectScene(ObjectSegmentationInput input,
                const ObjectSegmentationOptions& options);

} // namespace indoor
} // namespace pcl
