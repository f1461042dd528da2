/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/graph/surface_voxels.h"
#include "objects/structure/room_structure.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief A scanned room, or a single view, as every step that looks for objects in it
 * sees it. It is made once. */
struct ObjectScene {
  std::vector<Eigen::Vector3f> points;           ///< finite, metres, local frame
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ(); ///< against gravity, unit length
  Capture capture = Capture::Scan;    ///< of a table, the direction up is unknown
  double voxel_size = 0.03;           ///< that was used, metres (> 0)
  unsigned threads = 0;               ///< 0 = automatic; no result depends on it
  SurfaceVoxels voxels;               ///< of the points, with normals
  std::vector<StructurePlane> planes; ///< floor, ceiling and walls; may be empty
  /** per voxel: the number of its plane, from 1; 0 = none */
  std::vector<std::uint32_t> plane_of_voxel;

  /** \brief Get the plane of the voxel of a point, from 1; 0 = none. */
  std::uint32_t
  planeOfPoint(std::size_t point) const
  {
    return plane_of_voxel[voxels.cells.cell_of_point[point]];
  }

  /** \brief Get one flag per voxel: whether it is in a plane. */
  std::vector<std::uint8_t>
  structureFlags() const;
};

/** \brief Tell whether the parts of a scene fit each other and the labels of a step,
 * the voxel size is positive and the direction up is a unit vector.
 * \param[in] label_count labels, one per point
 */
bool
isConsistent(const ObjectScene& scene, std::size_t label_count);

} // namespace pcl::indoor
