/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/room_objects.h>

#include "objects/object_steps.h"

#include <pcl/exceptions.h>
#include <pcl/indoor/most_frequent.h>
#include <pcl/indoor/quantile.h>

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace pcl::indoor {

namespace {

constexpr float column_size = 0.1f; // metres
constexpr int column_reach = 3;     // columns around an object that show the floor
constexpr std::uint32_t nothing = 0xFFFFFFFFu;

/** \brief The lowest voxel around each upright column of a room that has any. */
class FloorMap {
public:
  explicit FloorMap(const std::vector<Eigen::Vector3f>& centroids)
  {
    if (!centroids.empty())
      corner_ = centroids.front().head<2>();
    for (const auto& centroid : centroids)
      corner_ = corner_.cwiseMin(centroid.head<2>());
    std::unordered_map<std::int64_t, float> lowest;
    for (const auto& centroid : centroids) {
      auto& height = lowest.emplace(columnOf(centroid), centroid.z()).first->second;
      height = std::min(height, centroid.z());
    }
    for (const auto& column : lowest)
      around_[column.first] = lowestAround(column.first, lowest);
  }

  /** \brief REQUIRES: a place in a column that has voxels. */
  float
  at(const Eigen::Vector3f& place) const
  {
    return around_.at(columnOf(place));
  }

private:
  static constexpr std::int64_t row = std::int64_t{1} << 32;

  std::int64_t
  columnOf(const Eigen::Vector3f& point) const
  {
    const Eigen::Vector2f place = (point.head<2>() - corner_) / column_size;
    return static_cast<std::int64_t>(place.x()) * row +
           static_cast<std::int64_t>(place.y());
  }

  static float
  lowestAround(std::int64_t column,
               const std::unordered_map<std::int64_t, float>& lowest)
  {
    float height = lowest.at(column);
    for (int x = -column_reach; x <= column_reach; ++x)
      for (int y = -column_reach; y <= column_reach; ++y)
        if (const auto other = lowest.find(column + x * row + y); other != lowest.end())
          height = std::min(height, other->second);
    return height;
  }

  Eigen::Vector2f corner_ = Eigen::Vector2f::Zero();
  std::unordered_map<std::int64_t, float> around_;
};

/** \brief The object that most points of a voxel belong to, of those in any. */
std::uint32_t
objectOfVoxel(const PointCells& cells,
              std::size_t voxel,
              const std::vector<std::uint32_t>& object_of_point,
              std::uint32_t object_count,
              std::vector<std::uint32_t>& objects)
{
  objects.clear();
  for (const auto point : cells.pointsOf(voxel))
    if (object_of_point[point] < object_count)
      objects.push_back(object_of_point[point]);
  return mostFrequent(objects, nothing);
}

/** \brief From the lowest point to the median floor below the points. */
float
floorDistance(const FloorMap& floor, const std::vector<OrientedPoint>& points)
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
  const auto& voxels = stepsOf(room).scene.voxels;
  if (object_of_point.size() != voxels.cells.cell_of_point.size())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        object_of_point.size()
                            << " objects do not fit "
                            << voxels.cells.cell_of_point.size() << " points");
  std::vector<ObjectSurface> surfaces(object_count);
  std::vector<std::uint32_t> of_voxel; // kept for its memory
  for (std::size_t voxel = 0; voxel < voxels.size(); ++voxel) {
    const auto object =
        objectOfVoxel(voxels.cells, voxel, object_of_point, object_count, of_voxel);
    if (object != nothing && voxels.normals[voxel].squaredNorm() > 0.5f)
      surfaces[object].points.push_back(
          {voxels.centroids[voxel], voxels.normals[voxel]});
  }
  const FloorMap floor(voxels.centroids);
  for (auto& surface : surfaces)
    if (!surface.points.empty())
      surface.floor_distance = floorDistance(floor, surface.points);
  return surfaces;
}

} // namespace pcl::indoor
