/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/object_steps.h"

#include <pcl/segmentation/room_objects.h>

#include <cstddef>
#include <functional>

namespace pcl::indoor {

/** \brief Segments points of which no two lie in one place. */
using SegmentDistinct = std::function<DetailedSegmentation(ObjectSegmentationInput)>;

/** \brief segmentObjects() of such points. */
DetailedSegmentation
segmentDistinct(ObjectSegmentationInput input,
                const ObjectSegmentationOptions& options,
                const ProgressCallback& progress = {});

/** \brief Segment each place once; copies of points get what their places have.
 * \throws pcl::BadArgumentException as withoutUnusable() does */
ObjectSegmentation
segmentEachPlace(ObjectSegmentationInput input, const SegmentDistinct& segment);

/** \brief Leave out normals that are none, which are estimated, and the voter of a
 * view, who is not asked.
 * \throws pcl::BadArgumentException if sizes differ, a view has no viewpoint, or the
 * direction up has not the length 1 */
ObjectSegmentationInput
withoutUnusable(ObjectSegmentationInput input);

/** \brief The options to work with. */
ObjectSegmentationOptions
sizedOptions(const ObjectSegmentationInput& input,
             const ObjectSegmentationOptions& given);

/** \brief segmentRoomObjects() by a way of segmenting.
 * \param[in] fewest points of an object, see separateRemainder() */
RoomObjects
roomObjectsBy(const SegmentDistinct& segment,
              RoomPoints room,
              std::size_t fewest,
              const VoxelVoter& voter);

} // namespace pcl::indoor
