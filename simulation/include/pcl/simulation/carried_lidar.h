/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/simulation/carried_path.h>
#include <pcl/simulation/range_sensor.h>

#include <Eigen/Geometry>

#include <vector>

namespace pcl::indoor {

enum class LidarPattern {
  Spinning,    ///< rings about an upright axis: each ring lies on a cone
  NonRepeating ///< a rosette ahead, drawn by two prisms that turn against each other
};

enum class LidarCarrier {
  Robot, ///< level, at one height; a non-repeating sensor looks left and right
  Person ///< sways, bobs, tilts, and hides what is behind the sensor
};

/** \brief Properties of a lidar that is carried along a path. */
struct CarriedLidarOptions : EchoOptions {
  LidarPattern pattern = LidarPattern::Spinning;
  LidarCarrier carrier = LidarCarrier::Robot;
  int rings = 16;                        ///< of a spinning lidar (1 ... 256)
  double lowest_ring = -M_PI / 12;       ///< radians above the horizon (> -pi/2)
  double highest_ring = M_PI / 12;       ///< radians (lowest_ring ... pi/2)
  int steps_per_turn = 900;              ///< rays of each ring in a turn (1 ... 100000)
  double field_width = 70 * M_PI / 180;  ///< of a rosette, radians (0 ... pi)
  double field_height = 77 * M_PI / 180; ///< radians (0 ... pi)
  int rays_per_frame = 10000;            ///< of a rosette (1 ... 10000000)
  double turn_rate = 10.0; ///< turns, or frames, that a second has time for (>= 0.1)
  double frame_rate =
      1.0;             ///< of these, frames per second that are kept (0.001 ... 1000)
  double drift = 0.04; ///< standard deviation of the position after 10 m of way,
                       ///< metres, before loops are closed (>= 0)
  int people = 1;      ///< who walk before and behind the sensor (0 ... 10)
};

/** \brief The lidars that are known by name. */
enum class LidarModel { Spinning, SolidState, Walk };

/** \brief The defaults of a lidar.
 *
 * Spinning: 16 rings within 30 degrees, on a robot; solid state: a rosette of 70 by 77
 * degrees, on a robot; walk: 16 rings within 30 degrees, in a person's hand.
 */
PCL_INDOOR_EXPORTS CarriedLidarOptions
lidarOptions(LidarModel model);

/** \brief How the robot or person of a lidar goes: the height that it is carried at,
 * the speed, and whether it looks around. */
PCL_INDOOR_EXPORTS PathOptions
pathOptions(LidarModel model);

/** \brief A turn of a spinning lidar, or as many rays of another. */
struct LidarFrame {
  std::size_t path = 0; ///< its number
  double time = 0.0;    ///< when it begins, seconds from the start of the path
};

/** \brief The frames of some paths that are kept, at least one of each. */
PCL_INDOOR_EXPORTS std::vector<LidarFrame>
framesOn(const std::vector<CarriedPath>& paths, const CarriedLidarOptions& options);

/** \brief Where the sensor is and how it is turned at a time.
 *
 * Its axes are: x ahead, y to the left, z up. On a robot it is where the path is, and
 * level. A person's hand moves with the steps, lowers and lifts the sensor, and tilts
 * it; phases are drawn from the seed.
 */
PCL_INDOOR_EXPORTS Eigen::Isometry3d
sensorPose(const CarriedPath& path, double time, const CarriedLidarOptions& options);

/** \brief Scan a building with a lidar that is carried along some paths.
 *
 * Each ray starts where the sensor is at its time. Echoes, glass and noise are those of
 * scanBuilding(); the errors of registration grow along a path and are closed at its
 * end. People walk at some distance before and behind the sensor: their points have the
 * category "person", object and part 0, and the room that they are in.
 * \return points frame by frame; poses are numbers of framesOn()
 * \throws BadArgumentException if an option is out of its range, or a path has no point
 */
PCL_INDOOR_EXPORTS SimulatedScan
scanAlong(const Building& building,
          const std::vector<CarriedPath>& paths,
          const CarriedLidarOptions& options);

} // namespace pcl::indoor
