/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/outline/place_profile.h"

#include <algorithm>

namespace pcl::indoor {
namespace {

constexpr std::size_t bins_per_width = 40;

} // namespace

PlaceProfile::PlaceProfile(double begin, double end, double width)
: begin_(begin)
, bin_(width / bins_per_width)
, counts_(bins_per_width + static_cast<std::size_t>(std::max(0.0, end - begin) / bin_))
{}

void
PlaceProfile::add(double place)
{
  const double bin = (place - begin_) / bin_;
  if (bin >= 0.0 && bin < static_cast<double>(counts_.size()))
    ++counts_[static_cast<std::size_t>(bin)];
}

std::optional<double>
PlaceProfile::firstFace(std::uint32_t least) const
{
  std::vector<std::uint64_t> crowds; // by their first bin
  std::uint64_t crowd = 0;
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    crowd += counts_[i];
    if (i + 1 < bins_per_width)
      continue;
    crowds.push_back(crowd);
    crowd -= counts_[i + 1 - bins_per_width];
  }
  const std::uint64_t fullest = *std::max_element(crowds.begin(), crowds.end());
  if (fullest < std::max(least, 1u))
    return std::nullopt;
  const auto begins = std::find_if(
      crowds.begin(), crowds.end(), [&](auto count) { return 2 * count >= fullest; });
  const auto reach =
      std::min<std::ptrdiff_t>(crowds.end() - begins, bins_per_width + 1);
  const std::size_t first = std::max_element(begins, begins + reach) - crowds.begin();
  double sum = 0.0;
  for (std::size_t i = first; i < first + bins_per_width; ++i)
    sum += counts_[i] * (static_cast<double>(i) + 0.5);
  return begin_ + bin_ * sum / static_cast<double>(crowds[first]);
}

} // namespace pcl::indoor
