/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace pcl::indoor::tool {

/** \brief From 0 to 1, neither included; the same with every library. */
inline double
uniform(std::mt19937& rng)
{
  return (static_cast<double>(rng()) + 0.5) / 4294967296.0;
}

/** \brief Bring a random choice of values to the front, in random order; the same with
 * every library. REQUIRES: count <= values.size() */
template <typename T>
void
drawToFront(std::vector<T>& values, std::size_t count, std::mt19937& rng)
{
  for (std::size_t k = 0; k < count; ++k)
    std::swap(values[k], values[k + rng() % (values.size() - k)]);
}

} // namespace pcl::indoor::tool
