/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/object_pieces.h"

#include "objects/join/building_pieces.h"
#include "objects/join/object_joining.h"
#include "objects/segment_names.h"
#include "objects/split/flat_objects.h"
#include "objects/split/object_gaps.h"

#include <pcl/indoor/most_frequent.h>

#include <utility>

namespace {

using pcl::indoor::DetailedSegmentation;
using pcl::indoor::JoiningScale;
using pcl::indoor::JoinTree;
using pcl::indoor::ObjectSegmentationOptions;
using pcl::indoor::StructureKind;

/** The piece of most points of each voxel. */
std::vector<std::uint32_t>
piecesOfVoxels(const DetailedSegmentation& result)
{
  const auto& cells = result.scene.voxels.cells;
  std::vector<std::uint32_t> piece_of_voxel(result.scene.voxels.size(), 0), pieces;
  for (std::size_t v = 0; v < result.scene.voxels.size(); ++v) {
    pieces.clear();
    for (const auto point : cells.pointsOf(v))
      pieces.push_back(result.piece_of_point[point]);
    piece_of_voxel[v] = pcl::indoor::mostFrequent(pieces, 0u);
  }
  return piece_of_voxel;
}

/** Value of each piece or union as a segment: expected IoU minus 0.38, half of the
 * panoptic quality reached; a segment that fits worse lowers that quality. 0 if below
 * fewest_points. */
std::vector<float>
worthOf(const JoinTree& tree,
        const ObjectSegmentationOptions& options,
        const DetailedSegmentation& result)
{
  constexpr float price = 0.38f;
  std::vector<std::size_t> points(result.segment_count, 0);
  for (const auto piece : result.piece_of_point)
    ++points[piece];
  auto worth = expectedFits(tree, options.pieces.scale, result.pieces.has_votes);
  for (std::size_t i = 0; i < worth.size(); ++i) {
    auto piece = i;
    if (i >= result.segment_count) {
      const auto& join = tree.joins[i - result.segment_count];
      piece = join.kept;
      points[piece] += points[join.gone];
    }
    worth[i] = points[piece] < options.fewest_points ? 0 : worth[i] - price;
  }
  return worth;
}

/** The segment of each piece, see PieceOptions::joining_level. */
std::vector<std::uint32_t>
objectsOf(const JoinTree& tree,
          const ObjectSegmentationOptions& options,
          const DetailedSegmentation& result)
{
  const auto [scale, level] = options.pieces;
  if (level || scale == JoiningScale::View)
    return segmentsAtLevel(
        result.segment_count, tree.joins, level.value_or(levelOf(scale)));
  return bestCut(tree.joins, worthOf(tree, options, result), levelOf(scale));
}

/** One segment for all that is of the same kind of structure. */
void
gatherByKind(const std::vector<StructureKind>& kinds,
             std::vector<std::uint32_t>& segment_of_piece)
{
  const auto first = static_cast<std::uint32_t>(segment_of_piece.size());
  for (std::size_t p = 0; p < kinds.size(); ++p)
    if (kinds[p] != StructureKind::None)
      segment_of_piece[p] = first + static_cast<std::uint32_t>(kinds[p]);
}

} // namespace

namespace pcl::indoor {

void
cutPieces(const std::vector<std::uint32_t>& piece_of_voxel,
          DetailedSegmentation& result)
{
  const auto& scene = result.scene;
  result.segment_of_point = partFlatObjects(scene, piece_of_voxel);
  std::vector<std::uint8_t> in_structure;
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    in_structure.push_back(scene.planeOfPoint(i) != 0);
  partAtGaps(scene, in_structure, result.segment_of_point);
}

void
joinToObjects(const ObjectSegmentationOptions& options,
              const std::optional<Eigen::Vector3f>& camera,
              DetailedSegmentation& result)
{
  numberSegments(result);
  result.piece_of_point = result.segment_of_point;
  const auto piece_of_voxel = piecesOfVoxels(result);
  const auto frame =
      camera ? viewFrame(result.scene, piece_of_voxel, result.segment_count, *camera)
             : roomFrame(result.scene);
  result.pieces = pieceGraph({result.scene,
                              piece_of_voxel,
                              result.segment_count,
                              result.supervoxels,
                              result.edges,
                              result.votes},
                             frame);
  const auto kinds = buildingPieces(result.pieces);
  leaveAlone(kinds, result.pieces);
  LearnedCriterion criterion(options.pieces.scale, result.pieces.has_votes);
  auto tree = joinPieces(result.pieces, criterion);
  auto segment_of_piece = objectsOf(tree, options, result);
  gatherByKind(kinds, segment_of_piece);
  result.joins = std::move(tree.joins);
  for (auto& segment : result.segment_of_point)
    segment = segment_of_piece[segment];
}

} // namespace pcl::indoor
