/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/object_steps.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::indoor {

/** Part pieces where points show what voxels are too coarse for: flat objects from the
 * surface they lie on, and the two sides of narrow gaps. Sets the segments of the
 * points.
 */
void
cutPieces(const std::vector<std::uint32_t>& piece_of_voxel,
          DetailedSegmentation& result);

/** Take the segments for pieces, and join those that are probably one object.
 * \param[in] camera where it was, if the points are a camera's view */
void
joinToObjects(const ObjectSegmentationOptions& options,
              const std::optional<Eigen::Vector3f>& camera,
              DetailedSegmentation& result);

} // namespace pcl::indoor
