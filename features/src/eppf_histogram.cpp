/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/exceptions.h>
#include <pcl/features/eppf_histogram.h>
#include <pcl/features/line_occupancy.h>
#include <pcl/features/pair_counting.h>
#include <pcl/features/pair_sampling.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl {
namespace indoor {

namespace {

constexpr double half_pi = 1.5707963267948966;

/** \brief What the inner loop reads of a point: half a cache line. */
struct Surflet {
  Eigen::Vector3f position;
  Eigen::Vector3f normal;
  LineOccupancy::Cell cell;
};

/** \brief The features of a block of pairs, before they are put into bins. */
struct PairBlock {
  std::array<float, pair_block_size> distance;
  std::array<float, pair_block_size>
      first_sine; // sine of the first surface angle, -beta_1
  std::array<float, pair_block_size>
      second_sine; // sine of the second surface angle, -beta_2
  std::array<float, pair_block_size> cosine; // of the angle between the normals
  std::array<std::uint8_t, pair_block_size> occupancy_bin;
  std::array<std::uint32_t, pair_block_size> bin;
  std::size_t size = 0;
};

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

/** \brief The points with normals that point away from their centroid. */
std::vector<OrientedPoint>
turnedOutward(std::vector<OrientedPoint> points)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& point : points)
    sum += point.position.cast<double>();
  const Eigen::Vector3f centroid =
      (sum / static_cast<double>(points.size())).cast<float>();
  for (auto& point : points)
    if (point.normal.dot(point.position - centroid) < 0.0f)
      point.normal = -point.normal;
  return points;
}

/** \brief Everything that is the same for all pairs of an object. */
class PairCounter {
public:
  PairCounter(const std::vector<OrientedPoint>& points,
              double extent,
              const EPPFOptions& options)
  : options_(options)
  , sampler_(points, options.sampling, options.seed)
  , grid_(points,
          options.grid_size > 0 ? options.grid_size : automaticGridSize(points.size()))
  {
    const double scale = options.scale > 0.0 ? options.scale : extent;
    bins_per_metre_ = static_cast<float>(options.bins.distance / scale);
    const auto& bins = options.bins;
    const bool has_sides = options.normal_sides != NormalSides::Ignored;
    const double lowest = has_sides ? -half_pi : 0.0;
    if (options.surface_angle_rule == SurfaceAngleRule::Joint)
      surface_borders_ = evenBorders(has_sides ? -1.0 : 0.0, jointLevels(bins));
    else
      surface_borders_ = sineBorders(lowest, bins.surface_angle);
    second_borders_ = sineBorders(lowest, bins.occupancy);
    const double largest_angle =
        options.normal_sides == NormalSides::Outward ? 2 * half_pi : half_pi;
    for (int k = 1; k < bins.normal_angle; ++k)
      normal_borders_.push_back(
          static_cast<float>(std::cos(largest_angle * k / bins.normal_angle)));
    for (int total = 1; total <= 64; ++total)
      for (int occupied = 1; occupied <= total; ++occupied) // the ends are occupied
        occupancy_bins_[64 * (total - 1) + occupied - 1] = static_cast<std::uint8_t>(
            std::min(bins.occupancy * occupied / total, bins.occupancy - 1));
    surflets_.reserve(points.size());
    for (const auto& point :
         options.normal_sides == NormalSides::Outward ? turnedOutward(points) : points)
      surflets_.push_back({point.position, point.normal, grid_.cell(point.position)});
  }

