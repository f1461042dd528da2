/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/disjoint_sets.h>
#include <pcl/segmentation/shadow_unions.h>

#include "interval.h"
#include "plane_growing.h"

#include <pcl/exceptions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace {

using pcl::indoor::Interval;
using pcl::indoor::ShadowUnionOptions;
using pcl::indoor::StructurePlane;
using pcl::indoor::SurfaceVoxels;

constexpr double max_tilt = 0.1; // of an upright plane, sine: 6 degrees

/** What a segment has of an upright plane. */
struct Front {
  std::uint32_t segment = 0;
  Interval along, height;
};

/** Looks at an upright plane from before it. */
class PlaneView {
public:
  PlaneView(const StructurePlane& plane,
            const Eigen::Vector3f& up,
            const SurfaceVoxels& voxels)
  : up_(up.cast<double>())
  , normal_((plane.normal - plane.normal.dot(up_) * up_).normalized())
  , along_(up_.cross(normal_))
  {
    double sum = 0;
    for (const auto v : plane.voxels)
      sum += normal_.dot(voxels.centroids[v].cast<double>());
    offset_ = sum / static_cast<double>(plane.voxels.size());
  }

  double
  along(const Eigen::Vector3f& point) const
  {
    return along_.dot(point.cast<double>());
  }

  double
  height(const Eigen::Vector3f& point) const
  {
    return up_.dot(point.cast<double>());
  }

  double
  before(const Eigen::Vector3f& point) const
  {
    return normal_.dot(point.cast<double>()) - offset_;
  }

private:
  Eigen::Vector3d up_, normal_, along_;
  double offset_ = 0;
};

/** Cells of a voxel's size that are marked, each counted once. */
class MarkedCells {
public:
  explicit MarkedCells(double cell_size)
  : cell_size_(cell_size)
  {}

  void
  mark(double along, double height)
  {
    cells_.emplace_back(std::floor(along / cell_size_),
                        std::floor(height / cell_size_));
  }

  double
  count()
  {
    std::sort(cells_.begin(), cells_.end());
    cells_.erase(std::unique(cells_.begin(), cells_.end()), cells_.end());
    return static_cast<double>(cells_.size());
  }

private:
  double cell_size_;
  std::vector<std::pair<double, double>> cells_;
};

/** The voxels that a segment has in a plane. */
struct Patch {
  std::vector<double> along, height;
};

/** Finds fronts in planes, and what hides the gaps between them. */
class ShadowFinder {
public:
  ShadowFinder(const SurfaceVoxels& voxels,
               const std::vector<std::uint8_t>& left_out,
               const std::vector<std::uint32_t>& segment_of_point,
               const ShadowUnionOptions& options)
  : voxels_(voxels)
  , left_out_(left_out)
  , segment_of_point_(segment_of_point)
  , options_(options)
  {}

  /** Those that are large and full enough, in the order of their segments. */
  std::vector<Front>
  frontsIn(const StructurePlane& plane, const PlaneView& view) const
  {
    std::map<std::uint32_t, Patch> patches;
    for (const auto v : plane.voxels)
      for (const auto segment : segmentsIn(v)) {
        auto& patch = patches[segment];
        patch.along.push_back(view.along(voxels_.centroids[v]));
        patch.height.push_back(view.height(voxels_.centroids[v]));
      }
    std::vector<Front> fronts;
    for (auto& [segment, patch] : patches) {
      const double filled = filledCells(patch);
      const double half = options_.voxel_size / 2;
      const Front front{segment,
                        pcl::indoor::trimmedRange(patch.along).widened(half),
                        pcl::indoor::trimmedRange(patch.height).widened(half)};
      if (front.along.length() >= options_.min_width &&
          front.height.length() >= options_.min_height &&
          filled >= options_.min_fill * cellsIn(front.along, front.height))
        fronts.push_back(front);
    }
    return fronts;
  }

  /** Whether two fronts of one plane are pieces of one that a shadow cuts. */
  bool
  areOne(const Front& a, const Front& b, const PlaneView& view) const
  {
    if (commonShare(a.height, b.height) < options_.min_overlap)
      return false;
    const auto common = commonPart(a.along, b.along); // the gap, turned around
    const Interval gap{common.high, common.low};
    const double width = std::min(a.along.length(), b.along.length());
    if (gap.length() < options_.min_gap * options_.voxel_size ||
        gap.length() > options_.max_gap ||
        gap.length() > options_.max_gap_share * width)
      return false;
    return isHidden(gap, commonPart(a.height, b.height), view, a.segment, b.segment);
  }

private:
  /** The segments of a voxel's points; none if it is left out. */
  std::vector<std::uint32_t>
  segmentsIn(std::uint32_t voxel) const
  {
    std::vector<std::uint32_t> segments;
    const auto& cells = voxels_.cells;
    for (auto j = cells.offsets[voxel];
         !left_out_[voxel] && j < cells.offsets[voxel + 1];
         ++j) {
      const auto segment = segment_of_point_[cells.points[j]];
      if (std::find(segments.begin(), segments.end(), segment) == segments.end())
        segments.push_back(segment);
    }
    return segments;
  }

