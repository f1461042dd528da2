/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/structure/room_structure.h"

#include "objects/structure/floor_search.h"
#include "objects/structure/plane_growing.h"

#include <pcl/indoor/quantile.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace {

using pcl::indoor::near_surface_voxels;
using pcl::indoor::sheet_cosine;
using pcl::indoor::StructurePlane;
using pcl::indoor::SurfaceVoxels;

constexpr double min_span = 0.85; // share of the room's extent in one of its directions
constexpr double min_length = 1.5;  // in that direction, metres: rooms are not lower
constexpr double most_beyond = 0.1; // share of what is seen that is behind a wall
constexpr double min_wall = 1.5;    // m^2, of a wall that is shorter than the room
constexpr double min_wall_height = 0.7;           // of it, as share of the room's
constexpr double min_wall_free = 1 - most_beyond; // of it, as min_free
constexpr double longest_row = 2e6; // voxels beside each other, see groupByCell()
/** Within chance_deviations, or so many voxels, a point counts to its plane. */
constexpr double least_tolerance = 0.2;

double
extentOf(const SurfaceVoxels& voxels,
         const std::vector<std::uint32_t>* members,
         const Eigen::Vector3d& direction)
{
  std::vector<double> heights;
  const auto add = [&](std::uint32_t v) {
    heights.push_back(direction.dot(voxels.centroids[v].cast<double>()));
  };
  if (members)
    for (const auto v : *members)
      add(v);
  else
    for (std::uint32_t v = 0; v < voxels.size(); ++v)
      add(v);
  return pcl::indoor::extentWithoutStrays(heights);
}

/** The standard deviation of a plane's points, from their median distance. */
double
deviationOf(const std::vector<Eigen::Vector3f>& points,
            const SurfaceVoxels& voxels,
            const StructurePlane& plane)
{
  std::vector<double> distances;
  for (const auto v : plane.voxels)
    for (const auto point : voxels.cells.pointsOf(v))
      distances.push_back(
          std::abs(plane.normal.dot(points[point].cast<double>()) - plane.offset));
  return pcl::indoor::deviation_per_median * pcl::indoor::median(distances);
}

/** The voxels of a plane and those at most two voxels from them. */
std::vector<std::uint32_t>
withSurroundings(const SurfaceVoxels& voxels, const StructurePlane& plane)
{
  std::vector<std::uint8_t> taken(voxels.size(), 0);
  auto found = plane.voxels;
  for (const auto v : found)
    taken[v] = 1;
  std::size_t begin = 0;
  for (int round = 0; round < near_surface_voxels; ++round) {
    const auto end = found.size();
    for (; begin < end; ++begin) {
      const auto v = found[begin];
      for (const auto other : voxels.neighbors.of(v)) {
        if (!taken[other]) {
          taken[other] = 1;
          found.push_back(other);
        }
      }
    }
  }
  return found;
}

