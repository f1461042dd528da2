/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

/* How many normals of a simulated scan each way of orientation turns to the side that
 * the surface was seen from, as a table: room by room, and all rooms at once.
 *
 *   bench_normal_orientation plan.json ... */

#include "objects/graph/surface_voxels.h"

#include <pcl/features/normal_orientation.h>
#include <pcl/simulation/building.h>
#include <pcl/simulation/plan.h>
#include <pcl/simulation/range_sensor.h>
#include <pcl/simulation/trajectory.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <string>

using namespace pcl::indoor;

namespace {

constexpr double voxel_size = 0.06;

/** Points with the directions they were seen from, unit vectors. */
struct Scan {
  std::vector<Eigen::Vector3f> points, sights;
};

void
add(const SimulatedScan& scan,
    const std::vector<Eigen::Vector3d>& poses,
    std::size_t i,
    Scan& part)
{
  const auto& place = scan.points[i];
  const Eigen::Vector3f point(place.x, place.y, place.z);
  part.points.push_back(point);
  part.sights.push_back(
      (poses[scan.poses[i]] - point.cast<double>()).normalized().cast<float>());
}

/** Normals that were turned, and those of them that are right. */
struct Score {
  std::size_t right = 0, all = 0;
  double seconds = 0;
};

void
score(const Scan& scan, NormalOrientation orientation, Score& score)
{
  auto voxels = surfaceVoxels(scan.points, {}, voxel_size);
  estimateNormals(scan.points, voxels, 0);
  std::vector<Eigen::Vector3f> seen(voxels.size(), Eigen::Vector3f::Zero());
  Eigen::Vector3f middle = Eigen::Vector3f::Zero();
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    seen[voxels.cells.cell_of_point[i]] += scan.sights[i];
    middle += scan.points[i] / static_cast<float>(scan.points.size());
  }
  FreeSpaceOptions options;
  options.cell_size = 2 * voxel_size;
  options.threads = 1;
  const auto begin = std::clock();
  orientNormals(orientation,
                voxels.centroids,
                voxels.neighbors,
                orientation == NormalOrientation::Viewpoint
                    ? std::vector<Eigen::Vector3f>{middle}
                    : std::vector<Eigen::Vector3f>(),
                options,
                voxels.normals);
  score.seconds += static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    // Seen from both sides, or edge-on: no side is right.
    const float length = seen[v].norm();
    const float cosine = length > 0 ? voxels.normals[v].dot(seen[v]) / length : 0;
    if (std::abs(cosine) < 0.2f)
      continue;
    ++score.all;
    score.right += cosine > 0;
  }
}

void
print(const char* plan, const char* extent, const std::vector<Scan>& scans)
{
  const std::pair<const char*, NormalOrientation> ways[] = {
      {"viewpoint in the middle", NormalOrientation::Viewpoint},
      {"graph, Eq. (2.7)", NormalOrientation::Graph},
      {"free space", NormalOrientation::FreeSpace}};
  for (const auto& way : ways) {
    Score result;
    for (const auto& scan : scans)
      score(scan, way.second, result);
    std::printf("| %s, %s | %s | %.1f | %.2f |\n",
                plan,
                extent,
                way.first,
                100.0 * static_cast<double>(result.right) /
                    static_cast<double>(result.all),
                result.seconds);
  }
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc < 2) {
    std::fprintf(stderr, "Syntax is: %s plan.json ...\n", argv[0]);
    return EXIT_FAILURE;
  }
  std::printf("| scan | way | right [%%] | CPU s |\n| --- | --- | ---: | ---: |\n");
  for (int i = 1; i < argc; ++i) {
    const auto plan = readPlan(argv[i]);
    const auto building = buildBuilding(plan, argv[i]);
    const auto poses =
        plan.trajectory.empty() ? planTrajectory(building, {}) : plan.trajectory;
    auto scan = scanBuilding(building, poses, {});
    thinScan(scan, 0.03);
    Scan all;
    std::map<std::uint32_t, Scan> rooms;
    for (std::size_t k = 0; k < scan.points.size(); ++k) {
      add(scan, poses, k, all);
      if (scan.points[k].room > 0)
        add(scan, poses, k, rooms[scan.points[k].room]);
    }
    std::vector<Scan> parts;
    for (const auto& room : rooms)
      parts.push_back(room.second);
    const std::string path = argv[i];
    const auto name = path.substr(path.find_last_of('/') + 1);
    print(name.c_str(), "room by room", parts);
    print(name.c_str(), "all at once", {all});
  }
}
