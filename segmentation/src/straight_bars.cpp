/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/disjoint_sets.h>
#include <pcl/segmentation/straight_bars.h>

#include "bar_finder.h"
#include "segment_members.h"

#include <pcl/exceptions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace {

using pcl::indoor::CellBox;
using pcl::indoor::DisjointSets;
using pcl::indoor::GridCell;
using pcl::indoor::SegmentMembers;
using pcl::indoor::StraightBarOptions;
using pcl::indoor::SurfaceVoxels;

constexpr float max_tilt = 0.1f;       // of a level bar, sine: 6 degrees
constexpr double min_plan_share = 0.5; // of the smaller part, below another
constexpr std::uint32_t min_part = 8;  // voxels
constexpr double min_of_others = 0.01; // of a bar, in what it runs through

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
  , size_of_(1 + *std::max_element(segment_of_point.begin(), segment_of_point.end()), 0)
  , is_held_(voxels.size(), 0)
  {
    const Eigen::Matrix3d to_axes =
        options.axes.transpose().cast<double>() / options.voxel_size;
    Eigen::Array3d lowest =
        Eigen::Array3d::Constant(std::numeric_limits<double>::max());
    for (const auto i : voxels.cells.points)
      if (!left_out[i]) {
        members_.push_back(i);
        ++size_of_[segment_of_point[i]];
        places_.emplace_back(to_axes * points[i].cast<double>());
        lowest = lowest.min(places_.back().array());
      }
    for (auto& place : places_) // cells are numbered by small integers
      place.array() -= lowest.floor();
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
    std::map<std::uint32_t, double> points_of;
    double count = 0;
    for (std::size_t k = 0; k < members_.size(); ++k)
      if (holds(bar, places_[k])) {
        ++points_of[segment_of_point_[members_[k]]];
        ++count;
      }
    const bool is_beam = thicknessOf(bar) * options_.voxel_size >= options_.min_beam;
    double of_others = 0; // points of segments that are not just the bar
    for (const auto& [segment, its_count] : points_of) {
      const bool is_bar = its_count > options_.max_share * size_of_[segment];
      if (its_count > options_.max_share * count && (!is_beam || is_bar))
        return false;
      of_others += is_bar ? 0 : its_count;
    }
    if (of_others < min_of_others * count)
      return false;
    const auto voxels = moveOut(bar);
    markHeld(voxels, 1);
    for (const auto& entry : points_of)
      partLoose(entry.first);
    markHeld(voxels, 0);
    return true;
  }

