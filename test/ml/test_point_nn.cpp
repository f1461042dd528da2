/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/exceptions.h>
#include <pcl/ml/point_nn.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace pcl::indoor {
namespace {

using Points = std::vector<Eigen::Vector3f>;
using Table = std::vector<std::vector<double>>;

Points
randomPoints(std::size_t count, std::uint32_t seed)
{
  std::mt19937 random(seed);
  const auto number = [&random] {
    return static_cast<float>(random() % 1000) / 500.0f;
  };
  Points points(count);
  for (auto& point : points)
    point = {number(), 0.5f * number(), number() * number()};
  return points;
}

TEST(FarthestPoints, AreAsTheDefinitionSays)
{
  for (const std::size_t count : {1u, 2u, 7u, 60u}) {
    auto points = randomPoints(count, 3);
    if (count == 60)
      for (std::size_t k = 30; k < 60; ++k) // ties
        points[k] = points[k - 30];
    const auto found = farthestPoints(points, 40);
    ASSERT_EQ(found.size(), std::min<std::size_t>(count, 40));
    Eigen::Vector3f mean = Eigen::Vector3f::Zero();
    for (const auto& point : points)
      mean += point / static_cast<float>(count);
    for (const auto& point : points)
      EXPECT_LE((point - mean).norm(), (points[found[0]] - mean).norm() + 1e-5f);
    for (std::size_t n = 1; n < found.size(); ++n) {
      const auto gap = [&](std::size_t k) { // from those found before
        float least = std::numeric_limits<float>::infinity();
        for (std::size_t j = 0; j < n; ++j)
          least = std::min(least, (points[k] - points[found[j]]).squaredNorm());
        return least;
      };
      for (std::size_t k = 0; k < count; ++k)
        EXPECT_LE(gap(k), gap(found[n]));
    }
    auto sorted = found;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(std::unique(sorted.begin(), sorted.end()), sorted.end());
  }
  EXPECT_TRUE(farthestPoints({}, 3).empty());
  EXPECT_TRUE(farthestPoints(randomPoints(3, 1), 0).empty());
}

TEST(NearestPoints, AreAsSortingSays)
{
  auto points = randomPoints(50, 4);
  points[30] = points[7];
  for (const std::size_t wanted : {0u, 1u, 9u, 50u, 70u}) {
    const auto place = points[7];
    std::vector<std::uint32_t> expected(50);
    for (std::uint32_t k = 0; k < 50; ++k)
      expected[k] = k;
    std::stable_sort(expected.begin(), expected.end(), [&](auto a, auto b) {
      return (points[a] - place).squaredNorm() < (points[b] - place).squaredNorm();
    });
    expected.resize(std::min<std::size_t>(wanted, 50));
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(nearestPoints(points, place, wanted), expected);
  }
}

/** Sines and cosines of a place, axis after axis. */
std::vector<double>
embedded(const Eigen::Vector3d& place, int size, const PointNNOptions& options)
{
  std::vector<double> values;
  for (int axis = 0; axis < 3; ++axis)
    for (int k = 0; k < size / 6; ++k) {
      const double angle = options.magnitude * place[axis] /
                           std::pow(options.wavelength_base, 6.0 * k / size);
      values.push_back(std::sin(angle));
      values.push_back(std::cos(angle));
    }
  return values;
}

double
deviation(const std::vector<double>& values)
{
  double mean = 0.0;
  for (const double value : values)
    mean += value / static_cast<double>(values.size());
  double sum = 0.0;
  for (const double value : values)
    sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

std::vector<double>
pooled(const Table& rows)
{
  std::vector<double> values(rows[0].size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    values[k] = -1e9;
    double sum = 0.0;
    for (const auto& row : rows) {
      values[k] = std::max(values[k], row[k]);
      sum += row[k];
    }
    values[k] += sum / static_cast<double>(rows.size());
  }
  return values;
}

/** The paper's formulas one after the other, in double precision. */
std::vector<double>
naiveDescriptor(Points points, const PointNNOptions& options)
{
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  for (const auto& point : points)
    mean += point / static_cast<float>(points.size());
  float reach = 0.0f;
  for (auto& point : points)
    reach = std::max(reach, (point -= mean).norm());
  Table features;
  for (auto& point : points)
    features.push_back(
        embedded((point /= reach).cast<double>(), options.embedding_size, options));
  int size = options.embedding_size;
  for (int stage = 0; stage < options.stage_count; ++stage, size *= 2) {
    const auto centers = farthestPoints(points, points.size() / 2);
    std::vector<double> places;
    std::vector<double> differences;
    const auto for_pairs = [&](const auto& visit) {
      for (const auto c : centers)
        for (const auto n : nearestPoints(points, points[c], options.neighbor_count))
          visit(c, n);
    };
    for_pairs([&](auto c, auto n) {
      for (int axis = 0; axis < 3; ++axis)
        places.push_back(points[n][axis] - points[c][axis]);
      for (int k = 0; k < size; ++k)
        differences.push_back(features[n][k] - features[c][k]);
    });
    const double place_deviation = deviation(places) + 1e-5;
    const double feature_deviation = deviation(differences) + 1e-5;
    Table next;
    Points kept;
    for (const auto c : centers) {
      Table rows;
      for (const auto n : nearestPoints(points, points[c], options.neighbor_count)) {
        const Eigen::Vector3d place =
            (points[n].cast<double>() - points[c].cast<double>()) / place_deviation;
        auto row = embedded(place, 2 * size, options);
        for (int k = 0; k < 2 * size; ++k) {
          const double feature =
              k < size ? (features[n][k] - features[c][k]) / feature_deviation
                       : features[c][k - size];
          row[k] = (feature + row[k]) * row[k];
        }
        rows.push_back(row);
      }
      next.push_back(pooled(rows));
      kept.push_back(points[c]);
    }
    features = next;
    points = kept;
  }
  auto values = pooled(features);
  double squares = 0.0;
  for (const double value : values)
    squares += value * value;
  for (double& value : values)
    value /= std::sqrt(squares);
  return values;
}

TEST(PointNN, IsAsThePapersFormulas)
{
  PointNNOptions options;
  for (const auto& [count, size, neighbors, stages] : {std::array<int, 4>{40, 6, 5, 2},
                                                       {64, 12, 90, 3},
                                                       {33, 18, 1, 1},
                                                       {2, 6, 9, 1}}) {
    options.embedding_size = size;
    options.neighbor_count = static_cast<std::size_t>(neighbors);
    options.stage_count = stages;
    const auto points = randomPoints(static_cast<std::size_t>(count), 5);
    const auto found = pointNNDescriptor(points, options);
    const auto expected = naiveDescriptor(points, options);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k)
      EXPECT_NEAR(found[k], expected[k], 2e-3) << k; // sines of hundreds, in floats
  }
}

TEST(PointNN, DependsOnShapeAlone)
{
  auto points = randomPoints(200, 6);
  PointNNOptions options;
  options.point_count = 128;
  const auto descriptor = pointNNDescriptor(points, options);
  EXPECT_EQ(descriptor.size(), 72u * 16u);
  const auto similarity = [&](const std::vector<float>& other) {
    double sum = 0.0;
    for (std::size_t k = 0; k < other.size(); ++k)
      sum += double(other[k]) * descriptor[k];
    return sum;
  };
  EXPECT_NEAR(similarity(descriptor), 1.0, 1e-5);
  auto moved = points;
  for (auto& point : moved)
    point = 4.0f * point + Eigen::Vector3f(2, 4, 8);
  EXPECT_NEAR(similarity(pointNNDescriptor(moved, options)), 1.0, 1e-2);
  std::reverse(points.begin(), points.end());
  EXPECT_NEAR(similarity(pointNNDescriptor(points, options)), 1.0, 1e-2);
  EXPECT_LT(similarity(pointNNDescriptor(randomPoints(200, 7), options)), 0.999);
}

TEST(PointNN, NeedsTwoPlaces)
{
  EXPECT_TRUE(std::isnan(pointNNDescriptor({})[0]));
  EXPECT_TRUE(std::isnan(pointNNDescriptor(Points(30, {1, 2, 3}))[0]));
  for (const float value : pointNNDescriptor({{0, 0, 0}, {1, 0, 0}}))
    EXPECT_TRUE(std::isfinite(value));
}

TEST(PointNN, RefusesWrongOptions)
{
  const auto refused = [](auto change) {
    PointNNOptions options;
    change(options);
    EXPECT_THROW(pointNNDescriptor(randomPoints(20, 1), options), BadArgumentException);
  };
  refused([](auto& o) { o.point_count = 15; });
  refused([](auto& o) { o.stage_count = 0; });
  refused([](auto& o) { o.stage_count = 9; });
  refused([](auto& o) { o.embedding_size = 70; });
  refused([](auto& o) { o.embedding_size = 0; });
  refused([](auto& o) { o.neighbor_count = 0; });
  refused([](auto& o) { o.wavelength_base = 1.0; });
  refused([](auto& o) { o.magnitude = NAN; });
}

TEST(PointNN, ScoresAreSumsOverTheMemory)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const PointNNMemory memory{{{1, 0}, {0, 2}, {3, 3}, {nan, nan}}, {0, 2, 0, 1}};
  const double half = std::sqrt(0.5);
  const double a = std::exp(-10.0 * (1 - 1)) + std::exp(-10.0 * (1 - half));
  const double c = std::exp(-10.0);
  const auto scores = pointNNScores({5, 0}, memory, 3, 10.0);
  ASSERT_EQ(scores.size(), 3u);
  EXPECT_NEAR(scores[0], a / (a + c), 1e-6);
  EXPECT_EQ(scores[1], 0.0f);
  EXPECT_NEAR(scores[2], c / (a + c), 1e-6);
  EXPECT_EQ(pointNNScores({1, 2}, memory, 3, 1e9), (std::vector<float>{1, 0, 0}));
  EXPECT_TRUE(pointNNScores({nan, 0}, memory, 3, 10.0).empty());
  EXPECT_TRUE(pointNNScores({1, 0}, {}, 3, 10.0).empty());
  EXPECT_THROW(pointNNScores({1, 0}, memory, 2, 10.0), BadArgumentException);
  EXPECT_THROW(pointNNScores({1}, memory, 3, 10.0), BadArgumentException);
  EXPECT_THROW(pointNNScores({1, 0}, {{{1, 0}}, {}}, 3, 10.0), BadArgumentException);
  EXPECT_THROW(pointNNScores({1, 0}, {{{1, 0}}, {-1}}, 3, 10.0), BadArgumentException);
}

} // namespace
} // namespace pcl::indoor
