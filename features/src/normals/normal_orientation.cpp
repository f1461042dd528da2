/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/normal_orientation.h>

#include "internal/point_bounds.h"
#include "normals/free_viewpoints.h"

#include <pcl/exceptions.h>
#include <pcl/features/normal_graph.h>
#include <pcl/indoor/flood_fill.h>
#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/quantile.h>
#include <pcl/indoor/threads.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace {

using pcl::indoor::Adjacency;
using pcl::indoor::FreeSpaceGrid;
using pcl::indoor::FreeSpaceOptions;

constexpr int spreading_rounds = 4;
constexpr float smooth_cosine =
    0.8f; // normals of one surface differ by less than 37 deg

void
requireLegal(const FreeSpaceOptions& options)
{
  if (!(options.cell_size > 0) || !std::isfinite(options.cell_size))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "The cell size must be positive, not " << options.cell_size
                                                               << " m.");
  if (options.viewpoints < 1 || options.sample_stride < 1)
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "Free space needs at least one viewpoint and stride, not "
                            << options.viewpoints << " and " << options.sample_stride
                            << ".");
}

/** Finds the viewpoints nearest to positions, which are taken block by block. */
class NearestViewpoints {
public:
  using Ranked = std::pair<float, std::uint32_t>; // squared distance, number

  NearestViewpoints(const std::vector<Eigen::Vector3f>& viewpoints, std::size_t count)
  : viewpoints_(viewpoints)
  , count_(std::min(count, viewpoints.size()))
  {}

  /** \brief Prepare for positions in a box: only viewpoints that are among the nearest
   * of some place in it are looked at from then on. */
  void
  enterBlock(const Eigen::AlignedBox3f& box)
  {
    ranked_.clear();
    for (std::uint32_t i = 0; i < viewpoints_.size(); ++i) {
      const Eigen::Array3f to_low = (viewpoints_[i] - box.min()).array().abs();
      const Eigen::Array3f to_high = (viewpoints_[i] - box.max()).array().abs();
      ranked_.emplace_back(to_low.max(to_high).square().sum(), i);
    }
    const float farthest =
        pcl::indoor::valueAtRank(ranked_, count_ - 1).first * 1.0001f;
    candidates_.clear();
    for (std::uint32_t i = 0; i < viewpoints_.size(); ++i)
      if (box.squaredExteriorDistance(viewpoints_[i]) <= farthest)
        candidates_.push_back(i);
  }

  /** \return nearest first, ties by number */
  const std::vector<Ranked>&
  nearestTo(const Eigen::Vector3f& position)
  {
    ranked_.clear();
    for (const auto i : candidates_)
      ranked_.emplace_back((viewpoints_[i] - position).squaredNorm(), i);
    std::partial_sort(ranked_.begin(),
                      ranked_.begin() + static_cast<std::ptrdiff_t>(count_),
                      ranked_.end());
    ranked_.resize(count_);
    return ranked_;
  }

private:
  const std::vector<Eigen::Vector3f>& viewpoints_;
  std::size_t count_;
  std::vector<Ranked> ranked_;
  std::vector<std::uint32_t> candidates_;
};

/** Votes of the viewpoints on the sides of the normals; positive: keep the normal. */
std::vector<float>
collectVotes(const std::vector<Eigen::Vector3f>& positions,
             const std::vector<Eigen::Vector3f>& normals,
             const std::vector<Eigen::Vector3f>& viewpoints,
             const FreeSpaceGrid& grid,
             const FreeSpaceOptions& options)
{
  constexpr double least_block_size = 2, most_blocks = 1e6; // metres; along an axis
  std::vector<float> votes(positions.size(), 0.0f);
  std::vector<Eigen::Vector3f> sampled;
  for (std::size_t i = 0; i < positions.size(); i += options.sample_stride)
    sampled.push_back(positions[i]);
  const double extent = pcl::indoor::boundsOf(sampled).sizes().maxCoeff();
  const auto blocks = pcl::indoor::groupByCell(
      sampled, std::max(least_block_size, extent / most_blocks));
  pcl::indoor::parallelFor(
      static_cast<std::ptrdiff_t>(blocks.size()),
      pcl::indoor::threadCount(options.threads),
      1,
      [&] { return NearestViewpoints(viewpoints, options.viewpoints); },
      [&](NearestViewpoints& nearest, std::ptrdiff_t b) {
        Eigen::AlignedBox3f box;
        for (const auto point : blocks.pointsOf(b))
          box.extend(sampled[point]);
        nearest.enterBlock(box);
        for (const auto point : blocks.pointsOf(b)) {
          const auto i = point * options.sample_stride;
          for (const auto& entry : nearest.nearestTo(positions[i])) {
            const auto& viewpoint = viewpoints[entry.second];
            const float cosine =
                (viewpoint - positions[i]).normalized().dot(normals[i]);
            if (std::abs(cosine) > 0.1f && grid.sees(viewpoint, positions[i]))
              votes[i] += cosine;
          }
        }
      });
  return votes;
}

