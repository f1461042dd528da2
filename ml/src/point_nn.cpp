/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/ml/point_nn.h>

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>

namespace pcl::indoor {

namespace {

using Points = std::vector<Eigen::Vector3f>;
using Indices = std::vector<std::uint32_t>;

/** \brief A row of values per point. */
using Rows = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Row = Eigen::Array<float, 1, Eigen::Dynamic>;

void
requireOptions(const PointNNOptions& options)
{
  const auto fail = [](const char* problem) {
    PCL_THROW_EXCEPTION(BadArgumentException, "Point-NN needs " << problem);
  };
  if (options.point_count < 16)
    fail("at least 16 points");
  if (options.stage_count < 1 || options.stage_count > 8)
    fail("1 to 8 stages");
  if (options.embedding_size < 6 || options.embedding_size > 600 ||
      options.embedding_size % 6 != 0)
    fail("an embedding of 6 to 600 values, a multiple of 6");
  if (options.neighbor_count < 1)
    fail("at least 1 neighbour");
  if (!(options.wavelength_base > 1.0) || !std::isfinite(options.wavelength_base))
    fail("a base of wavelengths above 1");
  if (!(options.magnitude > 0.0) || !std::isfinite(options.magnitude))
    fail("a magnitude above 0");
}

Points
chosen(const Points& points, const Indices& indices)
{
  Points result(indices.size());
  std::transform(indices.begin(), indices.end(), result.begin(), [&](auto index) {
    return points[index];
  });
  return result;
}

Eigen::Vector3f
meanOf(const Points& points)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& point : points)
    sum += point.cast<double>();
  return (sum / static_cast<double>(points.size())).cast<float>();
}

/** \brief The points around their mean, the farthest 1 away.
 * \return false if all are
 * in one place */
bool
normalize(Points& points)
{
  if (std::all_of(points.begin(), points.end(), [&](const auto& point) {
        return point == points.front();
      }))
    return false;
  const Eigen::Vector3f mean = meanOf(points);
  float reach = 0.0f;
  for (auto& point : points) {
    point -= mean;
    reach = std::max(reach, point.norm());
  }
  for (auto& point : points)
    point /= reach;
  return true;
}

/** \brief Sines and cosines of coordinates, Eq. (4) and (5) of the paper: per axis sine
 * and cosine of each wavelength in turn. */
struct Waves {
  Rows values;  ///< sine, cosine, ...
  Rows swapped; ///< cosine, sine, ...
};

Waves
wavesOf(const Points& points, int size, double scale, const PointNNOptions& options)
{
  const int count = size / 6; // wavelengths
  std::vector<double> frequencies(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k)
    frequencies[static_cast<std::size_t>(k)] =
        scale * options.magnitude /
        std::pow(options.wavelength_base, static_cast<double>(k) / count);
  const auto rows = static_cast<Eigen::Index>(points.size());
  Waves waves{Rows(rows, size), Rows(rows, size)};
  for (Eigen::Index row = 0; row < rows; ++row)
    for (Eigen::Index axis = 0, k = 0; axis < 3; ++axis)
      for (const double frequency : frequencies) {
        const double angle = frequency * points[static_cast<std::size_t>(row)][axis];
        waves.values(row, k) = static_cast<float>(std::sin(angle));
        waves.values(row, k + 1) = static_cast<float>(std::cos(angle));
        waves.swapped(row, k) = waves.values(row, k + 1);
        waves.swapped(row, k + 1) = waves.values(row, k);
        k += 2;
      }
  return waves;
}

/** \brief Points that remain after a stage, and the neighbours of each. */
struct Groups {
  Indices centers;
  std::vector<Indices> neighbors;
};

/** \brief One over the standard deviation of the neighbours' differences from their
 * centre, all together. */
template <typename Difference>
float
inverseDeviation(const Groups& groups, const Difference& difference)
{
  double sum = 0.0;
  double squares = 0.0;
  double count = 0.0;
  for (std::size_t group = 0; group < groups.centers.size(); ++group)
    for (const auto neighbor : groups.neighbors[group]) {
      const auto values = difference(neighbor, groups.centers[group]);
      sum += values.sum();
      squares += (values * values).sum();
      count += static_cast<double>(values.size());
    }
  const double variance = (squares - sum * sum / count) / std::max(count - 1.0, 1.0);
  return static_cast<float>(1.0 / (std::sqrt(std::max(variance, 0.0)) + 1e-5));
}

