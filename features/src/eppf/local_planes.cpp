/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "eppf/local_planes.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace pcl::indoor {

namespace {

constexpr std::size_t most_points = 4096;
constexpr std::size_t neighbor_count = 16;
constexpr float largest_float = std::numeric_limits<float>::max();

/** \brief Of a place to the box of a block. */
float
squaredDistance(const PointColumns::Block& box, const Eigen::Vector3f& place)
{
  const Eigen::Array3f away =
      (box.lower - place.array()).max(place.array() - box.upper).max(0.0f);
  return away.matrix().squaredNorm();
}

/** \brief The least and the largest of values. */
std::pair<float, float>
range(const std::vector<float>& values)
{
  float least = values.front();
  float largest = least;
  const auto count = static_cast<int>(values.size());
#pragma omp simd reduction(min : least) reduction(max : largest)
  for (int k = 0; k < count; ++k) {
    least = std::min(least, values[k]);
    largest = std::max(largest, values[k]);
  }
  return {least, largest};
}

} // namespace

PointColumns::PointColumns(const std::vector<OrientedPoint>& points,
                           const std::vector<std::uint32_t>& order)
{
  const std::size_t count = std::min(points.size(), most_points);
  indices.resize(count);
  x.resize(count);
  y.resize(count);
  z.resize(count);
  const bool takes_all = count == points.size(); // a division each takes long
  for (std::size_t k = 0; k < count; ++k) {
    indices[k] = order[takes_all ? k : k * points.size() / count];
    const auto& position = points[indices[k]].position;
    x[k] = position.x();
    y[k] = position.y();
    z[k] = position.z();
  }
  makeBlocks();
}

/** \brief The order visits cells one after the other: a block is a cell. */
void
PointColumns::makeBlocks()
{
  const auto [low_x, high_x] = range(x);
  const auto [low_y, high_y] = range(y);
  const auto [low_z, high_z] = range(z);
  const float edge = std::max({high_x - low_x, high_y - low_y, high_z - low_z});
  const float scale = 7.999f / std::clamp(edge, 1e-30f, largest_float);
  const auto place = [scale](float value, float low) {
    return static_cast<int>(std::min((value - low) * scale, 7.999f));
  };
  std::array<std::uint16_t, most_points> cells;
  for (std::size_t k = 0; k < size(); ++k)
    cells[k] = static_cast<std::uint16_t>(place(x[k], low_x) << 6 |
                                          place(y[k], low_y) << 3 | place(z[k], low_z));
  blocks.reserve(512);
  for (std::size_t first = 0, last = 0; first < size(); first = last) {
    Eigen::Array3f lower = at(first).array();
    Eigen::Array3f upper = lower;
    for (last = first + 1; last < size() && cells[last] == cells[first]; ++last) {
      lower = lower.min(at(last).array());
      upper = upper.max(at(last).array());
    }
    blocks.push_back({lower, upper, first, last});
  }
}

LocalPlane::LocalPlane(const Eigen::Vector3f& mean,
                       const Eigen::Matrix3f& second_moment)
: offset(mean)
{
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(second_moment - mean * mean.transpose());
  normal = solver.eigenvectors().col(0);
  variances = solver.eigenvalues().cwiseMax(0.0f);
}

void
Nearby::gather(const PointColumns& points, const PointColumns::Block& box, float width)
{
  x.clear();
  y.clear();
  z.clear();
  const float reach = 3.0f * width;
  for (std::size_t block = 0; block < points.blocks.size(); ++block) {
    const auto& other = points.blocks[block];
    const Eigen::Array3f away =
        (other.lower - box.upper).max(box.lower - other.upper).max(0.0f);
    if (away.matrix().squaredNorm() > reach * reach)
      continue;
    const auto first = static_cast<std::ptrdiff_t>(other.first);
    const auto last = static_cast<std::ptrdiff_t>(other.last);
    x.insert(x.end(), points.x.begin() + first, points.x.begin() + last);
    y.insert(y.end(), points.y.begin() + first, points.y.begin() + last);
    z.insert(z.end(), points.z.begin() + first, points.z.begin() + last);
  }
}

LocalPlane
planeAround(const Nearby& points, const Eigen::Vector3f& place, float width)
{
  const float scale = 1.0f / (2 * 16 * width * width);
  float sum = 0, sx = 0, sy = 0, sz = 0, xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  const float* const px = points.x.data();
  const float* const py = points.y.data();
  const float* const pz = points.z.data();
  const float cx = place.x(), cy = place.y(), cz = place.z();
  const auto count = static_cast<int>(points.x.size());
#pragma omp simd reduction(+ : sum, sx, sy, sz, xx, xy, xz, yy, yz, zz)
  for (int k = 0; k < count; ++k) {
    const float dx = px[k] - cx;
    const float dy = py[k] - cy;
    const float dz = pz[k] - cz;
    const float rest = 1.0f - (dx * dx + dy * dy + dz * dz) * scale;
    float w = rest > 0.0f ? rest : 0.0f; // (1 - t / 16)^16 for exp(-t)
    w *= w;
    w *= w;
    w *= w;
    w *= w;
    sum += w;
    sx += w * dx;
    sy += w * dy;
    sz += w * dz;
    xx += w * dx * dx;
    xy += w * dx * dy;
    xz += w * dx * dz;
    yy += w * dy * dy;
    yz += w * dy * dz;
    zz += w * dz * dz;
  }
  Eigen::Matrix3f moment;
  moment << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return {Eigen::Vector3f(sx, sy, sz) / sum, moment / sum};
}

LocalPlane
planeOfNearest(const PointColumns& points, std::size_t center, float radius)
{
  thread_local std::vector<std::pair<float, std::uint32_t>> near;
  const Eigen::Vector3f place = points.at(center);
  near.resize(points.size());
  std::size_t found = 0;
  constexpr float least = std::numeric_limits<float>::min(); // a square can be 0
  for (float limit = std::max(radius * radius, least); found < neighbor_count;
       limit *= 4) {
    found = 0;
    for (std::size_t block = 0; block < points.blocks.size(); ++block) {
      if (squaredDistance(points.blocks[block], place) > limit)
        continue;
      const std::size_t first = points.blocks[block].first;
      const std::size_t last = points.blocks[block].last;
      for (std::size_t k = first; k < last; ++k) {
        const float distance = (points.at(k) - place).squaredNorm();
        near[found] = {distance, static_cast<std::uint32_t>(k)};
        found += distance <= limit ? 1 : 0;
      }
    }
  }
  std::nth_element(near.begin(),
                   near.begin() + neighbor_count - 1,
                   near.begin() + static_cast<std::ptrdiff_t>(found));
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  Eigen::Matrix3f moment = Eigen::Matrix3f::Zero();
  for (std::size_t k = 0; k < neighbor_count; ++k) {
    const Eigen::Vector3f offset = points.at(near[k].second) - place;
    mean += offset;
    moment += offset * offset.transpose();
  }
  return {mean / neighbor_count, moment / neighbor_count};
}

} // namespace pcl::indoor
