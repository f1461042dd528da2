/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Changes of a cloud that results must survive: docs/method/robustness.md says how
// well.
#pragma once

#include "support/labelled_points.h"

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace pcl::indoor {
namespace test {

/** A number between two, in steps of a thousandth of their difference. */
inline float
drawn(float low, float high, std::mt19937& rng)
{
  return low + (high - low) * static_cast<float>(rng() % 1001) / 1000;
}

/** Values in an order, which may leave some out and take others several times. */
template <typename Values>
Values
inOrder(const Values& values, const std::vector<std::size_t>& order)
{
  Values result;
  for (const auto i : order)
    result.push_back(values[i]);
  return result;
}

/** Values in a changed order, brought back; of several for one place, the last. */
template <typename Values>
Values
backFrom(const Values& values, const std::vector<std::size_t>& order, std::size_t count)
{
  Values result(count);
  for (std::size_t k = 0; k < order.size(); ++k)
    result[order[k]] = values[k];
  return result;
}

/** All numbers below count, and every third of them once more at the end. */
inline std::vector<std::size_t>
withCopies(std::size_t count)
{
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < count; ++i)
    order.push_back(i);
  for (std::size_t i = 0; i < count; i += 3)
    order.push_back(i);
  return order;
}

/** All numbers below count that are drawn with a share of two thirds, ascending. */
inline std::vector<std::size_t>
randomSubset(std::size_t count, std::mt19937& rng)
{
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < count; ++i)
    if (rng() % 3 > 0)
      order.push_back(i);
  return order;
}

/** Points with some among them that are not finite.
 * \param[out] places where each of the points is among them
 */
inline std::vector<Eigen::Vector3f>
withBadPoints(const std::vector<Eigen::Vector3f>& points,
              std::mt19937& rng,
              std::vector<std::size_t>& places)
{
  constexpr float bad[] = {std::numeric_limits<float>::quiet_NaN(),
                           std::numeric_limits<float>::infinity(),
                           -std::numeric_limits<float>::infinity()};
  std::vector<Eigen::Vector3f> result;
  places.clear();
  for (const auto& point : points) {
    if (result.empty() || rng() % 4 == 0) {
      result.push_back(point);
      result.back()[static_cast<int>(rng() % 3)] = bad[rng() % 3];
    }
    places.push_back(result.size());
    result.push_back(point);
  }
  return result;
}

/** Points that are not finite must get the label 0 and change no other label.
 * \param[in] labels_of called with points, gives a label for each
 */
template <typename LabelsOf>
void
expectBadPointsToChangeNoLabel(const std::vector<Eigen::Vector3f>& points,
                               unsigned seed,
                               const LabelsOf& labels_of)
{
  std::mt19937 rng(seed);
  std::vector<std::size_t> places;
  const auto labels = labels_of(withBadPoints(points, rng, places));
  auto expected = labels;
  std::fill(expected.begin(), expected.end(), 0);
  const auto alone = labels_of(points);
  for (std::size_t i = 0; i < places.size(); ++i)
    expected[places[i]] = alone[i];
  EXPECT_EQ(labels, expected) << seed;
}

/** Points on a raster of 1 / 256 m, which floats hold exactly up to 65 km. */
inline std::vector<Eigen::Vector3f>
onRaster(std::vector<Eigen::Vector3f> points)
{
  for (auto& point : points)
    point = (256 * point.array()).round() / 256;
  return points;
}

inline std::vector<Eigen::Vector3f>
shifted(std::vector<Eigen::Vector3f> points, const Eigen::Vector3f& by)
{
  for (auto& point : points)
    point += by;
  return points;
}

/** UTM coordinates as floats have them, in steps of 1 / 16 m in x and 1 / 2 m in y, and
 * the same points near the origin: the difference of two such floats is exact. */
struct UtmPoints {
  Eigen::Vector3f offset = {691234, 5334567, 512};
  std::vector<Eigen::Vector3f> far, near;

  explicit UtmPoints(const std::vector<Eigen::Vector3f>& points)
  {
    for (const auto& point : points) {
      far.push_back(point + offset);
      near.push_back(far.back() - offset);
    }
  }
};

} // namespace test
} // namespace pcl::indoor
