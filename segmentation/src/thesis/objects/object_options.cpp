/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/first_problem.h"

#include <pcl/segmentation/thesis.h>

namespace pcl {
namespace indoor {

std::string
thesis::findProblem(const ObjectOptions& options)
{
  FirstProblem problem(indoor::findProblem(options.shared));
  const auto& [shared, edges, on_points] = options;
  problem.require(edges.concavity_weight >= 0 && edges.concavity_weight <= 1,
                  "concavity weight must be in [0, 1]",
                  edges.concavity_weight);
  problem.require(edges.concavity_tolerance_degrees >= 0 &&
                      edges.concavity_tolerance_degrees <= 180,
                  "concavity tolerance must be in [0, 180]",
                  edges.concavity_tolerance_degrees,
                  " degrees");
  problem.require(problem.isSize(edges.graph_scale),
                  "graph scale must not be negative",
                  edges.graph_scale);
  if (!on_points)
    return problem.text();
  problem.require(problem.isSize(on_points->removal_radius),
                  "radius of the removal must not be negative",
                  on_points->removal_radius,
                  " m");
  problem.require(on_points->ransac_share >= 0 && on_points->ransac_share <= 1,
                  "share of a plane must be in [0, 1]",
                  on_points->ransac_share);
  problem.require(problem.isWeight(on_points->color_weight),
                  "color importance must be in [0, 1e6]",
                  on_points->color_weight);
  problem.require(problem.isWeight(on_points->fpfh_weight),
                  "importance of FPFH must be in [0, 1e6]",
                  on_points->fpfh_weight);
  return problem.text();
}

thesis::ObjectOptions
thesisOptions()
{
  thesis::ObjectOptions options;
  options.shared.voxel_size = 0.03;
  options.shared.seed_size = 0.12;
  options.shared.min_segment_size = 3;
  options.on_points.emplace();
  options.on_points->removal_radius = 0.05; // Sec. 2.1.5.2, points 2 cm apart
  options.on_points->ransac_share = 0.05;
  return options;
}

thesis::ObjectOptions
thesisKinectOptions()
{
  auto options = thesisOptions();
  options.on_points.emplace();
  options.shared.curvature_threshold = 0.02f;
  options.edges.graph_scale = 5;
  options.shared.seed_size = 0.16;
  options.shared.voxel_size = 0.04;
  return options;
}

} // namespace indoor
} // namespace pcl
