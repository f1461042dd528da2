/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/disjoint_sets.h>
#include <pcl/segmentation/door_unions.h>

#include "ground_frame.h"
#include "interval.h"
#include "point_groups.h"
#include "quantile.h"
#include "wall_frames.h"

#include <pcl/exceptions.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace {

using pcl::indoor::DoorUnionOptions;
using pcl::indoor::Interval;
using pcl::indoor::PointBox;
using pcl::indoor::SegmentMembers;
using pcl::indoor::StructurePlane;

constexpr double max_before = 2;     // voxels before the wall that are still within it
constexpr double max_apart = 2;      // voxels between the edge of a leaf and its frame
constexpr std::size_t min_edge = 20; // points
constexpr double jamb_width = 0.05;  // metres, at the least
constexpr double parallel = 0.99;    // cosine of 8 degrees: a leaf that is shut

/** Finds the leaves of frames. */
class LeafFinder {
public:
  LeafFinder(const std::vector<Eigen::Vector3f>& points,
             const DoorUnionOptions& options)
  : points_(points)
  , options_(options)
  , ground_(pcl::indoor::groundFrame(options.up))
  {}

  bool
  isLeafOf(const StructurePlane& wall,
           const SegmentMembers& frame,
           const PointBox& frame_box,
           const SegmentMembers& leaf) const
  {
    const double voxel = options_.voxel_size;
    SegmentMembers edge, before;
    PointBox edge_box;
    for (const auto i : leaf) {
      const double height = wall.heightOf(points_[i].cast<double>());
      const bool is_within =
          height > -pcl::indoor::frame_depth && height < max_before * voxel;
      (is_within ? edge : before).push_back(i);
      if (is_within)
        edge_box.extend(points_[i]);
    }
    if (edge.size() < min_edge || before.size() < edge.size() ||
        edge_box.exteriorDistance(frame_box) > max_apart * voxel ||
        !hasHeightOf(frame, edge, leaf))
      return false;
    return fitsOpening(wall, frame, edge, before, leaf);
  }

private:
  std::vector<double>
  placesOf(const SegmentMembers& members, const Eigen::Vector3d& direction) const
  {
    std::vector<double> places;
    places.reserve(members.size());
    for (const auto i : members)
      places.push_back(direction.dot(points_[i].cast<double>()));
    return places;
  }

  Interval
  rangeOf(const SegmentMembers& members, const Eigen::Vector3d& direction) const
  {
    auto places = placesOf(members, direction);
    return pcl::indoor::trimmedRange(places);
  }

  bool
  hasHeightOf(const SegmentMembers& frame,
              const SegmentMembers& edge,
              const SegmentMembers& leaf) const
  {
    const Eigen::Vector3d up = ground_.row(2);
    const double height = rangeOf(frame, up).length(),
                 leaf_height = rangeOf(leaf, up).length();
    return height >= options_.min_height &&
           rangeOf(edge, up).length() >= options_.min_hinge * height &&
           leaf_height <= options_.max_ratio * height &&
           height <= options_.max_ratio * leaf_height;
  }

  /** Of a leaf that is flat and stands out of the wall, as what is before the wall
   * tells, and whose edge is in the opening. */
  bool
  fitsOpening(const StructurePlane& wall,
              const SegmentMembers& frame,
              const SegmentMembers& edge,
              const SegmentMembers& before,
              const SegmentMembers& leaf) const
  {
    const Eigen::Vector3d up = ground_.row(2), normal = normalOf(before),
                          along_wall = up.cross(wall.normal).normalized();
    if (rangeOf(before, normal).length() > options_.max_thickness ||
        std::abs(normal.dot(wall.normal)) > parallel)
      return false;
    const double width = rangeOf(leaf, up.cross(normal)).length();
    if (isBeside(frame, edge, along_wall, width))
      return false;
    SegmentMembers opening = frame;
    opening.insert(opening.end(), edge.begin(), edge.end());
    const double frame_width = rangeOf(opening, along_wall).length();
    return width <= options_.max_width && width <= options_.max_ratio * frame_width &&
           width >= options_.min_width_ratio * frame_width;
  }

