/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/voxel_normals.h"

#include "internal/point_moments.h"

#include <pcl/indoor/threads.h>

#include <pcl/exceptions.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <bitset>
#include <cstdint>

namespace pcl::indoor {

namespace {

void
requireValid(const std::vector<Eigen::Vector3f>& points, const OccupancyGrid& grid)
{
  if (grid.cells.size() != points.size())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "The grid was made of " << grid.cells.size()
                                                << " points, not of " << points.size()
                                                << ".");
}

/** \brief Sums over the points of a voxel, relative to its centre. */
struct VoxelMoments {
  Eigen::Vector3f centre;
  PointMoments sums;
};

/** \brief Numbers the voxels that hold points in their order: a bit per voxel, and per
 * word how many lie before it.
 */
class OccupiedVoxels {
public:
  OccupiedVoxels(const std::vector<std::int32_t>& cells, std::size_t voxel_count)
  : bits_((voxel_count + 63) / 64, 0)
  , before_(bits_.size(), 0)
  {
    for (const std::int32_t cell : cells)
      if (cell >= 0)
        bits_[cell / 64] |= std::uint64_t{1} << cell % 64;
    for (std::size_t word = 0; word < bits_.size(); ++word) {
      before_[word] = static_cast<std::int32_t>(voxel_.size());
      for (std::uint64_t left = bits_[word]; left != 0; left &= left - 1)
        voxel_.push_back(
            static_cast<std::int32_t>(64 * word + countBits(lowest(left) - 1)));
    }
  }

  std::size_t
  size() const
  {
    return voxel_.size();
  }

  /** \brief The voxel of a number. */
  std::int32_t
  voxel(std::size_t number) const
  {
    return voxel_[number];
  }

  /** \brief The number of a voxel, or -1 if it holds no points. */
  std::int32_t
  number(std::size_t voxel) const
  {
    const std::uint64_t word = bits_[voxel / 64];
    const std::uint64_t bit = std::uint64_t{1} << voxel % 64;
    return word & bit ? before_[voxel / 64] + countBits(word & (bit - 1)) : -1;
  }

private:
  static std::uint64_t
  lowest(std::uint64_t word)
  {
    return word & (~word + 1);
  }
  static int
  countBits(std::uint64_t word)
  {
    return static_cast<int>(std::bitset<64>(word).count());
  }

