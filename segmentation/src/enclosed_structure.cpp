/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/enclosed_structure.h>

#include "plane_shadow.h"

#include <pcl/exceptions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace {

using pcl::indoor::PlaneCell;
using pcl::indoor::PlaneShadow;
using pcl::indoor::StructurePlane;

using Members = std::vector<std::uint32_t>; // indices of points
using Box = Eigen::AlignedBox3f;

constexpr double touch = 2;     // voxels from a plane: what is nearer touches it
constexpr double min_depth = 2; // voxels: what is farther covers what is behind
constexpr std::size_t cells_per_point = 20; // a shadow with more has holes only

/** Cells of a plane, a voxel wide, along two directions of the room. */
class PlaneFrame {
public:
  PlaneFrame(const StructurePlane& plane, const Eigen::Matrix3d& axes, double cell_size)
  : normal_(plane.normal)
  , offset_(plane.offset)
  , cell_size_(cell_size)
  {
    int across = 0;
    (axes.transpose() * normal_).cwiseAbs().maxCoeff(&across);
    const Eigen::Vector3d along = axes.col((across + 1) % 3);
    u_ = (along - along.dot(normal_) * normal_).normalized();
    v_ = normal_.cross(u_);
  }

  /** In front of the plane, voxels. */
  double
  depthOf(const Eigen::Vector3f& point) const
  {
    return (normal_.dot(point.cast<double>()) - offset_) / cell_size_;
  }

  PlaneCell
  cellOf(const Eigen::Vector3f& point) const
  {
    return {indexOf(u_, point), indexOf(v_, point)};
  }

  /** The middle of a cell, in the plane. */
  Eigen::Vector3d
  placeOf(const PlaneCell& cell) const
  {
    return offset_ * normal_ + cell_size_ * ((static_cast<double>(cell[0]) + 0.5) * u_ +
                                             (static_cast<double>(cell[1]) + 0.5) * v_);
  }

private:
  std::int64_t
  indexOf(const Eigen::Vector3d& direction, const Eigen::Vector3f& point) const
  {
    return static_cast<std::int64_t>(
        std::floor(direction.dot(point.cast<double>()) / cell_size_));
  }

  Eigen::Vector3d normal_, u_, v_;
  double offset_, cell_size_;
};

/** The points of planes and of other segments, and the boxes around them. */
struct Groups {
  std::vector<Members> members;
  std::vector<Box> boxes;

  explicit Groups(std::size_t count)
  : members(count)
  , boxes(count)
  {}

  void
  add(std::uint32_t group, std::uint32_t index, const Eigen::Vector3f& point)
  {
    members[group].push_back(index);
    boxes[group].extend(point);
  }
};

Box
widened(Box box, double by)
{
  const Eigen::Vector3f margin = Eigen::Vector3f::Constant(static_cast<float>(by));
  return Box(box.min() - margin, box.max() + margin);
}

/** Cells at planes that stand on this one close a shadow. */
void
markOtherPlanes(const PlaneFrame& frame,
                const PlaneCell& low,
                const PlaneCell& high,
                const std::vector<const StructurePlane*>& others,
                double voxel_size,
                PlaneShadow& shadow)
{
  for (auto row = low[1]; row <= high[1]; ++row)
    for (auto column = low[0]; column <= high[0]; ++column) {
      const PlaneCell cell{column, row};
      const auto place = frame.placeOf(cell);
      for (const auto* other : others)
        if (std::abs(other->normal.dot(place) - other->offset) < touch * voxel_size) {
          shadow.mark(cell, PlaneShadow::closing);
          break;
        }
    }
}

