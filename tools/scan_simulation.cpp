/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/options.h"
#include "command_line/preset.h"
#include "files/cloud_file.h"
#include "simulation/scanner_options.h"
#include "text/place_text.h"

#include <pcl/conversions.h>
#include <pcl/simulation/building.h>
#include <pcl/simulation/carried_lidar.h>
#include <pcl/simulation/depth_camera.h>
#include <pcl/simulation/random_plan.h>
#include <pcl/simulation/scene_description.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace pcl::indoor::tool;

struct Options {
  std::string plan_file, output_file, json_file;
  std::string view, target = "0,0,0.7"; // X,Y,Z or random; no view: a moving sensor
  ScannerOptions scanner;
  double leaf_size = 0.04;
  double lean = -1.0;         // degrees; -1: as the plan says
  double lean_towards = -1.0; // degrees; -1: the walls that the plan names
};

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
                  "random:table:SEED, with :cluttered behind it for many small things, "
                  "or :lived_in for belongings and furniture of all shapes")
      .positional("output.pcd|ply", options.output_file, "the scan");
  addScannerOptions(parser, options.scanner);
  parser
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
  parser.expert({"-lean", "-lean_towards", "-view", "-target"});
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
  if (options.leaf_size > 0 && options.leaf_size < 0.001)
    throw ToolError("-leaf must be 0 or at least 0.001 m, not " +
                    std::to_string(options.leaf_size) + " m");
  for (const double angle : {options.lean, options.lean_towards})
    if (angle < 0 && angle != -1)
      throw ToolError("-lean and -lean_towards must be -1 or at least 0 degrees, not " +
                      std::to_string(angle) + " degrees");
  if (options.lean_towards >= 0 && options.lean < 0)
    throw ToolError("-lean_towards needs -lean");
  if (options.scanner.name != "sphere" && !options.view.empty())
    throw ToolError("-view looks with a camera, not with -scanner " +
                    options.scanner.name);
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
          ? pcl::indoor::planTrajectory(building, options.scanner.trajectory)
          : plan.trajectory;
  progress.start("Scanning from " + std::to_string(trajectory.size()) + " positions");
  options.scanner.sensor.progress = [&](std::size_t done, std::size_t all) {
    progress.update(done, all);
  };
  auto scan = pcl::indoor::scanBuilding(building, trajectory, options.scanner.sensor);
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

Scan
scanWithLidar(const pcl::indoor::Plan& plan,
              const pcl::indoor::Building& building,
              Options& options,
              Progress& progress)
{
  const auto paths = pathsOf(plan, building, options.scanner.path);
  const auto frames = pcl::indoor::framesOn(paths, options.scanner.lidar);
  double way = 0.0;
  for (const auto& path : paths)
    way += path.back().way;
  progress.start("Scanning " + std::to_string(frames.size()) + " frames along " +
                 std::to_string(std::lround(way)) + " m");
  options.scanner.lidar.progress = [&](std::size_t done, std::size_t all) {
    progress.update(done, all);
  };
  auto scan = pcl::indoor::scanAlong(building, paths, options.scanner.lidar);
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
scanWithHandCamera(const pcl::indoor::Building& building,
                   const Options& options,
                   Progress& progress)
{
  auto scan = captureRooms(building, options.scanner.rooms, progress);
  requireSeen(!scan.points.empty(), options);
  pcl::indoor::thinScan(scan, options.leaf_size);
  return {toCloud(scan), {}};
}

Scan
scanWithCamera(const pcl::indoor::Building& building,
               const Options& options,
               Progress& progress)
{
  progress.start("Seeing it");
  pcl::indoor::DepthCameraOptions camera;
  camera.seed = options.scanner.sensor.seed;
  const auto pose = options.view == "random"
                        ? pcl::indoor::drawCameraPose(
                              building, options.scanner.trajectory, camera.seed)
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
  if (options.scanner.name == hand_camera)
    return scanWithHandCamera(building, options, progress);
  return options.scanner.name == "sphere"
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

} // namespace

int
main(int argc, char** argv)
{
  Options options;
  options.scanner = scannerOptions(givenText(argc, argv, "-scanner"));
  if (givenText(argc, argv, "-scanner") == hand_camera)
    options.leaf_size = 0; // the vertices are thinned already
  return makeParser(options).run(argc, argv, [&](Progress& progress) {
    completeScanner(options.scanner, argc, argv);
    simulate(options, progress);
  });
}