  std::vector<std::uint64_t> bits_;
  std::vector<std::int32_t> before_;
  std::vector<std::int32_t> voxel_;
};

Eigen::Vector3i
placeOf(const GridShape& shape, std::int32_t voxel)
{
  return {voxel / (shape.ny * shape.nz), voxel / shape.nz % shape.ny, voxel % shape.nz};
}

std::vector<VoxelMoments>
sumUp(const std::vector<Eigen::Vector3f>& points,
      const OccupancyGrid& grid,
      const OccupiedVoxels& occupied,
      int threads)
{
  const std::size_t count = occupied.size();
  std::vector<VoxelMoments> moments(count);
#pragma omp parallel for schedule(static) num_threads(threads)
  for (int part = 0; part < threads; ++part) {
    // Each part owns a range of voxels and looks at all points: the sums have the same
    // order for any number of parts.
    const auto begin = static_cast<std::int32_t>(count * part / threads);
    const auto end = static_cast<std::int32_t>(count * (part + 1) / threads);
    for (std::int32_t n = begin; n < end; ++n) {
      const Eigen::Vector3i place = placeOf(grid.grid.shape, occupied.voxel(n));
      moments[n].centre =
          grid.toBuilding(grid.grid.center(place.x(), place.y(), place.z()))
              .cast<float>();
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (grid.cells[i] < 0)
        continue;
      const std::int32_t n = occupied.number(grid.cells[i]);
      if (n >= begin && n < end)
        moments[n].sums.add(points[i] - moments[n].centre);
    }
  }
  return moments;
}

/** \brief The scatter of the points in the 3 x 3 x 3 voxels around one. */
Eigen::Matrix3d
scatterAround(const Eigen::Vector3i& place,
              const GridShape& shape,
              const OccupiedVoxels& occupied,
              const std::vector<VoxelMoments>& moments,
              double& count)
{
  const Eigen::Vector3f centre =
      moments[occupied.number(shape.index(place.x(), place.y(), place.z()))].centre;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;
  count = 0.0;
  for (int step = 0; step < 27; ++step) {
    const int x = place.x() + step / 9 - 1;
    const int y = place.y() + step / 3 % 3 - 1;
    const int z = place.z() + step % 3 - 1;
    const std::int32_t n =
        shape.contains(x, y, z) ? occupied.number(shape.index(x, y, z)) : -1;
    if (n < 0)
      continue;
    const PointMoments& m = moments[n].sums;
    const Eigen::Vector3d to = (moments[n].centre - centre).cast<double>();
    const Eigen::Vector3d s = m.sum.cast<double>();
    const Eigen::Vector3d t = s + m.count * to; // the sum as seen from the middle
    xx += m.xx + s.x() * to.x() + to.x() * t.x();
    xy += m.xy + s.x() * to.y() + to.x() * t.y();
    xz += m.xz + s.x() * to.z() + to.x() * t.z();
    yy += m.yy + s.y() * to.y() + to.y() * t.y();
    yz += m.yz + s.y() * to.z() + to.y() * t.z();
    zz += m.zz + s.z() * to.z() + to.z() * t.z();
    sum += t;
    count += m.count;
  }
  Eigen::Matrix3d squares;
  squares << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return squares / count - sum * sum.transpose() / (count * count);
}

/** \brief A choice of voxels without a pattern that a wall could follow. */
bool
isChosen(const Eigen::Vector3i& place, int keep_one_in)
{
  auto hash = static_cast<std::uint32_t>(place.x()) * 0x9e3779b1u;
  hash = (hash ^ hash >> 15 ^ static_cast<std::uint32_t>(place.y())) * 0x85ebca77u;
  hash = (hash ^ hash >> 13 ^ static_cast<std::uint32_t>(place.z())) * 0xc2b2ae3du;
  return (hash >> 16) % static_cast<std::uint32_t>(keep_one_in) == 0;
}

} // namespace

WeightedNormals
voxelNormals(const std::vector<Eigen::Vector3f>& points,
             const OccupancyGrid& grid,
             int threads)
{
  constexpr int enough = 10000; // voxels; fewer blur the directions
  requireValid(points, grid);
  threads = threadCount(threads);
  const GridShape& shape = grid.grid.shape;
  const OccupiedVoxels occupied(grid.cells, shape.size());
  const std::vector<VoxelMoments> moments = sumUp(points, grid, occupied, threads);
  const auto count = static_cast<std::ptrdiff_t>(moments.size());
  const int keep_one_in = std::max(1, static_cast<int>(count / enough));
  std::vector<Eigen::Vector3d> normals(moments.size());
  std::vector<double> weights(moments.size(), 0.0);
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::ptrdiff_t n = 0; n < count; ++n) {
    const Eigen::Vector3i place = placeOf(shape, occupied.voxel(n));
    if (!isChosen(place, keep_one_in))
      continue;
    double inside = 0.0;
    const Eigen::Matrix3d scatter =
        scatterAround(place, shape, occupied, moments, inside);
    if (inside < plane_points)
      continue;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(scatter);
    const Eigen::Vector3d values = solver.eigenvalues().cwiseMax(0.0);
    const double flatness = (values[1] - values[0]) / values[2];
    if (!(flatness >= plane_flatness))
      continue;
    normals[n] = solver.eigenvectors().col(0).normalized();
    weights[n] = flatness;
  }
  WeightedNormals result;
  for (std::ptrdiff_t n = 0; n < count; ++n)
    if (weights[n] > 0.0) {
      result.normals.push_back(normals[n]);
      result.weights.push_back(weights[n]);
    }
  return result;
}

} // namespace pcl::indoor
