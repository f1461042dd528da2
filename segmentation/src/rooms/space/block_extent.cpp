/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/block_extent.h"

#include <pcl/indoor/flood_fill.h>
#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/quantile.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace pcl::indoor {

namespace {

using Block = Eigen::Vector3i;

constexpr int key_bits = 21;
constexpr int half = 1 << (key_bits - 1); // blocks to either side of the origin

std::uint64_t
packed(std::uint64_t x, std::uint64_t y, std::uint64_t z)
{
  return x << 2 * key_bits | y << key_bits | z;
}

/** \brief The key of a block; what is more than a million blocks away is clamped. */
std::uint64_t
keyOf(const Block& block)
{
  const auto part = [](int v) {
    return static_cast<std::uint64_t>(std::clamp(v, -half, half - 1) + half);
  };
  return packed(part(block.x()), part(block.y()), part(block.z()));
}

/** \brief The key of the block around a point. */
std::uint64_t
keyOf(const Eigen::Vector3f& point, double scale)
{
  // Not negative after the shift, so that the cast is the floor.
  const auto part = [&](float v) {
    const double shifted = scale * v + half;
    return static_cast<std::uint64_t>(
        std::min(std::max(shifted, 0.0), 2.0 * half - 1.0));
  };
  return packed(part(point.x()), part(point.y()), part(point.z()));
}

Block
blockOf(std::uint64_t key)
{
  const auto part = [&](int shift) {
    return static_cast<int>(key >> shift & (2 * half - 1)) - half;
  };
  return {part(2 * key_bits), part(key_bits), part(0)};
}

/** \brief Counts per key, in an open hash table that grows. */
class BlockCounts {
public:
  BlockCounts()
  : slots_(1 << 12)
  {}

  std::uint32_t&
  operator[](std::uint64_t key)
  {
    Slot& slot = slots_[find(key)];
    if (slot.key == key)
      return slot.count;
    if (2 * (used_ + 1) > slots_.size()) {
      grow();
      return (*this)[key];
    }
    ++used_;
    slot.key = key;
    return slot.count;
  }

  /** \brief The count of a block, or null if it has none. */
  const std::uint32_t*
  lookUp(std::uint64_t key) const
  {
    const Slot& slot = slots_[find(key)];
    return slot.key == key ? &slot.count : nullptr;
  }

  /** \brief All blocks and their counts in ascending order of the keys. */
  std::vector<std::pair<std::uint64_t, std::uint32_t>>
  sorted() const
  {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> blocks;
    blocks.reserve(used_);
    for (const Slot& slot : slots_)
      if (slot.key != empty)
        blocks.emplace_back(slot.key, slot.count);
    std::sort(blocks.begin(), blocks.end());
    return blocks;
  }

private:
  static constexpr std::uint64_t empty = ~std::uint64_t{0};

  struct Slot {
    std::uint64_t key = empty;
    std::uint32_t count = 0;
  };

  std::size_t
  find(std::uint64_t key) const
  {
    const std::size_t mask = slots_.size() - 1;
    std::size_t place = (key * 0x9e3779b97f4a7c15u >> 32) & mask;
    while (slots_[place].key != key && slots_[place].key != empty)
      place = (place + 1) & mask;
    return place;
  }

  void
  grow()
  {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old)
      if (slot.key != empty)
        slots_[find(slot.key)] = slot;
  }

  std::vector<Slot> slots_;
  std::size_t used_ = 0;
};

/** \brief Counts of the blocks seen last, one place for each block of a building of
 * usual size: no search in the table for most points.
 */
class RecentCounts {
public:
  explicit RecentCounts(BlockCounts& table)
  : table_(table)
  , slots_(1 << 15)
  {}

  void
  add(std::uint64_t key)
  {
    // 64 x 64 x 8 blocks by the last bits of the coordinates
    const std::uint64_t place =
        (key >> 2 * key_bits & 63) << 9 | (key >> key_bits & 63) << 3 | (key & 7);
    Slot& slot = slots_[place];
    if (slot.key != key) {
      if (slot.count > 0)
        table_[slot.key] += slot.count;
      slot.key = key;
      slot.count = 0;
    }
    ++slot.count;
  }

  void
  flush()
  {
    for (const Slot& slot : slots_)
      if (slot.count > 0)
        table_[slot.key] += slot.count;
  }

private:
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t count = 0;
  };

  BlockCounts& table_;
  std::vector<Slot> slots_;
};

using SortedBlocks = std::vector<std::pair<std::uint64_t, std::uint32_t>>;

