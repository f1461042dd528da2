/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/structure/enclosed_structure.h"

#include "objects/structure/plane_frame.h"
#include "objects/structure/point_groups.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <unordered_map>

namespace {

using pcl::indoor::near_surface_voxels;
using pcl::indoor::ObjectScene;
using pcl::indoor::PlaneCell;
using pcl::indoor::PlaneFrame;
using pcl::indoor::PlaneShadow;
using pcl::indoor::PointGroups;
using pcl::indoor::StructurePlane;

using Members = pcl::indoor::SegmentMembers;
using Box = pcl::indoor::PointBox;

constexpr double cells_per_point = 20; // with more, a segment is too sparse
constexpr double casing_depth = 0.2;   // metres, on either side of a wall

/** Whether at least 95 % of some points lie within casing_depth of a plane, as those of
 * casings of doors and windows do; true for no points. */
bool
isCasing(const Members& members,
         const StructurePlane& plane,
         const std::vector<Eigen::Vector3f>& points)
{
  const double allowed = 0.05 * static_cast<double>(members.size());
  double far = 0;
  return std::all_of(members.begin(), members.end(), [&](std::uint32_t i) {
    far += std::abs(plane.heightOf(points[i].cast<double>())) > casing_depth;
    return far <= allowed;
  });
}

/** The plane ends where others begin, which stand on it. */
void
markEnds(const PlaneFrame& frame,
         const PlaneCell& low,
         const PlaneCell& high,
         const std::vector<const StructurePlane*>& others,
         double voxel_size,
         PlaneShadow& shadow)
{
  for (const auto* other : others) {
    const auto side = frame.sideOf(other->normal);
    for (auto row = low[1]; row <= high[1]; ++row)
      for (auto column = low[0]; column <= high[0]; ++column)
        if (std::abs(other->heightOf(frame.placeOf({column, row}))) <
            near_surface_voxels * voxel_size)
          shadow.end({column, row}, side);
  }
}

/** A point seen along the normal of a plane. */
struct Projection {
  PlaneCell cell;
  double depth; // from the plane, voxels
};

/** The cells of a plane that a segment encloses from one side.
 * \param[in] is_casing what is within its outline is its own, covered or not */
std::vector<PlaneCell>
cellsEnclosedBy(const std::vector<Projection>& segment,
                bool is_casing,
                const PlaneFrame& frame,
                const std::vector<const StructurePlane*>& others,
                double voxel_size)
{
  if (segment.empty())
    return {};
  auto low = segment.front().cell, high = low;
  std::size_t touching = 0, deep = 0;
  for (const auto& [cell, depth] : segment) {
    touching += depth < near_surface_voxels;
    deep += depth > 0;
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], cell[k]);
      high[k] = std::max(high[k], cell[k]);
    }
  }
  const auto cells = static_cast<double>(high[0] - low[0] + 1) *
                     static_cast<double>(high[1] - low[1] + 1);
  if (touching == 0 || (deep == 0 && !is_casing) ||
      cells > cells_per_point * static_cast<double>(segment.size()))
    return {};
  PlaneShadow shadow(low, high);
  for (const auto& [cell, depth] : segment) {
    if (depth < near_surface_voxels)
      shadow.mark(cell, PlaneShadow::closing);
    if (depth > 0)
      shadow.mark(cell, PlaneShadow::covered);
  }
  if (is_casing)
    shadow.coverAll();
  markEnds(frame, low, high, others, voxel_size, shadow);
  return shadow.enclosed();
}

struct CellHash {
  std::size_t
  operator()(const PlaneCell& cell) const
  {
    return std::hash<std::int64_t>()(cell[0] * 0x9E3779B1 + cell[1]);
  }
};

using SegmentOfCell = std::unordered_map<PlaneCell, std::uint32_t, CellHash>;
using MembersOfCell = std::unordered_map<PlaneCell, Members, CellHash>;

MembersOfCell
membersOfCells(const std::vector<Eigen::Vector3f>& points,
               const Members& members,
               const PlaneFrame& frame)
{
  MembersOfCell members_of_cell;
  for (const auto i : members)
    members_of_cell[frame.cellOf(points[i])].push_back(i);
  return members_of_cell;
}

std::size_t
countMembers(const std::vector<PlaneCell>& cells, const MembersOfCell& members_of_cell)
{
  std::size_t count = 0;
  for (const auto& cell : cells)
    if (const auto found = members_of_cell.find(cell); found != members_of_cell.end())
      count += found->second.size();
  return count;
}