private:
  static int
  thicknessOf(const CellBox& bar)
  {
    return std::min({bar.length(0), bar.length(1), bar.length(2)});
  }

  /** A new segment, of points that were in another. */
  std::uint32_t
  partOf(std::uint32_t segment)
  {
    size_of_.push_back(size_of_[segment]);
    return static_cast<std::uint32_t>(size_of_.size()) - 1;
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

  /** Make a segment of the bar's points; no other takes part of it.
   * \return their voxels, some more than once */
  SegmentMembers
  moveOut(const CellBox& bar)
  {
    size_of_.push_back(0);
    const auto number = static_cast<std::uint32_t>(size_of_.size()) - 1;
    SegmentMembers voxels;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < members_.size(); ++k) {
      if (holds(bar, places_[k])) {
        segment_of_point_[members_[k]] = number;
        voxels.push_back(voxels_.cells.cell_of_point[members_[k]]);
        continue;
      }
      members_[kept] = members_[k];
      places_[kept++] = places_[k];
    }
    members_.resize(kept);
    places_.resize(kept);
    return voxels;
  }

  /** Flag voxels and all around them. */
  void
  markHeld(const SegmentMembers& voxels, std::uint8_t flag)
  {
    const auto& neighbors = voxels_.neighbors;
    for (const auto v : voxels) {
      is_held_[v] = flag;
      for (auto j = neighbors.offsets[v]; j < neighbors.offsets[v + 1]; ++j)
        is_held_[neighbors.targets[j]] = flag;
    }
  }

  /** Make segments of the parts that the bar held together. */
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
      if (number.find(part) == number.end())
        number[part] = number.empty() ? segment : partOf(segment);
      segment_of_point_[i] = number[part];
    }
  }

  /** Voxels that touch, seen from above. */
  struct Part {
    std::uint32_t size = 0;
    bool is_held = false; ///< next to the bar
    Eigen::AlignedBox2f plan;

    bool
    isAboveOrBelow(const Part& other) const
    {
      const auto common = plan.intersection(other.plan);
      return !common.isEmpty() &&
             common.volume() >=
                 min_plan_share * std::min(plan.volume(), other.plan.volume());
    }
  };

  /** Those that touch, or lie above one another, are one part; crumbs, and what was not
   * next to the bar, go with the largest that was.
   * \param[in] voxels ascending
   * \return the number of its part for each voxel */
  std::vector<std::uint32_t>
  partsOf(const SegmentMembers& voxels) const
  {
    const auto touching = touchingParts(voxels);
    const auto parts = describe(voxels, touching);
    const auto largest = static_cast<std::uint32_t>(
        std::max_element(parts.begin(),
                         parts.end(),
                         [](const Part& a, const Part& b) {
                           return std::tie(a.is_held, a.size) <
                                  std::tie(b.is_held, b.size);
                         }) -
        parts.begin());
    DisjointSets sets(parts.size());
    for (std::uint32_t a = 0; a < parts.size(); ++a)
      for (std::uint32_t b = a + 1; b < parts.size() && parts[a].size >= min_part; ++b)
        if (parts[b].size >= min_part && parts[a].isAboveOrBelow(parts[b]))
          sets.merge(sets.find(a), sets.find(b));
    for (std::uint32_t part = 0; part < parts.size(); ++part)
      if (parts[part].size < min_part ||
          (!parts[part].is_held && sets.size(sets.find(part)) == 1))
        sets.merge(sets.find(part), sets.find(largest));
    std::vector<std::uint32_t> numbers;
    numbers.reserve(touching.size());
    for (const auto part : touching)
      numbers.push_back(sets.find(part));
    return numbers;
  }

  std::vector<std::uint32_t>
  touchingParts(const SegmentMembers& voxels) const
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
    return sets.labels();
  }

  std::vector<Part>
  describe(const SegmentMembers& voxels,
           const std::vector<std::uint32_t>& part_of_voxel) const
  {
    int upright = 0;
    (options_.axes.transpose() * options_.up).cwiseAbs().maxCoeff(&upright);
    const Eigen::Vector2f half =
        Eigen::Vector2f::Constant(static_cast<float>(options_.voxel_size) / 2);
    std::vector<Part> parts;
    for (std::size_t k = 0; k < voxels.size(); ++k) {
      if (part_of_voxel[k] == parts.size())
        parts.emplace_back();
      auto& part = parts[part_of_voxel[k]];
      const Eigen::Vector3f place =
          options_.axes.transpose() * voxels_.centroids[voxels[k]];
      const Eigen::Vector2f level(place[(upright + 1) % 3], place[(upright + 2) % 3]);
      part.plan.extend(level - half).extend(level + half);
      part.is_held = part.is_held || is_held_[voxels[k]] != 0;
      ++part.size;
    }
    return parts;
  }

  const SurfaceVoxels& voxels_;
  const StraightBarOptions& options_;
  std::vector<std::uint32_t>& segment_of_point_;
  std::vector<double> size_of_; // points of segments, when no bar had been taken out
  SegmentMembers members_;      // points that are in no bar, nor left out
  std::vector<Eigen::Vector3d> places_; // of the members, along the axes, voxels
  std::vector<std::uint8_t> is_held_;   // voxels next to the bar that is taken out
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
