/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/surface_triangles.h"

#include "rooms/dimensions.h"

#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/point_cells.h>
#include <pcl/indoor/threads.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace pcl::indoor {
namespace {

using Places = std::vector<Eigen::Vector3f>;
using Triangle = std::array<std::uint32_t, 3>;

constexpr float near_radius = 0.4f; // metres: enough where places are dense
constexpr float far_radius = 1.0f;  // metres: to find planes where they are sparse
constexpr float widest_gap = 0.8f;  // metres: doorways are wider
constexpr float noise = static_cast<float>(crowd);
constexpr std::size_t most_neighbors = 30; // that planes are told by
constexpr int directions = 8;              // around a place

/** A place beside another. */
struct Neighbor {
  float squared_distance;
  std::uint32_t place;
  Eigen::Vector3f offset; ///< from the other

  bool
  operator<(const Neighbor& other) const
  {
    return std::tie(squared_distance, place) <
           std::tie(other.squared_distance, other.place);
  }
};

/** What the surroundings of a place tell. */
struct Planes {
  std::array<Eigen::Vector3f, 2> normals;
  int count = 0;
  float gap = 0.0f; ///< up to where gaps are closed, metres
};

Places
meanPlaces(const std::vector<Eigen::Vector3f>& points, double cell_size)
{
  const PointCells cells = groupByCell(points, cell_size);
  Places places(cells.size());
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const std::uint32_t point : cells.pointsOf(cell))
      sum += points[point].cast<double>();
    const auto count = static_cast<double>(cells.pointsOf(cell).size());
    places[cell] = (sum / count).cast<float>();
  }
  return places;
}

/** Cells in which everything within a radius of a place lies in its own cell and those
 * beside it. */
struct Surroundings {
  Surroundings(const Places& places, float reach)
  : radius(reach)
  , cells(groupByCell(places, reach))
  , beside(cellAdjacency(cells.keys))
  {}

  /** The places within a distance, at most the radius, in no certain order. */
  void
  find(const Places& places,
       std::uint32_t place,
       float distance,
       std::vector<Neighbor>& neighbors) const
  {
    neighbors.clear();
    const Eigen::Vector3f center = places[place];
    const auto add = [&](std::size_t cell) {
      for (const std::uint32_t each : cells.pointsOf(cell)) {
        const Eigen::Vector3f offset = places[each] - center;
        const float squared = offset.squaredNorm();
        if (squared <= distance * distance && each != place)
          neighbors.push_back({squared, each, offset});
      }
    };
    const std::uint32_t own = cells.cell_of_point[place];
    add(own);
    for (const std::uint32_t other : beside.of(own))
      add(other);
  }

  float radius;
  PointCells cells;
  Adjacency beside;
};

/** The normal of the plane through an origin and the offsets from \a begin on; 0 if
 * they lie on a line. */
Eigen::Vector3f
fittedNormal(const Places& offsets, std::size_t begin)
{
  constexpr float thin = 0.04f; // as squares of extents
  const auto count = static_cast<float>(offsets.size() - begin + 1);
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  for (std::size_t i = begin; i < offsets.size(); ++i)
    mean += offsets[i] / count;
  Eigen::Matrix3f spread = mean * mean.transpose(); // of the origin
  for (std::size_t i = begin; i < offsets.size(); ++i)
    spread += (offsets[i] - mean) * (offsets[i] - mean).transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(spread);
  if (solver.eigenvalues()[1] < thin * solver.eigenvalues()[2])
    return Eigen::Vector3f::Zero();
  return solver.eigenvectors().col(0);
}

/** Find the plane through the origin on which most offsets lie, and take these out.
 * \return its normal; 0 if fewer than \a least lie on any */
