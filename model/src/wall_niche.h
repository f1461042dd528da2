/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/model/wall_holes.h>

#include <vector>

namespace pcl::indoor {

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
