/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <future>
#include <optional>
#include <string>

namespace pcl::indoor::tool {

/** \brief Whether this build can draw PNG files of plans: it was built with librsvg. */
bool
canDrawPlans();

/** \brief Begin to draw an SVG drawing, with its fonts, as a PNG file: at twice its
 * size, or smaller if it would be wider or higher than \a most_pixels.
 *
 * A process of its own draws, while this one goes on: libraries for fonts end theirs
 * where memory lacks.
 * \param[in] svg as planSvg() gives it
 * \return the bytes of the file; empty unless canDrawPlans(); a ToolError if it cannot
 * be drawn
 */
std::future<std::string>
drawnAsPng(const std::string& svg, int most_pixels = 10000);

/** \brief The same for results that hold without a picture: nothing unless
 * canDrawPlans(), and nothing but a warning where it cannot be drawn. */
std::future<std::optional<std::string>>
planPicture(const std::string& svg);

} // namespace pcl::indoor::tool
