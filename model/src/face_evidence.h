/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/model/building_model.h>
#include <pcl/model/model_openings.h>
#include <pcl/model/wall_image.h>

#include <vector>

namespace pcl::indoor {

/** \brief How much of a side is seen, column by column of its image. */
struct SeenColumns {
  double cell = 0.0;         ///< width of a column, metres
  std::vector<double> share; ///< of what no object hides, 0 to 1; negative = all hidden
};

/** \brief What of an image shows anything of a wall: its face, or what is a little
 * behind or before it. */
SeenColumns
seenColumns(const WallImage& image);

/** \brief What is known of a side besides its line. */
struct FaceEvidence {
  bool is_wall = true; ///< whether enough of a wall is seen there
  double depth = 0.0;  ///< of windows and outer doors behind it, metres; 0 = not known
};

/** \brief Say of each side whether a wall is there, and how deep its windows and outer
 * doors lie.
 *
 * Outlines of rooms bulge before open doors, stairs and where nothing was seen; there
 * is a side there, but hardly a point on it. A side of which less than half as much is
 * seen as of the sides of its room in general is no wall. Doors and windows, which
 * glass and open leaves leave empty, do not count; nor do passages, but a side that is
 * no more than a passage is no wall.
 * \param[in] columns per side; none = nothing is
 * seen there
 * \param[in] holes per side
 */
std::vector<FaceEvidence>
faceEvidence(const std::vector<WallFace>& faces,
             const std::vector<SeenColumns>& columns,
             const std::vector<FaceHoles>& holes,
             const std::vector<ModelOpening>& openings);

} // namespace pcl::indoor
