/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/object_surfaces.h>

#include <pcl/exceptions.h>
#include <pcl/indoor/quantile.h>
#include <pcl/indoor/voxel_map.h> // for PixelMap

#include <algorithm>
#include <limits>

namespace pcl {
namespace indoor {

namespace {

constexpr float column_size = 0.1f; // metres
constexpr int column_reach = 3;     // columns around an object that show the floor
constexpr std::uint32_t nothing = 0xFFFFFFFFu;

/** \brief The lowest height in each upright column of a room. */
struct FloorMap {
  Eigen::Vector2f corner = Eigen::Vector2f::Zero();
  PixelMap<float> heights;

  float&
  at(const Eigen::Vector3f& point)
  {
    const Eigen::Vector2f place = (point.head<2>() - corner) / column_size;
    return heights.at(static_cast<int>(place.x()), static_cast<int>(place.y()));
  }
};

/** \brief The object that most points of a voxel belong to. */
std::uint32_t
objectOfVoxel(const PointCells& cells,
              std::size_t voxel,
              const std::vector<std::uint32_t>& object_of_point,
              std::uint32_t object_count)
{
  std::uint32_t object = nothing;
  int lead = 0; // Boyer and Moore's vote
  for (const auto point : cells.pointsOf(voxel)) {
    const auto own = object_of_point[point];
    if (own >= object_count)
      continue;
    if (lead == 0)
      object = own;
    lead += own == object ? 1 : -1;
  }
  return object;
}

/** \brief Replace each value of a line by the lowest one within column_reach columns.
 */
template <typename At>
void
spreadLowest(int length, const At& at)
{
  std::vector<float> line(static_cast<std::size_t>(length));
  for (int k = 0; k < length; ++k)
    line[static_cast<std::size_t>(k)] = at(k);
  for (int k = 0; k < length; ++k) {
    const auto first = line.begin() + std::max(k - column_reach, 0);
    const auto last = line.begin() + std::min(k + column_reach + 1, length);
    at(k) = *std::min_element(first, last);
  }
}

/** \brief The lowest voxel around each column. */
FloorMap
floorBelow(const std::vector<Eigen::Vector3f>& centroids)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  FloorMap floor;
  if (centroids.empty())
    return floor;
  Eigen::Vector2f upper = centroids.front().head<2>();
  floor.corner = upper;
  for (const auto& centroid : centroids) {
    floor.corner = floor.corner.cwiseMin(centroid.head<2>());
    upper = upper.cwiseMax(centroid.head<2>());
  }
  auto& heights = floor.heights;
  heights.nx = static_cast<int>((upper.x() - floor.corner.x()) / column_size) + 1;
  heights.ny = static_cast<int>((upper.y() - floor.corner.y()) / column_size) + 1;
  heights.values.assign(heights.size(), infinity);
  for (const auto& centroid : centroids)
    floor.at(centroid) = std::min(floor.at(centroid), centroid.z());
  for (int y = 0; y < heights.ny; ++y)
    spreadLowest(heights.nx, [&](int x) -> float& { return heights.at(x, y); });
  for (int x = 0; x < heights.nx; ++x)
    spreadLowest(heights.ny, [&](int y) -> float& { return heights.at(x, y); });
  return floor;
}

/** \brief From the lowest point to the median floor below the points. */
float
floorDistance(FloorMap& floor, const std::vector<OrientedPoint>& points)
{
  std::vector<float> heights;
  float lowest = std::numeric_limits<float>::infinity();
  for (const auto& point : points) {
    heights.push_back(floor.at(point.position));
    lowest = std::min(lowest, point.position.z());
  }
  return std::max(lowest - median(heights), 0.0f);
}

} // namespace

std::vector<ObjectSurface>
objectSurfaces(const ObjectSegmentation& room,
               const std::vector<std::uint32_t>& object_of_point,
               std::uint32_t object_count)
{
  const auto& voxels = room.scene.voxels;
  if (object_of_point.size() != voxels.cells.cell_of_point.size())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        object_of_point.size()
                            << " objects do not fit "
                            << voxels.cells.cell_of_point.size() << " points");
  std::vector<ObjectSurface> surfaces(object_count);
  for (std::size_t voxel = 0; voxel < voxels.size(); ++voxel) {
    const auto object =
        objectOfVoxel(voxels.cells, voxel, object_of_point, object_count);
    if (object != nothing && voxels.normals[voxel].squaredNorm() > 0.5f)
      surfaces[object].points.push_back(
          {voxels.centroids[voxel], voxels.normals[voxel]});
  }
  auto floor = floorBelow(voxels.centroids);
  for (auto& surface : surfaces)
    if (!surface.points.empty())
      surface.floor_distance = floorDistance(floor, surface.points);
  return surfaces;
}

} // namespace indoor
} // namespace pcl