/** \brief A centre's share in the values of its neighbours. */
struct CenterRows {
  Row cosines; ///< of its place, each twice
  Row sines;   ///< of its place, each with minus before and without
  Row offsets; ///< its features, negative and scaled, then as they are
};

CenterRows
centerRows(const Waves& waves, const Rows& features, Eigen::Index center, float scale)
{
  const Eigen::Index half = features.cols();
  CenterRows rows{Row(2 * half), Row(2 * half), Row(2 * half)};
  for (Eigen::Index k = 0; k < 2 * half; k += 2) {
    rows.cosines[k] = rows.cosines[k + 1] = waves.values(center, k + 1);
    rows.sines[k] = -waves.values(center, k);
    rows.sines[k + 1] = waves.values(center, k);
  }
  rows.offsets.head(half) = -scale * features.row(center);
  rows.offsets.tail(half) = features.row(center);
  return rows;
}

/** \brief Maximum plus mean over the neighbours of (feature + wave) * wave, the wave
 * being that of the place around the centre, by
 * sin(p - c) = sin p cos c - cos p sin c and cos(p - c) = cos p cos c + sin p sin c. */
void
poolNeighbors(const Waves& waves,
              const Rows& scaled_features,
              const Indices& neighbors,
              const CenterRows& center,
              float* pooled)
{
  constexpr int lanes = 4; // rows are multiples of 12
  using Lanes = Eigen::Array<float, lanes, 1>;
  using ConstLanes = Eigen::Map<const Lanes>;
  const auto size = static_cast<std::size_t>(waves.values.cols());
  for (std::size_t k = 0; k < size; k += lanes) {
    const Lanes cosines = ConstLanes(center.cosines.data() + k);
    const Lanes sines = ConstLanes(center.sines.data() + k);
    const Lanes offsets = ConstLanes(center.offsets.data() + k);
    Lanes largest = Lanes::Constant(-std::numeric_limits<float>::infinity());
    Lanes sum = Lanes::Zero();
    for (const auto neighbor : neighbors) {
      const std::size_t place = neighbor * size + k;
      const Lanes wave = ConstLanes(waves.values.data() + place) * cosines +
                         ConstLanes(waves.swapped.data() + place) * sines;
      const Lanes feature = ConstLanes(scaled_features.data() + place) + offsets;
      const Lanes value = (feature + wave) * wave;
      largest = largest.max(value);
      sum += value;
    }
    Eigen::Map<Lanes>(pooled + k) =
        largest + sum / static_cast<float>(neighbors.size());
  }
}

/** \brief Local geometry aggregation and pooling of a stage. */
Rows
aggregated(const Points& points,
           const Rows& features,
           const Groups& groups,
           const PointNNOptions& options)
{
  const Eigen::Index size = 2 * features.cols();
  const float place_scale = inverseDeviation(groups, [&](auto neighbor, auto center) {
    return (points[neighbor] - points[center]).array();
  });
  const float scale = inverseDeviation(groups, [&](auto neighbor, auto center) {
    return features.row(neighbor) - features.row(center);
  });
  const auto waves = wavesOf(points, static_cast<int>(size), place_scale, options);
  Rows scaled_features = Rows::Zero(features.rows(), size);
  scaled_features.leftCols(features.cols()) = features * scale;
  Rows pooled(static_cast<Eigen::Index>(groups.centers.size()), size);
  for (std::size_t group = 0; group < groups.centers.size(); ++group)
    poolNeighbors(waves,
                  scaled_features,
                  groups.neighbors[group],
                  centerRows(waves, features, groups.centers[group], scale),
                  &pooled(static_cast<Eigen::Index>(group), 0));
  return pooled;
}

} // namespace

std::vector<std::uint32_t>
farthestPoints(const std::vector<Eigen::Vector3f>& points, std::size_t wanted)
{
  Indices found;
  wanted = std::min(wanted, points.size());
  if (wanted == 0)
    return found;
  found.reserve(wanted);
  const Eigen::Vector3f mean = meanOf(points);
  std::size_t next = 0;
  float farthest = -1.0f;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (const float distance = (points[k] - mean).squaredNorm(); distance > farthest) {
      farthest = distance;
      next = k;
    }
  // Squared distance from the points found; none twice, even if all are in one place.
  std::vector<float> distances(points.size(), std::numeric_limits<float>::infinity());
  for (;;) {
    found.push_back(static_cast<std::uint32_t>(next));
    if (found.size() == wanted)
      return found;
    distances[next] = -1.0f;
    const Eigen::Vector3f place = points[next];
    farthest = -1.0f;
    for (std::size_t k = 0; k < points.size(); ++k) {
      distances[k] = std::min(distances[k], (points[k] - place).squaredNorm());
      if (distances[k] > farthest) {
        farthest = distances[k];
        next = k;
      }
    }
  }
}

