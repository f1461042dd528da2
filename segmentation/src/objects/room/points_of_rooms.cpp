/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/room_objects.h>

#include <pcl/common/point_tests.h> // for isFinite
#include <pcl/exceptions.h>
#include <pcl/indoor/stray_points.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl::indoor {

std::vector<Indices>
pointsOfRooms(const PointCloud<PointXYZ>& points,
              const std::vector<std::uint32_t>& room_of_point,
              std::size_t room_count)
{
  if (room_of_point.size() != points.size())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        room_of_point.size()
                            << " rooms do not fit " << points.size() << " points");
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

} // namespace pcl::indoor
