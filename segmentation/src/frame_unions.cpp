/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/disjoint_sets.h>
#include <pcl/segmentation/frame_unions.h>

#include "quantile.h"

#include <pcl/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace {

using pcl::indoor::FrameUnionOptions;
using pcl::indoor::SurfaceVoxels;

constexpr double outlier_share = 0.03; // of a piece's voxels, cut off at either end

/** A segment between two values along each axis. */
struct Piece {
  std::size_t size = 0; ///< voxels; 0 = there is no such segment
  Eigen::Array3d low = Eigen::Array3d::Zero(), high = Eigen::Array3d::Zero();
  std::array<bool, 3> is_part{}; ///< of a frame that is thin along this axis

  Eigen::Array3d
  extent() const
  {
    return high - low;
  }
};

Piece
pieceOf(const std::vector<Eigen::Vector3f>& places, const FrameUnionOptions& options)
{
  Piece piece;
  piece.size = places.size();
  std::vector<double> heights;
  for (int axis = 0; axis < 3; ++axis) {
    heights.clear();
    for (const auto& place : places)
      heights.push_back(options.axes.col(axis).dot(place));
    piece.low[axis] =
        pcl::indoor::quantile(heights, outlier_share) - options.voxel_size / 2;
    piece.high[axis] =
        pcl::indoor::quantile(heights, 1 - outlier_share) + options.voxel_size / 2;
  }
  return piece;
}

/** A narrow bar or an open shape, thin along the axis. */
bool
isPartOfFrame(const Piece& piece, int axis, const FrameUnionOptions& options)
{
  if (std::abs(options.axes.col(axis).dot(options.up)) > 0.5f)
    return false;
  const auto extent = piece.extent();
  const double first = extent[(axis + 1) % 3], second = extent[(axis + 2) % 3];
  const double width = std::min(first, second), length = std::max(first, second);
  if (extent[axis] > options.max_thickness || length < options.min_length)
    return false;
  if (width <= options.max_thickness && length >= options.min_elongation * width)
    return true;
  const double layers = std::max(1.0, extent[axis] / options.voxel_size);
  const double filled = static_cast<double>(piece.size) * options.voxel_size *
                        options.voxel_size / layers;
  return filled <= options.max_fill * width * length;
}

bool
areOneFrame(const Piece& a, const Piece& b, const FrameUnionOptions& options)
{
  for (int axis = 0; axis < 3; ++axis) {
    if (!a.is_part[axis] || !b.is_part[axis])
      continue;
    const double common =
        std::min(a.high[axis], b.high[axis]) - std::max(a.low[axis], b.low[axis]);
    const double both =
        std::max(a.high[axis], b.high[axis]) - std::min(a.low[axis], b.low[axis]);
    if (common >= options.min_overlap * both)
      return true;
  }
  return false;
}

std::vector<Piece>
makePieces(const SurfaceVoxels& voxels,
           const std::vector<std::uint8_t>& left_out,
           const std::vector<std::uint32_t>& segment_of_voxel,
           const FrameUnionOptions& options)
{
  const auto last = *std::max_element(segment_of_voxel.begin(), segment_of_voxel.end());
  std::vector<std::vector<Eigen::Vector3f>> places(last + 1);
  for (std::size_t v = 0; v < voxels.size(); ++v)
    if (!left_out[v])
      places[segment_of_voxel[v]].push_back(voxels.centroids[v]);
  std::vector<Piece> pieces(places.size());
  for (std::size_t s = 0; s < places.size(); ++s) {
    if (places[s].empty())
      continue;
    pieces[s] = pieceOf(places[s], options);
    for (int axis = 0; axis < 3; ++axis)
      pieces[s].is_part[axis] = isPartOfFrame(pieces[s], axis, options);
  }
  return pieces;
}

void
requireValid(const SurfaceVoxels& voxels,
             const std::vector<std::uint8_t>& left_out,
             const std::vector<std::uint32_t>& segment_of_voxel,
             const FrameUnionOptions& options)
{
  if (left_out.size() != voxels.size() || segment_of_voxel.size() != voxels.size())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        voxels.size()
                            << " voxels have " << left_out.size() << " flags and "
                            << segment_of_voxel.size() << " segments.");
  if (!(options.voxel_size > 0) || !(options.max_thickness > 0) ||
      !(options.min_length >= 0) || !(options.min_elongation >= 1) ||
      !(options.max_fill >= 0) || !(options.min_overlap >= 0) ||
      !(std::abs(options.up.norm() - 1) < 1e-3f))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "Frames need positive sizes, an elongation of at least 1 and a "
                        "unit vector up.");
}

} // namespace

namespace pcl {
namespace indoor {

void
joinFrames(const SurfaceVoxels& voxels,
           const std::vector<std::uint8_t>& left_out,
           const FrameUnionOptions& options,
           std::vector<std::uint32_t>& segment_of_voxel)
{
  requireValid(voxels, left_out, segment_of_voxel, options);
  if (voxels.size() == 0)
    return;
  const auto pieces = makePieces(voxels, left_out, segment_of_voxel, options);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> touching;
  for (std::size_t v = 0; v < voxels.size(); ++v)
    for (auto j = voxels.neighbors.offsets[v]; j < voxels.neighbors.offsets[v + 1];
         ++j) {
      const auto other = voxels.neighbors.targets[j];
      if (!left_out[v] && !left_out[other] &&
          segment_of_voxel[v] < segment_of_voxel[other])
        touching.emplace_back(segment_of_voxel[v], segment_of_voxel[other]);
    }
  std::sort(touching.begin(), touching.end());
  touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
  DisjointSets frames(pieces.size());
  for (const auto& [a, b] : touching)
    if (areOneFrame(pieces[a], pieces[b], options))
      frames.merge(frames.find(a), frames.find(b));
  for (std::size_t v = 0; v < voxels.size(); ++v)
    if (!left_out[v])
      segment_of_voxel[v] = frames.find(segment_of_voxel[v]);
}

} // namespace indoor
} // namespace pcl
