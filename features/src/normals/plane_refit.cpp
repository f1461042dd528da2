/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "normals/plane_refit.h"

#include "internal/point_moments.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace {

constexpr int rounds = 2;
constexpr std::size_t fewest_points = 6;
constexpr std::size_t core_parts = 3;    // one part of the neighbours tells the noise
constexpr float sigmas_of_core = 0.861f; // third of a normal distribution: +-0.43 sigma
constexpr float inlier_sigmas = 2.0f;

/** Do the eigenvalues, ascending, belong to a surface? A line has two small ones. */
bool
spanPlane(const Eigen::Vector3d& eigenvalues)
{
  return eigenvalues[1] > 1e-6 * eigenvalues[2] && eigenvalues[2] > 0;
}

/** The shortest interval of heights that holds 0 and \a core sorted heights. */
std::pair<float, float>
coreInterval(const std::vector<float>& heights, std::size_t core)
{
  const auto zero = static_cast<std::size_t>(
      std::lower_bound(heights.begin(), heights.end(), 0.0f) - heights.begin());
  std::pair<float, float> best(heights.front(), heights.back());
  for (std::size_t begin = zero > core ? zero - core : 0;
       begin <= zero && begin + core < heights.size();
       ++begin) {
    const float low = std::min(heights[begin], 0.0f);
    const float high = std::max(heights[begin + core], 0.0f);
    if (high - low < best.second - best.first)
      best = {low, high};
  }
  return best;
}

} // namespace

namespace pcl::indoor {

Eigen::Vector3f
refitPlane(const std::vector<Eigen::Vector3f>& neighbors,
           const Eigen::Vector3f& normal,
           float largest_turn,
           std::vector<float>& heights)
{
  Eigen::Vector3f fitted = normal;
  for (int round = 0; round < rounds; ++round) {
    heights.clear();
    for (const auto& neighbor : neighbors)
      heights.push_back(fitted.dot(neighbor));
    std::sort(heights.begin(), heights.end());
    const auto core = coreInterval(heights, neighbors.size() / core_parts);
    const float middle = (core.first + core.second) / 2;
    const float sigma = (core.second - core.first) / sigmas_of_core;
    PointMoments inliers;
    for (const auto& neighbor : neighbors)
      if (std::abs(fitted.dot(neighbor) - middle) <= inlier_sigmas * sigma)
        inliers.add(neighbor);
    if (inliers.count < fewest_points)
      return fitted;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(inliers.covariance());
    if (!spanPlane(solver.eigenvalues()))
      return fitted;
    Eigen::Vector3f next = solver.eigenvectors().col(0).cast<float>().normalized();
    if (next.dot(normal) < 0)
      next *= -1;
    if (!(next.dot(normal) >= std::cos(largest_turn)))
      return fitted;
    fitted = next;
  }
  return fitted;
}

bool
surfaceVariation(const std::vector<Eigen::Vector3f>& positions, float& variation)
{
  PointMoments moments;
  for (const auto& position : positions)
    moments.add(position);
  variation = 0;
  if (moments.count < 3)
    return false;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(moments.covariance(), Eigen::EigenvaluesOnly);
  const Eigen::Vector3d values = solver.eigenvalues().cwiseMax(0);
  if (!spanPlane(values))
    return false;
  variation = static_cast<float>(values[0] / values.sum());
  return true;
}

} // namespace pcl::indoor
