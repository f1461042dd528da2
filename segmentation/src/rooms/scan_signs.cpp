/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/rooms/scan_signs.h>

#include <pcl/indoor/quantile.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <tuple>
#include <utility>
#include <vector>

namespace pcl {
namespace indoor {
namespace {

using Points = std::vector<Eigen::Vector3f>;
using KeyedPoints = std::vector<std::pair<std::uint64_t, std::uint32_t>>;

constexpr std::size_t sample_size = 15000;
constexpr double points_per_cell = 4.0; // a surface without holes, where it is average

/** Points chosen by the bits of their coordinates, in the order of these. */
Points
sampleOf(const Points& points)
{
  const std::uint64_t one_in = std::max<std::size_t>(1, points.size() / sample_size);
  Points sample;
  for (const auto& point : points) {
    std::uint32_t bits[3];
    std::memcpy(bits, point.data(), sizeof(bits));
    std::uint64_t hash = 0;
    for (const std::uint32_t part : bits)
      hash = (hash + part + 1) * 0x9e3779b97f4a7c15u;
    hash = (hash ^ hash >> 29) * 0xbf58476d1ce4e5b9u;
    if ((hash >> 32) % one_in == 0)
      sample.push_back(point);
  }
  std::sort(sample.begin(), sample.end(), [](const auto& a, const auto& b) {
    return std::make_tuple(a.x(), a.y(), a.z()) < std::make_tuple(b.x(), b.y(), b.z());
  });
  return sample;
}

/** A cube around all but the outermost hundredths of the points, cut into cells. */
struct Cells {
  Eigen::Vector3d origin;
  double edge = 0.0;
  double size = 0.0;

  bool
  contains(const Eigen::Vector3f& point) const
  {
    const Eigen::Array3d local = point.cast<double>() - origin;
    return (local >= 0.0).all() && (local < edge).all();
  }

  /** The place of a point along an axis in cells of a size. REQUIRES: contains(). */
  std::uint64_t
  place(const Eigen::Vector3f& point, int axis, double cell_size) const
  {
    return static_cast<std::uint64_t>((point[axis] - origin[axis]) / cell_size);
  }
};

/** A coordinate's bits with two places between each two. */
std::uint64_t
spread(std::uint64_t value)
{
  std::uint64_t result = 0;
  for (int bit = 0; bit < 12; ++bit)
    result |= (value >> bit & 1) << 3 * bit;
  return result;
}

/** The size at which an occupied cell holds some points on average. */
double
cellSize(const Points& sample, const Cells& cells)
{
  constexpr int levels = 12; // of an octree, each half as large as the one before
  std::vector<std::uint64_t> keys;
  for (const auto& point : sample) {
    if (!cells.contains(point))
      continue;
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
      key |= spread(cells.place(point, axis, cells.edge / (1 << levels))) << axis;
    keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end());
  double finer = 0.0; // points per cell, one level below
  for (int level = levels; level >= 0; --level) {
    std::size_t count = 0;
    const int shift = 3 * (levels - level);
    for (std::size_t i = 0; i < keys.size(); ++i)
      count += i == 0 || keys[i] >> shift != keys[i - 1] >> shift;
    const double mean = static_cast<double>(keys.size()) / std::max<double>(1.0, count);
    if (mean >= points_per_cell) {
      const double part =
          level == levels ? 1.0 : (points_per_cell - finer) / (mean - finer);
      return cells.edge / (1 << levels) * std::exp2(levels - level - 1 + part);
    }
    finer = mean;
  }
  return 0.0;
}

Cells
cellsOf(const Points& sample)
{
  Cells cells;
  Eigen::Vector3d low, high;
  std::vector<float> values(sample.size());
  for (int axis = 0; axis < 3; ++axis) {
    std::transform(sample.begin(), sample.end(), values.begin(), [axis](const auto& p) {
      return p[axis];
    });
    const std::size_t hundredth = values.size() / 100;
    low[axis] = valueAtRank(values, hundredth);
    high[axis] = valueAtRank(values, values.size() - 1 - hundredth);
  }
  cells.edge = 1.1 * (high - low).maxCoeff(); // the outermost surfaces are inside
  cells.origin = 0.5 * (low + high) - Eigen::Vector3d::Constant(0.5 * cells.edge);
  if (cells.edge > 0.0)
    cells.size = cellSize(sample, cells);
  return cells;
}

/** \param[in] key of a point inside the cells */
template <typename Key>
KeyedPoints
grouped(const Points& sample, const Cells& cells, const Key& key)
{
  KeyedPoints groups;
  for (std::uint32_t i = 0; i < sample.size(); ++i)
    if (cells.contains(sample[i]))
      groups.emplace_back(key(sample[i]), i);
  std::sort(groups.begin(), groups.end());
  return groups;
}

/** Per axis: the mean size of the plane that a piece of surface across it lies in, as
 * share of all surface. */
Eigen::Vector3d
meanPlaneSize(const Points& sample, const Cells& cells)
{
  constexpr std::size_t enough = 6; // points for a plane
  constexpr double straight = 0.97; // cosine of 14 degrees
  constexpr double flatness = 0.3;  // as for the normals of voxels
  const double size = 2.0 * cells.size;
  const auto groups = grouped(sample, cells, [&](const Eigen::Vector3f& p) {
    return cells.place(p, 0, size) << 42 | cells.place(p, 1, size) << 21 |
           cells.place(p, 2, size);
  });
  std::vector<double> places[3]; // of the pieces across each axis
  double all = 0.0;
  for (std::size_t begin = 0, end = 0; begin < groups.size(); begin = end) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    const Eigen::Vector3f& first = sample[groups[begin].second];
    for (; end < groups.size() && groups[end].first == groups[begin].first; ++end) {
      const Eigen::Vector3d p = (sample[groups[end].second] - first).cast<double>();
      sum += p;
      squares += p * p.transpose();
    }
    if (end - begin < enough)
      continue;
    const Eigen::Vector3d mean = sum / static_cast<double>(end - begin);
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(squares / static_cast<double>(end - begin) -
                         mean * mean.transpose());
    const Eigen::Vector3d values = solver.eigenvalues().cwiseMax(0.0);
    if (!(values[1] - values[0] > flatness * values[2]))
      continue;
    all += 1.0;
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(solver.eigenvectors()(axis, 0)) > straight)
        places[axis].push_back(first[axis] + mean[axis]);
  }
  Eigen::Vector3d result = Eigen::Vector3d::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    auto& at = places[axis];
    std::sort(at.begin(), at.end());
    double together = 0.0;
    for (std::size_t i = 0, from = 0, to = 0; i < at.size(); ++i) {
      for (; at[i] - at[from] > 0.25 * cells.size; ++from)
        ;
      for (; to < at.size() && at[to] - at[i] <= 0.25 * cells.size; ++to)
        ;
      together += static_cast<double>(to - from);
    }
    if (!at.empty())
      result[axis] = together / static_cast<double>(at.size()) / all;
  }
  return result;
}

