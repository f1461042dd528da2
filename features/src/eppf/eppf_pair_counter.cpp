/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "eppf/eppf_pair_counter.h"

#include "eppf/soft_bin.h"
#include "internal/point_bounds.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pcl::indoor {

namespace {

constexpr double half_pi = 1.5707963267948966;

/** \brief Inner borders of count equal bins of an angle from lowest to pi / 2, as
 * sines. */
std::vector<float>
sineBorders(double lowest, int count)
{
  std::vector<float> borders;
  for (int k = 1; k < count; ++k)
    borders.push_back(
        static_cast<float>(std::sin(lowest + (half_pi - lowest) * k / count)));
  return borders;
}

/** \brief Inner borders of count equal bins of a sine from lowest to 1. */
std::vector<float>
evenBorders(double lowest, int count)
{
  std::vector<float> borders;
  for (int k = 1; k < count; ++k)
    borders.push_back(static_cast<float>(lowest + (1.0 - lowest) * k / count));
  return borders;
}

/** \brief How many normals point away from a centroid. */
std::size_t
outwardCount(const std::vector<OrientedPoint>& points, const Eigen::Vector3f& centroid)
{
  return static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(), [&](const OrientedPoint& point) {
        return !(point.normal.dot(point.position - centroid) < 0.0f);
      }));
}

/** \brief The sine of the mean of two angles. */
float
meanSine(float one, float two)
{
  const auto angle = [](float sine) {
    return std::asin(std::clamp(sine, -1.0f, 1.0f));
  };
  return std::sin((angle(one) + angle(two)) / 2);
}

} // namespace

PairCounter::PairCounter(const std::vector<OrientedPoint>& points,
                         PairSampler sampler,
                         double scale,
                         const EPPFOptions& options)
: options_(options)
, sampler_(std::move(sampler))
, grid_(points,
        options.grid_size > 0 ? options.grid_size : automaticGridSize(points.size()))
, bins_per_metre_(static_cast<float>(options.bins.distance / scale))
{
  setBorders();
  const bool turns_each = options.normal_sides == NormalSides::Outward;
  const Eigen::Vector3f centroid = centroidOf(points);
  const bool turns_all = options.normal_sides == NormalSides::MostlyOutward &&
                         2 * outwardCount(points, centroid) < points.size();
  surflets_.reserve(points.size());
  for (const auto& [position, normal] : points) {
    const bool faces_inward = normal.dot(position - centroid) < 0.0f;
    const float sign = turns_all || (turns_each && faces_inward) ? -1.0f : 1.0f;
    surflets_.push_back({position, sign * normal, grid_.cell(position)});
  }
}

void
PairCounter::setBorders()
{
  const auto& bins = options_.bins;
  const bool has_sides = options_.normal_sides != NormalSides::Ignored;
  const double lowest = has_sides ? -half_pi : 0.0;
  if (options_.surface_angle_rule == SurfaceAngleRule::Joint)
    surface_borders_ = evenBorders(has_sides ? -1.0 : 0.0, jointLevels(bins));
  else
    surface_borders_ = sineBorders(lowest, bins.surface_angle);
  second_borders_ = sineBorders(lowest, bins.occupancy);
  const double largest_angle =
      areSidesKnown(options_.normal_sides) ? 2 * half_pi : half_pi;
  for (int k = 1; k < bins.normal_angle; ++k)
    normal_borders_.push_back(
        static_cast<float>(std::cos(largest_angle * k / bins.normal_angle)));
  for (int total = 1; total <= grid_.size(); ++total)
    for (int occupied = 1; occupied <= total; ++occupied) // the ends are occupied
      occupancy_bins_[64 * (total - 1) + occupied - 1] = static_cast<std::uint8_t>(
          std::min(bins.occupancy * occupied / total, bins.occupancy - 1));
}

void
PairCounter::count(std::size_t first_pair,
                   std::size_t last_pair,
                   std::vector<std::uint64_t>& counts) const
{
  PairBlock block;
  measure(first_pair, last_pair, block);
  combineAngles(block);
  std::fill_n(block.bin.begin(), block.size, 0u);
  addDistanceBins(block);
  addSurfaceBins(block);
  addNormalBins(block);
  addOccupancyBins(block);
  for (std::size_t k = 0; k < block.size; ++k)
    ++counts[block.bin[k]];
}

