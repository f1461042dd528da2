/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "rooms/room_points_file.h"

#include "files/tool_error.h"

#include <algorithm>
#include <fstream>
#include <vector>

namespace pcl::indoor::tool {
namespace {

constexpr std::size_t vector_size = sizeof(Eigen::Vector3f);

void
append(const Eigen::Vector3f& vector, std::string& bytes)
{
  bytes.append(reinterpret_cast<const char*>(vector.data()), vector_size);
}

} // namespace

std::string
pointsFile(std::size_t room)
{
  return "points_" + std::to_string(room + 1);
}

std::string
pointBytes(const RoomPoints& points)
{
  std::string bytes;
  bytes.reserve(vector_size * (points.positions.size() + points.normals.size()));
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    append(points.positions[i], bytes);
    if (!points.normals.empty())
      append(points.normals[i], bytes);
  }
  return bytes;
}

RoomPoints
readRoomPoints(const std::string& path, std::size_t count, bool has_normals)
{
  std::ifstream stream(path, std::ios::binary);
  RoomPoints points;
  points.positions.reserve(count);
  if (has_normals)
    points.normals.reserve(count);
  const std::size_t record = has_normals ? 2 : 1;
  std::vector<Eigen::Vector3f> block(record << 16);
  for (std::size_t left = count; left > 0;) {
    const std::size_t part = std::min(left, block.size() / record);
    if (!stream.read(reinterpret_cast<char*>(block.data()),
                     static_cast<std::streamsize>(part * record * vector_size)))
      throw ToolError(path + ": the file is gone or too short");
    for (std::size_t k = 0; k < part; ++k) {
      points.positions.push_back(block[k * record]);
      if (has_normals)
        points.normals.push_back(block[k * record + 1]);
    }
    left -= part;
  }
  return points;
}

} // namespace pcl::indoor::tool
