/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/object_steps.h"

namespace pcl {
namespace indoor {

/** \brief segmentObjects() of points of which nobody asks again whether some are
 * copies.
 */
DetailedSegmentation
segmentDistinct(ObjectSegmentationInput input,
                const ObjectSegmentationOptions& options,
                const ProgressCallback& progress = {});

} // namespace indoor
} // namespace pcl
