/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/nearest_sites.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace pcl::indoor {
namespace {

constexpr std::int32_t none = std::numeric_limits<std::int32_t>::max();

/** Nearest site within each line along y, by a forward and a backward sweep. */
void
nearestInLines(const PixelMap<std::uint8_t>& sites, NearestSites& nearest)
{
  for (int x = 0; x < sites.nx; ++x) {
    int last = -1;
    for (int y = 0; y < sites.ny; ++y) {
      if (sites.at(x, y))
        last = y;
      nearest.site.at(x, y) = last;
    }
    last = -1;
    for (int y = sites.ny - 1; y >= 0; --y) {
      if (sites.at(x, y))
        last = y;
      std::int32_t& site = nearest.site.at(x, y);
      if (last >= 0 && (site < 0 || last - y < y - site))
        site = last;
    }
  }
}

/** Lower envelope of the parabolas h[x] + (q - x)^2 along one line. */
class Envelope {
public:
  explicit Envelope(int size)
  : apex_(size)
  , border_(size + 1)
  {}

  void
  build(const std::vector<std::int64_t>& height)
  {
    count_ = 0;
    for (int x = 0; x < static_cast<int>(height.size()); ++x) {
      if (height[x] == none)
        continue;
      double border = -std::numeric_limits<double>::infinity();
      while (count_ > 0) {
        const int other = apex_[count_ - 1];
        const double fx = height[x] + static_cast<double>(x) * x;
        const double fo = height[other] + static_cast<double>(other) * other;
        border = (fx - fo) / (2.0 * (x - other));
        if (border > border_[count_ - 1])
          break;
        --count_;
        border = -std::numeric_limits<double>::infinity();
      }
      apex_[count_] = x;
      border_[count_] = border;
      ++count_;
    }
    at_ = 0;
  }

  /** The lowest parabola's apex at x, -1 without any; x must not go down between calls.
   */
  int
  lowest(int x)
  {
    if (count_ == 0)
      return -1;
    while (at_ + 1 < count_ && border_[at_ + 1] < x)
      ++at_;
    return apex_[at_];
  }

private:
  std::vector<int> apex_;
  std::vector<double> border_;
  int count_ = 0, at_ = 0;
};

} // namespace

NearestSites
nearestSites(const PixelMap<std::uint8_t>& sites)
{
  NearestSites nearest{PixelMap<std::int32_t>::filled(sites.nx, sites.ny, -1),
                       PixelMap<std::int32_t>::filled(sites.nx, sites.ny, none)};
  nearestInLines(sites, nearest);

  Envelope envelope(sites.nx);
  std::vector<std::int64_t> height(sites.nx);
  std::vector<std::int32_t> column(sites.nx);
  for (int y = 0; y < sites.ny; ++y) {
    for (int x = 0; x < sites.nx; ++x) {
      column[x] = nearest.site.at(x, y);
      const std::int64_t d = column[x] - y;
      height[x] = column[x] < 0 ? none : d * d;
    }
    envelope.build(height);
    for (int x = 0; x < sites.nx; ++x) {
      const int from = envelope.lowest(x);
      if (from < 0)
        continue;
      nearest.site.at(x, y) =
          static_cast<std::int32_t>(sites.index(from, column[from]));
      const std::int64_t across = x - from;
      nearest.squared_distance.at(x, y) = static_cast<std::int32_t>(
          std::min<std::int64_t>(height[from] + across * across, none - 1));
    }
  }
  return nearest;
}

NearestSites
nearestLabelled(const PixelMap<std::int32_t>& labels)
{
  auto sites = PixelMap<std::uint8_t>::filled(labels.nx, labels.ny, 0);
  for (std::size_t i = 0; i < labels.size(); ++i)
    sites.values[i] = labels.values[i] != 0;
  return nearestSites(sites);
}

void
growLabels(PixelMap<std::int32_t>& labels, double reach)
{
  const NearestSites nearest = nearestLabelled(labels);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (nearest.site.values[i] >= 0 &&
        nearest.squared_distance.values[i] <= reach * reach)
      labels.values[i] = labels.values[nearest.site.values[i]];
}

} // namespace pcl::indoor
