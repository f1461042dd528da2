/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/objects/object_scene.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief Give what closed objects hide of a wall back to them. The back of a wardrobe
 * is flat against the wall and was taken for it, but a wall behind a closed object
 * cannot have been seen; nor can a wall in front of a window that stands in it: that is
 * the window's own face. A cell of a plane, a voxel wide, is enclosed by a segment,
 * from either side, if the segment covers it, at least one voxel from the plane, and if
 * no way over cells that are covered leads out of it but over cells where the segment
 * is less than two voxels from the plane, or where another plane of the structure
 * begins. So a wall that is seen through an open shelf, or under a table, remains a
 * wall. Frames of doors and windows, all but a twentieth of them within 0.2 m of the
 * plane, cover what is within them: what lies there in the plane of the wall is a leaf
 * or a pane; but not more than half of the wall. A shelf as flat as that is taken for a
 * frame. Segments of which less than a tenth is across the plane are no closed objects,
 * but doubles of it. Where several segments enclose a cell, the smallest one gets it.
 * Floor and ceiling only end walls: what stands on a floor hides it, but does not own
 * it. No step of the thesis. The cost is linear in the points and in the cells of the
 * segments that reach planes.
 * \param[in,out] segment_of_point numbered from 0
 * \return how many points changed sides
 * \throws pcl::BadArgumentException if sizes differ
 */
std::size_t
yieldEnclosed(const ObjectScene& scene, std::vector<std::uint32_t>& segment_of_point);

} // namespace indoor
} // namespace pcl
