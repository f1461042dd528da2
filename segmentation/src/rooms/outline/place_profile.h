/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief Counts points along a line and tells where on it the first face across it is:
 * a floor seen from below, a wall or the post of a door seen from the room.
 *
 * The result does not depend on the order of the points; linear time in points and
 * length.
 */
class PlaceProfile {
public:
  /** \param[in] begin,end what lies outside does not count
   * \param[in] width of the crowd of points on a face: some standard deviations of
   * their noise (> 0), in the unit of the places; a fortieth of it is what is told
   * apart
   */
  PlaceProfile(double begin, double end, double width);

  void
  add(double place);

  /** \brief Get the place of the first face.
   *
   * Crowds are windows of the given width. The first that holds at least half as many
   * points as the fullest begins a face; the fullest within one more width is it, and
   * the mean of its points the result. Fewer points before it, outliers and noise, do
   * not move it. \return nothing if no crowd has \a least points
   */
  std::optional<double>
  firstFace(std::uint32_t least) const;

private:
  double begin_;
  double bin_;
  std::vector<std::uint32_t> counts_;
};

} // namespace indoor
} // namespace pcl
