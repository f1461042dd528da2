/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/outline/opening_posts.h"

#include "rooms/dimensions.h"
#include "rooms/outline/place_profile.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor {
namespace {

// beside a border, metres: thicker walls hold no labels
constexpr double deepest = RoomMapOptions{}.reach;
constexpr std::uint32_t least = 6;  // fewer points are outliers
constexpr double along_reach = 4.0; // pixels from the ends that voxels say: objects
                                    // beside a post close some

} // namespace

OpeningPosts::OpeningPosts(const std::vector<RegionOpening>& openings,
                           const OccupancyGrid& occupancy,
                           const RoomMap& map)
: openings_(openings)
, occupancy_(occupancy)
, map_(map)
, turn_(occupancy.turn())
, is_near_(map.labels.size(), 0)
, seen_(openings.size())
{
  const VoxelBits& grid = occupancy.grid;
  floor_ = grid.origin.z() + grid.voxel_size * (map.first_layer + map.range.begin);
  for (std::size_t k = 0; k < openings.size(); ++k) {
    const auto& [x, y] = std::make_pair(openings[k].x, openings[k].y);
    const double half = 0.5 * openings[k].width / grid.voxel_size;
    const double radius = std::hypot(half + along_reach, deepest / grid.voxel_size);
    for (int u = std::max(0, int(x - radius)); u < grid.shape.nx && u <= x + radius;
         ++u)
      for (int v = std::max(0, int(y - radius)); v < grid.shape.ny && v <= y + radius;
           ++v) {
        const std::size_t pixel = static_cast<std::size_t>(u) * grid.shape.ny + v;
        is_near_[pixel] = 1;
        near_.emplace_back(pixel, k);
      }
  }
  std::sort(near_.begin(), near_.end());
}

void
OpeningPosts::add(const Eigen::Vector3f& point, std::int32_t cell)
{
  const VoxelBits& grid = occupancy_.grid;
  const std::size_t pixel = cell / grid.shape.nz;
  if (cell < 0 || !is_near_[pixel])
    return;
  const double height = point.z() - floor_;
  const bool in_slab = map_.inSlab(pixel, cell % grid.shape.nz);
  const bool at_posts = height >= sill_height && height <= passage_height;
  if (!in_slab && !at_posts)
    return;
  const Eigen::Vector2d place =
      turn_ * point.head<2>().cast<double>() - grid.origin.head<2>();
  for (auto it = std::lower_bound(
           near_.begin(), near_.end(), std::make_pair(pixel, std::size_t{0}));
       it != near_.end() && it->first == pixel;
       ++it) {
    const RegionOpening& opening = openings_[it->second];
    const Eigen::Vector2d from =
        place - grid.voxel_size * Eigen::Vector2d(opening.x, opening.y);
    const double along = opening.along.dot(from);
    const double beside = from.x() * opening.along.y() - from.y() * opening.along.x();
    const double beyond = std::abs(along) - 0.5 * opening.width;
    if (std::abs(beside) > deepest)
      continue;
    Seen& seen = seen_[it->second];
    if (in_slab && beyond < 0.0)
      seen.lintel.push_back(beside);
    if (at_posts && std::abs(beyond) <= along_reach * grid.voxel_size)
      seen.posts[along > 0].emplace_back(std::abs(along), beside);
  }
}

std::pair<double, double>
OpeningPosts::wall(const Seen& seen) const
{
  PlaceProfile from_one(-deepest, deepest, crowd), from_other(-deepest, deepest, crowd);
  for (const double beside : seen.lintel) {
    from_one.add(beside);
    from_other.add(-beside);
  }
  const auto one = from_one.firstFace(least), other = from_other.firstFace(least);
  const double reach = 2.0 * occupancy_.grid.voxel_size;
  if (!one || -*other - *one < 0.5 * crowd) // no lintel, or one side of it only
    return {-reach, reach};
  return {*one, -*other};
}

void
OpeningPosts::add(const OpeningPosts& other)
{
  const auto append = [](const auto& from, auto& to) {
    to.insert(to.end(), from.begin(), from.end());
  };
  for (std::size_t k = 0; k < seen_.size(); ++k) {
    append(other.seen_[k].lintel, seen_[k].lintel);
    for (std::size_t side = 0; side < seen_[k].posts.size(); ++side)
      append(other.seen_[k].posts[side], seen_[k].posts[side]);
  }
}

std::pair<double, double>
OpeningPosts::ends(std::size_t opening) const
{
  const Seen& seen = seen_[opening];
  const double half = 0.5 * openings_[opening].width;
  const double reach = along_reach * occupancy_.grid.voxel_size;
  const auto [one, other] = wall(seen);
  // The faces of the wall itself tell only roughly where it ends.
  const double margin = std::min(0.5 * crowd, 0.25 * (other - one));
  const auto post = [&, one = one, other = other](int side) {
    for (const double beside : {-margin, 0.5 * crowd}) {
      PlaceProfile profile(half - reach, half + reach, crowd);
      for (const auto& place : seen.posts[side])
        if (place.y() >= one - beside && place.y() <= other + beside)
          profile.add(place.x());
      if (const auto face = profile.firstFace(least))
        return *face;
    }
    return half;
  };
  return {post(1), post(0)};
}

} // namespace pcl::indoor
