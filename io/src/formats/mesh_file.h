/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"
#include "files/mesh_sampling.h"

#include <pcl/indoor/exports.h>

#include <optional>
#include <string>

namespace pcl::indoor::tool {

enum class MeshFormat { OFF, OBJ, STL, GLB };

/** \brief What kind of mesh a file is, by its first bytes, else by the ending of its
 * name; nothing if it is none of these.
 * \param[in] beginning a few hundred bytes, or fewer if the file is shorter
 */
std::optional<MeshFormat>
meshFormat(const std::string& path, const std::string& beginning);

/** \brief Read an OFF, OBJ, STL or GLB file, see meshFormat(); one that is none of them
 * is taken for OBJ.
 *
 * Faces of more than three corners become fans. Large coordinates, for example of UTM,
 * are moved near the origin by whole units. Of OFF the counts may stand on the line of
 * the header, even without a space, as in files of ModelNet. PCL's own reader of OBJ is
 * not used because it takes damaged files for meshes.
 * \throws ToolError if the file is missing, damaged or truncated, or names vertices
 * that are not there
 */
PCL_INDOOR_EXPORTS Mesh
readMesh(const std::string& path);

/** \brief The mesh of a PLY file whose points were read.
 * \return without triangles if the file is no PLY or has no faces
 * \throws ToolError if its faces are damaged or name vertices that are not there
 */
PCL_INDOOR_EXPORTS Mesh
plyMesh(const CloudFile& file);

} // namespace pcl::indoor::tool