Members
smallestFirst(const PointGroups& objects)
{
  Members order;
  for (std::uint32_t s = 0; s < objects.members.size(); ++s)
    if (!objects.members[s].empty())
      order.push_back(s);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) {
    return objects.members[a].size() < objects.members[b].size();
  });
  return order;
}

/** Looks for the segments around cells of planes. */
class EnclosureFinder {
public:
  EnclosureFinder(const ObjectScene& scene,
                  const PointGroups& structure,
                  const PointGroups& objects)
  : scene_(scene)
  , objects_(objects)
  , smallest_first_(smallestFirst(objects))
  {
    for (const auto& box : structure.boxes)
      reach_.push_back(
          pcl::indoor::widened(box, near_surface_voxels * scene.voxel_size));
    for (const auto& members : structure.members)
      max_opening_.push_back(members.size() / 2);
  }

  /** Who encloses which cells of a plane; of several, the smallest. */
  SegmentOfCell
  segmentsAround(std::size_t plane,
                 const PlaneFrame& frame,
                 const MembersOfCell& members_of_cell) const
  {
    SegmentOfCell segments;
    for (const auto s : smallest_first_) {
      const auto& members = objects_.members[s];
      if (!reach_[plane].intersects(objects_.boxes[s]) || !touches(members, frame))
        continue;
      const auto others = planesAcross(plane, objects_.boxes[s]);
      const bool is_casing = isCasing(members, scene_.planes[plane], scene_.points);
      for (const auto& side : project(members, frame)) {
        const auto cells =
            cellsEnclosedBy(side, is_casing, frame, others, scene_.voxel_size);
        if (is_casing && countMembers(cells, members_of_cell) > max_opening_[plane])
          continue;
        for (const auto& cell : cells)
          segments.emplace(cell, s);
      }
    }
    return segments;
  }

private:
  bool
  touches(const Members& members, const PlaneFrame& frame) const
  {
    return std::any_of(members.begin(), members.end(), [&](std::uint32_t i) {
      return std::abs(frame.heightOf(scene_.points[i])) < near_surface_voxels;
    });
  }

  /** Those that a segment reaches, and that stand on the plane. */
  std::vector<const StructurePlane*>
  planesAcross(std::size_t plane, const Box& segment) const
  {
    std::vector<const StructurePlane*> others;
    for (std::size_t q = 0; q < scene_.planes.size(); ++q)
      if (pcl::indoor::areAcross(scene_.planes[q].normal,
                                 scene_.planes[plane].normal) &&
          reach_[q].intersects(segment))
        others.push_back(&scene_.planes[q]);
    return others;
  }

  /** The points before a plane and those behind it, both with those that lie in it. */
  std::array<std::vector<Projection>, 2>
  project(const Members& members, const PlaneFrame& frame) const
  {
    std::array<std::vector<Projection>, 2> sides;
    for (const auto i : members) {
      const double height = frame.heightOf(scene_.points[i]);
      const auto cell = frame.cellOf(scene_.points[i]);
      if (height >= -1)
        sides[0].push_back({cell, height});
      if (height <= 1)
        sides[1].push_back({cell, -height});
    }
    return sides;
  }

  const ObjectScene& scene_;
  const PointGroups& objects_;
  Members smallest_first_;
  std::vector<Box> reach_;               // of the planes
  std::vector<std::size_t> max_opening_; // in the planes, points
};

} // namespace

namespace pcl::indoor {

std::size_t
yieldEnclosed(const ObjectScene& scene, std::vector<std::uint32_t>& segment_of_point)
{
  assert(isConsistent(scene, segment_of_point.size()));
  if (scene.points.empty() || scene.planes.empty())
    return 0;
  const auto groups = groupPoints(scene, segment_of_point);
  const EnclosureFinder finder(scene, groups.planes, groups.objects);
  const auto axes = axesOf(scene.planes);
  std::size_t yielded = 0;
  for (std::size_t p = 0; p < scene.planes.size(); ++p) {
    if (kindOf(scene.planes[p], scene.up) != StructureKind::Wall)
      continue;
    const PlaneFrame frame(scene.planes[p], axes, scene.voxel_size);
    const auto members_of_cell =
        membersOfCells(scene.points, groups.planes.members[p], frame);
    for (const auto& [cell, segment] :
         finder.segmentsAround(p, frame, members_of_cell)) {
      const auto members = members_of_cell.find(cell);
      if (members == members_of_cell.end())
        continue;
      yielded += members->second.size();
      for (const auto i : members->second)
        segment_of_point[i] = segment;
    }
  }
  return yielded;
}

} // namespace pcl::indoor