void
PairCounter::addInterpolated(std::size_t first_pair,
                             std::size_t last_pair,
                             const std::vector<float>& weights,
                             float softness,
                             std::vector<std::uint64_t>& counts) const
{
  PairBlock block;
  measure(first_pair, last_pair, block);
  combineAngles(block);
  std::fill_n(block.bin.begin(), block.size, 0u);
  const auto& bins = options_.bins;
  const bool joint = options_.surface_angle_rule == SurfaceAngleRule::Joint &&
                     options_.features.surface_angle;
  const int levels = joint ? jointLevels(bins) : 1;
  const float lowest = options_.normal_sides == NormalSides::Ignored ? 0.0f : -1.0f;
  const auto level = [=](float sine) {
    return SoftBin((sine - lowest) / (1.0f - lowest) * static_cast<float>(levels),
                   levels,
                   softness);
  };
  if (!joint)
    addSurfaceBins(block);
  addNormalBins(block);
  addOccupancyBins(block);
  const int distance_bins = options_.features.distance ? bins.distance : 1;
  const auto level_stride =
      static_cast<std::uint32_t>(bins.normal_angle * bins.occupancy);
  const std::uint32_t distance_stride = level_stride * bins.surface_angle;
  for (std::size_t k = 0; k < block.size; ++k) {
    const auto pair = sampler_.pair(first_pair + block.pair[k]);
    const float weight = weights[pair.first] * weights[pair.second];
    const SoftBin f1(block.distance[k] * bins_per_metre_, distance_bins, softness);
    const auto one = level(block.first_sine[k]);
    const auto two = level(block.second_sine[k]);
    for (int corner = 0; corner < 8; ++corner) {
      const int a = corner & 1;
      const int b = (corner >> 1) & 1;
      const int c = corner >> 2;
      const float part = weight * f1.share[a] * one.share[b] * two.share[c];
      const auto higher = std::max(one.bin[b], two.bin[c]);
      const auto surface = higher * (higher + 1) / 2 + std::min(one.bin[b], two.bin[c]);
      counts[block.bin[k] + distance_stride * f1.bin[a] + level_stride * surface] +=
          static_cast<std::uint64_t>(part * 65536.0f + 0.5f);
    }
  }
}

/** \brief Eq. (5.2), (5.4), (5.5), (5.7) and (5.8) for the pairs of a block. */
void
PairCounter::measure(std::size_t first_pair,
                     std::size_t last_pair,
                     PairBlock& block) const
{
  const bool walks =
      options_.features.occupancy && options_.bins.occupancy > 1 &&
      options_.surface_angle_rule != SurfaceAngleRule::BothInsteadOfOccupancy;
  std::size_t size = 0;
  for (std::size_t k = first_pair; k < last_pair; ++k) {
    const auto pair = sampler_.pair(k);
    const auto& one = surflets_[pair.first];
    const auto& two = surflets_[pair.second];
    const Eigen::Vector3f direction = two.position - one.position;
    block.distance[size] = direction.squaredNorm();
    block.first_sine[size] = one.normal.dot(direction);
    block.second_sine[size] = two.normal.dot(direction);
    block.cosine[size] = one.normal.dot(two.normal);
    if (walks) {
      block.line[size] = grid_.lineBetween(one.cell, two.cell);
    }
    block.pair[size] = static_cast<std::uint32_t>(k - first_pair);
    size +=
        block.distance[size] > 0.0f ? 1 : 0; // points in one place have no direction
  }
  block.size = size;
  if (walks)
    walkLines(block);
  for (std::size_t k = 0; k < size; ++k)
    block.distance[k] = std::sqrt(block.distance[k]);
  for (std::size_t k = 0; k < size; ++k)
    block.first_sine[k] /= block.distance[k];
  for (std::size_t k = 0; k < size; ++k)
    block.second_sine[k] /= block.distance[k];
  if (options_.normal_angle_rule == NormalAngleRule::AroundLine)
    turnAroundLine(block);
}

/** \brief From the cosine between the normals to that between their parts across the
 * line. */
void
PairCounter::turnAroundLine(PairBlock& block)
{
  constexpr float least = 1e-6f; // a shorter part is of rounding
  for (std::size_t k = 0; k < block.size; ++k) {
    const float one = block.first_sine[k];
    const float two = block.second_sine[k];
    const float square = (1.0f - one * one) * (1.0f - two * two);
    const float product = block.cosine[k] - one * two;
    block.cosine[k] = square > least ? product / std::sqrt(square) : 1.0f;
  }
}

/** \brief Eq. (5.8). Lines of one length follow each other, so that the processor
 * foresees their ends: in the order of the pairs this takes half as long again. */
void
PairCounter::walkLines(PairBlock& block) const
{
  std::array<std::uint32_t, 65> starts{};
  for (std::size_t k = 0; k < block.size; ++k)
    ++starts[block.line[k].steps + 1];
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::array<std::uint16_t, pair_block_size> by_length;
  for (std::size_t k = 0; k < block.size; ++k)
    by_length[starts[block.line[k].steps]++] = static_cast<std::uint16_t>(k);
  for (std::size_t rank = 0; rank < block.size; ++rank) {
    const auto& line = block.line[by_length[rank]];
    block.occupancy_bin[by_length[rank]] =
        occupancy_bins_[64 * line.steps + grid_.countOccupied(line) - 1];
  }
}