std::vector<std::uint32_t>
nearestPoints(const std::vector<Eigen::Vector3f>& points,
              const Eigen::Vector3f& place,
              std::size_t wanted)
{
  wanted = std::min(wanted, points.size());
  // Distances and indices in one number each: bits of floats that are not negative are
  // in the order of the floats.
  std::vector<std::uint64_t> order(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const float distance = (points[k] - place).squaredNorm();
    std::uint32_t bits;
    std::memcpy(&bits, &distance, sizeof bits);
    order[k] = std::uint64_t(bits) << 32 | k;
  }
  if (wanted < order.size())
    std::nth_element(order.begin(),
                     order.begin() + static_cast<std::ptrdiff_t>(wanted),
                     order.end());
  Indices found(wanted);
  for (std::size_t k = 0; k < wanted; ++k)
    found[k] = static_cast<std::uint32_t>(order[k]);
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<float>
pointNNDescriptor(const std::vector<Eigen::Vector3f>& points,
                  const PointNNOptions& options)
{
  requireOptions(options);
  const auto size = static_cast<std::size_t>(options.embedding_size)
                    << options.stage_count;
  Points kept = points.size() > options.point_count
                    ? chosen(points, farthestPoints(points, options.point_count))
                    : points;
  if (!normalize(kept))
    return std::vector<float>(size, std::numeric_limits<float>::quiet_NaN());
  Rows features = wavesOf(kept, options.embedding_size, 1.0, options).values;
  for (int stage = 0; stage < options.stage_count; ++stage) {
    Groups groups;
    groups.centers = farthestPoints(kept, std::max<std::size_t>(kept.size() / 2, 1));
    for (const auto center : groups.centers)
      groups.neighbors.push_back(
          nearestPoints(kept, kept[center], options.neighbor_count));
    features = aggregated(kept, features, groups, options);
    kept = chosen(kept, groups.centers);
  }
  const Row descriptor = features.colwise().maxCoeff() + features.colwise().mean();
  const float length = descriptor.matrix().norm();
  std::vector<float> values(size);
  for (std::size_t k = 0; k < size; ++k)
    values[k] = descriptor[static_cast<Eigen::Index>(k)] / length;
  return values;
}

std::vector<float>
pointNNScores(const std::vector<float>& descriptor,
              const PointNNMemory& memory,
              std::size_t class_count,
              double sharpness)
{
  if (memory.descriptors.size() != memory.labels.size())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        memory.labels.size()
                            << " labels do not fit " << memory.descriptors.size()
                            << " descriptors");
  std::vector<std::pair<double, std::size_t>> similar; // cosine, class
  const auto squared = [](const std::vector<float>& values) {
    return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
  };
  const double own = squared(descriptor);
  for (std::size_t k = 0; k < memory.labels.size(); ++k) {
    const auto& other = memory.descriptors[k];
    if (other.size() != descriptor.size() || memory.labels[k] < 0 ||
        static_cast<std::size_t>(memory.labels[k]) >= class_count)
      PCL_THROW_EXCEPTION(BadArgumentException,
                          "Object "
                              << k << " of the memory has " << other.size()
                              << " values, not " << descriptor.size()
                              << ", or a label out of range: " << memory.labels[k]);
    const double cosine =
        std::inner_product(other.begin(), other.end(), descriptor.begin(), 0.0) /
        std::sqrt(own * squared(other));
    if (std::isfinite(cosine))
      similar.emplace_back(cosine, static_cast<std::size_t>(memory.labels[k]));
  }
  if (similar.empty())
    return {};
  // The nearest counts 1, so that no sharpness makes all of them 0.
  const double nearest = std::max_element(similar.begin(), similar.end())->first;
  std::vector<double> sums(class_count, 0.0);
  double all = 0.0;
  for (const auto& [cosine, label] : similar) {
    const double share = std::exp(-sharpness * (nearest - cosine));
    sums[label] += share;
    all += share;
  }
  std::vector<float> scores;
  for (const double sum : sums)
    scores.push_back(static_cast<float>(sum / all));
  return scores;
}

} // namespace pcl::indoor
