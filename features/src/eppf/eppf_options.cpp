/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/eppf_options.h>

#include "eppf/pair_options.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace pcl::indoor {

EPPFOptions
thesisEPPFOptions()
{
  return {};
}

EPPFOptions
shortEPPFOptions()
{
  EPPFOptions options;
  options.bins = {15, 3, 4, 3, {}};
  return options;
}

EPPFOptions
pairHarmonicsOptions()
{
  EPPFOptions options;
  options.bins = {8, 15, 5, 1, {3, 6, 12}};
  options.surface_angle_rule = SurfaceAngleRule::Joint;
  options.normal_angle_rule = NormalAngleRule::AroundLine;
  options.normal_sides = NormalSides::MostlyOutward;
  options.weighting = false;
  options.sampling = PairSampling::Stratified;
  options.denoising = true;
  options.grid_size = 0;
  return options;
}

int
automaticGridSize(std::size_t point_count)
{
  const double edge = std::sqrt(static_cast<double>(point_count) / 4.0);
  return static_cast<int>(std::lround(std::clamp(edge, 8.0, 64.0)));
}

std::string
findProblem(const EPPFOptions& options)
{
  OptionCheck check;
  const auto& bins = options.bins;
  const auto in = [](int low, int value, int high) {
    return low <= value && value <= high;
  };
  const std::pair<const char*, int> counts[] = {
      {"number of distance bins must be in 1 ... 64", bins.distance},
      {"number of surface angle bins must be in 1 ... 64", bins.surface_angle},
      {"number of normal angle bins must be in 1 ... 64", bins.normal_angle},
      {"number of occupancy bins must be in 1 ... 64", bins.occupancy}};
  for (const auto& [rule, count] : counts)
    check.require(in(1, count, 64), rule, count);
  const auto& harmonics = bins.harmonics;
  check.require(
      in(0, harmonics.shells, 64) && in(0, harmonics.distances, 64),
      "numbers of shells and of distances from the middle must be in 0 ... 64",
      std::to_string(harmonics.shells) + " and " + std::to_string(harmonics.distances));
  check.require(in(0, harmonics.degree, 8),
                "degree of harmonics must be in 0 ... 8",
                harmonics.degree);
  checkPairOptions(check, options.pair_count, options.scale);
  check.require(options.weighting_constant > 1.0 &&
                    std::isfinite(options.weighting_constant),
                "weighting constant must be above 1",
                options.weighting_constant);
  check.require(options.surface_angle_rule != SurfaceAngleRule::Joint ||
                    jointLevels(bins) > 0,
                "number of surface angle bins must be one of 1, 3, 6, 10, 15, ... for "
                "the joint rule",
                bins.surface_angle);
  check.require(options.grid_size == 0 || in(2, options.grid_size, 64),
                "grid size must be 0 (automatic) or in 2 ... 64 voxels",
                options.grid_size);
  return check.problem();
}

int
jointLevels(const EPPFBins& bins)
{
  for (int levels = 1; levels * (levels + 1) / 2 <= bins.surface_angle; ++levels)
    if (levels * (levels + 1) / 2 == bins.surface_angle)
      return levels;
  return 0;
}

} // namespace pcl::indoor
