/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "rooms/space/occupancy_grid.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Triangles between neighbouring places of surfaces. */
struct SurfaceTriangles {
  std::vector<Eigen::Vector3f> places;               ///< metres
  std::vector<std::array<std::uint32_t, 3>> corners; ///< places of each, ascending
};

/** \brief Find the triangles that close the surfaces of sparse points.
 *
 * Sparse points leave voxels of a surface free. Voxels large enough to be occupied
 * (closedVoxelSize()) lose narrow rooms and walls; between the triangles' corners small
 * ones are occupied, too. Sec. 3.3.3 and 6.2.1 name sparse points as a limit of the
 * method.
 *
 * The points in a cell are one place, their mean. On one or two planes through a place
 * most places around it must lie, or it is noise: the planes are found by trial, so
 * that both surfaces of an edge are. In each plane a place and its nearest neighbours
 * in two directions next to each other, of eight, are a triangle. A gap is closed that
 * is up to twice as wide as a place's distance to its twelfth neighbour, and at most
 * 0.8 m: doorways are wider.
 * \param[in] points metres, finite
 * \param[in] cell_size edge of the cells, metres (> 0)
 * \param[in] threads 0 = automatic; the result does not depend on it
 */
SurfaceTriangles
surfaceTriangles(const std::vector<Eigen::Vector3f>& points,
                 double cell_size,
                 int threads = 0);

/** \brief Mark the voxels that triangles pass through.
 * \param[in,out] occupancy their grid; the rest of it stays as it is
 */
void
addTriangles(const SurfaceTriangles& triangles, int threads, OccupancyGrid& occupancy);

} // namespace pcl::indoor
