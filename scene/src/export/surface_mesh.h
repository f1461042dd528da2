/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "export/saved_scene.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Triangles, counter-clockwise from outside; a corner is of one face only. */
struct SurfaceMesh {
  std::vector<Eigen::Vector3f> corners, normals;
  std::vector<std::uint32_t> triangles; ///< three corners each
};

/** \brief What rings enclose at a height, seen from above. */
SurfaceMesh
flatMesh(const std::vector<PlanRing>& rings, double height);

/** \brief Add an upright prism over the corners of a convex ring, which go
 * counter-clockwise. */
void
addPrism(SurfaceMesh& mesh, const PlanRing& corners, double bottom, double top);

/** \brief A wall with holes where its openings are.
 * \param[in] index of the wall in the scene */
SurfaceMesh
wallMesh(const SavedScene& scene, std::size_t index);

} // namespace pcl::indoor::tool