struct Interval {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void
  add(double value)
  {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/** Places in the grid: along x, the points of each plane beside those of the others; in
 * a new row where these are as many cells as a grid may have. */
std::vector<Eigen::Vector3f>
besideEachOther(const std::vector<Eigen::Vector3f>& points,
                const std::vector<std::uint32_t>& plane_of_point,
                double voxel_size)
{
  if (points.empty())
    return {};
  const auto last = *std::max_element(plane_of_point.begin(), plane_of_point.end());
  std::vector<Interval> intervals(last + 1);
  Interval across;
  for (std::size_t i = 0; i < points.size(); ++i) {
    intervals[plane_of_point[i]].add(points[i].x());
    across.add(points[i].y());
  }
  const auto voxels_over = [voxel_size](double length) {
    return (std::ceil(length / voxel_size) + 3) * voxel_size;
  };
  std::vector<Eigen::Vector2d> shift(last + 1, Eigen::Vector2d::Zero());
  Interval row;
  double row_place = 0;
  for (std::uint32_t plane = 0; plane <= last; ++plane) {
    const auto& [low, high] = intervals[plane];
    if (low > high) // it has no points
      continue;
    double place = row.low > row.high ? 0 : voxels_over(row.high - low);
    if (high + place - row.low > longest_row * voxel_size) {
      row_place += voxels_over(across.high - across.low);
      place = voxels_over(row.low - low);
    }
    shift[plane] = {place, row_place};
    row.low = std::min(row.low, low + place);
    row.high = high + place;
  }
  auto places = points;
  for (std::size_t i = 0; i < points.size(); ++i)
    places[i].head<2>() =
        (points[i].head<2>().cast<double>() + shift[plane_of_point[i]]).cast<float>();
  return places;
}

/** Whether a plane reaches from one side of a room to the other. */
struct Reach {
  bool one_way;   ///< in one direction, as walls do from floor to ceiling
  bool both_ways; ///< in both, as floors and ceilings do, also those of small rooms
};

/** Whether a plane lies along none of the room's directions. */
bool
isOblique(const StructurePlane& plane, const Eigen::Matrix3d& axes)
{
  for (int a = 0; a < 3; ++a)
    if (pcl::indoor::areAcross(axes.col(a), plane.normal))
      return false;
  return true;
}

/** Whether nearly all that is seen lies before a plane. */
bool
bounds(const SurfaceVoxels& voxels, const StructurePlane& plane, double voxel_size)
{
  const auto beyond = std::count_if(
      voxels.centroids.begin(), voxels.centroids.end(), [&](const auto& centroid) {
        return plane.heightOf(centroid.template cast<double>()) <
               -near_surface_voxels * voxel_size;
      });
  return static_cast<double>(beyond) <=
         most_beyond * static_cast<double>(voxels.size());
}

/** Whether a plane lies in a recess of a larger one, as doors and windows do in walls.
 * \param[in] planes the largest first */
bool
isRecessed(const SurfaceVoxels& voxels,
           const std::vector<StructurePlane>& planes,
           const StructurePlane& plane)
{
  constexpr double deepest_recess = 0.4; // metres: outer walls are not much thicker
  const Eigen::Vector3d middle =
      voxels.centroids[plane.voxels[plane.voxels.size() / 2]].cast<double>();
  for (const auto* wall = planes.data(); wall != &plane; ++wall) {
    const double height = wall->heightOf(middle);
    if (wall->normal.dot(plane.normal) > sheet_cosine && height < 0 &&
        height > -deepest_recess)
      return true;
  }
  return false;
}

/** \brief Tells which planes enclose a room. */
class StructureSearch {
public:
  /** \param[in] planes the largest first, at least one; must outlive the search */
  StructureSearch(const std::vector<StructurePlane>& planes,
                  const SurfaceVoxels& voxels,
                  double voxel_size,
                  const Eigen::Vector3f& up,
                  pcl::indoor::Capture capture)
  : planes_(planes)
  , voxels_(voxels)
  , voxel_size_(voxel_size)
  , near_(near_surface_voxels * voxel_size)
  , up_(up.cast<double>())
  , is_view_(capture == pcl::indoor::Capture::RoomView)
  , axes_(pcl::indoor::axesOf(planes))
  , height_(extentOf(voxels, nullptr, up_))
  {
    for (int a = 0; a < 3; ++a)
      room_[a] = extentOf(voxels, nullptr, axes_.col(a));
  }

  /** Whether what was seen is as long as a room is, at least. */
  bool
  isRoom() const
  {
    return *std::max_element(room_.begin(), room_.end()) >= min_length;
  }

  bool
  encloses(const StructurePlane& plane) const
  {
    const auto reach = reachOf(plane);
    if (!reach.one_way && !reach.both_ways)
      return is_view_ ? bounds(voxels_, plane, voxel_size_) &&
                            freeShare(plane, near_) >= pcl::indoor::min_free
                      : isRoom() && isWall(plane);
    // Walls seen from several places appear double: what is near does not count.
    return freeShare(plane, reach.both_ways ? pcl::indoor::other_layer : near_) >=
           pcl::indoor::min_free;
  }

private:
  Reach
  reachOf(const StructurePlane& plane) const
  {
    Reach reach{false, isRoom()};
    const bool is_oblique = isOblique(plane, axes_);
    for (int a = 0; a < 3; ++a)
      if (is_oblique || pcl::indoor::areAcross(axes_.col(a), plane.normal)) {
        const double extent = extentOf(voxels_, &plane.voxels, axes_.col(a));
        reach.one_way |=
            !is_oblique && extent >= std::max(min_span * room_[a], min_length);
        reach.both_ways &= extent + 2 * near_ >= min_span * room_[a]; // without edges
      }
    return reach;
  }

  /** Whether it is a part of a wall. */
  bool
  isWall(const StructurePlane& plane) const
  {
    return pcl::indoor::areAcross(plane.normal, up_) &&
           pcl::indoor::areaOfPlane(plane, voxel_size_) >= min_wall &&
           extentOf(voxels_, &plane.voxels, up_) >= min_wall_height * height_ &&
           bounds(voxels_, plane, voxel_size_) &&
           !isRecessed(voxels_, planes_, plane) &&
           freeShare(plane, near_) >= min_wall_free;
  }

  double
  freeShare(const StructurePlane& plane, double margin) const
  {
    return pcl::indoor::freeShareOfPlane(voxels_, plane, margin, voxel_size_);
  }

  const std::vector<StructurePlane>& planes_;
  const SurfaceVoxels& voxels_;
  double voxel_size_, near_; // metres
  Eigen::Vector3d up_;
  bool is_view_;
  Eigen::Matrix3d axes_;
  double height_;              // of all that was seen, metres
  std::array<double, 3> room_; // its extent along the axes, metres
};

} // namespace

namespace pcl::indoor {

Eigen::Matrix3d
axesOf(const std::vector<StructurePlane>& planes)
{
  if (planes.empty())
    return Eigen::Matrix3d::Identity();
  const Eigen::Vector3d first = planes.front().normal;
  Eigen::Vector3d second = first.unitOrthogonal();
  for (const auto& plane : planes)
    if (std::abs(plane.normal.dot(first)) < 0.1) {
      second = (plane.normal - plane.normal.dot(first) * first).normalized();
      break;
    }
  Eigen::Matrix3d axes;
  axes << first, second, first.cross(second);
  return axes;
}

StructureKind
kindOf(const StructurePlane& plane, const Eigen::Vector3f& up)
{
  const double cosine = plane.normal.dot(up.cast<double>());
  if (std::abs(cosine) < M_SQRT1_2)
    return StructureKind::Wall;
  return cosine > 0 ? StructureKind::Floor : StructureKind::Ceiling;
}

std::vector<StructurePlane>
findRoomStructure(const SurfaceVoxels& voxels,
                  double voxel_size,
                  const Eigen::Vector3f& up,
                  Capture capture)
{
  const float flat = ObjectSegmentationOptions().curvature_threshold;
  auto planes = growPlanes(voxels, voxel_size, flat);
  if (planes.empty())
    return {};
  const StructureSearch search(planes, voxels, voxel_size, up, capture);
  std::vector<std::uint8_t> is_floor(planes.size(), 0);
  if (search.isRoom())
    is_floor = floorsAmong(planes, voxels, voxel_size, up);
  std::vector<StructurePlane> structure;
  for (std::size_t p = 0; p < planes.size(); ++p)
    if (is_floor[p] || search.encloses(planes[p]))
      structure.push_back(std::move(planes[p]));
  return structure;
}

std::vector<std::uint32_t>
pointsOfStructure(const std::vector<Eigen::Vector3f>& points,
                  const SurfaceVoxels& voxels,
                  const std::vector<StructurePlane>& planes,
                  double voxel_size)
{
  std::vector<std::uint32_t> plane_of_point(points.size(), 0);
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const auto& plane = planes[p];
    const double tolerance =
        std::min(voxel_size,
                 std::max(chance_deviations * deviationOf(points, voxels, plane),
                          least_tolerance * voxel_size));
    for (const auto v : withSurroundings(voxels, plane))
      for (const auto point : voxels.cells.pointsOf(v)) {
        if (plane_of_point[point] == 0 &&
            std::abs(plane.heightOf(points[point].cast<double>())) <= tolerance)
          plane_of_point[point] = static_cast<std::uint32_t>(p + 1);
      }
  }
  return plane_of_point;
}

SurfaceVoxels
separateVoxels(const std::vector<Eigen::Vector3f>& points,
               const std::vector<std::uint32_t>& plane_of_point,
               double voxel_size,
               std::vector<std::uint32_t>& plane_of_voxel)
{
  assert(plane_of_point.size() == points.size());
  const auto grid_points = besideEachOther(points, plane_of_point, voxel_size);
  auto voxels = surfaceVoxels(points, grid_points, voxel_size);
  plane_of_voxel.assign(voxels.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i)
    plane_of_voxel[voxels.cells.cell_of_point[i]] = plane_of_point[i];
  return voxels;
}

} // namespace pcl::indoor
