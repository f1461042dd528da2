/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/graph/surface_graph.h"
#include "objects/join/piece_graph.h"
#include "objects/structure/object_scene.h"

#include <pcl/indoor/exports.h>
#include <pcl/segmentation/object_segmentation.h>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief What led to the segments of a scene. */
struct ObjectSteps {
  ObjectScene scene; ///< with the points of the input and the voxel size that was used
  std::vector<std::uint8_t> removed; ///< per voxel: non-convex, taken out and recovered
  Supervoxels supervoxels; ///< of the voxels that are in no plane and not removed
  std::vector<SurfaceEdge> edges; ///< between supervoxels
  PieceGraph pieces;              ///< those of the planes have no voxels
};

/** \brief A segmentation that is being made: its own pointer to the steps is null. */
struct DetailedSegmentation : ObjectSegmentation, ObjectSteps {};

/** \brief Hand over a segmentation that was made. */
ObjectSegmentation
published(DetailedSegmentation segmentation);

/** \brief The steps of a segmentation; empty ones where nothing was segmented. */
PCL_INDOOR_EXPORTS const ObjectSteps&
stepsOf(const ObjectSegmentation& segmentation);

} // namespace pcl::indoor
