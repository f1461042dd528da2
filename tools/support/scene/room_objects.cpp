/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/room_objects.h"

#include "command_line/options.h" // for AlreadyReported

#include <pcl/common/io.h>          // for copyPointCloud
#include <pcl/common/point_tests.h> // for isFinite
#include <pcl/ml/parallel_objects.h>
#include <pcl/segmentation/noise_resilient_lccp.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <unordered_map>

namespace pcl::indoor::tool {
namespace {

/** The numbers of the given objects of a room as 1 ... n, by their first points. */
std::vector<std::uint32_t>
numbersInRoom(const std::vector<std::uint32_t>& given, const Indices& room)
{
  std::unordered_map<std::uint32_t, std::uint32_t> numbers{{0, 0}};
  std::vector<std::uint32_t> result;
  for (const auto index : room) {
    const auto next = static_cast<std::uint32_t>(numbers.size());
    result.push_back(numbers.emplace(given[index], next).first->second);
  }
  return result;
}

/** The objects of one room, from 1, and their surfaces. */
RoomObjects
segmentOneRoom(const PointCloud<PointXYZ>& points,
               const PointCloud<Normal>::ConstPtr& normals,
               const std::vector<std::uint32_t>& given,
               const Indices& room,
               const ObjectSegmentationOptions& options)
{
  auto room_points = pcl::make_shared<PointCloud<PointXYZ>>();
  copyPointCloud(points, room, *room_points);
  NoiseResilientLCCP<PointXYZ> segmentation;
  segmentation.setOptions(options);
  segmentation.setInputCloud(room_points);
  if (normals) {
    auto room_normals = pcl::make_shared<PointCloud<Normal>>();
    copyPointCloud(*normals, room, *room_normals);
    segmentation.setInputNormals(room_normals);
  }
  RoomObjects objects;
  segmentation.segment(objects.object_of_point);
  if (objects.object_of_point.empty())
    throw AlreadyReported();
  objects.structure_of_point = segmentation.getStructure();
  objects.voxel_sizes = {segmentation.getResult().scene.voxel_size};
  if (!given.empty())
    objects.object_of_point = numbersInRoom(given, room);
  auto numbers = objects.object_of_point; // of all points, as all are finite
  const auto count = *std::max_element(numbers.begin(), numbers.end());
  for (auto& number : numbers)
    --number; // 0, no object, becomes a number beyond all objects
  objects.surfaces = objectSurfaces(segmentation.getResult(), numbers, count);
  return objects;
}

/** The finite points of room 1, room 2 and so on; last, of those in no room. */
std::vector<Indices>
pointsOfRooms(const PointCloud<PointXYZ>& points,
              const std::vector<std::uint32_t>& room_of_point)
{
  const std::size_t room_count =
      *std::max_element(room_of_point.begin(), room_of_point.end());
  std::vector<Indices> rooms(room_count + 1);
  for (std::size_t i = 0; i < room_of_point.size(); ++i)
    if (isFinite(points[i]))
      rooms[(room_of_point[i] + room_count) % (room_count + 1)].push_back(
          static_cast<index_t>(i));
  return rooms;
}

/** Large rooms first, so that no thread is left with one at the end. */
std::vector<std::size_t>
orderOfWork(const std::vector<Indices>& rooms)
{
  std::vector<std::size_t> order(rooms.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&rooms](std::size_t a, std::size_t b) {
    return rooms[a].size() > rooms[b].size();
  });
  return order;
}

} // namespace

RoomObjects
segmentRoomObjects(const PointCloud<PointXYZ>& points,
                   const PointCloud<Normal>::ConstPtr& normals,
                   const std::vector<std::uint32_t>& room_of_point,
                   const ObjectSegmentationOptions& options,
                   int threads,
                   const std::vector<std::uint32_t>& given,
                   const std::function<void(std::size_t done, std::size_t all)>& report)
{
  const auto rooms = pointsOfRooms(points, room_of_point);
  const auto order = orderOfWork(rooms);
  std::size_t all = 0;
  for (const auto& room : rooms)
    all += room.size();
  auto room_options = options;
  room_options.threads = 1; // the threads are busy with the rooms
  std::vector<RoomObjects> objects(rooms.size());
  std::size_t done = 0;
  forEachObject(order.size(), static_cast<unsigned int>(threads), [&](std::size_t i) {
    const auto room = order[i];
    if (!rooms[room].empty())
      objects[room] = segmentOneRoom(points, normals, given, rooms[room], room_options);
#pragma omp critical
    report(done += rooms[room].size(), all);
  });

  RoomObjects all_objects;
  all_objects.object_of_point.assign(points.size(), 0);
  all_objects.structure_of_point.assign(points.size(), 0);
  for (std::size_t room = 0; room < rooms.size(); ++room) {
    auto& [object_of_point, structure_of_point, surfaces, voxel_sizes] = objects[room];
    all_objects.voxel_sizes.push_back(voxel_sizes.empty() ? 0.0 : voxel_sizes.front());
    const auto first = static_cast<std::uint32_t>(all_objects.surfaces.size());
    for (std::size_t i = 0; i < object_of_point.size(); ++i)
      if (object_of_point[i] > 0) {
        all_objects.object_of_point[rooms[room][i]] = first + object_of_point[i];
        all_objects.structure_of_point[rooms[room][i]] = structure_of_point[i];
      }
    std::move(
        surfaces.begin(), surfaces.end(), std::back_inserter(all_objects.surfaces));
  }
  return all_objects;
}

} // namespace pcl::indoor::tool