/** The cells of a plane that a segment encloses. */
std::vector<PlaneCell>
cellsEnclosedBy(const std::vector<Eigen::Vector3f>& points,
                const Members& members,
                const PlaneFrame& frame,
                const std::vector<const StructurePlane*>& others,
                double voxel_size)
{
  auto low = frame.cellOf(points[members.front()]), high = low;
  bool touches = false, covers = false;
  for (const auto i : members) {
    const auto depth = frame.depthOf(points[i]);
    touches |= depth < touch;
    covers |= depth > min_depth;
    const auto cell = frame.cellOf(points[i]);
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], cell[k]);
      high[k] = std::max(high[k], cell[k]);
    }
  }
  const auto cells = static_cast<double>(high[0] - low[0] + 1) *
                     static_cast<double>(high[1] - low[1] + 1);
  if (!touches || !covers ||
      cells > static_cast<double>(cells_per_point * members.size()))
    return {};
  PlaneShadow shadow(low, high);
  for (const auto i : members) {
    const auto depth = frame.depthOf(points[i]);
    if (depth < -1) // behind the plane
      continue;
    if (depth < touch)
      shadow.mark(frame.cellOf(points[i]), PlaneShadow::closing);
    if (depth > min_depth)
      shadow.mark(frame.cellOf(points[i]), PlaneShadow::covered);
  }
  markOtherPlanes(frame, low, high, others, voxel_size, shadow);
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

/** Who encloses which cells of a plane; of several, the first of the order. */
SegmentOfCell
segmentsAround(const std::vector<Eigen::Vector3f>& points,
               const std::vector<StructurePlane>& planes,
               std::size_t plane,
               const PlaneFrame& frame,
               const Groups& structure,
               const Groups& objects,
               const Members& order,
               double voxel_size)
{
  const double reach = touch * voxel_size;
  const auto box = widened(structure.boxes[plane], reach);
  SegmentOfCell segments;
  for (const auto s : order) {
    if (!box.intersects(objects.boxes[s]))
      continue;
    std::vector<const StructurePlane*> others;
    for (std::size_t q = 0; q < planes.size(); ++q)
      if (std::abs(planes[q].normal.dot(planes[plane].normal)) < 0.3 &&
          widened(structure.boxes[q], reach).intersects(objects.boxes[s]))
        others.push_back(&planes[q]);
    for (const auto& cell :
         cellsEnclosedBy(points, objects.members[s], frame, others, voxel_size))
      segments.emplace(cell, s);
  }
  return segments;
}

Members
smallestFirst(const Groups& objects)
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

} // namespace

namespace pcl {
namespace indoor {

std::size_t
yieldEnclosed(const std::vector<Eigen::Vector3f>& points,
              const SurfaceVoxels& voxels,
              const std::vector<StructurePlane>& planes,
              double voxel_size,
              const std::vector<std::uint32_t>& plane_of_voxel,
              std::vector<std::uint32_t>& segment_of_point)
{
  const auto& voxel_of_point = voxels.cells.cell_of_point;
  if (voxel_of_point.size() != points.size() ||
      segment_of_point.size() != points.size() ||
      plane_of_voxel.size() != voxels.size())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        points.size()
                            << " points are " << voxel_of_point.size()
                            << " in voxels, with " << segment_of_point.size()
                            << " segments; " << voxels.size() << " voxels have "
                            << plane_of_voxel.size() << " numbers of planes.");
  if (points.empty() || planes.empty())
    return 0;
  Groups objects(1 +
                 *std::max_element(segment_of_point.begin(), segment_of_point.end()));
  Groups structure(planes.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const auto plane = plane_of_voxel[voxel_of_point[i]];
    if (plane == 0)
      objects.add(segment_of_point[i], i, points[i]);
    else
      structure.add(plane - 1, i, points[i]);
  }
  const auto order = smallestFirst(objects);
  const auto axes = axesOf(planes);
  std::size_t yielded = 0;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const PlaneFrame frame(planes[p], axes, voxel_size);
    const auto segment_of_cell =
        segmentsAround(points, planes, p, frame, structure, objects, order, voxel_size);
    for (const auto i : structure.members[p]) {
      const auto found = segment_of_cell.find(frame.cellOf(points[i]));
      if (found == segment_of_cell.end())
        continue;
      segment_of_point[i] = found->second;
      ++yielded;
    }
  }
  return yielded;
}

} // namespace indoor
} // namespace pcl
