/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::indoor {

/** \brief Counts points along a line and tells where on it the first face across it is:
 * a floor seen from below, a wall or the post of a door seen from the room.
 *
 * The result does not depend on the order of the points; linear time in points and
 * length.
 */
class PlaceProfile {
public:
  /** \param[in] begin,end what lies outside does not count
   * \param[in] width over which the points of one face scatter: some standard
   * deviations of their noise (> 0), in the unit of the places, crowd if these are
   * metres; the resolution is a fortieth of it
   */
  PlaceProfile(double begin, double end, double width);

  void
  add(double place);

  /** \brief Get the place of the first face.
   *
   * A window of the given width is moved along the line. Where it first holds half as
   * many points as it does at most, a face begins. The fullest window within one more
   * width is the face, and the mean of its points the result. Outliers before the face
   * do not move it.
   * \return nothing if no window has \a least points
   */
  std::optional<double>
  firstFace(std::uint32_t least) const;

private:
  double begin_;
  double bin_;
  std::vector<std::uint32_t> counts_;
};

} // namespace pcl::indoor
