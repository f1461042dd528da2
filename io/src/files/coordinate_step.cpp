/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/coordinate_step.h"

#include <pcl/indoor/quantile.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>

namespace pcl::indoor::tool {
namespace {

constexpr std::size_t group_size = 32; // 31 random multiples: their divisor is the step
constexpr std::size_t most_groups = 64;
constexpr std::size_t least_groups = 8; // that count, for a median to mean something
constexpr std::size_t least_different = 4;

/** The greatest common divisor of two positive numbers; \a least if it is not above
 * that. A rest of up to 1 % is taken for rounding: decimal steps are no doubles. */
double
commonDivisor(double a, double b, double least)
{
  if (a < b)
    std::swap(a, b);
  const double whole = a;
  do {
    const double rest = std::fmod(a, b);
    a = b;
    b = std::min(rest, a - rest);
  } while (b > 0.01 * a && a > least);
  // the rests have added up what was rounded, so it is taken from the whole
  return a > least ? whole / std::round(whole / a) : least;
}

/** Groups of values, drawn: those at equal distances could miss steps of a pattern. */
std::vector<std::vector<double>>
groupsOf(const std::vector<double>& values)
{
  std::mt19937 rng(1);
  std::vector<std::vector<double>> groups(
      std::min(values.size() / group_size, most_groups));
  for (auto& group : groups)
    for (std::size_t k = 0; k < group_size; ++k) {
      const double value = values[rng() % values.size()];
      if (std::isfinite(value))
        group.push_back(value);
    }
  return groups;
}

/** The step of a group; 0 if it has too few different values. */
double
stepOf(std::vector<double> group, double least)
{
  std::sort(group.begin(), group.end());
  group.erase(std::unique(group.begin(), group.end()), group.end());
  if (group.size() < least_different)
    return 0.0;
  const double rounding = 4.0 * std::numeric_limits<double>::epsilon() *
                          std::max(std::abs(group.front()), std::abs(group.back()));
  double step = 0.0;
  for (std::size_t k = 1; k < group.size(); ++k) {
    const double gap = group[k] - group[k - 1];
    if (gap > rounding) // else both are the same step
      step = step > 0.0 ? commonDivisor(gap, step, least) : gap;
  }
  return step;
}

} // namespace

double
commonStep(const std::vector<double>& values)
{
  const auto groups = groupsOf(values);
  std::vector<double> all;
  for (const auto& group : groups)
    all.insert(all.end(), group.begin(), group.end());
  if (all.empty())
    return 0.0;
  const double extent = quantile(all, 0.75) - quantile(all, 0.25);
  const double least = 1e-5 * extent; // below, what doubles round could be taken for it
  std::vector<double> steps;
  for (const auto& group : groups)
    if (const double step = stepOf(group, least); step > 0.0)
      steps.push_back(step);
  if (steps.size() < least_groups)
    return 0.0;
  const double step = median(steps);
  return step > least ? step : 0.0;
}

} // namespace pcl::indoor::tool
