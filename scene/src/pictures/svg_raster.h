/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <future>
#include <string>
#include <utility>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Whether this build can draw PNG files: it was built with librsvg. */
PCL_INDOOR_EXPORTS bool
canRasterise();

/** \brief A drawing on its way to a PNG file. */
struct Picture {
  std::string path;
  std::string svg;
  double pixels_per_unit = 2.0; ///< less if it would be more than 10000 wide or high
};

/** \brief Begin to draw pictures, with their fonts.
 *
 * A process of its own draws, while this one goes on: libraries for fonts end theirs
 * where memory lacks.
 * \return path and bytes of each PNG file. No picture is worth a run: where some cannot
 * be drawn, they are missing, and get() prints one warning that names them.
 */
PCL_INDOOR_EXPORTS std::future<std::vector<std::pair<std::string, std::string>>>
rasterised(const std::vector<Picture>& pictures);

/** \brief Draw and save pictures: as PNG, or as SVG where a path ends in .svg. One that
 * cannot be drawn is left out, with a warning. */
PCL_INDOOR_EXPORTS void
savePictures(const std::vector<Picture>& pictures);

} // namespace pcl::indoor::tool
