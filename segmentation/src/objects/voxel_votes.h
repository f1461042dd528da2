/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/structure/room_structure.h"

#include <pcl/indoor/voxel_classes.h>
#include <pcl/segmentation/object_segmentation.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::indoor {

/** What the voter takes the points for, the middles in their frame; empty if it is not
 * to be asked: there is none, or a ceiling was seen. */
VoxelClasses
votesFor(const std::vector<Eigen::Vector3f>& points,
         const std::vector<StructurePlane>& planes,
         const Eigen::Vector3f& up,
         const VoxelVoter& voter);

} // namespace pcl::indoor
