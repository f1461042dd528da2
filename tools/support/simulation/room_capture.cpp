/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "simulation/room_capture.h"

#include <pcl/simulation/random_draw.h>

#include <string>

namespace pcl::indoor::tool {

void
takeDefaults(const RoomCapture& rooms,
             RangeSensorOptions& sensor,
             TrajectoryOptions& trajectory)
{
  const auto& camera = rooms.camera;
  sensor.min_range = camera.camera.min_range;
  sensor.max_range = camera.camera.max_range;
  sensor.noise = camera.noise;
  sensor.drift = camera.drift;
  trajectory.spacing = camera.spacing;
  trajectory.sensor_height = camera.height;
}

void
addCaptureOptions(OptionParser& parser, RoomCapture& rooms)
{
  const std::string camera = std::string(hand_camera) + ": ";
  parser
      .number("-room",
              rooms.room,
              camera + "number of the room that is captured, with what is seen through "
                       "doors; 0 = one room after the other, each without",
              "",
              Range::atLeast(0))
      .number("-points",
              rooms.most_points,
              camera + "of a room with more vertices this many are drawn",
              "",
              Range::atLeast(1))
      .number("-fusion_voxel",
              rooms.camera.voxel_size,
              camera + "edge of a voxel that the views are fused in",
              "m",
              Range::between(0.005, 0.2));
}

void
complete(RoomCapture& rooms,
         const RangeSensorOptions& sensor,
         const TrajectoryOptions& trajectory)
{
  auto& camera = rooms.camera;
  camera.camera.min_range = sensor.min_range;
  camera.camera.max_range = sensor.max_range;
  camera.noise = sensor.noise;
  camera.drift = sensor.drift;
  camera.spacing = trajectory.spacing;
  camera.height = trajectory.sensor_height;
  camera.most_points = static_cast<std::size_t>(rooms.most_points);
  camera.seed = sensor.seed;
  camera.threads = sensor.threads;
}

SimulatedScan
captureRooms(const Building& building, const RoomCapture& rooms, Progress& progress)
{
  const auto room_count = static_cast<int>(building.rooms.size());
  if (rooms.room > room_count)
    throw ToolError("-room must be at most " + std::to_string(room_count) + ", not " +
                    std::to_string(rooms.room));
  const int first = rooms.room > 0 ? rooms.room : 1;
  const int last = rooms.room > 0 ? rooms.room : room_count;
  progress.start("Capturing " + std::to_string(last - first + 1) + " rooms");
  SimulatedScan all;
  for (int room = first; room <= last; ++room) {
    const auto number = static_cast<std::uint32_t>(room);
    auto camera = rooms.camera;
    camera.seed = mixSeed(rooms.camera.seed, number);
    const auto scan = captureRoom(building, number, camera);
    all.ray_count += scan.ray_count;
    for (const auto& point : scan.points)
      if (rooms.room > 0 || point.room == number)
        all.points.push_back(point);
    progress.update(room - first + 1, last - first + 1);
  }
  all.poses.assign(all.points.size(), 0);
  progress.done(std::to_string(all.ray_count) + " pixels, " +
                std::to_string(all.points.size()) + " vertices");
  return all;
}

} // namespace pcl::indoor::tool
