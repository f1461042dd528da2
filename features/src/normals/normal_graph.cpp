/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/normal_graph.h>

#include "internal/point_bounds.h"

#include <pcl/exceptions.h>
#include <pcl/features/sign_graph.h>

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

float
sideAgreement(const Eigen::Vector3f& position_1,
              const Eigen::Vector3f& normal_1,
              const Eigen::Vector3f& position_2,
              const Eigen::Vector3f& normal_2)
{
  const Eigen::Vector3f step = position_2 - position_1;
  const float squared = step.squaredNorm();
  if (!(squared > 0))
    return 0;
  const float along_1 = normal_1.dot(step), along_2 = normal_2.dot(step);
  // (n1 - 2 (n1.e) e) . n2, with the unit step e
  const float agreement = normal_1.dot(normal_2) - 2 * along_1 * along_2 / squared;
  const float steepness = std::max(along_1 * along_1, along_2 * along_2) / squared;
  const float weight = agreement * (1 - steepness);
  return std::isfinite(weight) ? weight : 0;
}

namespace {

/** List each pair of neighbours once, with the agreement of their normals. */
std::vector<SignEdge>
normalGraph(const std::vector<Eigen::Vector3f>& positions,
            const Adjacency& neighbors,
            const std::vector<Eigen::Vector3f>& normals)
{
  std::vector<SignEdge> edges;
  edges.reserve(neighbors.targets.size() / 2);
  for (std::uint32_t i = 0; i < positions.size(); ++i)
    for (const auto other : neighbors.of(i)) {
      if (i < other)
        edges.push_back(
            {i,
             other,
             sideAgreement(
                 positions[i], normals[i], positions[other], normals[other])});
    }
  return edges;
}

} // namespace

void
orientConsistently(const std::vector<Eigen::Vector3f>& positions,
                   const Adjacency& neighbors,
                   const std::vector<Eigen::Vector3f>& viewpoint,
                   std::vector<Eigen::Vector3f>& normals)
{
  if (normals.size() != positions.size() ||
      neighbors.offsets.size() != positions.size() + 1)
    PCL_THROW_EXCEPTION(BadArgumentException,
                        positions.size()
                            << " positions have " << normals.size() << " normals.");
  if (positions.empty())
    return;
  const Eigen::Vector3f target =
      viewpoint.empty() ? centroidOf(positions) : viewpoint.front();
  std::vector<std::uint32_t> component;
  const auto signs = findSigns(
      positions.size(), normalGraph(positions, neighbors, normals), &component);
  std::vector<double> facing(
      *std::max_element(component.begin(), component.end()) + std::size_t{1}, 0.0);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    normals[i] *= signs[i];
    const float cosine = normals[i].dot((target - positions[i]).normalized());
    if (std::isfinite(cosine))
      facing[component[i]] += cosine;
  }
  for (std::size_t i = 0; i < normals.size(); ++i)
    if (facing[component[i]] < 0)
      normals[i] *= -1;
}

} // namespace pcl::indoor
