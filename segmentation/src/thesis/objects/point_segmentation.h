/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/object_steps.h"

#include <pcl/segmentation/thesis.h>

namespace pcl::indoor {

/** \brief Segment a scene as Sec. 4.2 does, on points: see
 * thesis::PointOptions. Each point is a voxel of the result's scene.
 * \param[in] options that were checked, with points
 * \param[in] progress as for thesis::segmentObjects()
 */
DetailedSegmentation
segmentOnPoints(ObjectSegmentationInput input,
                const thesis::ObjectOptions& options,
                const ProgressCallback& progress);

} // namespace pcl::indoor
