/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/options.h"
#include "command_line/place_text.h"
#include "command_line/preset.h"
#include "files/cloud_file.h"

#include <pcl/conversions.h>
#include <pcl/simulation/building.h>
#include <pcl/simulation/carried_lidar.h>
#include <pcl/simulation/depth_camera.h>
#include <pcl/simulation/random_plan.h>
#include <pcl/simulation/range_sensor.h>
#include <pcl/simulation/scene_description.h>
#include <pcl/simulation/trajectory.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace pcl::indoor::tool;

struct Options {
  std::string plan_file, output_file, json_file;
  std::string scanner = "sphere";       // or the name of a model below
  std::string view, target = "0,0,0.7"; // X,Y,Z or random; no view: a moving sensor
  pcl::indoor::TrajectoryOptions trajectory;
  pcl::indoor::RangeSensorOptions sensor;
  pcl::indoor::CarriedLidarOptions lidar; // what it has in common with sensor is there
  pcl::indoor::PathOptions path;          // and what it has in common with trajectory
  double lowest_ring = 0.0, highest_ring = 0.0; // degrees
  double field_width = 0.0, field_height = 0.0; // degrees
  double leaf_size = 0.04;
  double lean = -1.0;         // degrees; -1: as the plan says
  double lean_towards = -1.0; // degrees; -1: the walls that the plan names
};

const std::map<std::string, pcl::indoor::LidarModel>&
lidarModels()
{
  using pcl::indoor::LidarModel;
  static const std::map<std::string, LidarModel> models{
      {"spinning", LidarModel::Spinning},
      {"solid_state", LidarModel::SolidState},
      {"walk", LidarModel::Walk}};
  return models;
}

/** The defaults of a scanner; of one that is not known, those of the usual one. */
Options
optionsOf(const std::string& scanner)
{
  Options options;
  const auto model = lidarModels().find(scanner);
  if (model == lidarModels().end())
    return options;
  options.lidar = pcl::indoor::lidarOptions(model->second);
  options.path = pcl::indoor::pathOptions(model->second);
  static_cast<pcl::indoor::EchoOptions&>(options.sensor) = options.lidar;
  options.sensor.drift = options.lidar.drift;
  options.sensor.rays_per_pose = options.lidar.rays_per_frame;
  options.trajectory = options.path;
  return options;
}

/** Options of lidars that are carried, and which of them count for which. */
struct LidarOption {
  const char* name;
  std::vector<std::string> scanners;
};

const std::vector<LidarOption>&
lidarOptionNames()
{
  static const std::vector<std::string> all{"spinning", "solid_state", "walk"},
      rings{"spinning", "walk"}, field{"solid_state"};
  static const std::vector<LidarOption> names{{"-rings", rings},
                                              {"-lowest_ring", rings},
                                              {"-highest_ring", rings},
                                              {"-steps_per_turn", rings},
                                              {"-field_width", field},
                                              {"-field_height", field},
                                              {"-turn_rate", all},
                                              {"-frame_rate", all},
                                              {"-speed", all},
                                              {"-entered", all},
                                              {"-people", all}};
  return names;
}

void
addLidarOptions(OptionParser& parser, Options& options)
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
              Range::positive())
      .number("-frame_rate",
              lidar.frame_rate,
              carried + "of these, how many in a second the map is made of",
              "1/s",
              Range::positive())
      .number("-speed",
              options.path.speed,
              carried + "of the carrier",
              "m/s",
              Range::positive())
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
addSensorOptions(OptionParser& parser, pcl::indoor::RangeSensorOptions& sensor)
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
              "standard deviation of a range",
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

OptionParser
makeParser(Options& options)
{
  OptionParser parser(
      "pcl_scan_simulation",
      "Builds the rooms and furniture of a plan file and scans them with "
      "a moving range sensor; every point gets the fields room, object, "
      "part and category.");
  parser
      .positional("plan.json",
                  options.plan_file,
                  "plan of the building, or random:home:SEED, random:office:SEED, "
                  "random:table:SEED, with :cluttered behind it for many small things")
      .positional("output.pcd|ply", options.output_file, "the scan")
      .text("-scanner",
            options.scanner,
            "sphere: looks all around from one position after another; carried along a "
            "path through doors: spinning: rings of a lidar on a robot; solid_state: a "
            "lidar that looks ahead, on a robot; walk: a spinning one in a person's "
            "hand. Defaults below are those of the scanner that is named before -h",
            {"sphere", "spinning", "solid_state", "walk"})
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
              Range::positive())
      .number("-leaf",
              options.leaf_size,
              "keep one point per cube of this edge, 0 = all",
              "m",
              Range::atLeast(0.0))
      .number("-lean",
              options.lean,
              "angle of all that leans in the plan, -1 = as the plan says",
              "degrees",
              Range::between(-1.0, 45.0))
      .number("-lean_towards",
              options.lean_towards,
              "direction in which the whole building leans, counter-clockwise from +x, "
              "-1 = the walls that the plan names lean",
              "degrees",
              Range::between(-1.0, 360.0))
      .text(
          "-view",
          options.view,
          "X,Y,Z in m, where a depth camera stands: what it sees at once, an organised "
          "cloud in its frame; random: from one of the positions, drawn by -seed, to "
          "an object; options of the moving sensor's rays do not count")
      .text(
          "-target", options.target, "X,Y,Z in m, in the middle of the view from X,Y,Z")
      .text("-json", options.json_file, "file for the names of rooms and objects");
  addSensorOptions(parser, options.sensor);
  addLidarOptions(parser, options);
  parser.expert({"-lean",
                 "-lean_towards",
                 "-view",
                 "-target",
                 "-rays_per_pose",
                 "-min_range",
                 "-max_range",
                 "-noise",
                 "-drift",
                 "-beam",
                 "-dropout",
                 "-glass",
                 "-glass_echo",
                 "-seed"});
  for (const auto& option : lidarOptionNames())
    parser.expert({option.name});
  return parser;
}