Eigen::Vector3f
takeCommonPlane(Places& offsets, float tolerance, std::size_t least)
{
  constexpr int trials = 40;   // enough where half of the places lie on the plane
  constexpr float flat = 0.3f; // sine of the angle between two offsets
  Eigen::Vector3f best = Eigen::Vector3f::Zero();
  if (offsets.size() < least)
    return best;
  std::size_t most = 0;
  std::uint32_t random = 12345;
  const auto draw = [&]() -> const Eigen::Vector3f& {
    random = random * 1664525u + 1013904223u;
    return offsets[(random >> 8) % offsets.size()];
  };
  for (int trial = 0; trial < trials && most < offsets.size(); ++trial) {
    const Eigen::Vector3f &a = draw(), &b = draw();
    const Eigen::Vector3f across = a.cross(b);
    const float length = across.norm();
    if (!(length > flat * a.norm() * b.norm()))
      continue;
    const Eigen::Vector3f normal = across / length;
    std::size_t count = 0;
    for (const auto& offset : offsets)
      count += std::abs(offset.dot(normal)) < tolerance;
    if (count > most) {
      most = count;
      best = normal;
    }
  }
  if (most < least)
    return Eigen::Vector3f::Zero();
  const auto on =
      std::partition(offsets.begin(), offsets.end(), [&](const auto& offset) {
        return std::abs(offset.dot(best)) >= tolerance;
      });
  best = fittedNormal(offsets, static_cast<std::size_t>(on - offsets.begin()));
  offsets.erase(on, offsets.end());
  return best;
}

/** \param[in,out] neighbors as many as there are; the nearest ones come first */
Planes
planesThrough(std::vector<Neighbor>& neighbors)
{
  constexpr float tolerance = 0.08f; // of the farthest neighbour's distance
  constexpr std::size_t least_counts[] = {11, 7}; // on the first plane, on a second one
  constexpr std::size_t twelfth = 11;             // neighbour, see the header
  constexpr float least_gap = 0.25f;              // metres
  Planes planes;
  const std::size_t count = std::min(neighbors.size(), most_neighbors);
  if (count < least_counts[0])
    return planes;
  std::partial_sort(neighbors.begin(), neighbors.begin() + count, neighbors.end());
  Places offsets;
  for (std::size_t i = 0; i < count; ++i)
    offsets.push_back(neighbors[i].offset);
  const auto distance = [&](std::size_t i) {
    return std::sqrt(neighbors[std::min(i, count - 1)].squared_distance);
  };
  planes.gap = std::clamp(2.0f * distance(twelfth), least_gap, widest_gap);
  const float off = std::max(noise, tolerance * distance(count - 1));
  for (const std::size_t least : least_counts) {
    const Eigen::Vector3f normal = takeCommonPlane(offsets, off, least);
    if (normal.isZero())
      break;
    planes.normals[planes.count++] = normal;
  }
  return planes;
}

/** Whether a place may lie on a surface with a normal. */
bool
agrees(const Planes& planes, const Eigen::Vector3f& normal)
{
  constexpr float parallel = 0.8f; // cosine
  for (int k = 0; k < planes.count; ++k)
    if (std::abs(normal.dot(planes.normals[k])) >= parallel)
      return true;
  return planes.count == 0;
}

/** The triangles of a place in one of its planes. */
void
addTrianglesAt(std::uint32_t place,
               const Eigen::Vector3f& normal,
               const std::vector<Neighbor>& neighbors,
               const std::vector<Planes>& planes,
               std::vector<Triangle>& triangles)
{
  constexpr float step = 0.2f; // of the distance
  const Eigen::Vector3f right = normal.unitOrthogonal(), up = normal.cross(right);
  std::array<const Neighbor*, directions> nearest{};
  for (const Neighbor& each : neighbors) {
    const float off = std::abs(each.offset.dot(normal));
    if (off > noise && off * off > step * step * each.squared_distance)
      continue;
    const double angle = std::atan2(each.offset.dot(up), each.offset.dot(right));
    const Neighbor*& best =
        nearest[static_cast<int>((angle / (2.0 * M_PI) + 1.0) * directions) %
                directions];
    if ((best == nullptr || each < *best) && agrees(planes[each.place], normal))
      best = &each;
  }
  for (int d = 0; d < directions; ++d) {
    const Neighbor *a = nearest[d], *b = nearest[(d + 1) % directions];
    if (a == nullptr || b == nullptr)
      continue;
    Triangle triangle = {place, a->place, b->place};
    std::sort(triangle.begin(), triangle.end());
    triangles.push_back(triangle);
  }
}

} // namespace

