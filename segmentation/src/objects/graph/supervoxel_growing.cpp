/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/graph/supervoxel_growing.h"

#include "objects/graph/average_columns.h"

#include <pcl/exceptions.h>
#include <pcl/indoor/flood_fill.h>
#include <pcl/indoor/threads.h>

#include <cmath>
#include <limits>
#include <utility>

namespace {

using pcl::indoor::Supervoxels;
using pcl::indoor::SurfaceDistance;
using pcl::indoor::SurfaceVoxels;

constexpr std::uint32_t none = Supervoxels::none;

/** Means of the voxels of each label; which voxels these are is left open. */
Supervoxels
averagePatches(const SurfaceVoxels& voxels,
               const std::vector<std::uint32_t>& labels,
               std::size_t patch_count)
{
  std::vector<Eigen::Vector3d> positions(patch_count, Eigen::Vector3d::Zero());
  std::vector<Eigen::Vector3d> normals(patch_count, Eigen::Vector3d::Zero());
  std::vector<std::uint32_t> counts(patch_count, 0);
  for (std::size_t v = 0; v < labels.size(); ++v) {
    if (labels[v] == none)
      continue;
    positions[labels[v]] += voxels.centroids[v].cast<double>();
    normals[labels[v]] += voxels.normals[v].cast<double>();
    ++counts[labels[v]];
  }
  Supervoxels patches;
  patches.centroids.resize(patch_count);
  patches.normals.resize(patch_count);
  for (std::size_t i = 0; i < patch_count; ++i) {
    const double count = std::max(counts[i], 1u);
    patches.centroids[i] = (positions[i] / count).cast<float>();
    patches.normals[i] = normals[i].norm() > 1e-9
                             ? Eigen::Vector3f(normals[i].normalized().cast<float>())
                             : Eigen::Vector3f::Zero();
  }
  patches.appearance.colors =
      pcl::indoor::averageColumns(voxels.appearance.colors, labels, patch_count);
  patches.appearance.shapes =
      pcl::indoor::averageColumns(voxels.appearance.shapes, labels, patch_count);
  return patches;
}

/** One seed per occupied cell of the seed grid: the voxel nearest to the cell's mean.
 */
std::vector<std::uint32_t>
placeSeeds(const SurfaceVoxels& voxels,
           const std::vector<std::uint8_t>& left_out,
           double grid_scale)
{
  std::vector<std::uint32_t> members;
  std::vector<Eigen::Vector3f> places;
  for (std::uint32_t v = 0; v < voxels.size(); ++v)
    if (!left_out[v]) {
      members.push_back(v);
      places.push_back(pcl::indoor::cellIndex(voxels.cells.keys[v]).cast<float>());
    }
  const auto cells = pcl::indoor::groupByCell(places, grid_scale);
  std::vector<std::uint32_t> seeds;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto in_cell = cells.pointsOf(c);
    Eigen::Vector3f mean = Eigen::Vector3f::Zero();
    for (const auto i : in_cell)
      mean += places[i];
    mean /= static_cast<float>(in_cell.size());
    auto best = *in_cell.begin();
    for (const auto i : in_cell)
      if ((places[i] - mean).squaredNorm() < (places[best] - mean).squaredNorm())
        best = i;
    seeds.push_back(members[best]);
  }
  return seeds;
}

/** The nearest of the patches around a voxel; its own patch wins ties. */
std::uint32_t
nearestPatch(const SurfaceVoxels& voxels,
             const std::vector<std::uint32_t>& labels,
             const Supervoxels& patches,
             const SurfaceDistance& distance,
             std::uint32_t voxel)
{
  std::uint32_t best = none, last = none;
  float nearest = std::numeric_limits<float>::max();
  const auto consider = [&](std::uint32_t label) {
    if (label == none || label == last)
      return;
    last = label;
    const float d =
        distance(voxels.centroids[voxel],
                 voxels.normals[voxel],
                 patches.centroids[label],
                 patches.normals[label]) +
        distance.ofAppearance(voxels.appearance, voxel, patches.appearance, label);
    if (d < nearest || (d == nearest && label < best && best != labels[voxel])) {
      nearest = d;
      best = label;
    }
  };
  consider(labels[voxel]);
  for (const auto other : voxels.neighbors.of(voxel))
    consider(labels[other]);
  return best;
}

/** One round: all voxels choose at once; only those without a patch if asked. */
bool
chooseOnce(const SurfaceVoxels& voxels,
           const std::vector<std::uint8_t>& left_out,
           const Supervoxels& patches,
           const SurfaceDistance& distance,
           bool only_unassigned,
           int threads,
           std::vector<std::uint32_t>& labels)
{
  auto chosen = labels;
  const auto count = static_cast<std::ptrdiff_t>(labels.size());
  bool changed = false;
#pragma omp parallel for schedule(static) num_threads(threads) reduction(|| : changed)
  for (std::ptrdiff_t v = 0; v < count; ++v) {
    if (left_out[v] || (only_unassigned && labels[v] != none))
      continue;
    chosen[v] =
        nearestPatch(voxels, labels, patches, distance, static_cast<std::uint32_t>(v));
    changed = changed || chosen[v] != labels[v];
  }
  labels.swap(chosen);
  return changed;
}

