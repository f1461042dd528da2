/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/indoor/distinct_points.h>
#include <pcl/indoor/point_hash.h>

#include <algorithm>
#include <array>
#include <tuple>

namespace {

constexpr std::uint32_t free_slot = 0xffffffffu;

/** Of a place: -0 is 0. */
std::uint64_t
placeHash(const Eigen::Vector3f& point)
{
  return pcl::indoor::pointHash(point.array() + 0.0f);
}

/** An entry of the table: most others in its way are told by the hash alone. */
struct Slot {
  std::uint32_t hash = 0;
  std::uint32_t place = free_slot;
};

} // namespace

namespace pcl::indoor {

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
    hashes[i % ahead] = placeHash(points[i]);
    __builtin_prefetch(&slots[hashes[i % ahead] & (size - 1)]);
  };
  for (std::size_t i = 0; i < ahead; ++i)
    look(i);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const auto hash = hashes[i % ahead];
    look(i + ahead);
    const auto short_hash = static_cast<std::uint32_t>(hash >> 32);
    auto at = hash & (size - 1);
    while (slots[at].place != free_slot &&
           (slots[at].hash != short_hash ||
            points[result.first[slots[at].place]] != points[i]))
      at = (at + 1) & (size - 1);
    if (slots[at].place == free_slot) {
      slots[at] = {short_hash, static_cast<std::uint32_t>(result.first.size())};
      result.first.push_back(i);
    }
    result.place.push_back(slots[at].place);
  }
  return result;
}

bool
mayHaveCopies(const std::vector<Eigen::Vector3f>& points)
{
  constexpr std::size_t sample_size = 20000;
  constexpr std::size_t points_per_counter = 16; // on average
  constexpr std::uint32_t crowd = 50; // of points of any places; chance gives up to 40
  if (points.size() <= sample_size)
    return true; // distinctPoints() is as fast
  // Points of one place share their hash, and thus a counter, and are in a sample or
  // not.
  const std::uint64_t most = (std::uint64_t{1} << 32) * sample_size / points.size();
  int size_bits = 4;
  while (points_per_counter << size_bits < points.size())
    ++size_bits;
  std::vector<std::uint32_t> counters(std::size_t{1} << size_bits, 0);
  std::vector<Eigen::Vector3f> sample;
  sample.reserve(2 * sample_size);
  for (const auto& point : points) {
    const auto hash = placeHash(point);
    ++counters[hash >> (64 - size_bits)];
    if ((hash & 0xffffffffu) < most)
      sample.push_back(point);
  }
  constexpr std::size_t fewest = 200; // one of so many: half of DistinctPoints's
  return *std::max_element(counters.begin(), counters.end()) >= crowd ||
         fewest * distinctPoints(sample).copies() > sample.size();
}

} // namespace pcl::indoor
