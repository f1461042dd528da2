/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/graph/surface_graph.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace {

constexpr float degrees = 180.0f / static_cast<float>(M_PI);
constexpr float convex_limit_degrees = 20;  // convex bends count no more than this
constexpr float concave_limit_degrees = 60; // nor concave ones more than this
constexpr float singular_share = 0.4f; // of a bend that counts where none is defined

/** LCCP's sanity criterion: the planes of the two patches do not meet between them but
 * beside them, so that the edge is neither convex nor concave. */
bool
isSingular(const Eigen::Vector3f& towards_1,
           const Eigen::Vector3f& normal_1,
           const Eigen::Vector3f& normal_2,
           float normal_angle)
{
  const float angle = pcl::indoor::angleDegrees(normal_1.cross(normal_2), towards_1);
  const float threshold = 60 / (1 + std::exp(-0.25f * (normal_angle - 25)));
  return std::min(angle, 180 - angle) < threshold;
}

} // namespace

namespace pcl::indoor {

float
angleDegrees(const Eigen::Vector3f& a, const Eigen::Vector3f& b)
{
  const float norms = a.norm() * b.norm();
  if (!(norms > 0))
    return 0;
  return std::acos(std::max(-1.0f, std::min(1.0f, a.dot(b) / norms))) * degrees;
}

float
bendDegrees(const Eigen::Vector3f& position_1,
            const Eigen::Vector3f& normal_1,
            const Eigen::Vector3f& position_2,
            const Eigen::Vector3f& normal_2)
{
  const Eigen::Vector3f towards_1 = position_1 - position_2;
  const float angle = angleDegrees(normal_1, normal_2);
  const float concave = std::min(angle, concave_limit_degrees);
  const bool is_convex = towards_1.dot(normal_1) >= towards_1.dot(normal_2);
  const float bend = is_convex ? -std::min(angle, convex_limit_degrees) : concave;
  if (isSingular(towards_1, normal_1, normal_2, angle))
    return std::max(bend, singular_share * concave);
  return bend;
}

std::vector<Border>
bendBorders(const Supervoxels& supervoxels, const std::vector<SurfaceEdge>& edges)
{
  std::vector<Border> borders;
  borders.reserve(edges.size());
  for (const auto& edge : edges) {
    const float bend = bendDegrees(supervoxels.centroids[edge.source],
                                   supervoxels.normals[edge.source],
                                   supervoxels.centroids[edge.target],
                                   supervoxels.normals[edge.target]);
    borders.push_back(
        {edge.source, edge.target, bend, static_cast<double>(edge.contacts)});
  }
  return borders;
}

std::vector<SurfaceEdge>
surfaceEdges(const SurfaceVoxels& voxels, const Supervoxels& supervoxels)
{
  const auto& label = supervoxels.label_of_voxel;
  std::vector<std::uint64_t> pairs;
  for (std::size_t v = 0; v < label.size(); ++v) {
    if (label[v] == Supervoxels::none)
      continue;
    for (const auto neighbor : voxels.neighbors.of(v)) {
      const auto other = label[neighbor];
      if (other != Supervoxels::none && label[v] < other) {
        const auto pair = (static_cast<std::uint64_t>(label[v]) << 32) | other;
        pairs.push_back(pair);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<SurfaceEdge> edges;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (i > 0 && pairs[i] == pairs[i - 1]) {
      ++edges.back().contacts;
      continue;
    }
    SurfaceEdge edge;
    edge.source = static_cast<std::uint32_t>(pairs[i] >> 32);
    edge.target = static_cast<std::uint32_t>(pairs[i]);
    edge.contacts = 1;
    edges.push_back(edge);
  }
  return edges;
}

} // namespace pcl::indoor
