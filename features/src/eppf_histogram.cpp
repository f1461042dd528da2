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
#include <sstream>
#include <utility>

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

/** \brief Inner borders of count equal bins over angles from first to last, as sines.
 */
std::vector<float>
sineBorders(double first, double last, int count)
{
  std::vector<float> borders;
  for (int k = 1; k < count; ++k)
    borders.push_back(static_cast<float>(std::sin(first + (last - first) * k / count)));
  return borders;
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
    const double lowest = options.oriented_normals ? -half_pi : 0.0;
    const auto& bins = options.bins;
    surface_borders_ = sineBorders(lowest, half_pi, bins.surface_angle);
    second_borders_ = sineBorders(lowest, half_pi, bins.occupancy);
    // |n1.n2| falls with the angle: cos(a) = sin(pi/2 - a), so the last bin comes
    // first.
    normal_borders_ = sineBorders(0.0, half_pi, bins.normal_angle);
    for (int total = 1; total <= 64; ++total)
      for (int occupied = 1; occupied <= total; ++occupied) // the ends are occupied
        occupancy_bins_[64 * (total - 1) + occupied - 1] = static_cast<std::uint8_t>(
            std::min(bins.occupancy * occupied / total, bins.occupancy - 1));
    surflets_.reserve(points.size());
    for (const auto& point : points)
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
    // beta = acos(n.d) - pi/2 = -asin(n.d)
    if (!options_.oriented_normals)
      for (std::size_t k = 0; k < block.size; ++k) {
        block.first_sine[k] = std::abs(block.first_sine[k]);
        block.second_sine[k] = std::abs(block.second_sine[k]);
      }
    else
      for (std::size_t k = 0; k < block.size; ++k) {
        block.first_sine[k] = -block.first_sine[k];
        block.second_sine[k] = -block.second_sine[k];
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
    const auto bins = options_.bins;
    if (options_.features.surface_angle)
      addBorders(block.first_sine,
                 surface_borders_,
                 static_cast<std::uint32_t>(bins.normal_angle * bins.occupancy),
                 block);
  }

  void
  addNormalBins(PairBlock& block) const
  {
    const auto bins = options_.bins;
    const auto stride = static_cast<std::uint32_t>(bins.occupancy);
    if (!options_.features.normal_angle)
      return;
    for (std::size_t k = 0; k < block.size; ++k)
      block.cosine[k] = std::abs(block.cosine[k]);
    for (std::size_t k = 0; k < block.size; ++k)
      block.bin[k] += stride * static_cast<std::uint32_t>(bins.normal_angle - 1);
    for (const float border : normal_borders_)
      for (std::size_t k = 0; k < block.size; ++k)
        block.bin[k] -= block.cosine[k] > border ? stride : 0u;
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

int
automaticGridSize(std::size_t point_count)
{
  const double edge = std::sqrt(static_cast<double>(point_count) / 2.0);
  return static_cast<int>(std::lround(std::clamp(edge, 8.0, 64.0)));
}

std::string
whatIsWrong(const EPPFOptions& options)
{
  std::ostringstream problem;
  const auto& bins = options.bins;
  const std::pair<const char*, int> counts[] = {{"distance", bins.distance},
                                                {"surface angle", bins.surface_angle},
                                                {"normal angle", bins.normal_angle},
                                                {"occupancy", bins.occupancy}};
  for (const auto& [name, count] : counts)
    if (count < 1 || count > 64) {
      problem << "The number of " << name << " bins must be in 1 ... 64, not " << count;
      return problem.str();
    }
  if (options.pair_count < 1 || options.pair_count > 0xFFFFFFFFu)
    problem << "The number of pairs must be in 1 ... 2^32 - 1, not "
            << options.pair_count;
  else if (!(options.scale >= 0.0) || !std::isfinite(options.scale))
    problem << "The scale must be 0 (automatic) or a positive length, not "
            << options.scale << " m";
  else if (!(options.weighting_constant > 1.0) ||
           !std::isfinite(options.weighting_constant))
    problem << "The weighting constant must be above 1, not "
            << options.weighting_constant;
  else if (options.grid_size != 0 && (options.grid_size < 2 || options.grid_size > 64))
    problem << "The grid size must be 0 (automatic) or in 2 ... 64 voxels, not "
            << options.grid_size;
  return problem.str();
}

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
