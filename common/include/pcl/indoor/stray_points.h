/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl::indoor {

/** \brief Metres: a float holds half a millimetre where coordinates are smaller. */
constexpr double float_reach = 4096.0;

/** \brief Find points that are no part of a scan, as the zeros of a scanner that saw
 * nothing, in a scan with large coordinates.
 *
 * A stray is more than four kilometres away from the middle of all points along an
 * axis, and 100 times as far as their median: a large scan has none, nor one in
 * millimetres.
 * \param[in] points finite
 * \return their places in \a points, ascending
 */
PCL_INDOOR_EXPORTS std::vector<std::size_t>
strayPoints(const std::vector<Eigen::Vector3f>& points);

/** \brief Take out the values at some places.
 * \param[in] places ascending
 * \param[in,out] values one for each place, or none at all
 */
template <typename Values>
void
takeOut(const std::vector<std::size_t>& places, Values& values)
{
  if (places.empty() || values.empty())
    return;
  auto next = places.begin();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (next != places.end() && *next == i)
      ++next;
    else
      values[kept++] = values[i];
  values.resize(kept);
}

/** \brief Put a value at each place that takeOut() has emptied. */
template <typename Values>
void
putBack(const std::vector<std::size_t>& places,
        const typename Values::value_type& value,
        Values& values)
{
  auto from = values.size();
  values.resize(from + places.size());
  auto to = values.size();
  for (auto place = places.rbegin(); place != places.rend(); ++place) {
    while (to > *place + 1)
      values[--to] = values[--from];
    values[--to] = value;
  }
}

} // namespace pcl::indoor