/** Connected parts of equal label, numbered by first voxel; voxels left out get none.
 */
std::vector<std::uint32_t>
connectedParts(const SurfaceVoxels& voxels,
               const std::vector<std::uint8_t>& left_out,
               const std::vector<std::uint32_t>& labels,
               std::vector<std::uint32_t>& part_sizes)
{
  std::vector<std::uint32_t> part(labels.size(), none), members;
  part_sizes.clear();
  for (std::uint32_t first = 0; first < labels.size(); ++first) {
    if (part[first] != none || left_out[first])
      continue;
    const auto number = static_cast<std::uint32_t>(part_sizes.size());
    part[first] = number;
    members.assign(1, first);
    pcl::indoor::floodFill(members, voxels.neighbors, [&](auto other, auto) {
      if (part[other] != none || labels[other] != labels[first] || left_out[other])
        return false;
      part[other] = number;
      return true;
    });
    part_sizes.push_back(static_cast<std::uint32_t>(members.size()));
  }
  return part;
}

/** Take the patch from all but the largest connected part of each. */
void
releaseFragments(const SurfaceVoxels& voxels,
                 const std::vector<std::uint8_t>& left_out,
                 std::size_t patch_count,
                 std::vector<std::uint32_t>& labels)
{
  std::vector<std::uint32_t> sizes;
  const auto part = connectedParts(voxels, left_out, labels, sizes);
  std::vector<std::uint32_t> largest(patch_count, none);
  for (std::size_t v = 0; v < labels.size(); ++v) {
    if (labels[v] == none)
      continue;
    auto& best = largest[labels[v]];
    if (best == none || sizes[part[v]] > sizes[best])
      best = part[v];
  }
  for (std::size_t v = 0; v < labels.size(); ++v)
    if (labels[v] != none && part[v] != largest[labels[v]])
      labels[v] = none;
}

} // namespace

namespace pcl::indoor {

float
SurfaceDistance::ofAppearance(const SurfaceAppearance& one,
                              std::size_t i,
                              const SurfaceAppearance& other,
                              std::size_t j) const
{
  const auto a = static_cast<Eigen::Index>(i), b = static_cast<Eigen::Index>(j);
  float sum = 0;
  if (color_weight > 0 && one.colors.cols() > 0 && other.colors.cols() > 0)
    sum += color_weight * (one.colors.col(a) - other.colors.col(b)).norm() / 100;
  if (shape_weight > 0 && one.shapes.cols() > 0 && other.shapes.cols() > 0)
    sum += shape_weight * (one.shapes.col(a) - other.shapes.col(b)).lpNorm<1>() / 2;
  return sum;
}

Supervoxels
growSupervoxels(const SurfaceVoxels& voxels,
                const std::vector<std::uint8_t>& left_out,
                double grid_scale,
                const SurfaceDistance& distance,
                unsigned threads)
{
  if (!(grid_scale >= 1))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "Seeds must be at least one voxel apart, not " << grid_scale
                                                                       << ".");
  const int workers = threadCount(threads);
  const auto seeds = placeSeeds(voxels, left_out, grid_scale);
  std::vector<std::uint32_t> labels(voxels.size(), none);
  for (std::uint32_t i = 0; i < seeds.size(); ++i)
    labels[seeds[i]] = i;
  // As far as the original: a patch may reach 1.8 times the seed size. What has no end
  // within the voxels is reached in as many rounds as there are voxels.
  const auto rounds = static_cast<std::size_t>(
      std::min(std::ceil(1.8 * grid_scale),
               std::max(1000.0, static_cast<double>(voxels.size()))));
  auto patches = averagePatches(voxels, labels, seeds.size());
  for (std::size_t round = 0; round < rounds; ++round) {
    if (!chooseOnce(voxels, left_out, patches, distance, false, workers, labels))
      break;
    patches = averagePatches(voxels, labels, seeds.size());
  }
  releaseFragments(voxels, left_out, seeds.size(), labels);
  for (std::size_t round = 0; round < rounds; ++round)
    if (!chooseOnce(voxels, left_out, patches, distance, true, workers, labels))
      break;
  std::vector<std::uint32_t> sizes;
  labels = connectedParts(voxels, left_out, labels, sizes);
  auto supervoxels = averagePatches(voxels, labels, sizes.size());
  supervoxels.label_of_voxel = std::move(labels);
  return supervoxels;
}

} // namespace pcl::indoor
