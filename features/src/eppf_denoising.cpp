/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/eppf_denoising.h>
#include <pcl/features/pair_counting.h>
#include <pcl/features/pair_sampling.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace pcl {
namespace indoor {

namespace {

constexpr std::size_t fewest_points = 256;
constexpr std::size_t most_points = 4096;
constexpr int probe_count = 32;        // enough for most objects without noise
constexpr int many_probes_count = 128; // where these leave it open
constexpr std::size_t neighbor_count = 16;
constexpr float object_area = 3.0f; // of an object of extent 1, about

/** \brief Coordinates of at most most_points points, evenly along the order. */
struct Coordinates {
  /** \brief The box of points that follow each other in one of 8^3 cells. */
  struct Block {
    Eigen::Array3f lower, upper;
    std::size_t first = 0, last = 0;
  };

  std::vector<std::uint32_t> indices;
  std::vector<float> x, y, z;
  std::vector<Block> blocks;

  Coordinates(const std::vector<OrientedPoint>& points,
              const std::vector<std::uint32_t>& order)
  {
    const std::size_t count = std::min(points.size(), most_points);
    for (std::size_t k = 0; k < count; ++k) {
      indices.push_back(order[k * points.size() / count]);
      const auto& position = points[indices.back()].position;
      x.push_back(position.x());
      y.push_back(position.y());
      z.push_back(position.z());
    }
    makeBlocks();
  }

  std::size_t
  size() const
  {
    return x.size();
  }

  /** \brief Of a place to the box of a block. */
  float
  squaredDistanceTo(std::size_t block, const Eigen::Vector3f& place) const
  {
    const auto& box = blocks[block];
    const Eigen::Array3f away =
        (box.lower - place.array()).max(place.array() - box.upper).max(0.0f);
    return away.matrix().squaredNorm();
  }

  Eigen::Vector3f
  at(std::size_t k) const
  {
    return {x[k], y[k], z[k]};
  }

private:
  /** \brief The order visits cells one after the other: a block is a cell. */
  void
  makeBlocks()
  {
    Eigen::Array3f lower = at(0).array();
    Eigen::Array3f upper = lower;
    for (std::size_t k = 1; k < size(); ++k) {
      lower = lower.min(at(k).array());
      upper = upper.max(at(k).array());
    }
    const float scale = 7.999f / std::max((upper - lower).maxCoeff(), 1e-30f);
    Eigen::Array3i last_cell = Eigen::Array3i::Constant(-1);
    for (std::size_t k = 0; k < size(); ++k) {
      const Eigen::Array3f place = at(k).array();
      const Eigen::Array3i cell = ((place - lower) * scale).cast<int>();
      if ((cell != last_cell).any())
        blocks.push_back({place, place, k, k});
      last_cell = cell;
      auto& block = blocks.back();
      block.lower = block.lower.min(place);
      block.upper = block.upper.max(place);
      block.last = k + 1;
    }
  }
};

/** \brief The plane of a neighbourhood. */
struct LocalPlane {
  Eigen::Vector3f offset; // from the place to the neighbours' mean
  Eigen::Vector3f normal;
  Eigen::Vector3f variances; // ascending, along the normal first

  LocalPlane(const Eigen::Vector3f& mean, const Eigen::Matrix3f& second_moment)
  : offset(mean)
  {
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
    solver.computeDirect(second_moment - mean * mean.transpose());
    normal = solver.eigenvectors().col(0);
    variances = solver.eigenvalues().cwiseMax(0.0f);
  }

  /** \brief 0 for a plane, 1 for a ball or a round rod. */
  float
  thickness() const
  {
    return variances[1] > 0.0f ? variances[0] / variances[1] : 0.0f;
  }
};

/** \brief Points that a window may reach, side by side. */
struct Nearby {
  std::vector<float> x, y, z;

