/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/object_pieces.h"

#include "objects/graph/object_voxels.h"
#include "objects/structure/wall_frames.h"

#include "objects/split/flat_things.h"
#include "objects/split/object_gaps.h"
#include "objects/split/object_seams.h"

#include <algorithm>

namespace {

using pcl::indoor::ObjectSegmentation;
using pcl::indoor::ObjectSegmentationOptions;

/** The piece of most points of each voxel. */
std::vector<std::uint32_t>
piecesOfVoxels(const ObjectSegmentation& result)
{
  const auto& cells = result.voxels.cells;
  std::vector<std::uint32_t> piece_of_voxel(result.voxels.size(), 0), pieces;
  for (std::size_t v = 0; v < result.voxels.size(); ++v) {
    pieces.clear();
    for (auto i = cells.offsets[v]; i < cells.offsets[v + 1]; ++i)
      pieces.push_back(result.piece_of_point[cells.points[i]]);
    std::sort(pieces.begin(), pieces.end());
    std::ptrdiff_t most = 0;
    for (auto begin = pieces.begin(); begin != pieces.end();) {
      const auto end = std::upper_bound(begin, pieces.end(), *begin);
      if (end - begin > most) {
        most = end - begin;
        piece_of_voxel[v] = *begin;
      }
      begin = end;
    }
  }
  return piece_of_voxel;
}

/** The flags, and those of the segments that are one piece: these were cut before. */
std::vector<std::uint8_t>
withSinglePieces(const ObjectSegmentation& result, std::vector<std::uint8_t> flags)
{
  std::vector<std::uint8_t> has_joined(result.pieces.pieces.size(), 0);
  for (std::size_t i = 0; i < flags.size(); ++i)
    if (result.segment_of_point[i] != result.piece_of_point[i])
      has_joined[result.segment_of_point[i]] = 1;
  for (std::size_t i = 0; i < flags.size(); ++i)
    flags[i] |= !has_joined[result.segment_of_point[i]];
  return flags;
}

void
cutGaps(const std::vector<Eigen::Vector3f>& points,
        const std::vector<std::uint8_t>& left_out,
        const ObjectSegmentationOptions& options,
        ObjectSegmentation& result)
{
  pcl::indoor::ObjectGapOptions gaps;
  gaps.up = options.up;
  gaps.voxel_size = options.voxel_size;
  gaps.threads = options.threads;
  pcl::indoor::partAtGaps(points, left_out, gaps, result.segment_of_point);
}

} // namespace

namespace pcl {
namespace indoor {

void
numberSegments(ObjectSegmentation& result)
{
  const auto highest =
      std::max_element(result.segment_of_point.begin(), result.segment_of_point.end());
  std::vector<std::uint32_t> number(
      highest == result.segment_of_point.end() ? 0 : *highest + 1, Supervoxels::none);
  result.segment_count = 0;
  for (auto& segment : result.segment_of_point) {
    if (number[segment] == Supervoxels::none)
      number[segment] = result.segment_count++;
    segment = number[segment];
  }
}

void
cutPieces(const std::vector<Eigen::Vector3f>& points,
          const std::vector<std::uint32_t>& piece_of_voxel,
          const ObjectSegmentationOptions& options,
          ObjectSegmentation& result)
{
  const auto in_plane = inStructure(result);
  FlatThingOptions things;
  things.up = options.up;
  things.voxel_size = options.voxel_size;
  result.segment_of_point =
      partFlatThings(points, result.voxels, piece_of_voxel, in_plane, things);
  std::vector<std::uint8_t> point_in_plane;
  for (const auto voxel : result.voxels.cells.cell_of_point)
    point_in_plane.push_back(in_plane[voxel]);
  cutGaps(points, point_in_plane, options, result);
}

void
joinPiecesOfRoom(const std::vector<StructurePlane>& planes,
                 const ObjectSegmentationOptions& options,
                 ObjectSegmentation& result)
{
  numberSegments(result);
  result.piece_of_point = result.segment_of_point;
  const auto piece_of_voxel = piecesOfVoxels(result);
  result.pieces = pieceGraph({result.voxels,
                              result.plane_of_voxel,
                              piece_of_voxel,
                              result.segment_count,
                              result.supervoxels,
                              result.edges,
                              options.voxel_size},
                             planes,
                             options.up);
  LearnedCriterion criterion(options.scale);
  result.joins = joinPieces(result.pieces, criterion);
  const auto segment_of_piece =
      segmentsAtLevel(result.segment_count, result.joins, options.joining_level);
  for (auto& segment : result.segment_of_point)
    segment = segment_of_piece[segment];
}

void
cutBodies(const std::vector<Eigen::Vector3f>& points,
          const std::vector<StructurePlane>& planes,
          const ObjectSegmentationOptions& options,
          ObjectSegmentation& result)
{
  const auto left_out = flagStructureAndFrames(points,
                                               result.voxels,
                                               planes,
                                               result.plane_of_voxel,
                                               options.voxel_size,
                                               options.up,
                                               result.segment_of_point);
  cutGaps(points, withSinglePieces(result, left_out), options, result);
  ObjectSeamOptions seams;
  seams.up = options.up;
  seams.voxel_size = options.voxel_size;
  seams.threads = options.threads;
  partAtSeams(points, result.voxels, left_out, seams, result.segment_of_point);
}

} // namespace indoor
} // namespace pcl