  /** \brief Count the pairs of one block. */
  void
  count(std::size_t first_pair,
        std::size_t last_pair,
        std::vector<std::uint32_t>& counts) const
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

private:
  /** \brief Eq. (5.2), (5.4), (5.5), (5.7) and (5.8) for the pairs of a block. */
  void
  measure(std::size_t first_pair, std::size_t last_pair, PairBlock& block) const
  {
    const bool walks =
        options_.features.occupancy &&
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
        const auto line = grid_.countBetween(one.cell, two.cell);
        block.occupancy_bin[size] =
            occupancy_bins_[64 * (line.total - 1) + line.occupied - 1];
      }
      size +=
          block.distance[size] > 0.0f ? 1 : 0; // points in one place have no direction
    }
    block.size = size;
    for (std::size_t k = 0; k < size; ++k)
      block.distance[k] = std::sqrt(block.distance[k]);
    for (std::size_t k = 0; k < size; ++k)
      block.first_sine[k] /= block.distance[k];
    for (std::size_t k = 0; k < size; ++k)
      block.second_sine[k] /= block.distance[k];
  }

  /** \brief Leave in first_sine the sine of f2. */
  void
  combineAngles(PairBlock& block) const
  {
    // beta = acos(n.d) - pi/2 = -asin(n.d), Eq. (5.4) and (5.5)
    const auto sides = options_.normal_sides;
    const float second_sign = sides == NormalSides::Outward ? 1.0f : -1.0f;
    if (sides == NormalSides::Ignored)
      for (std::size_t k = 0; k < block.size; ++k) {
        block.first_sine[k] = std::abs(block.first_sine[k]);
        block.second_sine[k] = std::abs(block.second_sine[k]);
      }
    else // outward ones are measured towards the other point, each of them
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

  static float
  meanSine(float one, float two)
  {
    const auto angle = [](float sine) {
      return std::asin(std::clamp(sine, -1.0f, 1.0f));
    };
    return std::sin((angle(one) + angle(two)) / 2);
  }

  void
  addDistanceBins(PairBlock& block) const
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
  static void
  addBorders(const std::array<float, pair_block_size>& values,
             const std::vector<float>& borders,
             std::uint32_t stride,
             PairBlock& block)
  {
    for (const float border : borders)
      for (std::size_t k = 0; k < block.size; ++k)
        block.bin[k] += values[k] >= border ? stride : 0u;
  }

  void
  addSurfaceBins(PairBlock& block) const
  {
    const auto& bins = options_.bins;
    const auto stride = static_cast<std::uint32_t>(bins.normal_angle * bins.occupancy);
    if (!options_.features.surface_angle)
      return;
    if (options_.surface_angle_rule != SurfaceAngleRule::Joint) {
      addBorders(block.first_sine, surface_borders_, stride, block);
      return;
    }
    for (std::size_t k = 0; k < block.size; ++k) {
      std::uint32_t one = 0;
      std::uint32_t two = 0;
      for (const float border : surface_borders_) {
        one += block.first_sine[k] >= border ? 1u : 0u;
        two += block.second_sine[k] >= border ? 1u : 0u;
      }
      const auto higher = std::max(one, two);
      block.bin[k] += stride * (higher * (higher + 1) / 2 + std::min(one, two));
    }
  }

  void
  addNormalBins(PairBlock& block) const
  {
    const auto stride = static_cast<std::uint32_t>(options_.bins.occupancy);
    if (!options_.features.normal_angle)
      return;
    if (options_.normal_sides != NormalSides::Outward)
      for (std::size_t k = 0; k < block.size; ++k)
        block.cosine[k] = std::abs(block.cosine[k]); // Eq. (5.7)
    for (const float border : normal_borders_)
      for (std::size_t k = 0; k < block.size; ++k)
        block.bin[k] += block.cosine[k] <= border ? stride : 0u;
  }

  void
  addOccupancyBins(PairBlock& block) const
  {
    if (!options_.features.occupancy)
      return;
    if (options_.surface_angle_rule == SurfaceAngleRule::BothInsteadOfOccupancy)
      addBorders(block.second_sine, second_borders_, 1u, block); // Eq. (5.13)
    else
      for (std::size_t k = 0; k < block.size; ++k)
        block.bin[k] += block.occupancy_bin[k];
  }

  const EPPFOptions& options_;
  PairSampler sampler_;
  LineOccupancy grid_;
  std::vector<Surflet> surflets_;
  std::vector<float> surface_borders_;
  std::vector<float> second_borders_;
  std::vector<float> normal_borders_;
  std::array<std::uint8_t, 64 * 64> occupancy_bins_{};
  float bins_per_metre_ = 0.0f;
};

/** \brief Eq. (5.11), and the sum brought to 1. */
std::vector<float>
weighted(const std::vector<std::uint32_t>& counts, const EPPFOptions& options)
{
  std::vector<double> weights(counts.size());
  const std::size_t stride = counts.size() / options.bins.distance;
  double sum = 0.0;
  for (std::size_t bin = 0; bin < counts.size(); ++bin) {
    const double place = static_cast<double>(bin / stride) / options.bins.distance;
    const double weight =
        options.weighting ? std::log(place + options.weighting_constant) : 1.0;
    weights[bin] = weight * counts[bin];
    sum += weights[bin];
  }
  std::vector<float> histogram(counts.size());
  std::transform(weights.begin(), weights.end(), histogram.begin(), [sum](double w) {
    return static_cast<float>(w / sum);
  });
  return histogram;
}

} // namespace

std::vector<float>
eppfHistogram(const std::vector<OrientedPoint>& points, const EPPFOptions& options)
{
  const auto problem = whatIsWrong(options);
  if (!problem.empty())
    PCL_THROW_EXCEPTION(BadArgumentException, problem);
  const float extent = objectExtent(points);
  if (!(extent > 0.0f))
    return std::vector<float>(options.bins.size(),
                              std::numeric_limits<float>::quiet_NaN());
  const PairCounter counter(points, extent, options);
  const auto counts =
      countPairs(options.pair_count,
                 options.bins.size(),
                 options.number_of_threads,
                 [&counter](std::size_t first, std::size_t last, auto& own) {
                   counter.count(first, last, own);
                 });
  return weighted(counts, options);
}

} // namespace indoor
} // namespace pcl
