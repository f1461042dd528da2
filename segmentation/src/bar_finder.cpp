/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "bar_finder.h"

#include "interval.h"

#include <pcl/segmentation/disjoint_sets.h>

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>

namespace {

using pcl::indoor::CellBox;

constexpr double min_overlap = 0.5; // of the widths of stretches in line
constexpr double min_filled = 0.8;  // of a break between them
constexpr int nearest = 2;          // cells away from a bar is beside it
constexpr int farthest = 3;

/** One box for all that a relation of pairs puts together; such pairs touch or overlap
 * in an axis. */
template <typename Related>
std::vector<CellBox>
united(std::vector<CellBox> boxes, int axis, const Related& are_related)
{
  std::sort(boxes.begin(), boxes.end(), [axis](const CellBox& a, const CellBox& b) {
    return std::tie(a.low[axis], a.low, a.high) < std::tie(b.low[axis], b.low, b.high);
  });
  pcl::indoor::DisjointSets sets(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    for (auto j = i + 1; j < boxes.size() && boxes[i].common(boxes[j], axis) >= 0; ++j)
      if (are_related(boxes[i], boxes[j]))
        sets.merge(sets.find(i), sets.find(j));
  const auto labels = sets.labels();
  std::vector<CellBox> unions;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    if (labels[i] == unions.size())
      unions.push_back(boxes[i]);
    unions[labels[i]].include(boxes[i]);
  }
  return unions;
}

pcl::indoor::Interval
widthOf(const CellBox& box, int axis)
{
  return {static_cast<double>(box.low[axis]), box.high[axis] + 1.0};
}

} // namespace

namespace pcl {
namespace indoor {

BarFinder::BarFinder(std::vector<GridCell> cells, const StraightBarOptions& options)
: runs_(std::move(cells))
, options_(options)
{}

std::vector<CellBox>
BarFinder::barsAlong(int axis) const
{
  const int across = (axis + 1) % 3, third = (axis + 2) % 3;
  const auto stretches =
      united(runs_.thinAlong(axis, options_.min_stretch / options_.voxel_size),
             across,
             [&](const CellBox& a, const CellBox& b) {
               const int shorter = std::min(a.length(axis), b.length(axis));
               return a.common(b, third) >= 0 && 2 * a.common(b, axis) >= shorter;
             });
  auto bars = united(stretches, across, [&](const CellBox& a, const CellBox& b) {
    return areOneBeam(a, b, axis);
  });
  bars.erase(std::remove_if(bars.begin(),
                            bars.end(),
                            [&](const CellBox& box) { return !isBar(box, axis); }),
             bars.end());
  return bars;
}

/** Beams of one width in line, with a break between them that something fills. */
bool
BarFinder::areOneBeam(const CellBox& a, const CellBox& b, int axis) const
{
  const int across = (axis + 1) % 3, third = (axis + 2) % 3;
  const auto [narrow, wide] = std::minmax(
      {a.length(across), a.length(third), b.length(across), b.length(third)});
  const int gap = -a.common(b, axis);
  if (gap <= 0 || gap > options_.max_break * wide ||
      narrow * options_.voxel_size < options_.min_beam ||
      commonShare(widthOf(a, across), widthOf(b, across)) < min_overlap ||
      commonShare(widthOf(a, third), widthOf(b, third)) < min_overlap)
    return false;
  CellBox between = a;
  between.include(b);
  between.low[axis] = std::min(a.high[axis], b.high[axis]) + 1;
  between.high[axis] = between.low[axis] + gap - 1;
  return lengthWith(between, axis, 0, farthest) >= min_filled * gap;
}

bool
BarFinder::isBar(const CellBox& box, int axis) const
{
  const auto [narrow, wide] =
      std::minmax({box.length((axis + 1) % 3), box.length((axis + 2) % 3)});
  const double length = box.length(axis);
  return length * options_.voxel_size >= options_.min_length &&
         length >= options_.min_elongation * wide &&
         wide <= options_.max_flatness * narrow &&
         length - lengthWith(box, axis, nearest, farthest) >=
             options_.min_clear * length;
}

int
BarFinder::lengthWith(const CellBox& box, int axis, int from, int to) const
{
  std::vector<std::uint8_t> is_occupied(static_cast<std::size_t>(box.length(axis)), 0);
  for (const auto& cell : runs_.cells()) {
    const CellBox single{cell, cell};
    const int away = 1 - std::min(box.common(single, (axis + 1) % 3),
                                  box.common(single, (axis + 2) % 3));
    if (box.common(single, axis) == 1 && away >= from && away <= to)
      is_occupied[static_cast<std::size_t>(cell[axis] - box.low[axis])] = 1;
  }
  return static_cast<int>(std::count(is_occupied.begin(), is_occupied.end(), 1));
}

} // namespace indoor
} // namespace pcl