/** Let each position hear its neighbours on the same smooth surface. */
std::vector<float>
spreadVotes(const std::vector<Eigen::Vector3f>& normals,
            const Adjacency& neighbors,
            const std::vector<float>& votes,
            unsigned threads)
{
  std::vector<float> sums(votes.size());
  const auto count = static_cast<std::ptrdiff_t>(votes.size());
#pragma omp parallel for num_threads(pcl::indoor::threadCount(threads))
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    float sum = votes[i];
    for (const auto other : neighbors.of(i)) {
      const float cosine = normals[i].dot(normals[other]);
      if (std::abs(cosine) > smooth_cosine)
        sum += cosine * votes[other];
    }
    sums[i] = sum;
  }
  return sums;
}

/** Positions without vote follow a decided neighbour, outwards from the decided ones.
 */
void
followNeighbors(const Adjacency& neighbors,
                std::vector<float>& votes,
                std::vector<Eigen::Vector3f>& normals)
{
  std::vector<std::uint32_t> decided;
  for (std::uint32_t i = 0; i < votes.size(); ++i)
    if (votes[i] != 0)
      decided.push_back(i);
  pcl::indoor::floodFill(decided, neighbors, [&](auto other, auto from) {
    if (votes[other] != 0)
      return false;
    votes[other] = 1;
    if (normals[from].dot(normals[other]) < 0)
      normals[other] *= -1;
    return true;
  });
}

} // namespace

namespace pcl::indoor {

void
orientTowards(const Eigen::Vector3f& viewpoint,
              const std::vector<Eigen::Vector3f>& positions,
              std::vector<Eigen::Vector3f>& normals)
{
  for (std::size_t i = 0; i < normals.size(); ++i)
    if (normals[i].dot(viewpoint - positions[i]) < 0)
      normals[i] *= -1;
}

void
orientTowardsFreeSpace(const std::vector<Eigen::Vector3f>& positions,
                       const Adjacency& neighbors,
                       const FreeSpaceOptions& options,
                       std::vector<Eigen::Vector3f>& normals)
{
  requireLegal(options);
  if (normals.size() != positions.size() ||
      neighbors.offsets.size() != positions.size() + 1)
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        positions.size()
                            << " positions have " << normals.size() << " normals.");
  if (positions.empty())
    return;
  const FreeSpaceGrid grid(positions, options.cell_size);
  const auto viewpoints = viewpointsIn(grid, options);
  auto votes = collectVotes(positions, normals, viewpoints, grid, options);
  for (int round = 0; round < spreading_rounds; ++round)
    votes = spreadVotes(normals, neighbors, votes, options.threads);
  for (std::size_t i = 0; i < normals.size(); ++i)
    if (votes[i] < 0)
      normals[i] *= -1;
  followNeighbors(neighbors, votes, normals);
}

void
orientNormals(NormalOrientation orientation,
              const std::vector<Eigen::Vector3f>& positions,
              const Adjacency& neighbors,
              const std::vector<Eigen::Vector3f>& viewpoint,
              const FreeSpaceOptions& free_space,
              std::vector<Eigen::Vector3f>& normals)
{
  if (orientation == NormalOrientation::Automatic)
    orientation =
        viewpoint.empty() ? NormalOrientation::FreeSpace : NormalOrientation::Viewpoint;
  if (orientation == NormalOrientation::Viewpoint && viewpoint.empty())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "Normals cannot be turned to a viewpoint that is not known.");
  if (orientation == NormalOrientation::Graph)
    orientConsistently(positions, neighbors, viewpoint, normals);
  else if (orientation == NormalOrientation::FreeSpace)
    orientTowardsFreeSpace(positions, neighbors, free_space, normals);
  else
    orientTowards(viewpoint.front(), positions, normals);
}

} // namespace pcl::indoor