  /** Whether the edge is on the outer side of a jamb of the frame, nearer to it than to
   * the other end of an opening. If the jamb went with the leaf, there is none. */
  bool
  isBeside(const SegmentMembers& frame,
           const SegmentMembers& edge,
           const Eigen::Vector3d& along_wall,
           double width) const
  {
    const auto range = rangeOf(frame, along_wall);
    auto places = placesOf(edge, along_wall);
    const double middle = pcl::indoor::quantile(places, 0.5);
    if (range.widened(options_.voxel_size / 2).holds(middle))
      return false;
    const double end = middle < range.low ? range.low : range.high;
    if (std::abs(middle - end) > width / 2)
      return false;
    SegmentMembers jamb;
    for (const auto i : frame)
      if (std::abs(along_wall.dot(points_[i].cast<double>()) - end) < jamb_width)
        jamb.push_back(i);
    const Eigen::Vector3d up = ground_.row(2);
    return !jamb.empty() && rangeOf(jamb, up).length() >=
                                options_.min_hinge * rangeOf(frame, up).length();
  }

  /** The level direction across which the points reach least. */
  Eigen::Vector3d
  normalOf(const SegmentMembers& members) const
  {
    const Eigen::Matrix<double, 2, 3> plan = ground_.topRows<2>();
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const auto i : members)
      mean += points_[i].cast<double>();
    mean /= static_cast<double>(members.size());
    Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
    for (const auto i : members) {
      const Eigen::Vector2d offset = plan * (points_[i].cast<double>() - mean);
      scatter += offset * offset.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(scatter);
    return plan.transpose() * solver.eigenvectors().col(0);
  }

  const std::vector<Eigen::Vector3f>& points_;
  const DoorUnionOptions& options_;
  Eigen::Matrix3d ground_;
};

void
requireValid(std::size_t point_count,
             const pcl::indoor::SurfaceVoxels& voxels,
             std::size_t plane_count,
             std::size_t segment_count,
             const DoorUnionOptions& options)
{
  if (voxels.cells.cell_of_point.size() != point_count ||
      plane_count != voxels.size() || segment_count != point_count)
    PCL_THROW_EXCEPTION(
        pcl::BadArgumentException,
        point_count << " points have " << voxels.cells.cell_of_point.size()
                    << " voxels, " << segment_count << " segments and, of "
                    << voxels.size() << " voxels, " << plane_count << " planes.");
  if (!(options.voxel_size > 0) || !(options.min_height >= 0) ||
      !(options.max_thickness >= 0) || !(options.max_width >= 0) ||
      !(options.min_width_ratio >= 0 && options.min_width_ratio <= 1) ||
      !(options.max_ratio >= 1) ||
      !(options.min_hinge >= 0 && options.min_hinge <= 1) ||
      !(std::abs(options.up.norm() - 1) < 1e-3f))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "Doors need positive sizes, shares from 0 to 1, a ratio of at "
                        "least 1 and a unit vector up.");
}

} // namespace

namespace pcl {
namespace indoor {

std::size_t
joinDoorLeaves(const std::vector<Eigen::Vector3f>& points,
               const SurfaceVoxels& voxels,
               const std::vector<StructurePlane>& planes,
               const std::vector<std::uint32_t>& plane_of_voxel,
               const DoorUnionOptions& options,
               std::vector<std::uint32_t>& segment_of_point)
{
  requireValid(
      points.size(), voxels, plane_of_voxel.size(), segment_of_point.size(), options);
  if (points.empty() || planes.empty())
    return 0;
  const auto groups =
      groupPoints(points, voxels, planes.size(), plane_of_voxel, segment_of_point);
  const auto& [members, boxes] = groups.objects;
  const auto frames =
      framesInWalls(points, planes, groups, options.voxel_size, options.up);
  std::vector<std::uint8_t> is_frame(members.size(), 0), is_joined(members.size(), 0);
  for (const auto& frame : frames)
    is_frame[frame.segment] = 1;
  DisjointSets doors(members.size());
  const LeafFinder finder(points, options);
  for (const auto& [wall, frame] : frames) {
    const auto reach = widened(boxes[frame], options.max_width);
    for (std::uint32_t leaf = 0; leaf < members.size(); ++leaf)
      if (!is_frame[leaf] && reach.intersects(boxes[leaf]) &&
          finder.isLeafOf(planes[wall], members[frame], boxes[frame], members[leaf])) {
        doors.merge(doors.find(frame), doors.find(leaf));
        is_joined[leaf] = 1;
      }
  }
  for (auto& segment : segment_of_point)
    segment = doors.find(segment);
  return static_cast<std::size_t>(std::count(is_joined.begin(), is_joined.end(), 1));
}

} // namespace indoor
} // namespace pcl
