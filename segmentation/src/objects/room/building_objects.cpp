/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/room_objects.h>

#include <pcl/common/point_tests.h> // for isFinite
#include <pcl/exceptions.h>
#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/stray_points.h>

#include <algorithm>
#include <iterator>
#include <mutex>
#include <numeric>
#include <utility>

namespace pcl {
namespace indoor {
namespace {

RoomPoints
pointsOf(const Indices& room,
         const PointCloud<PointXYZ>& points,
         const PointCloud<Normal>::ConstPtr& normals,
         const std::vector<std::uint32_t>& given)
{
  RoomPoints own;
  for (const auto index : room) {
    own.positions.emplace_back(points[index].getVector3fMap());
    if (normals)
      own.normals.emplace_back((*normals)[index].getNormalVector3fMap());
    if (!given.empty())
      own.given.push_back(given[index]);
  }
  return own;
}

void
requireOnePerPoint(std::size_t count, std::size_t point_count, const char* what)
{
  if (count != point_count)
    PCL_THROW_EXCEPTION(BadArgumentException,
                        count << " " << what << " do not fit " << point_count
                              << " points");
}

/** The objects of the rooms, one room after the other. */
BuildingObjects
gathered(const std::vector<Indices>& rooms,
         std::vector<RoomObjects> objects,
         std::size_t point_count)
{
  BuildingObjects all;
  all.object_of_point.assign(point_count, 0);
  all.structure_of_point.assign(point_count, 0);
  for (std::size_t room = 0; room < rooms.size(); ++room) {
    auto& own = objects[room];
    all.voxel_sizes.push_back(own.voxel_size);
    const auto first = static_cast<std::uint32_t>(all.surfaces.size());
    for (std::size_t i = 0; i < own.object_of_point.size(); ++i) {
      if (own.object_of_point[i] > 0)
        all.object_of_point[rooms[room][i]] = first + own.object_of_point[i];
      all.structure_of_point[rooms[room][i]] = own.structure_of_point[i];
    }
    std::move(
        own.surfaces.begin(), own.surfaces.end(), std::back_inserter(all.surfaces));
  }
  return all;
}

} // namespace

std::vector<Indices>
pointsOfRooms(const PointCloud<PointXYZ>& points,
              const std::vector<std::uint32_t>& room_of_point,
              std::size_t room_count)
{
  requireOnePerPoint(room_of_point.size(), points.size(), "rooms");
  Indices used;
  std::vector<Eigen::Vector3f> positions;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (isFinite(points[i])) {
      used.push_back(static_cast<index_t>(i));
      positions.emplace_back(points[i].getVector3fMap());
    }
  const auto strays = strayPoints(positions);
  takeOut(strays, used);
  takeOut(strays, positions);
  std::vector<std::uint32_t> room_of_used;
  for (const auto index : used)
    room_of_used.push_back(room_of_point[index]);
  room_of_used = withSurroundings(positions, std::move(room_of_used));
  std::vector<Indices> rooms(room_count + 1);
  for (std::size_t i = 0; i < used.size(); ++i)
    rooms[(room_of_used[i] + room_count) % (room_count + 1)].push_back(used[i]);
  return rooms;
}

std::vector<std::size_t>
largestFirst(const std::vector<std::size_t>& sizes)
{
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&sizes](std::size_t a, std::size_t b) {
    return sizes[a] > sizes[b];
  });
  return order;
}

BuildingObjects
segmentBuildingObjects(
    const PointCloud<PointXYZ>& points,
    const PointCloud<Normal>::ConstPtr& normals,
    const std::vector<std::uint32_t>& room_of_point,
    const ObjectSegmentationOptions& options,
    int threads,
    const std::vector<std::uint32_t>& given,
    const std::function<void(std::size_t done, std::size_t all)>& report)
{
  if (normals)
    requireOnePerPoint(normals->size(), points.size(), "normals");
  if (!given.empty())
    requireOnePerPoint(given.size(), points.size(), "given objects");
  const std::size_t room_count =
      room_of_point.empty()
          ? 0
          : *std::max_element(room_of_point.begin(), room_of_point.end());
  const auto rooms = pointsOfRooms(points, room_of_point, room_count);
  std::vector<std::size_t> sizes;
  for (const auto& room : rooms)
    sizes.push_back(room.size());
  const auto order = largestFirst(sizes);
  const auto all = std::accumulate(sizes.begin(), sizes.end(), std::size_t(0));
  std::size_t done = 0;
  auto room_options = options;
  room_options.threads = 1; // the threads are busy with the rooms
  std::vector<RoomObjects> objects(rooms.size());
  std::mutex mutex; // of the report
  parallelFor(
      static_cast<std::ptrdiff_t>(order.size()), threads, 1, [&](std::ptrdiff_t i) {
        const auto room = order[static_cast<std::size_t>(i)];
        objects[room] = segmentRoomObjects(
            pointsOf(rooms[room], points, normals, given), room_options);
        const std::lock_guard<std::mutex> lock(mutex);
        done += sizes[room];
        if (report)
          report(done, all);
      });
  return gathered(rooms, std::move(objects), points.size());
}

} // namespace indoor
} // namespace pcl
