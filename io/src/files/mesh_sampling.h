/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/oriented_point.h>
#include <pcl/indoor/exports.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor::tool {

/** \brief A surface of triangles. */
struct Mesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices of vertices
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();    ///< was subtracted from them
  bool y_is_up = false;                                ///< its format says so
};

/** \brief Draw points on a mesh, evenly over its area.
 *
 * The area is cut into \a count parts of the same size in the order of the triangles,
 * and a point is drawn in each, so that a triangle gets its share of the points but for
 * less than two. Normals are the triangles', by the order of their corners. Triangles
 * without an area, or with a corner that is not finite, get no point.
 * \param[in] seed same seed, same points
 * \return count points, in the order of the triangles
 * \throws pcl::BadArgumentException if a triangle names a vertex that is not there or
 * none has an area
 */
PCL_INDOOR_EXPORTS std::vector<OrientedPoint>
sampleMesh(const Mesh& mesh, std::size_t count, std::uint32_t seed);

} // namespace pcl::indoor::tool
