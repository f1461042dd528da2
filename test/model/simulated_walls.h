/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/model/wall_image.h>
#include <pcl/segmentation/building_rooms.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <random>
#include <vector>

namespace pcl::indoor {

constexpr double simulated_spacing = 0.025; // metres

/** \brief Uniform noise of 5 mm to each side, the same on every machine. */
class SimulatedNoise {
public:
  double
  operator()()
  {
    return 0.01 * (static_cast<double>(rng_() % 1000001) / 1e6 - 0.5);
  }

private:
  std::mt19937 rng_{7};
};

/** \brief A rectangle in a wall, with what is seen in it. */
struct SimulatedHole {
  Eigen::AlignedBox2d box; ///< along, height
  double depth = 0.0;      ///< of what is seen, before the face; 0 = nothing
};

inline Eigen::AlignedBox2d
rectangle(double left, double low, double right, double high)
{
  return {Eigen::Vector2d(left, low), Eigen::Vector2d(right, high)};
}

/** \brief The points of a wall's side, from its begin along it. */
inline std::vector<WallPoint>
simulatedSide(double length, double height, const std::vector<SimulatedHole>& holes)
{
  SimulatedNoise noise;
  std::vector<WallPoint> points;
  const double half = 0.5 * simulated_spacing;
  for (double u = half; u < length; u += simulated_spacing)
    for (double v = half; v < height; v += simulated_spacing) {
      double before = 0.0;
      bool is_seen = true;
      for (const auto& hole : holes)
        if (hole.box.contains(Eigen::Vector2d(u, v))) {
          before = hole.depth;
          is_seen = hole.depth != 0.0;
        }
      if (is_seen)
        points.push_back({static_cast<float>(u),
                          static_cast<float>(before + noise()),
                          static_cast<float>(v)});
    }
  return points;
}

/** \brief Rooms with points on their walls. */
struct SimulatedRooms {
  pcl::PointCloud<pcl::PointXYZ> points;
  std::vector<std::uint32_t> room_of_point;
  std::vector<Room> rooms;

  /** \brief Add a rectangular room, 2.6 m high, whose outline is drawn a little wrong.
   * \param[in] holes per side: below, right, above, left; along it counter-clockwise
   */
  void
  add(const Eigen::AlignedBox2d& box,
      const std::vector<std::vector<SimulatedHole>>& holes,
      double wrong = 0.03)
  {
    const Eigen::Vector2d low = box.min(), high = box.max();
    const std::vector<Eigen::Vector2d> corners{
        low, {high.x(), low.y()}, high, {low.x(), high.y()}};
    Room room;
    room.label = static_cast<std::uint32_t>(rooms.size() + 1);
    room.height = 2.6;
    room.area = box.volume();
    room.lower.setZero();
    room.upper.setZero();
    room.centroid.setZero();
    room.footprint.resize(1);
    for (const auto& corner : corners)
      room.footprint[0].emplace_back(
          corner.x() + (corner.x() < box.center().x() ? wrong : -wrong),
          corner.y() + (corner.y() < box.center().y() ? wrong : -wrong),
          0.0);
    for (std::size_t side = 0; side < 4; ++side) {
      const Eigen::Vector2d begin = corners[side], end = corners[(side + 1) % 4];
      const Eigen::Vector2d along = (end - begin).normalized();
      const Eigen::Vector2d inward(-along.y(), along.x());
      for (const auto& point :
           simulatedSide((end - begin).norm(), room.height, holes[side])) {
        const Eigen::Vector2d place = begin + static_cast<double>(point.along) * along +
                                      static_cast<double>(point.before) * inward;
        points.push_back({static_cast<float>(place.x()),
                          static_cast<float>(place.y()),
                          point.height});
        room_of_point.push_back(room.label);
      }
    }
    rooms.push_back(room);
  }

  PointsOfRooms
  pointsOfRooms() const
  {
    return {points, room_of_point, static_cast<std::uint32_t>(rooms.size())};
  }
};

} // namespace pcl::indoor
