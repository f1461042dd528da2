/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"
#include "files/mesh_sampling.h"

#include <pcl/indoor/exports.h>

#include <cstddef>

namespace pcl::indoor::tool {

/** \brief How many points are drawn on a mesh: one per 4 square centimetres if its unit
 * is the metre, at least a hundred thousand, at most two millions. */
std::size_t
surfacePointCount(const Mesh& mesh);

/** \brief Draw points evenly on a mesh, the same each time. They have no normals: which
 * side of a face is the front, many meshes do not tell. Without faces, the vertices are
 * the points.
 * \param[in,out] file gets the points as its cloud, the offset and a note; its path is
 * for errors
 * \throws ToolError if no face has an area
 */
void
drawPoints(const Mesh& mesh, CloudFile& file);

/** \brief The points of a mesh, see readMesh() and drawPoints(). */
void
loadMesh(CloudFile& file, const TableColumns& columns);

/** \brief A scan of surfaces: as loadCloud(), but of a PLY with faces that its vertices
 * do not cover, points drawn on the faces.
 *
 * The vertices of a mesh that was made of a scan are as dense as the scan; those of
 * walls that are a few large triangles are not. Faces count by their area: they are
 * covered if those of a typical place are as many as would lie 0.1 m apart, where
 * drawPoints() puts one per 0.02 m.
 */
PCL_INDOOR_EXPORTS CloudFile
loadSurface(const std::string& path,
            const TableColumns& columns = {},
            std::size_t least_points = 2);

} // namespace pcl::indoor::tool
