/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/options.h"
#include "command_line/preset.h"
#include "files/cloud_file.h"
#include "files/output_file.h"
#include "simulation/simulation_options.h"
#include "text/place_text.h"

#include <pcl/conversions.h>
#include <pcl/simulation/building.h>
#include <pcl/simulation/carried_lidar.h>
#include <pcl/simulation/depth_camera.h>
#include <pcl/simulation/random_plan.h>
#include <pcl/simulation/scene_description.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <locale>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace pcl::indoor::tool;

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

pcl::indoor::Plan
planOf(const SimulationOptions& options)
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
  std::vector<std::uint32_t> position_of_point; ///< from 0
};

void
requireSeen(bool any_surface, const SimulationOptions& options)
{
  if (!any_surface)
    throw ToolError(options.plan_file + ": no ray found a surface");
}

std::function<void(std::size_t, std::size_t)>
updates(Progress& progress)
{
  return [&](std::size_t done, std::size_t all) { progress.update(done, all); };
}

/** The points of a scan by rays, thinned, and where they were seen from. */
Scan
seenByRays(pcl::indoor::SimulatedScan scan,
           std::vector<Eigen::Vector3d> positions,
           const SimulationOptions& options,
           Progress& progress)
{
  progress.done(std::to_string(scan.ray_count) + " rays, " +
                std::to_string(scan.points.size()) + " points");
  requireSeen(!scan.points.empty(), options);
  pcl::indoor::thinScan(scan, options.leaf_size);
  return {toCloud(scan), std::move(positions), std::move(scan.poses)};
}

Scan
scanWithMovingSensor(const pcl::indoor::Plan& plan,
                     const pcl::indoor::Building& building,
                     SimulationOptions& options,
                     Progress& progress)
{
  const auto trajectory =
      plan.trajectory.empty()
          ? pcl::indoor::planTrajectory(building, options.scanner.trajectory)
          : plan.trajectory;
  progress.start("Scanning from " + std::to_string(trajectory.size()) + " positions");
  options.scanner.sensor.progress = updates(progress);
  return seenByRays(
      pcl::indoor::scanBuilding(building, trajectory, options.scanner.sensor),
      trajectory,
      options,
      progress);
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
              SimulationOptions& options,
              Progress& progress)
{
  const auto paths = pathsOf(plan, building, options.scanner.path);
  const auto frames = pcl::indoor::framesOn(paths, options.scanner.lidar);
  double way = 0.0;
  for (const auto& path : paths)
    way += path.back().way;
  progress.start("Scanning " + std::to_string(frames.size()) + " frames along " +
                 std::to_string(std::lround(way)) + " m");
  options.scanner.lidar.progress = updates(progress);
  std::vector<Eigen::Vector3d> positions;
  for (const auto& frame : frames)
    positions.push_back(pcl::indoor::placeAt(paths[frame.path], frame.time).position);
  return seenByRays(pcl::indoor::scanAlong(building, paths, options.scanner.lidar),
                    std::move(positions),
                    options,
                    progress);
}

Scan
scanWithHandCamera(const pcl::indoor::Building& building,
                   const SimulationOptions& options,
                   Progress& progress)
{
  auto scan = captureRooms(building, options.scanner.rooms, progress);
  requireSeen(!scan.points.empty(), options);
  pcl::indoor::thinScan(scan, options.leaf_size);
  return {toCloud(scan), {}, {}};
}

Scan
scanWithCamera(const pcl::indoor::Building& building,
               const SimulationOptions& options,
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
  return {toCloud(view), {pose.position}, {}};
}

Scan
scanWithScanner(const pcl::indoor::Plan& plan,
                const pcl::indoor::Building& building,
                SimulationOptions& options,
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

/** The positions, a line each; the cloud gets the field station. */
OutputFile
stationsBeside(const std::string& path, Scan& scan)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(9);
  for (const auto& position : scan.positions)
    text << position.x() << ' ' << position.y() << ' ' << position.z() << '\n';
  auto stations = scan.position_of_point;
  for (auto& station : stations)
    ++station;
  appendField(scan.cloud, "station", stations);
  return writtenBeside(path, text.str());
}

void
simulate(SimulationOptions& options, Progress& progress)
{
  requireUsable(options);
  progress.start("Building " + options.plan_file);
  const auto plan = planOf(options);
  const auto building = pcl::indoor::buildBuilding(plan, options.plan_file);
  progress.done(std::to_string(building.rooms.size()) + " rooms, " +
                std::to_string(building.objects.size()) + " objects, " +
                std::to_string(building.triangles.size()) + " triangles");
  auto scan = scanWithScanner(plan, building, options, progress);
  const auto points = std::to_string(scan.cloud.width * scan.cloud.height) + " points";
  progress.start("Saving " + options.output_file);
  std::vector<OutputFile> files;
  if (!options.json_file.empty())
    files.push_back(writtenBeside(
        options.json_file, pcl::indoor::describeScene(building, scan.positions)));
  if (!options.stations_file.empty())
    files.push_back(stationsBeside(options.stations_file, scan));
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
  SimulationOptions options;
  options.scanner = scannerOptions(givenText(argc, argv, "-scanner"));
  if (givenText(argc, argv, "-scanner") == hand_camera)
    options.leaf_size = 0; // the vertices are thinned already
  return simulationParser(options).run(argc, argv, [&](Progress& progress) {
    completeScanner(options.scanner, argc, argv);
    simulate(options, progress);
  });
}
