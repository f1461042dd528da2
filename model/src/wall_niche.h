/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/model/wall_holes.h>

#include <algorithm>
#include <vector>

namespace pcl::indoor {

/** \brief Length of the pieces of an edge that are seen or not: metres, at least three
 * cells. */
inline double
edgePiece(const WallImage& image)
{
  return std::max(0.1, 3.0 * image.cell);
}

/** \brief Let a hole whose frame fills a niche end at the sides of the niche.
 *
 * What the wall's plane was fitted to is no wall then but the frame, and on three sides
 * at least the wall stands out of it.
 * \param[in,out] hole its box and what it is framed by
 */
void
growToNiche(const WallImage& image,
            const std::vector<WallPoint>& points,
            FaceHole& hole);

} // namespace pcl::indoor
