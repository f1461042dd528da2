/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstdint>
#include <string>
#include <vector>

/** Messages with the fields and the types of ROS's own. */
namespace pcl::indoor::test {

struct Time {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
};

struct Header {
  Time stamp;
  std::string frame_id;
};

struct PointField {
  std::string name;
  std::uint32_t offset = 0;
  std::uint8_t datatype = 0;
  std::uint32_t count = 0;
};

/** sensor_msgs/PointCloud2 */
struct PointCloud2 {
  Header header;
  std::uint32_t height = 0, width = 0;
  std::vector<PointField> fields;
  bool is_bigendian = false;
  std::uint32_t point_step = 0, row_step = 0;
  std::vector<std::uint8_t> data;
  bool is_dense = false;
};

struct Point {
  double x = 0, y = 0, z = 0;
};

struct Quaternion {
  double x = 0, y = 0, z = 0, w = 1;
};

struct Pose {
  Point position;
  Quaternion orientation;
};

struct MapMetaData {
  Time map_load_time;
  float resolution = 0;
  std::uint32_t width = 0, height = 0;
  Pose origin;
};

/** nav_msgs/OccupancyGrid */
struct OccupancyGrid {
  Header header;
  MapMetaData info;
  std::vector<std::int8_t> data;
};

struct Color {
  float r = 0, g = 0, b = 0, a = 0;
};

/** visualization_msgs/Marker */
struct Marker {
  enum : std::int32_t { CUBE = 1, LINE_LIST = 5, TEXT_VIEW_FACING = 9 };
  enum : std::int32_t { ADD = 0, DELETEALL = 3 };
  Header header;
  std::string ns;
  std::int32_t id = 0, type = 0, action = 0;
  Pose pose;
  Point scale;
  Color color;
  std::vector<Point> points;
  std::string text;
};

struct MarkerArray {
  std::vector<Marker> markers;
};

} // namespace pcl::indoor::test
