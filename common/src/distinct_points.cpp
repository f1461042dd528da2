/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/indoor/distinct_points.h>
#include <pcl/indoor/point_hash.h>

#include <array>
#include <tuple>

namespace {

constexpr std::uint32_t none = 0xffffffffu;

/** An entry of the table: most others in its way are told by the hash alone. */
struct Slot {
  std::uint32_t hash = 0;
  std::uint32_t place = none;
};

} // namespace

namespace pcl {
namespace indoor {

std::vector<Eigen::Vector3f>
DistinctPoints::least(const std::vector<Eigen::Vector3f>& values) const
{
  const auto key = [](const Eigen::Vector3f& v) {
    return std::make_tuple(!v.allFinite(), v.x(), v.y(), v.z());
  };
  auto result = once(values);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (key(values[i]) < key(result[place[i]]))
      result[place[i]] = values[i];
  return result;
}

DistinctPoints
distinctPoints(const std::vector<Eigen::Vector3f>& points)
{
  DistinctPoints result;
  result.first.reserve(points.size());
  result.place.reserve(points.size());
  std::size_t size = 16;
  while (size < 2 * points.size())
    size *= 2;
  std::vector<Slot> slots(size);
  // The table is larger than the caches: what comes next is fetched ahead.
  constexpr std::size_t ahead = 16;
  std::array<std::uint64_t, ahead> hashes{};
  const auto look = [&](std::size_t i) {
    if (i >= points.size())
      return;
    hashes[i % ahead] = pointHash(points[i].array() + 0.0f); // -0 is 0
    __builtin_prefetch(&slots[hashes[i % ahead] & (size - 1)]);
  };
  for (std::size_t i = 0; i < ahead; ++i)
    look(i);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const auto hash = hashes[i % ahead];
    look(i + ahead);
    const auto short_hash = static_cast<std::uint32_t>(hash >> 32);
    auto at = hash & (size - 1);
    while (slots[at].place != none &&
           (slots[at].hash != short_hash ||
            points[result.first[slots[at].place]] != points[i]))
      at = (at + 1) & (size - 1);
    if (slots[at].place == none) {
      slots[at] = {short_hash, static_cast<std::uint32_t>(result.first.size())};
      result.first.push_back(i);
    }
    result.place.push_back(slots[at].place);
  }
  return result;
}

} // namespace indoor
} // namespace pcl
