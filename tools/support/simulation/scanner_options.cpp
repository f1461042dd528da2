/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "simulation/scanner_options.h"

#include "command_line/preset.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

namespace {

const std::map<std::string, LidarModel>&
lidarModels()
{
  static const std::map<std::string, LidarModel> models{
      {"spinning", LidarModel::Spinning},
      {"solid_state", LidarModel::SolidState},
      {"walk", LidarModel::Walk}};
  return models;
}

/** An option that does not count for all scanners. */
struct SpecialOption {
  const char* name;
  std::vector<std::string> scanners;
};

const std::vector<SpecialOption>&
specialOptions()
{
  static const std::vector<std::string> all{"spinning", "solid_state", "walk"},
      rings{"spinning", "walk"}, field{"solid_state"}, camera{hand_camera},
      lidars{"sphere", "spinning", "solid_state", "walk"};
  static const std::vector<SpecialOption> names{
      {"-rays_per_pose", {"sphere", "solid_state"}},
      {"-rings", rings},
      {"-lowest_ring", rings},
      {"-highest_ring", rings},
      {"-steps_per_turn", rings},
      {"-field_width", field},
      {"-field_height", field},
      {"-turn_rate", all},
      {"-frame_rate", all},
      {"-speed", all},
      {"-entered", all},
      {"-people", all},
      {"-beam", lidars},
      {"-dropout", lidars},
      {"-glass", lidars},
      {"-glass_echo", lidars},
      {"-room", camera},
      {"-points", camera},
      {"-fusion_voxel", camera}};
  return names;
}

void
addPathOptions(OptionParser& parser, ScannerOptions& options)
{
  parser
      .text("-scanner",
            options.name,
            "sphere: looks all around from one position after another; carried along a "
            "path through doors: spinning: rings of a lidar on a robot; solid_state: a "
            "lidar that looks ahead, on a robot; walk: a spinning one in a person's "
            "hand; depth_camera: in somebody's hand, room by room, fused to a surface. "
            "Defaults below are those of the scanner that is named before -h",
            {"sphere", "spinning", "solid_state", "walk", hand_camera})
      .number(
          "-spacing",
          options.trajectory.spacing,
          "distance between positions; of carried scanners, between places that the "
          "path comes to",
          "m",
          Range::positive())
      .number("-height",
              options.trajectory.sensor_height,
              "height of the sensor above the floor",
              "m",
              Range::positive());
}

void
addSensorOptions(OptionParser& parser, RangeSensorOptions& sensor)
{
  const Range share = Range::between(0.0, 1.0);
  parser
      .number("-rays_per_pose",
              sensor.rays_per_pose,
              "sphere, solid_state: rays sent from each position or in a frame",
              "",
              Range::atLeast(1))
      .number("-min_range",
              sensor.min_range,
              "nearest surface that gives an echo",
              "m",
              Range::atLeast(0.0))
      .number("-max_range",
              sensor.max_range,
              "farthest surface that gives an echo",
              "m",
              Range::positive())
      .number("-noise",
              sensor.noise,
              "standard deviation of a range; of depth_camera at 1 m, growing with its "
              "square",
              "m",
              Range::atLeast(0.0))
      .number(
          "-drift",
          sensor.drift,
          "standard deviation of the error of a position; of carried scanners after "
          "10 m of way, before it is closed at the end",
          "m",
          Range::atLeast(0.0))
      .number("-beam",
              sensor.beam,
              "standard deviation of the directions in a beam, 0 = no mixed pixels",
              "radians",
              Range::between(0.0, 0.1))
      .number("-dropout",
              sensor.dropout,
              "share of echoes lost at right angles; more are at grazing ones",
              "",
              share)
      .number(
          "-glass", sensor.glass_ghost, "share of rays that glass mirrors", "", share)
      .number("-glass_echo",
              sensor.glass_echo,
              "share of rays that glass returns",
              "",
              share)
      .number("-seed", sensor.seed, "the same seed gives the same scan")
      .number("-threads", sensor.threads, "0 = automatic", "", Range::atLeast(0));
}

void
addLidarOptions(OptionParser& parser, ScannerOptions& options)
{
  auto& lidar = options.lidar;
  const auto degrees = [](double radians) { return std::round(radians * 180 / M_PI); };
  options.lowest_ring = degrees(lidar.lowest_ring);
  options.highest_ring = degrees(lidar.highest_ring);
  options.field_width = degrees(lidar.field_width);
  options.field_height = degrees(lidar.field_height);
  const std::string rings = "spinning, walk: ", field = "solid_state: ",
                    carried = "carried scanners: ";
  const Range slope = Range::between(-89.0, 89.0), angle = Range::between(1.0, 179.0);
  parser
      .number("-rings", lidar.rings, rings + "rays above each other", "", {1.0, 256.0})
      .number("-lowest_ring",
              options.lowest_ring,
              rings + "the lowest ray above the horizon",
              "degrees",
              slope)
      .number("-highest_ring",
              options.highest_ring,
              rings + "the highest ray",
              "degrees",
              slope)
      .number("-steps_per_turn",
              lidar.steps_per_turn,
              rings + "rays of a ring in a turn",
              "",
              {1.0, 100000.0})
      .number("-field_width",
              options.field_width,
              field + "width of the view",
              "degrees",
              angle)
      .number("-field_height",
              options.field_height,
              field + "height of the view",
              "degrees",
              angle)
      .number("-turn_rate",
              lidar.turn_rate,
              carried + "turns or frames that the sensor makes in a second",
              "1/s",
              Range::between(0.1, 1000.0))
      .number("-frame_rate",
              lidar.frame_rate,
              carried + "of these, how many in a second the map is made of",
              "1/s",
              Range::between(0.001, 1000.0))
      .number("-speed",
              options.path.speed,
              carried + "of the carrier",
              "m/s",
              Range::between(0.05, 20.0))
      .number("-entered",
              options.path.entered,
              carried +
                  "share of the rooms that are entered; others are seen through doors",
              "",
              Range::between(0.0, 1.0))
      .number("-people",
              lidar.people,
              carried + "people who walk behind and before the sensor",
              "",
              {0.0, 10.0});
}

void
requireConsistent(const ScannerOptions& options)
{
  if (options.sensor.max_range <= options.sensor.min_range)
    throw ToolError("-max_range must be above -min_range (" +
                    std::to_string(options.sensor.min_range) + " m), not " +
                    std::to_string(options.sensor.max_range) + " m");
  if (options.sensor.glass_ghost + options.sensor.glass_echo > 1.0)
    throw ToolError("-glass and -glass_echo together must be at most 1");
  if (options.lowest_ring > options.highest_ring)
    throw ToolError("-lowest_ring must be at most -highest_ring");
}

// Options that do not count for the scanner would do nothing, unseen.
void
requireOptionsOf(const std::string& scanner, int argc, const char* const* argv)
{
  for (const auto& [name, scanners] : specialOptions())
    if (isGiven(argc, argv, name) &&
        std::find(scanners.begin(), scanners.end(), scanner) == scanners.end())
      throw ToolError(std::string(name) + " does not count for -scanner " + scanner);
}

} // namespace

