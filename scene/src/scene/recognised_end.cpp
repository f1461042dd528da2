/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/recognised_end.h"

#include "scene/bundled_network.h"

#include <pcl/indoor/point_cells.h>
#include <pcl/ml/bundled_model.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <future>
#include <system_error>
#include <utility>

namespace pcl::indoor::tool {
namespace {

using Points = std::vector<Eigen::Vector3f>;

Points
pointsAt(const NumberRange& places, const Points& points)
{
  Points some;
  for (const auto place : places)
    some.push_back(points[place]);
  return some;
}

/** Squares of a scan, and how many cells of a network's voxels their points fill. */
struct Surface {
  std::vector<Points> squares;
  std::size_t cells = 0;
};

/** The squares that show most surface, of so many cells in all. */
Surface
mostSurface(const Points& points, double cell_size)
{
  constexpr double side = 5.0;           // metres
  constexpr std::size_t enough = 50'000; // cells
  auto flat = points;
  for (auto& point : flat)
    point.z() = 0.0f;
  const auto squares = groupByCell(flat, side);
  Points().swap(flat); // they may be many
  std::vector<std::pair<std::size_t, std::size_t>> by_cells;
  for (std::size_t square = 0; square < squares.size(); ++square)
    by_cells.emplace_back(
        groupByCell(pointsAt(squares.pointsOf(square), points), cell_size).size(),
        square);
  std::stable_sort(by_cells.begin(), by_cells.end(), [](const auto& a, const auto& b) {
    return a.first > b.first;
  });
  Surface most;
  for (const auto& [cells, square] : by_cells) {
    if (most.cells >= enough)
      break;
    most.squares.push_back(pointsAt(squares.pointsOf(square), points));
    most.cells += cells;
  }
  return most;
}

/** Whether points lie so close to each other that the network tells more of them than
 * chance. */
bool
areDense(const Surface& surface, double voxel_size)
{
  constexpr double edge = 4.0;   // voxels, of cubes
  constexpr double enough = 2.5; // voxels in a cube: 10 cm apart 3.1, 15 cm 2
  std::size_t cubes = 0;
  for (const auto& square : surface.squares)
    cubes += groupByCell(square, edge * voxel_size).size();
  return static_cast<double>(surface.cells) >= enough * static_cast<double>(cubes);
}

/** Voxels, and those of them that are an object of some class. */
struct Recognised {
  std::size_t objects = 0, all = 0;

  void
  add(const Points& points, const VoxelNetwork& network)
  {
    constexpr float clearly = 0.8f;
    const auto voxels = classifyVoxels(points, network);
    const auto count = static_cast<std::ptrdiff_t>(voxels.class_count);
    for (auto row = voxels.probabilities.begin(); row != voxels.probabilities.end();
         row += count, ++all) {
      const auto best = std::max_element(row + building_classes, row + count);
      objects += *best > clearly &&
                 network.classes[static_cast<std::size_t>(best - row)] != "other";
    }
  }

  double
  share() const
  {
    return all > 0 ? static_cast<double>(objects) / static_cast<double>(all) : 0.0;
  }
};

} // namespace

int
recognisedEnd(const Points& points)
{
  std::error_code error;
  if (!std::filesystem::exists(bundledNetworkFile(), error))
    return 0; // rooms can be had without it
  const auto& network = bundledNetwork();
  constexpr double little = 0.01, clearly_more = 2.0;
  const auto surface = mostSurface(points, network.voxel_size);
  if (!areDense(surface, network.voxel_size))
    return 0;
  const auto lookAt = [&](float up) {
    Recognised recognised;
    for (auto square : surface.squares) {
      for (auto& point : square)
        point = {point.x(), up * point.y(), up * point.z()};
      recognised.add(square, network);
    }
    return recognised.share();
  };
  auto turned = std::async(std::launch::async, lookAt, -1.0f);
  const double up = lookAt(1.0f), down = turned.get();
  if (up > little && up > clearly_more * down)
    return 1;
  return down > little && down > clearly_more * up ? -1 : 0;
}

} // namespace pcl::indoor::tool