SurfaceTriangles
surfaceTriangles(const std::vector<Eigen::Vector3f>& points,
                 double cell_size,
                 int threads)
{
  SurfaceTriangles result;
  result.places = meanPlaces(points, cell_size);
  const Places& places = result.places;
  const Surroundings near(places, near_radius), far(places, far_radius);
  const auto count = static_cast<std::ptrdiff_t>(places.size());
  constexpr std::ptrdiff_t chunk = 1024;
  std::vector<Planes> planes(places.size());
  parallelFor(
      count,
      threads,
      chunk,
      [] { return std::vector<Neighbor>(); },
      [&](std::vector<Neighbor>& neighbors, std::ptrdiff_t i) {
        const auto place = static_cast<std::uint32_t>(i);
        near.find(places, place, near.radius, neighbors);
        if (neighbors.size() < most_neighbors)
          far.find(places, place, far.radius, neighbors);
        planes[place] = planesThrough(neighbors);
      });
  struct State {
    std::vector<Neighbor> neighbors;
    std::vector<Triangle> triangles;
  };
  parallelFor(
      count,
      threads,
      chunk,
      [] { return State(); },
      [&](State& state, std::ptrdiff_t i) {
        const auto place = static_cast<std::uint32_t>(i);
        const Planes& own = planes[place];
        if (own.count == 0)
          return;
        const Surroundings& around = own.gap <= near.radius ? near : far;
        around.find(places, place, own.gap, state.neighbors);
        for (int k = 0; k < own.count; ++k)
          addTrianglesAt(
              place, own.normals[k], state.neighbors, planes, state.triangles);
      },
      [&](const State& state) {
        result.corners.insert(
            result.corners.end(), state.triangles.begin(), state.triangles.end());
      });
  std::sort(result.corners.begin(), result.corners.end());
  result.corners.erase(std::unique(result.corners.begin(), result.corners.end()),
                       result.corners.end());
  return result;
}

void
addTriangles(const SurfaceTriangles& triangles, int threads, OccupancyGrid& occupancy)
{
  VoxelBits& grid = occupancy.grid;
  const auto mark = [&grid](const Eigen::Vector3d& place) {
    const Eigen::Vector3i voxel =
        ((place - grid.origin) / grid.voxel_size).array().floor().cast<int>();
    if (grid.shape.contains(voxel.x(), voxel.y(), voxel.z()))
      grid.set(voxel.x(), voxel.y(), voxel.z());
  };
  const auto count = static_cast<std::ptrdiff_t>(triangles.corners.size());
#pragma omp parallel for schedule(static) num_threads(threadCount(threads))
  for (std::ptrdiff_t t = 0; t < count; ++t) {
    const auto corner = [&](int k) {
      const auto& place = triangles.places[triangles.corners[t][k]];
      return occupancy.toGrid(place.cast<double>());
    };
    const Eigen::Vector3d first = corner(0);
    const Eigen::Vector3d a = corner(1) - first, b = corner(2) - first;
    const double longest = std::max({a.norm(), b.norm(), (a - b).norm()});
    const int steps = static_cast<int>(std::ceil(2.0 * longest / grid.voxel_size));
    for (int i = 0; i <= steps; ++i)
      for (int k = 0; i + k <= steps; ++k)
        mark(first + a * i / steps + b * k / steps);
  }
}

} // namespace pcl::indoor
