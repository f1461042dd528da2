/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/open_plan.h"

#include "rooms/space/map_regions.h"
#include "rooms/space/visibility.h"

#include <algorithm>
#include <vector>

namespace pcl::indoor {
namespace {

/** Pixels of a space, evenly spread over it. */
std::vector<Eigen::Vector3i>
somePixels(const std::vector<std::vector<std::uint32_t>>& pixels,
           const std::vector<std::int32_t>& space,
           int ny)
{
  constexpr std::size_t enough = 64; // pixels: the lines between tell a percent
  std::vector<std::uint32_t> all;
  for (const auto label : space)
    all.insert(all.end(), pixels[label].begin(), pixels[label].end());
  const std::size_t count = std::min(enough, all.size());
  std::vector<Eigen::Vector3i> some;
  for (std::size_t k = 0; k < count; ++k) {
    const auto pixel = static_cast<int>(all[(2 * k + 1) * all.size() / (2 * count)]);
    some.emplace_back(pixel / ny, pixel % ny, 0);
  }
  return some;
}

} // namespace

PixelMap<std::int32_t>
fillIslands(PixelMap<std::int32_t> rooms)
{
  auto empty = PixelMap<std::uint8_t>::filled(rooms.nx, rooms.ny, 0);
  for (std::size_t i = 0; i < rooms.size(); ++i)
    empty.values[i] = rooms.values[i] == 0;
  forEachRegion(empty, Neighbours::Eight, [&](const auto& part) {
    std::int32_t around = 0; // the room around the part
    bool is_island = true;
    for (const std::size_t pixel : part) {
      const int x = static_cast<int>(pixel / rooms.ny);
      const int y = static_cast<int>(pixel % rooms.ny);
      is_island = is_island && x > 0 && y > 0 && x + 1 < rooms.nx && y + 1 < rooms.ny;
      forEachNeighbour(rooms, pixel, Neighbours::Eight, [&](std::size_t other) {
        const std::int32_t room = rooms.values[other];
        if (room == 0)
          return;
        is_island = is_island && (around == 0 || around == room);
        around = room;
      });
    }
    if (is_island)
      for (const std::size_t pixel : part)
        rooms.values[pixel] = around;
  });
  return rooms;
}

OpenPlan::OpenPlan(const PixelMap<std::int32_t>& labels,
                   const PixelMap<float>& field,
                   double pixel_size,
                   const OpenPlanOptions& options)
: options_(options)
, pixel_area_(pixel_size * pixel_size)
{
  walls_.shape = {labels.nx, labels.ny, 1};
  walls_.values.resize(field.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    walls_.values[i] = !(field.values[i] > 0);
    const auto label = static_cast<std::size_t>(labels.values[i]);
    if (label >= pixels_.size()) {
      pixels_.resize(label + 1);
      width_.resize(label + 1, 0.0);
    }
    if (label == 0)
      continue;
    pixels_[label].push_back(static_cast<std::uint32_t>(i));
    width_[label] = std::max(width_[label], 2.0 * field.values[i]);
  }
}

double
OpenPlan::area(const std::vector<std::int32_t>& space) const
{
  double area = 0.0;
  for (const auto label : space)
    area += pixel_area_ * static_cast<double>(pixels_[label].size());
  return area;
}

bool
OpenPlan::isHabitable(const std::vector<std::int32_t>& space) const
{
  double width = 0.0;
  for (const auto label : space)
    width = std::max(width, width_[label]);
  return area(space) >= options_.habitable_area &&
         area(space) <= options_.max_elongation * width * width;
}

double
OpenPlan::sharedView(const std::vector<std::int32_t>& a,
                     const std::vector<std::int32_t>& b) const
{
  const auto from = somePixels(pixels_, a, walls_.shape.ny);
  const auto to = somePixels(pixels_, b, walls_.shape.ny);
  std::size_t open = 0;
  for (const auto& p : from)
    for (const auto& q : to)
      open += lineOfSight(walls_, p, q);
  const std::size_t lines = from.size() * to.size();
  return lines > 0 ? static_cast<double>(open) / static_cast<double>(lines) : 0.0;
}

bool
OpenPlan::separates(const std::vector<std::int32_t>& a,
                    const std::vector<std::int32_t>& b) const
{
  return isHabitable(a) && isHabitable(b) &&
         sharedView(a, b) <= options_.max_shared_view;
}

} // namespace pcl::indoor