/** \brief Leave in first_sine the sine of f2. */
void
PairCounter::combineAngles(PairBlock& block) const
{
  // beta = acos(n.d) - pi/2 = -asin(n.d), Eq. (5.4) and (5.5)
  const auto sides = options_.normal_sides;
  const float second_sign = areSidesKnown(sides) ? 1.0f : -1.0f;
  if (sides == NormalSides::Ignored)
    for (std::size_t k = 0; k < block.size; ++k) {
      block.first_sine[k] = std::abs(block.first_sine[k]);
      block.second_sine[k] = std::abs(block.second_sine[k]);
    }
  else // where sides are known, measured towards the other point, each of them
    for (std::size_t k = 0; k < block.size; ++k) {
      block.first_sine[k] = -block.first_sine[k];
      block.second_sine[k] *= second_sign;
    }
  auto& one = block.first_sine;
  const auto& two = block.second_sine;
  switch (options_.surface_angle_rule) {
  case SurfaceAngleRule::Maximum: // Eq. (5.6)
    for (std::size_t k = 0; k < block.size; ++k)
      one[k] = std::max(one[k], two[k]);
    break;
  case SurfaceAngleRule::Minimum:
    for (std::size_t k = 0; k < block.size; ++k)
      one[k] = std::min(one[k], two[k]);
    break;
  case SurfaceAngleRule::Mean:
    for (std::size_t k = 0; k < block.size; ++k)
      one[k] = meanSine(one[k], two[k]);
    break;
  case SurfaceAngleRule::Joint:     // each is put into a level of its own
  case SurfaceAngleRule::RandomOne: // which point comes first is random already
  case SurfaceAngleRule::BothInsteadOfOccupancy:
    break;
  }
}

void
PairCounter::addDistanceBins(PairBlock& block) const
{
  const auto bins = options_.bins;
  if (!options_.features.distance)
    return;
  const float last = static_cast<float>(bins.distance - 1);
  const std::uint32_t stride = static_cast<std::uint32_t>(bins.surface_angle) *
                               bins.normal_angle * bins.occupancy;
  for (std::size_t k = 0; k < block.size; ++k) {
    const float place = std::min(block.distance[k] * bins_per_metre_, last);
    block.bin[k] += stride * static_cast<std::uint32_t>(static_cast<int>(place));
  }
}

/** \brief Add stride for each border a value reaches. */
void
PairCounter::addBorders(const std::array<float, pair_block_size>& values,
                        const std::vector<float>& borders,
                        std::uint32_t stride,
                        PairBlock& block)
{
  for (const float border : borders)
    for (std::size_t k = 0; k < block.size; ++k)
      block.bin[k] += values[k] >= border ? stride : 0u;
}

void
PairCounter::addSurfaceBins(PairBlock& block) const
{
  const auto& bins = options_.bins;
  const auto stride = static_cast<std::uint32_t>(bins.normal_angle * bins.occupancy);
  if (!options_.features.surface_angle)
    return;
  if (options_.surface_angle_rule != SurfaceAngleRule::Joint) {
    addBorders(block.first_sine, surface_borders_, stride, block);
    return;
  }
  std::array<std::uint32_t, pair_block_size> one;
  std::array<std::uint32_t, pair_block_size> two;
  std::fill_n(one.begin(), block.size, 0u);
  std::fill_n(two.begin(), block.size, 0u);
  for (const float border : surface_borders_)
    for (std::size_t k = 0; k < block.size; ++k) {
      one[k] += block.first_sine[k] >= border ? 1u : 0u;
      two[k] += block.second_sine[k] >= border ? 1u : 0u;
    }
  for (std::size_t k = 0; k < block.size; ++k) {
    const auto higher = std::max(one[k], two[k]);
    block.bin[k] += stride * (higher * (higher + 1) / 2 + std::min(one[k], two[k]));
  }
}

void
PairCounter::addNormalBins(PairBlock& block) const
{
  const auto stride = static_cast<std::uint32_t>(options_.bins.occupancy);
  if (!options_.features.normal_angle)
    return;
  if (!areSidesKnown(options_.normal_sides))
    for (std::size_t k = 0; k < block.size; ++k)
      block.cosine[k] = std::abs(block.cosine[k]); // Eq. (5.7)
  for (const float border : normal_borders_)
    for (std::size_t k = 0; k < block.size; ++k)
      block.bin[k] += block.cosine[k] <= border ? stride : 0u;
}

void
PairCounter::addOccupancyBins(PairBlock& block) const
{
  if (!options_.features.occupancy || options_.bins.occupancy == 1)
    return;
  if (options_.surface_angle_rule == SurfaceAngleRule::BothInsteadOfOccupancy)
    addBorders(block.second_sine, second_borders_, 1u, block); // Eq. (5.13)
  else
    for (std::size_t k = 0; k < block.size; ++k)
      block.bin[k] += block.occupancy_bin[k];
}

} // namespace pcl::indoor
