/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "pictures/pixel_image.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::indoor::tool {

/** \brief A cloud as a camera sees it: drawn once, coloured as often as wanted. */
class CloudView {
public:
  /** \brief A room from obliquely above, without the surfaces that are seen from
   * behind: the ceiling and the walls on this side.
   * \param[in] points metres, z up; those that are not finite are left out
   * \param[in] normals towards the room, one per point; zero or NaN: seen from any side
   */
  static CloudView
  fromAbove(const std::vector<Eigen::Vector3f>& points,
            const std::vector<Eigen::Vector3f>& normals,
            int width,
            int height);

  /** \brief A single view from its camera at the origin, z forward, y down. */
  static CloudView
  fromCamera(const std::vector<Eigen::Vector3f>& points,
             const std::vector<Eigen::Vector3f>& normals,
             int width,
             int height);

  /** \brief Draw the points in the colours of their labels, lighter where they face the
   * camera.
   * \param[in] labels one per point
   */
  PixelImage
  draw(const std::vector<std::uint32_t>& labels) const;

  /** \brief Count the pixels that show a point. */
  std::size_t
  coveredPixels() const;

private:
  CloudView(int width, int height);

  void
  fill(const std::vector<Eigen::Vector3f>& screen, const std::vector<float>& shades);

  int width_, height_;
  std::vector<std::int64_t> point_of_pixel_; // -1 where there is none
  std::vector<float> shade_of_pixel_;
};

/** \brief Rename predicted labels so that a segment has the number, hence the colour,
 * of the true one that it covers best, and all others have numbers of their own. 0
 * stays. */
std::vector<std::uint32_t>
namedAsTruth(const std::vector<std::uint32_t>& truth,
             const std::vector<std::uint32_t>& predicted);

} // namespace pcl::indoor::tool