ScannerOptions
scannerOptions(const std::string& name)
{
  ScannerOptions options;
  if (name == hand_camera)
    takeDefaults(options.rooms, options.sensor, options.trajectory);
  const auto model = lidarModels().find(name);
  if (model == lidarModels().end())
    return options;
  options.lidar = lidarOptions(model->second);
  options.path = pathOptions(model->second);
  static_cast<EchoOptions&>(options.sensor) = options.lidar;
  options.sensor.drift = options.lidar.drift;
  options.sensor.rays_per_pose = options.lidar.rays_per_frame;
  options.trajectory = options.path;
  return options;
}

void
addScannerOptions(OptionParser& parser, ScannerOptions& options)
{
  addPathOptions(parser, options);
  addSensorOptions(parser, options.sensor);
  addLidarOptions(parser, options);
  addCaptureOptions(parser, options.rooms);
  parser.expert({"-min_range", "-max_range", "-noise", "-drift", "-seed"});
  for (const auto& option : specialOptions())
    parser.expert({option.name});
}

void
completeScanner(ScannerOptions& options, int argc, const char* const* argv)
{
  constexpr double degree = M_PI / 180;
  requireOptionsOf(options.name, argc, argv);
  requireConsistent(options);
  static_cast<EchoOptions&>(options.lidar) = options.sensor;
  options.lidar.drift = options.sensor.drift;
  options.lidar.rays_per_frame = options.sensor.rays_per_pose;
  options.lidar.lowest_ring = options.lowest_ring * degree;
  options.lidar.highest_ring = options.highest_ring * degree;
  options.lidar.field_width = options.field_width * degree;
  options.lidar.field_height = options.field_height * degree;
  static_cast<TrajectoryOptions&>(options.path) = options.trajectory;
  options.path.seed = options.sensor.seed;
  complete(options.rooms, options.sensor, options.trajectory);
}

} // namespace pcl::indoor::tool