  /** \brief The points of all blocks within 3 widths of a box; farther ones have a
   * weight below 0.011. */
  void
  gather(const Coordinates& points, const Coordinates::Block& box, float width)
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
};

/** \brief The plane of the points around a place, weighted by nearly exp(-d^2 / (2
 * width^2)). */
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

/** \brief The plane of the neighbor_count nearest points. */
LocalPlane
planeOfNearest(const Coordinates& points, std::size_t center, float radius)
{
  thread_local std::vector<std::pair<float, std::uint32_t>> near;
  const Eigen::Vector3f place = points.at(center);
  near.resize(points.size());
  std::size_t found = 0;
  for (float limit = radius * radius; found < neighbor_count; limit *= 4) {
    found = 0;
    for (std::size_t block = 0; block < points.blocks.size(); ++block) {
      if (points.squaredDistanceTo(block, place) > limit)
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

float
ramp(float value, float from, float to)
{
  return std::clamp((value - from) / (to - from), 0.0f, 1.0f);
}

/** \brief Mean distance of the points, if their object's surface is a usual one. */
float
usualSpacing(std::size_t point_count, float extent)
{
  return extent * std::sqrt(object_area / static_cast<float>(point_count));
}

/** \brief The point at the middle of the probe-th of count equal parts of the order.
 */
std::size_t
probedPoint(const Coordinates& points, int probe, int count)
{
  return (2 * static_cast<std::size_t>(probe) + 1) * points.size() /
         (2 * static_cast<std::size_t>(count));
}

/** \brief Deviation of the points from planes, of one of the flattest probes. */
float
residual(const Coordinates& points, float width, int threads)
{
  std::array<float, probe_count> squares;
#pragma omp parallel num_threads(threads)
  {
    Nearby nearby;
#pragma omp for schedule(dynamic, 2)
    for (int probe = 0; probe < probe_count; ++probe) {
      const Eigen::Vector3f place = points.at(probedPoint(points, probe, probe_count));
      nearby.gather(points, {place, place, 0, 0}, width);
      const float seen = planeAround(nearby, place, width).variances[0];
      // A window of variance v shows noise of variance s as 1 / (1 / s + 1 / v).
      const float window = width * width;
      squares[probe] =
          seen < 0.999f * window ? seen * window / (window - seen) : 1000.0f * window;
    }
  }
  const auto chosen = squares.begin() + probe_count / 10;
  std::nth_element(squares.begin(), chosen, squares.end());
  return std::sqrt(*chosen);
}

/** \brief Evidence of noise: none if two of a few neighbourhoods are flat. */
float
evidenceOfFew(const Coordinates& points, float spacing)
{
  constexpr float flat = 0.12f;
  std::array<float, probe_count> thickness;
  int flat_count = 0;
  for (int probe = 0; probe < probe_count; ++probe) {
    const std::size_t center = probedPoint(points, probe, probe_count);
    thickness[probe] = planeOfNearest(points, center, 2.6f * spacing).thickness();
    flat_count += thickness[probe] <= flat ? 1 : 0;
    if (flat_count == 2)
      return 0.0f;
  }
  std::nth_element(thickness.begin(), thickness.begin() + 1, thickness.end());
  return ramp(thickness[1], flat, 0.16f);
}

/** \brief Evidence of noise: none if a tenth of many neighbourhoods is rather flat, as
 * it is on objects of small parts. */
float
evidenceOfMany(const Coordinates& points, float spacing, int threads)
{
  std::array<float, many_probes_count> thickness;
#pragma omp parallel for schedule(static) num_threads(threads)
  for (int probe = 0; probe < many_probes_count; ++probe)
    thickness[probe] = planeOfNearest(points,
                                      probedPoint(points, probe, many_probes_count),
                                      2.6f * spacing)
                           .thickness();
  const auto chosen = thickness.begin() + many_probes_count / 10;
  std::nth_element(thickness.begin(), chosen, thickness.end());
  return ramp(*chosen, 0.22f, 0.25f);
}

/** \brief The distance that one in a hundred pairs exceeds. */
float
largeDistance(const std::vector<OrientedPoint>& points)
{
  constexpr std::size_t pair_count = 4096;
  const PairSampler sampler(points.size(), 0);
  std::vector<float> distances(pair_count);
  for (std::size_t k = 0; k < pair_count; ++k) {
    const auto pair = sampler.pair(k);
    distances[k] = (points[pair.first].position - points[pair.second].position).norm();
  }
  const auto chosen = distances.end() - pair_count / 100;
  std::nth_element(distances.begin(), chosen, distances.end());
  return *chosen;
}

} // namespace

PointNoise
measureNoise(const std::vector<OrientedPoint>& points,
             const std::vector<std::uint32_t>& order,
             float extent,
             unsigned int number_of_threads)
{
  assert(points.size() == order.size());
  if (points.size() < fewest_points)
    return {};
  const Coordinates some(points, order);
  const float spacing = usualSpacing(some.size(), extent);
  PointNoise noise;
  noise.evidence = evidenceOfFew(some, spacing);
  if (!(noise.evidence > 0.0f))
    return {};
  const int threads = pairThreadCount(number_of_threads);
  noise.evidence *= evidenceOfMany(some, spacing, threads);
  if (!(noise.evidence > 0.0f))
    return {};
  float width = 1.5f * spacing;
  noise.deviation = residual(some, width, threads);
  while (width < 1.4f * noise.deviation && width < extent) {
    width *= 1.25f;
    noise.deviation = residual(some, width, threads);
  }
  // Finer noise may as well be small parts of the object, and harms little.
  noise.evidence *= ramp(noise.deviation / spacing, 0.45f, 0.55f);
  return noise.evidence > 0.0f ? noise : PointNoise();
}

DenoisedObject
denoised(const std::vector<OrientedPoint>& points,
         const std::vector<std::uint32_t>& order,
         float extent,
         const PointNoise& noise,
         unsigned int number_of_threads)
{
  assert(points.size() == order.size());
  const Coordinates some(points, order);
  const float width = 1.2f * noise.deviation;
  DenoisedObject object;
  object.points.resize(some.size());
  object.weights.resize(some.size());
  const auto block_count = static_cast<int>(some.blocks.size());
#pragma omp parallel num_threads(pairThreadCount(number_of_threads))
  {
    Nearby nearby;
#pragma omp for schedule(dynamic, 4)
    for (int block = 0; block < block_count; ++block) {
      nearby.gather(some, some.blocks[block], width);
      const std::size_t first = some.blocks[block].first;
      const std::size_t last = some.blocks[block].last;
      for (std::size_t k = first; k < last; ++k) {
        const auto plane = planeAround(nearby, some.at(k), width);
        object.points[k] = points[some.indices[k]];
        object.points[k].position +=
            noise.evidence * plane.normal.dot(plane.offset) * plane.normal;
        const float flatness = std::max(1.0f - plane.thickness(), 0.02f);
        object.weights[k] = 1.0f + noise.evidence * (flatness - 1.0f);
      }
    }
  }
  // Noise finer than the points are dense moves the farthest ones but little.
  const float coarseness =
      ramp(noise.deviation / usualSpacing(some.size(), extent), 0.5f, 1.0f);
  const float share = noise.evidence * coarseness;
  object.extent = (1.0f - share) * extent + share * 1.1f * largeDistance(object.points);
  return object;
}

} // namespace indoor
} // namespace pcl
