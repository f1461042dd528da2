/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <algorithm>
#include <cstddef>

namespace pcl::indoor {

/** \brief Get the value that most of them are, of equally frequent ones the smallest.
 * \param[in,out] values are put into ascending order
 * \param[in] otherwise what is returned if there are none
 */
template <typename Values, typename Value>
Value
mostFrequent(Values& values, Value otherwise)
{
  std::sort(values.begin(), values.end());
  std::ptrdiff_t most = 0;
  for (auto begin = values.begin(); begin != values.end();) {
    const auto end = std::upper_bound(begin, values.end(), *begin);
    if (end - begin > most) {
      most = end - begin;
      otherwise = *begin;
    }
    begin = end;
  }
  return otherwise;
}

} // namespace pcl::indoor
