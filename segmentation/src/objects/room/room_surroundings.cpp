/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/room_objects.h>

#include <pcl/indoor/most_frequent.h>
#include <pcl/indoor/point_cells.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace {

using pcl::indoor::Adjacency;
using pcl::indoor::PointCells;

constexpr double cell_size = 0.25; // metres: no gap between points of a sparse scan
constexpr int steps = 2;           // cells: half a metre, as deep as a cupboard

/** The room that most points of each cell are in, of equal ones the smaller number; 0
 * if none is in a room. */
std::vector<std::uint32_t>
roomsOfCells(const PointCells& cells, const std::vector<std::uint32_t>& room_of_point)
{
  std::vector<std::uint32_t> rooms(cells.size(), 0), own;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    own.clear();
    for (const auto point : cells.pointsOf(cell))
      if (room_of_point[point] > 0)
        own.push_back(room_of_point[point]);
    rooms[cell] = pcl::indoor::mostFrequent(own, 0u);
  }
  return rooms;
}

/** The room of the nearest cell around one that is in a room; 0 if there is none. */
std::uint32_t
roomBeside(std::size_t cell,
           const PointCells& cells,
           const Adjacency& around,
           const std::vector<std::uint32_t>& rooms)
{
  std::pair<int, std::uint32_t> nearest{4, 0u}; // squared distance, room
  for (const auto other : around.of(cell))
    if (rooms[other] > 0) {
      const int distance = (pcl::indoor::cellIndex(cells.keys[cell]) -
                            pcl::indoor::cellIndex(cells.keys[other]))
                               .squaredNorm();
      nearest = std::min(nearest, {distance, rooms[other]});
    }
  return nearest.second;
}

} // namespace

namespace pcl::indoor {

std::vector<std::uint32_t>
withSurroundings(const std::vector<Eigen::Vector3f>& positions,
                 std::vector<std::uint32_t> room_of_point)
{
  if (std::find(room_of_point.begin(), room_of_point.end(), 0u) == room_of_point.end())
    return room_of_point;
  const auto cells = groupByCell(positions, cell_size);
  const auto around = cellAdjacency(cells.keys);
  auto rooms = roomsOfCells(cells, room_of_point);
  std::vector<std::uint32_t> left;
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell)
    if (rooms[cell] == 0)
      left.push_back(cell);
  for (int step = 0; step < steps; ++step) {
    const auto before = rooms;
    for (const auto cell : left)
      if (before[cell] == 0)
        rooms[cell] = roomBeside(cell, cells, around, before);
  }
  for (std::size_t i = 0; i < room_of_point.size(); ++i)
    if (room_of_point[i] == 0)
      room_of_point[i] = rooms[cells.cell_of_point[i]];
  return room_of_point;
}

} // namespace pcl::indoor
