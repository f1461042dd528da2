/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/coordinate_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace pcl::indoor::tool;

namespace {

/** So many values within an extent. */
std::vector<double>
anyValues(std::size_t count, double extent, unsigned seed)
{
  std::mt19937 rng(seed);
  std::vector<double> values(count);
  for (auto& value : values)
    value = extent * static_cast<double>(rng()) / 4294967296.0;
  return values;
}

std::vector<double>
inSteps(std::vector<double> values, double step, double offset)
{
  for (auto& value : values)
    value = std::round(value / step) * step + offset;
  return values;
}

} // namespace

TEST(CoordinateStep, IsThatOfTheValuesWhereverTheyLie)
{
  unsigned seed = 0;
  for (const double step : {0.5, 0.0625, 0.1, 0.01, 0.001})
    for (const double offset : {0.0, 691234.567, 5334567.25})
      for (const double extent : {8.0, 60.0, 700.0}) {
        const auto values = inSteps(anyValues(20000, extent, ++seed), step, offset);
        if (step > 1e-5 * extent) { // else it could not be told from rounding
          EXPECT_NEAR(commonStep(values), step, 1e-3 * step)
              << step << " " << offset << " " << extent;
        }
      }
}

TEST(CoordinateStep, OfDoublesThatWereFloatsIsThatOfFloats)
{
  auto values = anyValues(20000, 12.0, 1);
  for (auto& value : values)
    value = static_cast<double>(static_cast<float>(value + 5334567.25));
  EXPECT_DOUBLE_EQ(commonStep(values), 0.5);
  for (auto& value : values)
    value -= 5334560.123; // also after they were moved
  EXPECT_NEAR(commonStep(values), 0.5, 1e-6);
}

TEST(CoordinateStep, AFarValueDoesNotHideIt)
{
  for (unsigned seed = 1; seed <= 50; ++seed) {
    auto values = inSteps(anyValues(20000, 3.0, seed), 0.125, 0.0);
    for (std::size_t i = 0; i < values.size(); i += 9)
      values[i] = -10000.0; // where nothing was measured
    EXPECT_DOUBLE_EQ(commonStep(values), 0.125) << seed;
    auto any = anyValues(20000, 3.0, seed);
    for (std::size_t i = 0; i < any.size(); i += 9)
      any[i] = -10000.0;
    EXPECT_EQ(commonStep(any), 0.0) << seed;
  }
}

TEST(CoordinateStep, ThereIsNoneBetweenAnyValues)
{
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const auto values = anyValues(seed * 100, 10.0, seed);
    EXPECT_EQ(commonStep(values), 0.0) << seed;
  }
}

TEST(CoordinateStep, PlanesShowNone)
{
  std::vector<double> values;
  for (int i = 0; i < 10000; ++i)
    values.push_back(i % 2 == 0 ? 0.0 : 2.5);
  EXPECT_EQ(commonStep(values), 0.0);
  EXPECT_EQ(commonStep(std::vector<double>(1000, 3.0)), 0.0);
}

TEST(CoordinateStep, IsThatOfAPatternInItsOrder)
{
  for (int row = 3; row < 40; ++row) {
    std::vector<double> values;
    for (int i = 0; i < 400; ++i)
      values.push_back(i % (row + 1));
    EXPECT_DOUBLE_EQ(commonStep(values), 1.0) << row;
  }
}

TEST(CoordinateStep, FewOtherValuesDoNotMatter)
{
  auto values = inSteps(anyValues(20000, 12.0, 3), 0.5, 5334567.0);
  for (std::size_t i = 0; i < values.size(); i += 200)
    values[i] = i % 400 == 0 ? 0.0 : i % 600 == 0 ? NAN : 5334567.0 + 1e-4 * double(i);
  EXPECT_DOUBLE_EQ(commonStep(values), 0.5);
}

TEST(CoordinateStep, FewValuesTellNone)
{
  EXPECT_EQ(commonStep({}), 0.0);
  EXPECT_EQ(commonStep({1.0, 2.0}), 0.0);
  EXPECT_EQ(commonStep(std::vector<double>(1000, NAN)), 0.0);
  EXPECT_EQ(commonStep(inSteps(anyValues(100, 12.0, 3), 0.5, 0.0)), 0.0);
}

TEST(CoordinateStep, DoesNotDependOnTheOrder)
{
  auto values = inSteps(anyValues(5000, 12.0, 3), 0.01, 691234.0);
  const double step = commonStep(values);
  std::sort(values.begin(), values.end());
  EXPECT_NEAR(commonStep(values), step, 1e-6);
}
