/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/disjoint_sets.h>
#include <pcl/segmentation/frame_unions.h>

#include "interval.h"
#include "segment_boxes.h"

#include <pcl/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace {

using pcl::indoor::FrameUnionOptions;
using pcl::indoor::Interval;
using pcl::indoor::SurfaceVoxels;

/** A segment, and of a frame of which thin axis it may be a part. */
struct Piece {
  pcl::indoor::SegmentBox box;
  std::array<bool, 3> is_part{};
};

/** A narrow bar or an open shape, thin along the axis. */
bool
isPartOfFrame(const pcl::indoor::SegmentBox& piece,
              int axis,
              const FrameUnionOptions& options)
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
    const Interval layer_a{a.box.low[axis], a.box.high[axis]},
        layer_b{b.box.low[axis], b.box.high[axis]};
    if (commonShare(layer_a, layer_b) >= options.min_overlap)
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
  std::vector<Piece> pieces;
  for (const auto& box : pcl::indoor::segmentBoxes(
           voxels, left_out, segment_of_voxel, options.axes, options.voxel_size)) {
    pieces.push_back({box, {}});
    for (int axis = 0; axis < 3 && box.size > 0; ++axis)
      pieces.back().is_part[axis] = isPartOfFrame(box, axis, options);
  }
  return pieces;
}

void
requireValid(const FrameUnionOptions& options)
{
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
  requireOnePerVoxel(voxels, left_out, segment_of_voxel);
  requireValid(options);
  if (voxels.size() == 0)
    return;
  const auto pieces = makePieces(voxels, left_out, segment_of_voxel, options);
  DisjointSets frames(pieces.size());
  for (const auto& [a, b] : touchingSegments(voxels, left_out, segment_of_voxel))
    if (areOneFrame(pieces[a], pieces[b], options))
      frames.merge(frames.find(a), frames.find(b));
  renumberSegments(
      left_out, [&](auto s) { return frames.find(s); }, segment_of_voxel);
}

} // namespace indoor
} // namespace pcl