pcl::PCLPointCloud2
toCloud(const pcl::PointCloud<pcl::indoor::PointXYZScene>& points)
{
  pcl::PCLPointCloud2 cloud;
  pcl::toPCLPointCloud2(points, cloud);
  return cloud;
}

pcl::PCLPointCloud2
toCloud(const pcl::indoor::SimulatedScan& scan)
{
  pcl::PointCloud<pcl::indoor::PointXYZScene> points;
  points.resize(scan.points.size());
  std::copy(scan.points.begin(), scan.points.end(), points.begin());
  return toCloud(points);
}

void
requireUsable(const Options& options)
{
  if (options.sensor.max_range <= options.sensor.min_range)
    throw ToolError("-max_range must be above -min_range (" +
                    std::to_string(options.sensor.min_range) + " m), not " +
                    std::to_string(options.sensor.max_range) + " m");
  if (options.sensor.glass_ghost + options.sensor.glass_echo > 1.0)
    throw ToolError("-glass and -glass_echo together must be at most 1");
  if (options.leaf_size > 0 && options.leaf_size < 0.001)
    throw ToolError("-leaf must be 0 or at least 0.001 m, not " +
                    std::to_string(options.leaf_size) + " m");
  for (const double angle : {options.lean, options.lean_towards})
    if (angle < 0 && angle != -1)
      throw ToolError("-lean and -lean_towards must be -1 or at least 0 degrees, not " +
                      std::to_string(angle) + " degrees");
  if (options.lean_towards >= 0 && options.lean < 0)
    throw ToolError("-lean_towards needs -lean");
  if (options.lowest_ring > options.highest_ring)
    throw ToolError("-lowest_ring must be at most -highest_ring");
  if (options.scanner != "sphere" && !options.view.empty())
    throw ToolError("-view looks with a camera, not with -scanner " + options.scanner);
  requireWritableCloud(options.output_file);
  if (!options.json_file.empty())
    requireWritable(options.json_file);
}

pcl::indoor::Plan
planOf(const Options& options)
{
  const auto random = pcl::indoor::randomPlanNamed(options.plan_file);
  auto plan = random ? *random : pcl::indoor::readPlan(options.plan_file);
  if (options.lean >= 0 && options.lean_towards >= 0)
    pcl::indoor::setLean(
        plan, {options.lean * M_PI / 180, options.lean_towards * M_PI / 180});
  else if (options.lean >= 0)
    pcl::indoor::setLean(plan, options.lean * M_PI / 180);
  return plan;
}

/** What was scanned, and from where. */
struct Scan {
  pcl::PCLPointCloud2 cloud;
  std::vector<Eigen::Vector3d> positions;
};

void
requireSeen(bool any_surface, const Options& options)
{
  if (!any_surface)
    throw ToolError(options.plan_file + ": no ray found a surface");
}

Scan
scanWithMovingSensor(const pcl::indoor::Plan& plan,
                     const pcl::indoor::Building& building,
                     Options& options,
                     Progress& progress)
{
  const auto trajectory =
      plan.trajectory.empty()
          ? pcl::indoor::planTrajectory(building, options.trajectory)
          : plan.trajectory;
  progress.start("Scanning from " + std::to_string(trajectory.size()) + " positions");
  options.sensor.progress = [&](std::size_t done, std::size_t all) {
    progress.update(done, all);
  };
  auto scan = pcl::indoor::scanBuilding(building, trajectory, options.sensor);
  progress.done(std::to_string(scan.ray_count) + " rays, " +
                std::to_string(scan.points.size()) + " points");
  requireSeen(!scan.points.empty(), options);
  pcl::indoor::thinScan(scan, options.leaf_size);
  return {toCloud(scan), trajectory};
}

/** The paths of a carried lidar: as the plan says, or through all of the building. */
std::vector<pcl::indoor::CarriedPath>
pathsOf(const pcl::indoor::Plan& plan,
        const pcl::indoor::Building& building,
        const pcl::indoor::PathOptions& options)
{
  if (plan.trajectory.empty())
    return pcl::indoor::planPaths(building, options);
  return {pcl::indoor::pathThrough(plan.trajectory, options)};
}

