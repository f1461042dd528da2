/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/model/wall_image.h>

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace pcl::indoor {

/** \brief An upright rectangle in a wall's side in which the wall's face is not. */
struct FaceHole {
  Eigen::AlignedBox2d box; ///< along the side from its begin, and height, metres
  bool is_proud = false;   ///< whether it stands before the face
  double seen = 0.0;       ///< share in which something before or behind is seen
  double hidden = 0.0;     ///< share in which objects stand before the wall
  double depth = 0.0;      ///< median, before the face, metres; 0 = nothing seen
  double reveal = 0.0;     ///< share of the border, without its lower side, along
                           ///< which something behind the face is seen
  std::array<double, 4> framed{}; ///< left, right, above, below: share with the face
                                  ///< beyond the edge
};

/** \brief Find rectangles without the wall's face, at least 0.3 m wide and high.
 *
 * Connected cells are divided where their upper or lower ends jump: a window beside a
 * glazed door is two. Each edge is then put where the points of the face begin, by the
 * likelihood of their number in each centimetre across it.
 */
PCL_INDOOR_EXPORTS std::vector<FaceHole>
wallHoles(const WallImage& image, const std::vector<WallPoint>& points);

} // namespace pcl::indoor
