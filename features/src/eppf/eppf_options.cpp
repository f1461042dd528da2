/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/eppf_options.h>

#include <algorithm>
#include <cmath>
#include <sstream>
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
  const auto& harmonics = bins.harmonics;
  if (std::min(harmonics.shells, harmonics.distances) < 0 ||
      std::max(harmonics.shells, harmonics.distances) > 64)
    problem
        << "The numbers of shells and of distances from the middle must be in 0 ... "
           "64, not "
        << harmonics.shells << " and " << harmonics.distances;
  else if (harmonics.degree < 0 || harmonics.degree > 8)
    problem << "The degree of harmonics must be in 0 ... 8, not " << harmonics.degree;
  else if (options.pair_count < 1 || options.pair_count > 0xFFFFFFFFu)
    problem << "The number of pairs must be in 1 ... 2^32 - 1, not "
            << options.pair_count;
  else if (!(options.scale >= 0.0) || !std::isfinite(options.scale))
    problem << "The scale must be 0 (automatic) or a positive length, not "
            << options.scale << " m";
  else if (!(options.weighting_constant > 1.0) ||
           !std::isfinite(options.weighting_constant))
    problem << "The weighting constant must be above 1, not "
            << options.weighting_constant;
  else if (options.surface_angle_rule == SurfaceAngleRule::Joint &&
           jointLevels(bins) == 0)
    problem
        << "The number of surface angle bins must be one of 1, 3, 6, 10, 15, ... for "
           "the joint rule, not "
        << bins.surface_angle;
  else if (options.grid_size != 0 && (options.grid_size < 2 || options.grid_size > 64))
    problem << "The grid size must be 0 (automatic) or in 2 ... 64 voxels, not "
            << options.grid_size;
  return problem.str();
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
