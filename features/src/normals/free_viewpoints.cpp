/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "normals/free_viewpoints.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor {
namespace {

constexpr float clearance_share = 0.4f; // of the largest: no viewpoints under tables

/** A room of this size, m^3, gets the number of viewpoints in the options. */
constexpr double room_volume = 60;
constexpr double most_viewpoints = 2000;

/** Free places on a coarse raster, with their clearance in metres. */
struct Candidate {
  Eigen::Vector3f place;
  float clearance;
};

int
rasterStep(const FreeSpaceGrid& grid)
{
  constexpr double most_candidates = 64000;
  const double cells = grid.shape().cast<double>().prod();
  return std::max(1, static_cast<int>(std::ceil(std::cbrt(cells / most_candidates))));
}

std::vector<Candidate>
freeCandidates(const FreeSpaceGrid& grid)
{
  const auto directions = grid.enclosedDirections();
  const Eigen::Vector3i shape = grid.shape();
  const int raster = rasterStep(grid);
  std::vector<Candidate> candidates;
  Eigen::Vector3i cell;
  for (cell.x() = raster / 2; cell.x() < shape.x(); cell.x() += raster)
    for (cell.y() = raster / 2; cell.y() < shape.y(); cell.y() += raster)
      for (cell.z() = raster / 2; cell.z() < shape.z(); cell.z() += raster) {
        const auto i = grid.index(cell);
        if (directions[i] >= 5 && grid.clearance(i) > 2)
          candidates.push_back(
              {grid.center(cell),
               static_cast<float>(grid.clearance(i) * grid.cellSize())});
      }
  return candidates;
}

std::size_t
viewpointCount(const FreeSpaceGrid& grid,
               std::size_t candidate_count,
               const FreeSpaceOptions& options)
{
  const double edge = grid.cellSize() * rasterStep(grid);
  const double volume = edge * edge * edge * static_cast<double>(candidate_count);
  // Half as many where hardly anything is enclosed, so that lines of sight stay short.
  const double cell = grid.cellSize() * grid.cellSize() * grid.cellSize();
  const double box = cell * grid.shape().cast<double>().prod();
  const double rooms =
      std::max({1.0, volume / room_volume, std::floor(box / (2 * room_volume))});
  const double count = options.viewpoints * rooms;
  return static_cast<std::size_t>(
      std::max<double>(options.viewpoints, std::min(count, most_viewpoints)));
}

} // namespace

std::vector<Eigen::Vector3f>
viewpointsIn(const FreeSpaceGrid& grid, const FreeSpaceOptions& options)
{
  auto candidates = freeCandidates(grid);
  if (candidates.empty())
    return {grid.center(grid.shape() / 2)};
  const auto count = viewpointCount(grid, candidates.size(), options);
  const auto nearer = [](const auto& a, const auto& b) {
    return a.clearance < b.clearance;
  };
  const float widest =
      std::max_element(candidates.begin(), candidates.end(), nearer)->clearance;
  candidates.erase(std::remove_if(candidates.begin(),
                                  candidates.end(),
                                  [&](const auto& candidate) {
                                    return candidate.clearance <
                                           clearance_share * widest;
                                  }),
                   candidates.end());
  std::vector<Eigen::Vector3f> viewpoints;
  while (viewpoints.size() < count) {
    const auto best = std::max_element(candidates.begin(), candidates.end(), nearer);
    if (!(best->clearance > 0))
      break;
    viewpoints.push_back(best->place);
    // A place counts for no more than its distance to the places that were taken.
    for (auto& candidate : candidates)
      candidate.clearance = std::min(
          candidate.clearance, 0.5f * (candidate.place - viewpoints.back()).norm());
  }
  return viewpoints;
}

} // namespace pcl::indoor
