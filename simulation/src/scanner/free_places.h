/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/building.h>

#include <vector>

namespace pcl::indoor {

/** \brief A place where the carrier of a sensor may be. */
struct FreePlace {
  Eigen::Vector2d at; ///< metres, as drawn: before the building leans
  double free;        ///< metres to the nearest wall or piece of furniture (> 0)
};

/** \brief What the sensor's carrier walks on: the floor of a room, or a platform in it.
 */
struct Level {
  const Building& building;
  std::uint32_t room_number;
  const PlatformInfo* platform; ///< none: the floor

  const RoomInfo&
  room() const
  {
    return building.rooms[room_number - 1];
  }

  double
  heightAt(const Eigen::Vector2d& at) const
  {
    return platform ? platform->elevation + platform->top.heightAt(at) : room().floor;
  }

  double
  headroomAt(const Eigen::Vector2d& at) const
  {
    return room().floor + room().ceiling.heightAt(at) - heightAt(at);
  }

  /** \brief Where a sensor is that is carried this high, or just below the ceiling. */
  Eigen::Vector3d
  sensorAt(const Eigen::Vector2d& at, double height) const;
};

/** \brief Distance between neighbouring places, metres. */
constexpr double place_step = 0.2;

/** \brief All places of a grid on a level that nothing blocks up to a height. */
std::vector<FreePlace>
placesOn(const Level& level, double height);

/** \brief The freest place first, then always the one farthest from all chosen ones. */
std::vector<Eigen::Vector2d>
spread(const std::vector<FreePlace>& places, double spacing, double clearance);

} // namespace pcl::indoor
