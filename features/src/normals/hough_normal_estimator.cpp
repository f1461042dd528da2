/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/hough_normal_estimator.h>

#include "normals/accumulator_options.h"
#include "normals/plane_refit.h"

#include <pcl/indoor/require_valid.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace {

constexpr float thinnest_triangle = 1e-3f; // square of the sine of its angle
constexpr unsigned votes_between_checks = 8;

using pcl::indoor::HoughAccumulator;

std::vector<std::uint32_t>
randomNumbers(std::size_t count, std::uint32_t seed)
{
  std::mt19937 rng(seed);
  std::vector<std::uint32_t> numbers(count);
  for (auto& number : numbers)
    number = static_cast<std::uint32_t>(rng());
  return numbers;
}

/** Bits of a number that is not negative, which are in the order of such numbers. */
std::uint32_t
orderedBits(float number)
{
  std::uint32_t bits;
  std::memcpy(&bits, &number, sizeof(bits));
  return bits;
}

} // namespace

namespace pcl::indoor {

unsigned
houghTripleCount(unsigned bins, double confidence, double deviation)
{
  return static_cast<unsigned>(
      std::ceil(std::log(2 * bins / (1 - confidence)) / (2 * deviation * deviation)));
}

std::string
findProblem(const HoughNormalOptions& options)
{
  OptionCheck check;
  checkAccumulator(check, options.bin_angle_degrees, options.rotations);
  check.require(options.confidence > 0 && options.confidence < 1,
                "confidence must be in (0, 1)",
                options.confidence);
  check.require(options.deviation >= 0.01 && options.deviation <= 1,
                "deviation must be in [0.01, 1]",
                options.deviation);
  check.require(options.triples <= 1000000,
                "number of triples must be at most 1000000",
                options.triples);
  check.require(options.cubes_per_edge >= 1 && options.cubes_per_edge <= 16,
                "number of cubes per edge must be in [1, 16]",
                options.cubes_per_edge);
  check.require(options.plane_distance > 0,
                "largest distance of planes must be positive",
                options.plane_distance);
  check.require(options.cluster_tolerance_degrees >= 0 &&
                    options.cluster_tolerance_degrees <= 90,
                "cluster tolerance must be in [0, 90]",
                options.cluster_tolerance_degrees,
                " degrees");
  return check.problem();
}

HoughNormalEstimator::HoughNormalEstimator(const HoughNormalOptions& options)
: options_(requireValid(options))
, accumulator_(std::make_shared<HoughAccumulator>(
      options.bin_angle_degrees, options.rotations, options.seed))
{
  triple_count_ = options.triples > 0 ? options.triples
                                      : houghTripleCount(accumulator_->binCount(),
                                                         options.confidence,
                                                         options.deviation);
  random_ = std::make_shared<std::vector<std::uint32_t>>(
      randomNumbers(3 * static_cast<std::size_t>(triple_count_), options.seed));
  votes_.assign(static_cast<std::size_t>(options.rotations) * accumulator_->binCount(),
                0);
}

/** By distance, ties by coordinates: the same order whatever the order was. */
void
HoughNormalEstimator::sortNeighbors(std::vector<Eigen::Vector3f>& neighbors)
{
  keys_.clear();
  for (std::size_t i = 0; i < neighbors.size(); ++i)
    keys_.push_back(std::uint64_t{orderedBits(neighbors[i].squaredNorm())} << 32 | i);
  std::sort(keys_.begin(), keys_.end());
  sorted_.clear();
  for (const auto key : keys_)
    sorted_.push_back(neighbors[key & 0xffffffffu]);
  for (std::size_t begin = 0, end = 0; begin < keys_.size(); begin = end) {
    while (end < keys_.size() && keys_[end] >> 32 == keys_[begin] >> 32)
      ++end;
    if (end - begin > 1)
      std::sort(sorted_.begin() + static_cast<std::ptrdiff_t>(begin),
                sorted_.begin() + static_cast<std::ptrdiff_t>(end),
                [](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
                  return std::lexicographical_compare(
                      a.data(), a.data() + 3, b.data(), b.data() + 3);
                });
  }
  neighbors.swap(sorted_);
}

/** List the neighbours by cubes of the cube around their ball; empty ones are left out.
 */
void
HoughNormalEstimator::sortIntoCubes(const std::vector<Eigen::Vector3f>& neighbors)
{
  const auto edge = static_cast<int>(options_.cubes_per_edge);
  const float radius = std::max(neighbors.back().norm(), 1e-30f); // they are sorted
  const float scale = static_cast<float>(edge) / (2 * radius);
  cube_of_neighbor_.clear();
  for (const auto& neighbor : neighbors) {
    const Eigen::Array3i cell =
        ((neighbor.array() + radius) * scale).cast<int>().max(0).min(edge - 1);
    cube_of_neighbor_.push_back((cell.x() * edge + cell.y()) * edge + cell.z());
  }
  cube_ends_.assign(static_cast<std::size_t>(edge) * edge * edge + 1, 0);
  for (const auto cube : cube_of_neighbor_)
    ++cube_ends_[cube + 1];
  cube_offsets_.assign(1, 0);
  for (std::size_t cube = 1; cube < cube_ends_.size(); ++cube) {
    if (cube_ends_[cube] > 0)
      cube_offsets_.push_back(cube_offsets_.back() + cube_ends_[cube]);
    cube_ends_[cube] += cube_ends_[cube - 1];
  }
  order_.resize(neighbors.size());
  for (std::uint32_t i = 0; i < order_.size(); ++i)
    order_[cube_ends_[cube_of_neighbor_[i]]++] = i;
}

/** Has an accumulator a leading bin whose lead is not chance? Two shares out of T votes
 * have confidence intervals of +-1 / sqrt(T). One accumulator is enough: in the others,
 * the same directions may be divided by the border of two bins. */
bool
HoughNormalEstimator::isDecided() const
{
  const std::uint64_t drawn = directions_.size();
  return std::any_of(leaders_.begin(), leaders_.end(), [&](const auto& leader) {
    const std::uint64_t lead = leader.votes - leader.second;
    return lead * lead >= 4 * drawn;
  });
}

unsigned
HoughNormalEstimator::drawTriples(const std::vector<Eigen::Vector3f>& neighbors)
{
  const unsigned copies = accumulator_->rotations();
  const std::size_t bins = accumulator_->binCount();
  leaders_.assign(copies, Leader());
  directions_.clear();
  bins_.clear();
  const bool by_cubes = options_.sampling == HoughSampling::Cubes;
  const std::uint64_t choices = by_cubes ? cube_offsets_.size() - 1 : neighbors.size();
  const auto pick = [&](std::uint32_t random) -> std::size_t {
    const std::uint64_t product = random * choices;
    if (!by_cubes)
      return product >> 32;
    // The high part chooses the cube, what is left of the fraction a point in it.
    const auto begin = cube_offsets_[product >> 32];
    const auto size = cube_offsets_[(product >> 32) + 1] - begin;
    return order_[begin + (((product & 0xffffffffu) * size) >> 32)];
  };
  const auto tolerance = static_cast<float>(options_.plane_distance);
  const float largest_distance =
      tolerance * tolerance * neighbors.back().squaredNorm(); // squared
  for (unsigned drawn = 0; drawn < triple_count_; ++drawn) {
    const std::uint32_t* random = random_->data() + 3 * static_cast<std::size_t>(drawn);
    const auto& corner = neighbors[pick(random[0])];
    const Eigen::Vector3f a = neighbors[pick(random[1])] - corner;
    const Eigen::Vector3f b = neighbors[pick(random[2])] - corner;
    // Not a.cross(b), which the linker finds as a function outside of this library.
    const Eigen::Vector3f normal(a.y() * b.z() - a.z() * b.y(),
                                 a.z() * b.x() - a.x() * b.z(),
                                 a.x() * b.y() - a.y() * b.x());
    const float squared = normal.squaredNorm();
    const float distance =
        normal.dot(corner); // of the plane, times the normal's length
    if (!(squared > thinnest_triangle * a.squaredNorm() * b.squaredNorm()) ||
        distance * distance > largest_distance * squared)
      continue;
    directions_.push_back(normal / std::sqrt(squared));
    bins_.push_back(accumulator_->bins(directions_.back()));
    for (unsigned copy = 0; copy < copies; ++copy) {
      const std::uint32_t bin = bins_.back()[copy];
      const auto votes = ++votes_[copy * bins + bin];
      auto& leader = leaders_[copy];
      if (bin == leader.bin)
        leader.votes = votes;
      else if (votes > leader.votes)
        leader = {bin, votes, leader.votes};
      else
        leader.second = std::max(leader.second, votes);
    }
    if (directions_.size() % votes_between_checks == 0 && isDecided())
      return drawn + 1;
  }
  return triple_count_;
}

Eigen::Vector3f
HoughNormalEstimator::meanOfLeadingBin(unsigned copy) const
{
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (std::size_t i = 0; i < directions_.size(); ++i)
    if (bins_[i][copy] == leaders_[copy].bin)
      sum += sum.dot(directions_[i]) < 0 ? Eigen::Vector3f(-directions_[i])
                                         : directions_[i];
  return sum.normalized();
}

/** One direction from those of the accumulators. */
Eigen::Vector3f
HoughNormalEstimator::chooseDirection() const
{
  const auto copies = static_cast<unsigned>(leaders_.size());
  std::vector<Eigen::Vector3f> means;
  for (unsigned copy = 0; copy < copies; ++copy)
    means.push_back(meanOfLeadingBin(copy));
  const auto weight = [&](unsigned copy) {
    return static_cast<float>(leaders_[copy].votes);
  };
  // The mean around each accumulator's direction; the group with the most votes wins.
  const double tolerance = options_.choice == HoughChoice::Mean ? 90
                           : options_.choice == HoughChoice::Best
                               ? 0
                               : options_.cluster_tolerance_degrees;
  const auto cosine = static_cast<float>(std::cos(tolerance * M_PI / 180));
  Eigen::Vector3f chosen = means[0];
  float most_votes = 0;
  for (unsigned middle = 0; middle < copies; ++middle) {
    Eigen::Vector3f sum = weight(middle) * means[middle];
    float votes = weight(middle);
    for (unsigned copy = 0; copy < copies && tolerance > 0; ++copy) {
      const float similarity = means[middle].dot(means[copy]);
      if (copy == middle || std::abs(similarity) < cosine)
        continue;
      sum += (similarity < 0 ? -weight(copy) : weight(copy)) * means[copy];
      votes += weight(copy);
    }
    if (votes > most_votes) {
      most_votes = votes;
      chosen = sum;
    }
  }
  return chosen.normalized();
}

HoughNormal
HoughNormalEstimator::estimate(std::vector<Eigen::Vector3f>& neighbors)
{
  HoughNormal result;
  result.normal.setConstant(std::numeric_limits<float>::quiet_NaN());
  result.curvature = std::numeric_limits<float>::quiet_NaN();
  if (neighbors.size() < 3)
    return result;
  sortNeighbors(neighbors);
  float curvature = 0;
  if (!surfaceVariation(neighbors, curvature))
    return result;
  if (options_.sampling == HoughSampling::Cubes)
    sortIntoCubes(neighbors);
  result.triples = drawTriples(neighbors);
  if (!directions_.empty()) {
    result.curvature = curvature;
    result.normal = chooseDirection();
    for (const auto& leader : leaders_)
      result.share = std::max(result.share,
                              static_cast<float>(leader.votes) /
                                  static_cast<float>(directions_.size()));
    if (options_.refine)
      result.normal =
          refitPlane(neighbors,
                     result.normal,
                     static_cast<float>(1.5 * options_.bin_angle_degrees * M_PI / 180),
                     heights_);
  }
  // Only what was touched is cleared: there are more bins than votes.
  for (const auto* bins : bins_)
    for (unsigned copy = 0; copy < accumulator_->rotations(); ++copy)
      votes_[copy * static_cast<std::size_t>(accumulator_->binCount()) + bins[copy]] =
          0;
  return result;
}

} // namespace pcl::indoor
