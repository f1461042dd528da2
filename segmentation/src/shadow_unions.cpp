/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/disjoint_sets.h>
#include <pcl/segmentation/shadow_unions.h>

#include "plane_growing.h"
#include "quantile.h"
#include "segment_boxes.h"

#include <pcl/exceptions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

namespace {

using pcl::indoor::outlier_share;
using pcl::indoor::quantile;
using pcl::indoor::ShadowUnionOptions;
using pcl::indoor::StructurePlane;
using pcl::indoor::SurfaceVoxels;

constexpr double max_tilt = 0.3; // of an upright plane, sine

/** Where something is on a level or upright axis. */
struct Interval {
  double low = 0, high = 0;

  double
  length() const
  {
    return high - low;
  }

  bool
  holds(double place) const
  {
    return place > low && place < high;
  }

  Interval
  widened(double by) const
  {
    return {low - by, high + by};
  }
};

/** What a segment has of an upright plane. */
struct Front {
  std::uint32_t segment = 0;
  double area = 0; // square metres
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

/** The points that a segment has in a plane. */
struct Patch {
  std::size_t voxels = 0;
  std::uint32_t last_voxel = 0;
  std::vector<double> along, height;
};

Interval
trimmed(std::vector<double>& places, double voxel_size)
{
  const Interval interval{quantile(places, outlier_share),
                          quantile(places, 1 - outlier_share)};
  return interval.widened(voxel_size / 2);
}

/** Finds fronts in planes, and what hides the gaps between them. */
class ShadowFinder {
public:
  ShadowFinder(const std::vector<Eigen::Vector3f>& points,
               const SurfaceVoxels& voxels,
               const std::vector<std::uint8_t>& left_out,
               const ShadowUnionOptions& options)
  : points_(points)
  , voxels_(voxels)
  , left_out_(left_out)
  , options_(options)
  {}

  /** Those that are large and full enough, in the order of their segments. */
  std::vector<Front>
  frontsIn(const StructurePlane& plane,
           const PlaneView& view,
           const std::vector<std::uint32_t>& segment_of_point) const
  {
    std::map<std::uint32_t, Patch> patches;
    const auto& cells = voxels_.cells;
    for (const auto v : plane.voxels)
      for (auto j = cells.offsets[v]; !left_out_[v] && j < cells.offsets[v + 1]; ++j) {
        const auto& point = points_[cells.points[j]];
        auto& patch = patches[segment_of_point[cells.points[j]]];
        patch.voxels += patch.voxels == 0 || patch.last_voxel != v;
        patch.last_voxel = v;
        patch.along.push_back(view.along(point));
        patch.height.push_back(view.height(point));
      }
    std::vector<Front> fronts;
    for (auto& [segment, patch] : patches) {
      Front front;
      front.segment = segment;
      front.along = trimmed(patch.along, options_.voxel_size);
      front.height = trimmed(patch.height, options_.voxel_size);
      const double outline = front.along.length() * front.height.length();
      const double area = static_cast<double>(patch.voxels) * cellArea();
      if (front.along.length() >= options_.min_width &&
          front.height.length() >= options_.min_height &&
          area >= options_.min_fill * outline)
        fronts.push_back(front);
    }
    return fronts;
  }

  /** Whether two fronts of one plane are pieces of one that a shadow cuts. */
  bool
  areOne(const Front& a, const Front& b, const PlaneView& view) const
  {
    const double tolerance = options_.max_offset * options_.voxel_size;
    if (std::abs(a.height.low - b.height.low) > tolerance ||
        std::abs(a.height.high - b.height.high) > tolerance)
      return false;
    const Interval gap{std::min(a.along.high, b.along.high),
                       std::max(a.along.low, b.along.low)};
    const double width = std::min(a.along.length(), b.along.length());
    if (gap.length() < options_.min_gap * options_.voxel_size ||
        gap.length() > options_.max_gap ||
        gap.length() > options_.max_gap_share * width)
      return false;
    const Interval height{std::max(a.height.low, b.height.low),
                          std::min(a.height.high, b.height.high)};
    return isHidden(gap, height, view);
  }

private:
  double
  cellArea() const
  {
    return options_.voxel_size * options_.voxel_size;
  }

