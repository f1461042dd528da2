/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace pcl::indoor {

/** \brief The bin of a value and the neighbour that it is nearest to, with the share of
 * each. */
struct SoftBin {
  std::array<std::uint32_t, 2> bin;
  std::array<float, 2> share;

  /** \brief A bin is 1 wide; within softness / 2 of a border both bins have a share. */
  SoftBin(float place, int count, float softness)
  {
    const float middle = std::clamp(place - 0.5f, 0.0f, static_cast<float>(count - 1));
    const int lower = std::min(static_cast<int>(middle), std::max(count - 2, 0));
    const float past_border = middle - static_cast<float>(lower) - 0.5f;
    const float upper_share = std::clamp(past_border / softness + 0.5f, 0.0f, 1.0f);
    bin = {static_cast<std::uint32_t>(lower),
           static_cast<std::uint32_t>(std::min(lower + 1, count - 1))};
    share = {1.0f - upper_share, upper_share};
  }
};

} // namespace pcl::indoor
