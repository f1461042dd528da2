/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/disjoint_sets.h>
#include <pcl/segmentation/straight_bars.h>

#include "bar_cells.h"
#include "segment_members.h"

#include <pcl/exceptions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace {

using pcl::indoor::CellBox;
using pcl::indoor::DisjointSets;
using pcl::indoor::GridCell;
using pcl::indoor::SegmentMembers;
using pcl::indoor::StraightBarOptions;
using pcl::indoor::SurfaceVoxels;

constexpr float max_tilt = 0.1f;    // of a level bar, sine: 6 degrees
constexpr double min_overlap = 0.5; // of the widths of stretches in line
constexpr int nearest = 2;          // cells away from a bar is beside it
constexpr int farthest = 3;
constexpr double min_plan_share = 0.5; // of the smaller part, below another

/** One box for all that a relation of pairs puts together. */
template <typename Related>
std::vector<CellBox>
united(const std::vector<CellBox>& boxes, const Related& are_related)
{
  DisjointSets sets(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j)
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

/** Finds the bars along the axes of a grid of cells. */
class BarFinder {
public:
  BarFinder(std::vector<GridCell> cells, const StraightBarOptions& options)
  : runs_(std::move(cells))
  , options_(options)
  {}

  std::vector<CellBox>
  barsAlong(int axis) const
  {
    const int across = (axis + 1) % 3, third = (axis + 2) % 3;
    auto stretches =
        united(runs_.thinAlong(axis, options_.min_stretch / options_.voxel_size),
               [&](const CellBox& a, const CellBox& b) {
                 const int shorter = std::min(a.length(axis), b.length(axis));
                 return a.common(b, across) >= 0 && a.common(b, third) >= 0 &&
                        2 * a.common(b, axis) >= shorter;
               });
    auto bars = united(stretches, [&](const CellBox& a, const CellBox& b) {
      const int gap = -a.common(b, axis);
      const int width = std::max(
          {a.length(across), a.length(third), b.length(across), b.length(third)});
      return gap >= 0 && gap <= options_.max_break * width &&
             commonWidth(a, b, across) >= min_overlap &&
             commonWidth(a, b, third) >= min_overlap;
    });
    bars.erase(std::remove_if(bars.begin(),
                              bars.end(),
                              [&](const CellBox& box) { return !isBar(box, axis); }),
               bars.end());
    return bars;
  }

private:
  static double
  commonWidth(const CellBox& a, const CellBox& b, int axis)
  {
    const double both =
        std::max(a.high[axis], b.high[axis]) - std::min(a.low[axis], b.low[axis]) + 1;
    return a.common(b, axis) / both;
  }

  bool
  isBar(const CellBox& box, int axis) const
  {
    const auto [narrow, wide] =
        std::minmax({box.length((axis + 1) % 3), box.length((axis + 2) % 3)});
    const double length = box.length(axis);
    return length * options_.voxel_size >= options_.min_length &&
           length >= options_.min_elongation * wide &&
           wide <= options_.max_flatness * narrow &&
           clearLength(box, axis) >= options_.min_clear * length;
  }

  /** How many cells of its length have nothing beside them. */
  double
  clearLength(const CellBox& box, int axis) const
  {
    const int across = (axis + 1) % 3, third = (axis + 2) % 3;
    std::vector<std::uint8_t> is_clear(static_cast<std::size_t>(box.length(axis)), 1);
    for (const auto& cell : runs_.cells()) {
      const CellBox single{cell, cell};
      const int away =
          1 - std::min(box.common(single, across), box.common(single, third));
      if (box.common(single, axis) == 1 && away >= nearest && away <= farthest)
        is_clear[static_cast<std::size_t>(cell[axis] - box.low[axis])] = 0;
    }
    return static_cast<double>(std::count(is_clear.begin(), is_clear.end(), 1));
  }

  pcl::indoor::CellRuns runs_;
  const StraightBarOptions& options_;
};

/** Takes bars out of segments, and parts what they held together. */
class BarCutter {
public:
  BarCutter(const std::vector<Eigen::Vector3f>& points,
            const SurfaceVoxels& voxels,
            const std::vector<std::uint8_t>& left_out,
            const StraightBarOptions& options,
            std::vector<std::uint32_t>& segment_of_point)
  : voxels_(voxels)
  , options_(options)
  , segment_of_point_(segment_of_point)
  , next_segment_(1 +
                  *std::max_element(segment_of_point.begin(), segment_of_point.end()))
  {
    for (const auto i : voxels.cells.points)
      if (!left_out[i]) {
        members_.push_back(i);
        places_.push_back((options.axes.transpose() * points[i]).cast<double>() /
                          options.voxel_size);
      }
  }

  /** The cells with points, each once, ascending. */
  std::vector<GridCell>
  cells() const
  {
    constexpr std::ptrdiff_t last = 8; // a voxel may lie in as many
    std::vector<GridCell> cells;
    for (const auto& place : places_) {
      const GridCell cell{static_cast<int>(std::floor(place[0])),
                          static_cast<int>(std::floor(place[1])),
                          static_cast<int>(std::floor(place[2]))};
      const auto count = static_cast<std::ptrdiff_t>(cells.size());
      const auto recent = cells.end() - std::min(last, count);
      if (std::find(recent, cells.end(), cell) == cells.end())
        cells.push_back(cell);
    }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return cells;
  }

  /** \return whether the bar was taken out */
  bool
  takeOut(const CellBox& bar)
  {
    SegmentMembers inside;
    std::map<std::uint32_t, double> points_of;
    for (std::size_t k = 0; k < members_.size(); ++k)
      if (holds(bar, places_[k])) {
        inside.push_back(members_[k]);
        ++points_of[segment_of_point_[members_[k]]];
      }
    const bool is_beam = thicknessOf(bar) * options_.voxel_size >= options_.min_beam;
    for (const auto& [segment, count] : points_of)
      if (count > options_.max_share * static_cast<double>(inside.size()) &&
          (!is_beam || count > options_.max_share * sizeOf(segment)))
        return false;
    for (const auto i : inside)
      segment_of_point_[i] = next_segment_;
    ++next_segment_;
    for (const auto& entry : points_of)
      partLoose(entry.first);
    return true;
  }

private:
  static int
  thicknessOf(const CellBox& bar)
  {
    return std::min({bar.length(0), bar.length(1), bar.length(2)});
  }

  double
  sizeOf(std::uint32_t segment) const
  {
    return static_cast<double>(
        std::count_if(members_.begin(), members_.end(), [&](std::uint32_t i) {
          return segment_of_point_[i] == segment;
        }));
  }

  /** The surface may be up to half a cell outside of the cells. */
  static bool
  holds(const CellBox& bar, const Eigen::Vector3d& place)
  {
    for (int axis = 0; axis < 3; ++axis)
      if (place[axis] < bar.low[axis] - 0.5 || place[axis] > bar.high[axis] + 1.5)
        return false;
    return true;
  }

  /** Make segments of the parts that neither touch nor lie above one another. */
  void
  partLoose(std::uint32_t segment)
  {
    SegmentMembers members, voxels;
    for (const auto i : members_)
      if (segment_of_point_[i] == segment) {
        members.push_back(i);
        voxels.push_back(voxels_.cells.cell_of_point[i]);
      }
    std::sort(voxels.begin(), voxels.end());
    voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
    const auto part_of_voxel = partsOf(voxels);
    std::map<std::uint32_t, std::uint32_t> number;
    for (const auto i : members) {
      const auto at = std::lower_bound(
          voxels.begin(), voxels.end(), voxels_.cells.cell_of_point[i]);
      const auto part = part_of_voxel[static_cast<std::size_t>(at - voxels.begin())];
      if (number.empty())
        number.emplace(part, segment);
      else if (number.emplace(part, next_segment_).second)
        ++next_segment_;
      segment_of_point_[i] = number[part];
    }
  }

  /** \param[in] voxels ascending
   * \return the number of its part for each voxel */
  std::vector<std::uint32_t>
  partsOf(const SegmentMembers& voxels) const
  {
    DisjointSets sets(voxels.size());
    const auto& neighbors = voxels_.neighbors;
    for (std::uint32_t k = 0; k < voxels.size(); ++k)
      for (auto j = neighbors.offsets[voxels[k]]; j < neighbors.offsets[voxels[k] + 1];
           ++j) {
        const auto other =
            std::lower_bound(voxels.begin(), voxels.end(), neighbors.targets[j]);
        if (other != voxels.end() && *other == neighbors.targets[j])
          sets.merge(sets.find(k),
                     sets.find(static_cast<std::uint32_t>(other - voxels.begin())));
      }
    const auto touching = sets.labels();
    const auto plans = plansOf(voxels, touching);
    DisjointSets stacks(plans.size());
    for (std::uint32_t a = 0; a < plans.size(); ++a)
      for (std::uint32_t b = a + 1; b < plans.size(); ++b)
        if (areaOf(plans[a].intersection(plans[b])) >=
            min_plan_share * std::min(areaOf(plans[a]), areaOf(plans[b])))
          stacks.merge(stacks.find(a), stacks.find(b));
    std::vector<std::uint32_t> parts;
    parts.reserve(touching.size());
    for (const auto part : touching)
      parts.push_back(stacks.find(part));
    return parts;
  }

  /** The boxes around parts, seen from above. */
  std::vector<Eigen::AlignedBox2f>
  plansOf(const SegmentMembers& voxels, const std::vector<std::uint32_t>& parts) const
  {
    int upright = 0;
    (options_.axes.transpose() * options_.up).cwiseAbs().maxCoeff(&upright);
    const Eigen::Vector2f half =
        Eigen::Vector2f::Constant(static_cast<float>(options_.voxel_size) / 2);
    std::vector<Eigen::AlignedBox2f> plans;
    for (std::size_t k = 0; k < voxels.size(); ++k) {
      if (parts[k] == plans.size())
        plans.emplace_back();
      const Eigen::Vector3f place =
          options_.axes.transpose() * voxels_.centroids[voxels[k]];
      const Eigen::Vector2f level(place[(upright + 1) % 3], place[(upright + 2) % 3]);
      plans[parts[k]].extend(level - half).extend(level + half);
    }
    return plans;
  }

  static float
  areaOf(const Eigen::AlignedBox2f& plan)
  {
    return plan.isEmpty() ? 0 : plan.volume();
  }

  const SurfaceVoxels& voxels_;
  const StraightBarOptions& options_;
  std::vector<std::uint32_t>& segment_of_point_;
  std::uint32_t next_segment_;
  SegmentMembers members_;              // points that are not left out
  std::vector<Eigen::Vector3d> places_; // of the members, along the axes, voxels
};

void
requireValid(std::size_t point_count,
             const SurfaceVoxels& voxels,
             std::size_t flag_count,
             std::size_t segment_count,
             const StraightBarOptions& options)
{
  if (voxels.cells.cell_of_point.size() != point_count || flag_count != point_count ||
      segment_count != point_count)
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        point_count << " points have "
                                    << voxels.cells.cell_of_point.size() << " voxels, "
                                    << flag_count << " flags and " << segment_count
                                    << " segments.");
  if (!(options.voxel_size > 0) || !(options.min_length >= 0) ||
      !(options.min_elongation >= 1) || !(options.max_flatness >= 1) ||
      !(options.min_clear >= 0 && options.min_clear <= 1) ||
      !(options.min_stretch >= 0) || !(options.max_break >= 0) ||
      !(options.max_share >= 0 && options.max_share <= 1) || !(options.min_beam >= 0) ||
      !(std::abs(options.up.norm() - 1) < 1e-3f) ||
      !(options.axes.transpose() * options.axes).isIdentity(1e-3f))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "Bars need positive sizes, ratios of at least 1, shares from 0 "
                        "to 1, orthonormal axes and a unit vector up.");
}

} // namespace

namespace pcl {
namespace indoor {

std::size_t
partAtBars(const std::vector<Eigen::Vector3f>& points,
           const SurfaceVoxels& voxels,
           const std::vector<std::uint8_t>& left_out,
           const StraightBarOptions& options,
           std::vector<std::uint32_t>& segment_of_point)
{
  requireValid(
      points.size(), voxels, left_out.size(), segment_of_point.size(), options);
  if (points.empty())
    return 0;
  BarCutter cutter(points, voxels, left_out, options, segment_of_point);
  const BarFinder finder(cutter.cells(), options);
  std::size_t taken_out = 0;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(options.axes.col(axis).dot(options.up)) <= max_tilt)
      for (const auto& bar : finder.barsAlong(axis))
        taken_out += cutter.takeOut(bar);
  return taken_out;
}

} // namespace indoor
} // namespace pcl
