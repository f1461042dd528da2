/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/structure/object_scene.h"

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Give points of a wall to the closed object that hides the wall there.
 *
 * The back of a wardrobe is flat against the wall, so its points were taken for the
 * wall. But the wall behind a closed object cannot have been seen: these points belong
 * to the object. No step of the thesis.
 *
 * The plane is divided into cells of one voxel. A segment encloses a cell if
 * - it has points over the cell, at least one voxel away from the plane, and
 * - the region of such cells is closed off all around: by cells in which the segment
 *   comes nearer than two voxels to the plane, or by another plane of the structure.
 *
 * A wall that is seen through an open shelf, or under a table, so remains a wall. If
 * several segments enclose a cell, the smallest one gets it.
 *
 * Frames of doors and windows, nearly all of whose points lie within 0.2 m of the
 * plane, get what lies in the plane within their outline, as a leaf or a pane does, but
 * never more than half of the wall. A shelf as flat as that is taken for a frame.
 * Floors and ceilings are never given away.
 *
 * The cost is linear in the points and in the cells of the segments that reach planes.
 * \param[in,out] segment_of_point numbered from 0
 * \return how many points changed sides
 */
std::size_t
yieldEnclosed(const ObjectScene& scene, std::vector<std::uint32_t>& segment_of_point);

} // namespace pcl::indoor