  double
  filledCells(const Patch& patch) const
  {
    MarkedCells cells(options_.voxel_size);
    for (std::size_t i = 0; i < patch.along.size(); ++i)
      cells.mark(patch.along[i], patch.height[i]);
    return cells.count();
  }

  double
  cellsIn(const Interval& along, const Interval& height) const
  {
    return along.length() * height.length() /
           (options_.voxel_size * options_.voxel_size);
  }

  /** Nothing is seen in the gap or through it, nor the sides of bodies beside it, but
   * something before it that is not of the pieces. */
  bool
  isHidden(const Interval& gap,
           const Interval& height,
           const PlaneView& view,
           std::uint32_t a,
           std::uint32_t b) const
  {
    const double voxel = options_.voxel_size, margin = 2 * voxel;
    const auto within = gap.widened(-voxel), beside = gap.widened(voxel),
               around = gap.widened(gap.length()), level = height.widened(-margin);
    if (!(level.length() > 0))
      return false;
    MarkedCells filled(voxel), seen(voxel), hiding(voxel);
    for (std::uint32_t v = 0; v < voxels_.size(); ++v) {
      const auto& place = voxels_.centroids[v];
      const double along = view.along(place), up = view.height(place),
                   before = view.before(place);
      if (!around.holds(along) || !level.holds(up) || std::abs(before) > options_.reach)
        continue;
      if (before >= margin) {
        const auto segments = segmentsIn(v);
        if (std::none_of(segments.begin(), segments.end(), [&](auto segment) {
              return segment == a || segment == b;
            }))
          hiding.mark(along, up);
      }
      else if (before <= -margin && beside.holds(along))
        seen.mark(along, up);
      else if (before > -margin && within.holds(along))
        filled.mark(along, up);
    }
    const double cells = cellsIn(within, level);
    return filled.count() <= options_.max_filled * cells &&
           seen.count() <= options_.max_seen * cells &&
           hiding.count() >= options_.min_hiding * cells;
  }

  const SurfaceVoxels& voxels_;
  const std::vector<std::uint8_t>& left_out_;
  const std::vector<std::uint32_t>& segment_of_point_;
  const ShadowUnionOptions& options_;
};

void
requireValid(const SurfaceVoxels& voxels,
             std::size_t flag_count,
             std::size_t segment_count,
             const ShadowUnionOptions& options)
{
  if (segment_count != voxels.cells.cell_of_point.size() ||
      flag_count != voxels.size() || voxels.normals.size() != voxels.size() ||
      voxels.curvatures.size() != voxels.size())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        voxels.cells.cell_of_point.size()
                            << " points have " << segment_count << " segments, their "
                            << voxels.size() << " voxels " << flag_count << " flags, "
                            << voxels.normals.size() << " normals and "
                            << voxels.curvatures.size() << " curvatures.");
  if (!(options.voxel_size > 0) || !(options.min_width >= 0) ||
      !(options.min_height >= 0) || !(options.min_fill >= 0 && options.min_fill <= 1) ||
      !(options.min_overlap >= 0) || !(options.min_gap > 2) ||
      !(options.max_gap >= 0) || !(options.max_gap_share >= 0) ||
      !(options.max_filled >= 0) || !(options.max_seen >= 0) ||
      !(options.min_hiding >= 0) || !(options.reach >= 0) ||
      !(std::abs(options.up.norm() - 1) < 1e-3f))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "Shadows need positive sizes, a gap of more than two voxels, "
                        "shares of at least 0 and a unit vector up.");
}

} // namespace

namespace pcl {
namespace indoor {

std::size_t
joinAcrossShadows(const SurfaceVoxels& voxels,
                  const std::vector<std::uint8_t>& left_out,
                  const ShadowUnionOptions& options,
                  std::vector<std::uint32_t>& segment_of_point)
{
  requireValid(voxels, left_out.size(), segment_of_point.size(), options);
  if (segment_of_point.empty())
    return 0;
  DisjointSets sets(
      1 + *std::max_element(segment_of_point.begin(), segment_of_point.end()));
  const ShadowFinder finder(voxels, left_out, segment_of_point, options);
  std::size_t joined = 0;
  for (const auto& plane :
       growPlanes(voxels, options.voxel_size, RoomStructureOptions().flat_curvature)) {
    if (std::abs(plane.normal.dot(options.up.cast<double>())) > max_tilt)
      continue;
    const PlaneView view(plane, options.up, voxels);
    const auto fronts = finder.frontsIn(plane, view);
    for (std::size_t i = 0; i < fronts.size(); ++i)
      for (std::size_t j = i + 1; j < fronts.size(); ++j) {
        const auto a = sets.find(fronts[i].segment), b = sets.find(fronts[j].segment);
        if (a == b || !finder.areOne(fronts[i], fronts[j], view))
          continue;
        sets.merge(a, b);
        ++joined;
      }
  }
  for (std::size_t i = 0; joined > 0 && i < segment_of_point.size(); ++i)
    if (!left_out[voxels.cells.cell_of_point[i]])
      segment_of_point[i] = sets.find(segment_of_point[i]);
  return joined;
}

} // namespace indoor
} // namespace pcl
