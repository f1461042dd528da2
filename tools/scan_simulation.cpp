/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/options.h"
#include "command_line/place_text.h"
#include "files/cloud_file.h"

#include <pcl/conversions.h>
#include <pcl/simulation/building.h>
#include <pcl/simulation/depth_camera.h>
#include <pcl/simulation/random_plan.h>
#include <pcl/simulation/range_sensor.h>
#include <pcl/simulation/scene_description.h>
#include <pcl/simulation/trajectory.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace pcl::indoor::tool;

struct Options {
  std::string plan_file, output_file, json_file;
  std::string view, target = "0,0,0.7"; // X,Y,Z or random; no view: a moving sensor
  pcl::indoor::TrajectoryOptions trajectory;
  pcl::indoor::RangeSensorOptions sensor;
  double leaf_size = 0.04;
  double lean = -1.0;         // degrees; -1: as the plan says
  double lean_towards = -1.0; // degrees; -1: the walls that the plan names
};

void
addSensorOptions(OptionParser& parser, pcl::indoor::RangeSensorOptions& sensor)
{
  const Range share = Range::between(0.0, 1.0);
  parser
      .number("-rays_per_pose",
              sensor.rays_per_pose,
              "rays sent from each position",
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
      .number("-drift",
              sensor.drift,
              "standard deviation of the error of a position",
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
      .number("-spacing",
              options.trajectory.spacing,
              "distance between positions",
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
  const auto scan = options.view.empty()
                        ? scanWithMovingSensor(plan, building, options, progress)
                        : scanWithCamera(building, options, progress);
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

} // namespace

int
main(int argc, char** argv)
{
  Options options;
  return makeParser(options).run(
      argc, argv, [&](Progress& progress) { simulate(options, progress); });
}