  /** Nothing is seen in the gap or through it, but something before it. */
  bool
  isHidden(const Interval& gap, const Interval& height, const PlaneView& view) const
  {
    const double margin = 2 * options_.voxel_size;
    const auto within = gap.widened(-options_.voxel_size);
    const auto around = gap.widened(gap.length());
    const auto level = height.widened(-margin);
    if (!(level.length() > 0))
      return false;
    std::size_t filled = 0, seen = 0, hiding = 0;
    for (const auto& centroid : voxels_.centroids) {
      const double along = view.along(centroid), before = view.before(centroid);
      if (!around.holds(along) || !level.holds(view.height(centroid)) ||
          std::abs(before) > options_.reach)
        continue;
      filled += std::abs(before) < margin && within.holds(along);
      seen += before <= -margin && within.holds(along);
      hiding += before >= margin;
    }
    const double cells = within.length() * level.length() / cellArea();
    return static_cast<double>(filled) <= options_.max_filled * cells &&
           static_cast<double>(seen) <= options_.max_seen * cells &&
           static_cast<double>(hiding) >= options_.min_hiding * cells;
  }

  const std::vector<Eigen::Vector3f>& points_;
  const SurfaceVoxels& voxels_;
  const std::vector<std::uint8_t>& left_out_;
  const ShadowUnionOptions& options_;
};

void
requireValid(std::size_t point_count,
             const SurfaceVoxels& voxels,
             std::size_t flag_count,
             std::size_t segment_count,
             const ShadowUnionOptions& options)
{
  if (voxels.cells.cell_of_point.size() != point_count ||
      segment_count != point_count || flag_count != voxels.size() ||
      voxels.normals.size() != voxels.size() ||
      voxels.curvatures.size() != voxels.size())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        point_count << " points have " << segment_count << " segments, "
                                    << voxels.cells.cell_of_point.size()
                                    << " of them are in " << voxels.size()
                                    << " voxels with " << flag_count << " flags, "
                                    << voxels.normals.size() << " normals and "
                                    << voxels.curvatures.size() << " curvatures.");
  if (!(options.voxel_size > 0) || !(options.min_width >= 0) ||
      !(options.min_height >= 0) || !(options.min_fill >= 0) ||
      !(options.max_offset >= 0) || !(options.min_gap >= 2) ||
      !(options.max_gap >= 0) || !(options.max_gap_share >= 0) ||
      !(options.max_filled >= 0) || !(options.max_seen >= 0) ||
      !(options.min_hiding >= 0) || !(options.reach >= 0) ||
      !(std::abs(options.up.norm() - 1) < 1e-3f))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "Shadows need positive sizes, a gap of at least two voxels, "
                        "shares of at least 0 and a unit vector up.");
}

} // namespace

namespace pcl {
namespace indoor {

std::size_t
joinAcrossShadows(const std::vector<Eigen::Vector3f>& points,
                  const SurfaceVoxels& voxels,
                  const std::vector<std::uint8_t>& left_out,
                  const ShadowUnionOptions& options,
                  std::vector<std::uint32_t>& segment_of_point)
{
  requireValid(
      points.size(), voxels, left_out.size(), segment_of_point.size(), options);
  if (points.empty())
    return 0;
  DisjointSets sets(
      1 + *std::max_element(segment_of_point.begin(), segment_of_point.end()));
  const ShadowFinder finder(points, voxels, left_out, options);
  std::size_t joined = 0;
  for (const auto& plane :
       growPlanes(voxels, options.voxel_size, RoomStructureOptions().flat_curvature)) {
    if (std::abs(plane.normal.dot(options.up.cast<double>())) > max_tilt)
      continue;
    const PlaneView view(plane, options.up, voxels);
    const auto fronts = finder.frontsIn(plane, view, segment_of_point);
    for (std::size_t i = 0; i < fronts.size(); ++i)
      for (std::size_t j = i + 1; j < fronts.size(); ++j) {
        const auto a = sets.find(fronts[i].segment), b = sets.find(fronts[j].segment);
        if (a == b || !finder.areOne(fronts[i], fronts[j], view))
          continue;
        sets.merge(a, b);
        ++joined;
      }
  }
  for (std::size_t i = 0; joined > 0 && i < points.size(); ++i)
    if (!left_out[voxels.cells.cell_of_point[i]])
      segment_of_point[i] = sets.find(segment_of_point[i]);
  return joined;
}

} // namespace indoor
} // namespace pcl