SortedBlocks
countBlocks(const std::vector<Eigen::Vector3f>& points, int threads)
{
  const auto count = static_cast<std::ptrdiff_t>(points.size());
  constexpr double scale = 1.0 / block_size;
  BlockCounts all;
  constexpr std::ptrdiff_t chunk = 1 << 16;
  parallelFor((count + chunk - 1) / chunk,
              threads,
              1,
              [] { return BlockCounts(); },
              [&](BlockCounts& own, std::ptrdiff_t k) {
                RecentCounts recent(own);
                for (auto i = k * chunk; i < std::min(count, (k + 1) * chunk); ++i)
                  recent.add(keyOf(points[i], scale));
                recent.flush();
              },
              [&all](const BlockCounts& own) {
                for (const auto& [key, points_in_block] : own.sorted())
                  all[key] += points_in_block;
              });
  return all.sorted();
}

/** \brief Drop the blocks that do not count for the extent. */
void
dropSparse(SortedBlocks& blocks)
{
  constexpr double few = 0.02; // of the median block's points: strays
  std::vector<std::uint32_t> counts;
  counts.reserve(blocks.size());
  for (const auto& block : blocks)
    counts.push_back(block.second);
  const double least = few * median(counts);
  const auto sparse = [&](const auto& block) { return block.second < least; };
  blocks.erase(std::remove_if(blocks.begin(), blocks.end(), sparse), blocks.end());
}

/** \brief A connected part of the cloud. */
struct Part {
  std::uint64_t points = 0;
  double blocks = 0.0;
  Eigen::Array3d low;
  Eigen::Array3d high; // upper corner of the last block
};

void
addBlock(Part& part, const Block& block, std::uint32_t points)
{
  const Eigen::Array3d low = block.cast<double>().array();
  part.low = part.points == 0 ? low : part.low.min(low).eval();
  part.high = part.points == 0 ? low + 1.0 : part.high.max(low + 1.0).eval();
  part.points += points;
  part.blocks += 1.0;
}

/** \brief The parts that are connected over faces, edges and corners of blocks. */
std::vector<Part>
connectedParts(const SortedBlocks& blocks)
{
  BlockCounts numbers;
  for (std::size_t b = 0; b < blocks.size(); ++b)
    numbers[blocks[b].first] = static_cast<std::uint32_t>(b);
  std::vector<char> seen(blocks.size(), 0);
  std::vector<std::size_t> members;
  const auto for_each_neighbor = [&](std::size_t b, const auto& visit) {
    const Block block = blockOf(blocks[b].first);
    for (int n = 0; n < 27; ++n) {
      const Block step(n / 9 - 1, n / 3 % 3 - 1, n % 3 - 1);
      if (const std::uint32_t* other = numbers.lookUp(keyOf(block + step)))
        visit(*other);
    }
  };
  std::vector<Part> parts;
  for (std::size_t start = 0; start < blocks.size(); ++start) {
    if (seen[start])
      continue;
    Part part;
    seen[start] = 1;
    members.assign(1, start);
    pcl::indoor::floodFill(members, for_each_neighbor, [&](auto other, auto) {
      return !std::exchange(seen[other], 1);
    });
    for (const auto member : members)
      addBlock(part, blockOf(blocks[member].first), blocks[member].second);
    parts.push_back(part);
  }
  return parts;
}

/** \brief Take parts into the box, largest first, while they are worth the space. */
Part
mergeWorthwhile(std::vector<Part> parts)
{
  std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
    return a.points > b.points;
  });
  Part kept = parts.front();
  parts.erase(parts.begin());
  const auto takes = [&](const Part& part) {
    const Eigen::Array3d low = kept.low.min(part.low);
    const Eigen::Array3d high = kept.high.max(part.high);
    const double growth = (high - low).prod() - (kept.high - kept.low).prod();
    if (growth > most_growth * part.blocks)
      return false;
    kept.low = low;
    kept.high = high;
    return true;
  };
  for (std::size_t before = 0; before != parts.size();) {
    before = parts.size(); // a part that was too far may be near now
    std::vector<Part> left;
    for (const auto& part : parts)
      if (!takes(part))
        left.push_back(part);
    parts.swap(left);
  }
  return kept;
}

} // namespace

Box
blockExtent(const std::vector<Eigen::Vector3f>& points, int threads)
{
  SortedBlocks blocks = countBlocks(points, threads);
  dropSparse(blocks);
  const Part kept = mergeWorthwhile(connectedParts(blocks));
  // The noise of a surface on the border of a block lies in a block too sparse to
  // count.
  constexpr double noise = 0.5;
  Box box;
  box.low = (kept.low - noise).matrix() * block_size;
  box.high = (kept.high + noise).matrix() * block_size;
  return box;
}

} // namespace pcl::indoor
