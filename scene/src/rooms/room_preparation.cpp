/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "rooms/room_preparation.h"

#include <pcl/features/hough_normals.h>
#include <pcl/features/multi_scale_normals.h>
#include <pcl/features/normal_orientation.h>
#include <pcl/filters/scan_outliers.h>
#include <pcl/indoor/middle_point.h>
#include <pcl/indoor/neighbor_distance.h>

#include <algorithm>
#include <cstddef>

namespace pcl::indoor::tool {
namespace {

constexpr unsigned threads = 1; // the others are busy with other rooms

template <typename T>
void
keep(const std::vector<std::uint8_t>& removed, std::vector<T>& values)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!removed[i])
      values[count++] = values[i];
  values.resize(count);
}

/** Points without a normal have that of a neighbour that has one, or else upwards. */
void
fillGaps(const Adjacency& neighbors, std::vector<Eigen::Vector3f>& normals)
{
  const auto found = normals;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (found[i].allFinite())
      continue;
    normals[i] = Eigen::Vector3f::UnitZ();
    for (const auto neighbor : neighbors.of(i))
      if (found[neighbor].allFinite()) {
        normals[i] = found[neighbor];
        break;
      }
  }
}

PointCloud<Normal>
estimated(const std::string& method, const PointCloud<PointXYZ>& cloud)
{
  if (method == "multi_scale") {
    MultiScaleNormalOptions options;
    options.threads = threads;
    return multiScaleNormals(cloud, options);
  }
  HoughNormalEstimation<PointXYZ> estimation(threads);
  estimation.setInputCloud(cloud.makeShared());
  PointCloud<Normal> normals;
  estimation.compute(normals);
  return normals;
}

/** Normals that face the free space, one per point; none if there can be none. */
std::vector<Eigen::Vector3f>
normalsOf(const std::string& method, const std::vector<Eigen::Vector3f>& points)
{
  PointCloud<PointXYZ> cloud;
  for (const auto& point : points)
    cloud.emplace_back(point.x(), point.y(), point.z());
  std::vector<Eigen::Vector3f> normals;
  for (const auto& normal : estimated(method, cloud))
    normals.emplace_back(normal.getNormalVector3fMap());
  if (normals.empty())
    return normals;
  const auto neighbors = nearestNeighbors(points, 8, threads);
  fillGaps(neighbors, normals);
  FreeSpaceOptions free_space;
  free_space.threads = threads;
  orientNormals(
      NormalOrientation::FreeSpace, points, neighbors, {}, free_space, normals);
  return normals;
}

} // namespace

std::vector<std::uint8_t>
prepareRoom(const RoomPreparation& preparation, RoomPoints& room)
{
  std::vector<std::uint8_t> removed;
  const bool has_normals = preparation.normals == "voxels" || !room.normals.empty();
  if (room.positions.empty() || (has_normals && !preparation.removes_outliers))
    return removed;
  auto points = room.positions;
  moveToMiddle(points);
  if (preparation.removes_outliers) {
    ScanOutlierOptions options;
    options.threads = threads;
    removed = scanOutliers(points, options);
    keep(removed, points);
    keep(removed, room.positions);
    keep(removed, room.normals);
    keep(removed, room.given);
  }
  if (!has_normals && !points.empty())
    room.normals = normalsOf(preparation.normals, points);
  return removed;
}

void
putBack(const std::vector<std::uint8_t>& removed, RoomObjects& objects)
{
  if (removed.empty())
    return;
  const auto spread = [&removed](std::vector<std::uint32_t>& values) {
    std::vector<std::uint32_t> all(removed.size(), 0);
    std::size_t next = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (!removed[i])
        all[i] = values[next++];
    values = std::move(all);
  };
  if (objects.object_of_point.empty()) { // all were taken out
    objects.object_of_point.assign(removed.size(), 0);
    objects.structure_of_point.assign(removed.size(), 0);
    return;
  }
  spread(objects.object_of_point);
  spread(objects.structure_of_point);
  if (objects.votes.class_count > 0)
    spread(objects.votes.voxel_of_point);
}

} // namespace pcl::indoor::tool
