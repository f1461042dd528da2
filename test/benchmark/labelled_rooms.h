/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Rooms of labelled scans, to judge segmentations by.
#pragma once

#include "files/cloud_file.h"
#include "files/tool_error.h"

#include <pcl/indoor/point_cells.h>
#include <pcl/segmentation/segmentation_metrics.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

using Cloud = PointCloud<PointXYZ>;

constexpr std::size_t large = 100;        // points of an object
constexpr std::size_t fewest_objects = 3; // large ones in a room
constexpr double flat_thickness = 0.15;   // metres
constexpr double step_of_turns = 11;      // degrees

/** \brief Where rooms come from. */
struct RoomSource {
  std::vector<std::string> scans;
  /** "none": a scan is a room */
  std::string room_field = "room", object_field = "object";
  std::string part_field; ///< empty: objects have no parts
  std::string united;     ///< "2,3/6,7,8": labels of objects that are one object
  unsigned turns = 1;     ///< about the vertical, by 11 degrees each
};

struct LabelledRoom {
  std::string name;
  Cloud::Ptr points = pcl::make_shared<Cloud>();
  SegmentLabels objects, parts;
  std::vector<std::uint32_t> flat, others; ///< large objects: flat on walls, and not
};

/** \brief Distance between the 1st and the 99th percentile. */
inline double
spread(std::vector<float>& values)
{
  const auto rest = static_cast<std::ptrdiff_t>(values.size() / 100);
  const auto low = values.begin() + rest, high = values.end() - 1 - rest;
  std::nth_element(values.begin(), low, values.end());
  const float lowest = *low;
  std::nth_element(values.begin(), high, values.end());
  return *high - lowest;
}

inline bool
isThin(const std::vector<Eigen::Vector3f>& places)
{
  std::vector<float> heights(places.size());
  for (int degrees = 0; degrees < 180; degrees += 5) {
    const double angle = degrees * M_PI / 180;
    const Eigen::Vector3f direction(
        static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0);
    std::transform(places.begin(), places.end(), heights.begin(), [&](const auto& p) {
      return direction.dot(p);
    });
    if (spread(heights) <= flat_thickness)
      return true;
  }
  return false;
}

/** \brief Tell the large objects that are flat on walls from the others. */
inline void
sortObjects(LabelledRoom& room)
{
  std::vector<Eigen::Vector3f> places;
  std::vector<std::uint32_t> objects;
  std::map<std::uint32_t, std::vector<Eigen::Vector3f>> places_of;
  for (std::size_t i = 0; i < room.objects.size(); ++i)
    if (const auto& point = (*room.points)[i]; std::isfinite(point.x)) {
      places.push_back(point.getVector3fMap());
      objects.push_back(room.objects[i]);
      places_of[objects.back()].push_back(places.back());
    }
  const auto cells = groupByCell(places, flat_thickness);
  const auto around = cellAdjacency(cells.keys);
  std::vector<std::uint8_t> near_wall(cells.size(), 0);
  for (std::size_t i = 0; i < places.size(); ++i)
    if (objects[i] == 0)
      near_wall[cells.cell_of_point[i]] |= 1;
  for (std::uint32_t c = 0; c < cells.size(); ++c)
    for (const auto other : around.of(c))
      near_wall[c] |= near_wall[other] & 1 ? 2 : 0;
  std::map<std::uint32_t, std::size_t> on_wall;
  for (std::size_t i = 0; i < places.size(); ++i)
    on_wall[objects[i]] += near_wall[cells.cell_of_point[i]] != 0;
  for (const auto& [object, own] : places_of) {
    if (object == 0 || own.size() < large)
      continue;
    const bool is_flat = 2 * on_wall[object] >= own.size() && isThin(own);
    (is_flat ? room.flat : room.others).push_back(object);
  }
}

inline LabelledRoom
turned(const LabelledRoom& room, unsigned turn)
{
  auto result = room;
  result.points = pcl::make_shared<Cloud>(*room.points);
  const double angle = turn * step_of_turns * M_PI / 180;
  const auto cosine = static_cast<float>(std::cos(angle)),
             sine = static_cast<float>(std::sin(angle));
  for (auto& point : *result.points) {
    const float x = point.x, y = point.y;
    point.x = cosine * x - sine * y;
    point.y = sine * x + cosine * y;
  }
  if (turn > 0)
    result.name += ", turned by " + std::to_string(turn * step_of_turns);
  return result;
}

/** \brief Give all labels of a group the first of it. */
inline void
unite(const std::string& groups, std::vector<std::uint32_t>& labels)
{
  std::map<std::uint32_t, std::uint32_t> first_of;
  std::istringstream stream(groups);
  for (std::string group; std::getline(stream, group, '/');) {
    std::istringstream members(group);
    std::vector<std::uint32_t> numbers;
    for (std::string number; std::getline(members, number, ',');) {
      if (number.empty() || number.size() > 9 ||
          number.find_first_not_of("0123456789") != std::string::npos)
        throw ToolError("-unite: '" + number + "' is no label");
      numbers.push_back(static_cast<std::uint32_t>(std::stoul(number)));
      first_of[numbers.back()] = numbers.front();
    }
  }
  for (auto& label : labels)
    if (const auto found = first_of.find(label); found != first_of.end())
      label = found->second;
}

inline std::vector<LabelledRoom>
cutRooms(const std::string& path, const RoomSource& source)
{
  const auto file = loadCloud(path);
  auto object_of = readLabels(file, source.object_field);
  const auto part_of =
      source.part_field.empty() ? object_of : readLabels(file, source.part_field);
  unite(source.united, object_of);
  if (source.room_field == "none") {
    LabelledRoom room{path, file.points, object_of, part_of, {}, {}};
    return {room};
  }
  const auto room_of = readLabels(file, source.room_field);
  std::map<std::uint32_t, LabelledRoom> rooms;
  for (std::size_t i = 0; i < room_of.size(); ++i) {
    if (room_of[i] == 0)
      continue;
    auto& room = rooms[room_of[i]];
    room.points->push_back((*file.points)[i]);
    room.objects.push_back(object_of[i]);
    room.parts.push_back(part_of[i]);
  }
  std::vector<LabelledRoom> all;
  for (auto& [number, room] : rooms) {
    room.name = path + " " + source.room_field + " " + std::to_string(number);
    all.push_back(std::move(room));
  }
  return all;
}

/** \brief The rooms of all scans with at least three large objects, each as often as
 * it is turned.
 * \throws ToolError if there is none */
inline std::vector<LabelledRoom>
loadRooms(const RoomSource& source)
{
  std::vector<LabelledRoom> rooms;
  for (const auto& scan : source.scans)
    for (auto& room : cutRooms(scan, source)) {
      sortObjects(room);
      if (room.flat.size() + room.others.size() < fewest_objects &&
          source.room_field != "none")
        continue;
      for (unsigned turn = 0; turn < source.turns; ++turn)
        rooms.push_back(turned(room, turn));
    }
  if (rooms.empty())
    throw ToolError("no room has three objects of 100 points");
  return rooms;
}

} // namespace pcl::indoor::tool