/** What the lidar has in common with the usual sensor, and what is given in degrees. */
void
completeLidar(Options& options)
{
  constexpr double degree = M_PI / 180;
  static_cast<pcl::indoor::EchoOptions&>(options.lidar) = options.sensor;
  options.lidar.drift = options.sensor.drift;
  options.lidar.rays_per_frame = options.sensor.rays_per_pose;
  options.lidar.lowest_ring = options.lowest_ring * degree;
  options.lidar.highest_ring = options.highest_ring * degree;
  options.lidar.field_width = options.field_width * degree;
  options.lidar.field_height = options.field_height * degree;
  static_cast<pcl::indoor::TrajectoryOptions&>(options.path) = options.trajectory;
  options.path.seed = options.sensor.seed;
}

Scan
scanWithLidar(const pcl::indoor::Plan& plan,
              const pcl::indoor::Building& building,
              Options& options,
              Progress& progress)
{
  completeLidar(options);
  const auto paths = pathsOf(plan, building, options.path);
  const auto frames = pcl::indoor::framesOn(paths, options.lidar);
  double way = 0.0;
  for (const auto& path : paths)
    way += path.back().way;
  progress.start("Scanning " + std::to_string(frames.size()) + " frames along " +
                 std::to_string(std::lround(way)) + " m");
  options.lidar.progress = [&](std::size_t done, std::size_t all) {
    progress.update(done, all);
  };
  auto scan = pcl::indoor::scanAlong(building, paths, options.lidar);
  progress.done(std::to_string(scan.ray_count) + " rays, " +
                std::to_string(scan.points.size()) + " points");
  requireSeen(!scan.points.empty(), options);
  pcl::indoor::thinScan(scan, options.leaf_size);
  std::vector<Eigen::Vector3d> positions;
  for (const auto& frame : frames)
    positions.push_back(pcl::indoor::placeAt(paths[frame.path], frame.time).position);
  return {toCloud(scan), positions};
}

Scan
scanWithCamera(const pcl::indoor::Building& building,
               const Options& options,
               Progress& progress)
{
  progress.start("Seeing it");
  pcl::indoor::DepthCameraOptions camera;
  camera.seed = options.sensor.seed;
  const auto pose =
      options.view == "random"
          ? pcl::indoor::drawCameraPose(building, options.trajectory, camera.seed)
          : pcl::indoor::CameraPose{readPlace("-view", options.view),
                                    readPlace("-target", options.target)};
  const auto view = pcl::indoor::viewBuilding(building, pose, camera);
  const auto seen = std::count_if(
      view.begin(), view.end(), [](const auto& point) { return point.category != 0; });
  requireSeen(seen > 0, options);
  progress.done(std::to_string(seen) + " of " + std::to_string(view.size()) +
                " pixels have a depth");
  return {toCloud(view), {pose.position}};
}

Scan
scanWithScanner(const pcl::indoor::Plan& plan,
                const pcl::indoor::Building& building,
                Options& options,
                Progress& progress)
{
  if (!options.view.empty())
    return scanWithCamera(building, options, progress);
  return options.scanner == "sphere"
             ? scanWithMovingSensor(plan, building, options, progress)
             : scanWithLidar(plan, building, options, progress);
}

void
simulate(Options& options, Progress& progress)
{
  requireUsable(options);
  progress.start("Building " + options.plan_file);
  const auto plan = planOf(options);
  const auto building = pcl::indoor::buildBuilding(plan, options.plan_file);
  progress.done(std::to_string(building.rooms.size()) + " rooms, " +
                std::to_string(building.objects.size()) + " objects, " +
                std::to_string(building.triangles.size()) + " triangles");
  const auto scan = scanWithScanner(plan, building, options, progress);
  const auto points = std::to_string(scan.cloud.width * scan.cloud.height) + " points";
  progress.start("Saving " + options.output_file);
  std::vector<OutputFile> files;
  if (!options.json_file.empty())
    files.push_back(writtenBeside(
        options.json_file, pcl::indoor::describeScene(building, scan.positions)));
  files.push_back(cloudBeside(options.output_file, scan.cloud, {}));
  commitTogether(files);
  Progress::conclude([&] {
    progress.done(points);
    progress.summary(options.output_file + ": " + points);
  });
}

/** Throw where an option is given that does not count for the scanner. */
void
requireOptionsOf(const std::string& scanner, int argc, const char* const* argv)
{
  for (const auto& [name, scanners] : lidarOptionNames())
    if (isGiven(argc, argv, name) &&
        std::find(scanners.begin(), scanners.end(), scanner) == scanners.end())
      throw ToolError(std::string(name) + " does not count for -scanner " + scanner);
}

} // namespace

int
main(int argc, char** argv)
{
  Options options = optionsOf(givenText(argc, argv, "-scanner"));
  return makeParser(options).run(argc, argv, [&](Progress& progress) {
    requireOptionsOf(options.scanner, argc, argv);
    simulate(options, progress);
  });
}
