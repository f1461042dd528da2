/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace pcl::indoor {

/** \brief Points without their copies: scans that were merged twice, or tiles that
 * overlap, have several points in exactly one place. */
struct PCL_INDOOR_EXPORTS DistinctPoints {
  std::vector<std::uint32_t> first; ///< the first point of each place, ascending
  std::vector<std::uint32_t> place; ///< of each point, a position in first

  /** \brief Get the number of points that lie in the place of an earlier one. */
  std::size_t
  copies() const
  {
    return place.size() - first.size();
  }

  /** \brief Do copies matter? Rounded coordinates give some in most scans; below one of
   * a hundred points they change nothing. */
  bool
  hasCopies() const
  {
    return 100 * copies() >= place.size() && copies() > 0;
  }

  /** \brief Take the values of the first point of each place; no values stay none. */
  template <typename T>
  std::vector<T>
  once(const std::vector<T>& values) const
  {
    std::vector<T> result;
    if (values.empty())
      return result;
    result.reserve(first.size());
    for (const auto i : first)
      result.push_back(values[i]);
    return result;
  }

  /** \brief Take of the values of each place the least: the same for any order of the
   * points. What is not finite is taken where there is nothing else. */
  std::vector<Eigen::Vector3f>
  least(const std::vector<Eigen::Vector3f>& values) const;

  /** \brief Give each point the value of its place; no values stay none. */
  template <typename T>
  std::vector<T>
  forAll(const std::vector<T>& values) const
  {
    std::vector<T> result;
    if (values.empty())
      return result;
    result.reserve(place.size());
    for (const auto i : place)
      result.push_back(values[i]);
    return result;
  }
};

/** \brief Find the points that lie in exactly one place. Linear in the points.
 * \param[in] points finite
 */
PCL_INDOOR_EXPORTS DistinctPoints
distinctPoints(const std::vector<Eigen::Vector3f>& points);

/** \brief A quick look before distinctPoints().
 * \param[in] points finite
 * \return false only if fewer than one of a hundred points are copies (as far as some
 * 20,000 points tell) and no place has a hundred points
 */
PCL_INDOOR_EXPORTS bool
mayHaveCopies(const std::vector<Eigen::Vector3f>& points);

/** \brief distinctPoints() of points whose copies matter; nothing, and sooner, of all
 * others. */
inline std::optional<DistinctPoints>
placesOfCopies(const std::vector<Eigen::Vector3f>& points)
{
  if (!mayHaveCopies(points))
    return {};
  auto places = distinctPoints(points);
  return places.hasCopies() ? std::optional(std::move(places)) : std::nullopt;
}

} // namespace pcl::indoor