/** The length of which half of the free space of the columns has at least as much. */
double
freeLength(const Points& sample, const Cells& cells, int axis)
{
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto columns = grouped(sample, cells, [&](const Eigen::Vector3f& p) {
    return cells.place(p, u, cells.size) << 32 | cells.place(p, v, cells.size);
  });
  std::vector<double> gaps; // the longest of each column
  double sum = 0.0;
  std::vector<float> column;
  for (std::size_t begin = 0, end = 0; begin < columns.size(); begin = end) {
    column.clear();
    for (; end < columns.size() && columns[end].first == columns[begin].first; ++end)
      column.push_back(sample[columns[end].second][axis]);
    std::sort(column.begin(), column.end());
    double longest = 0.0;
    for (std::size_t i = 1; i < column.size(); ++i)
      longest = std::max<double>(longest, column[i] - column[i - 1]);
    if (longest <= 2.0 * cells.size)
      continue; // along a surface
    gaps.push_back(longest);
    sum += longest;
  }
  std::sort(gaps.begin(), gaps.end());
  double shorter = 0.0;
  for (const double gap : gaps)
    if ((shorter += gap) >= 0.5 * sum)
      return gap;
  return 0.0;
}

} // namespace

int
ScanSigns::uprightAxis() const
{
  constexpr double clearly = 1.4; // upright buildings stay below 0.6
  int axis = 2;
  const double most = uprightness.maxCoeff(&axis);
  return uprightness[2] > 0.0 && most > clearly * uprightness[2] ? axis : 2;
}

ScanSigns
scanSigns(const std::vector<Eigen::Vector3f>& points)
{
  ScanSigns signs;
  const Points sample = sampleOf(points);
  if (sample.size() < 1000) // too few for floors and ceilings to face each other
    return signs;
  const Cells cells = cellsOf(sample);
  if (!(cells.size > 0.0))
    return signs;
  const Eigen::Vector3d planes = meanPlaneSize(sample, cells);
  for (int axis = 0; axis < 3; ++axis) {
    signs.free_length[axis] = freeLength(sample, cells, axis);
    if (signs.free_length[axis] > 0.0)
      signs.uprightness[axis] = planes[axis] / signs.free_length[axis];
  }
  return signs;
}

double
likelyMetresPerUnit(double length)
{
  constexpr double room_height = 2.5; // metres
  double best = 1.0;
  for (const double unit : {1.0, 0.3048, 0.0254, 0.01, 0.001})
    if (std::abs(std::log(length * unit / room_height)) <
        std::abs(std::log(length * best / room_height)))
      best = unit;
  return best;
}

} // namespace indoor
} // namespace pcl
