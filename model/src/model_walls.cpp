/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/indoor/quantile.h>
#include <pcl/model/model_walls.h>

#include "internal/cross.h"
#include "wall_dimensions.h"
#include "wall_pieces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace pcl::indoor {
namespace {

constexpr double parallel = 0.98; // cosine, 11 degrees

std::optional<FacePair>
pairOf(const std::vector<WallFace>& faces, std::size_t i, std::size_t j)
{
  const WallFace &one = faces[i], &other = faces[j];
  const Eigen::Vector2d along = one.along();
  if (along.dot(other.along()) > -parallel)
    return std::nullopt;
  if (std::min(one.ceiling, other.ceiling) - std::max(one.floor, other.floor) < 1.0)
    return std::nullopt;
  FacePair pair;
  pair.face = i;
  pair.other = j;
  pair.from = std::max(0.0, along.dot(other.end - one.begin));
  pair.to = std::min(one.length(), along.dot(other.begin - one.begin));
  if (pair.to - pair.from < least_wall)
    return std::nullopt;
  // how far behind the middle of the overlap the other one is
  const Eigen::Vector2d middle = one.begin + 0.5 * (pair.from + pair.to) * along;
  const Eigen::Vector2d way = other.along();
  pair.gap =
      -one.inward().dot(other.begin + way.dot(middle - other.begin) * way - middle);
  if (pair.gap < 0.01 || pair.gap > thickest_old_wall)
    return std::nullopt;
  return pair;
}

/** The depth of windows and outer doors in each side; where none is known, that in the
 * middle of its storey. */
std::vector<double>
depthsOf(const std::vector<WallFace>& faces, std::vector<double> depths)
{
  depths.resize(faces.size(), 0.0);
  std::map<std::uint32_t, std::vector<double>> of_storeys;
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (depths[i] > 0.0)
      of_storeys[faces[i].storey].push_back(depths[i]);
  for (auto& [storey, known] : of_storeys) {
    const double middle = median(known);
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (faces[i].storey == storey && depths[i] == 0.0)
        depths[i] = middle;
  }
  return depths;
}

/** How far to the right of the line of another wall a wall ends, metres. One with two
 * sides ends on the axis, or as near to it as is known; one with one side is told by
 * that side, which ends on a side of the other. */
double
beyondLine(const WallPiece& piece, const WallPiece& other)
{
  if (piece.two_sided > 0.0)
    return 0.5 * other.depth;
  const Eigen::Vector2d middle =
      0.5 * (piece.wall.begin + piece.wall.end) - other.wall.begin;
  const double side = crossOf(other.wall.end - other.wall.begin, middle);
  return side < 0.0 ? 0.5 * other.wall.thickness : -0.5 * other.wall.thickness;
}

/** Let walls end on the axes of those that they meet. */
void
closeCorners(std::vector<WallPiece>& pieces)
{
  const auto before = pieces;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (const bool at_end : {false, true}) {
      const ModelWall& wall = before[i].wall;
      const Eigen::Vector2d end = at_end ? wall.end : wall.begin;
      const Eigen::Vector2d along = (wall.end - wall.begin).normalized();
      double nearest = crossing;
      for (std::size_t j = 0; j < pieces.size(); ++j) {
        const ModelWall& other = before[j].wall;
        const Eigen::Vector2d way = (other.end - other.begin).normalized();
        const double turn = crossOf(along, way);
        if (i == j || wall.storey != other.storey || std::abs(turn) < flat_corner)
          continue;
        const Eigen::Vector2d begin =
            other.begin +
            beyondLine(before[i], before[j]) * Eigen::Vector2d(way.y(), -way.x());
        const double step = crossOf(begin - end, way) / turn;
        const double place = way.dot(end + step * along - begin);
        const double most = lengthOf(other) + crossing;
        if (std::abs(step) >= nearest || place < -crossing || place > most)
          continue;
        nearest = std::abs(step);
        (at_end ? pieces[i].wall.end : pieces[i].wall.begin) = end + step * along;
      }
    }
}

} // namespace

std::vector<FacePair>
facePairs(const std::vector<WallFace>& faces)
{
  std::vector<Eigen::Vector3d> circles; // middle and radius of each
  for (const WallFace& face : faces) {
    const Eigen::Vector2d middle = 0.5 * (face.begin + face.end);
    circles.emplace_back(middle.x(), middle.y(), 0.5 * face.length());
  }
  const auto areNear = [&](std::size_t i, std::size_t j) {
    const double most = circles[i].z() + circles[j].z() + thickest_old_wall;
    return (circles[i] - circles[j]).head<2>().squaredNorm() <= most * most;
  };
  std::vector<FacePair> all;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = 0; j < faces.size(); ++j)
      if (i != j && areNear(i, j))
        if (const auto pair = pairOf(faces, i, j))
          all.push_back(*pair);
  std::vector<FacePair> nearest;
  for (std::size_t first = 0, end = 0; first < all.size(); first = end) {
    while (end < all.size() && all[end].face == all[first].face)
      ++end;
    for (std::size_t i = first; i < end; ++i) {
      const FacePair& pair = all[i];
      bool is_hidden = false;
      for (std::size_t j = first; j < end; ++j)
        is_hidden |= all[j].gap < pair.gap &&
                     std::min(all[j].to, pair.to) - std::max(all[j].from, pair.from) >
                         0.5 * (pair.to - pair.from);
      if (!is_hidden)
        nearest.push_back(pair);
    }
  }
  return nearest;
}

std::vector<ModelWall>
modelWalls(const std::vector<WallFace>& faces,
           const std::vector<FacePair>& pairs,
           const std::vector<double>& depths)
{
  auto pieces = joinedPieces(wallPieces(faces, pairs, depthsOf(faces, depths)));
  std::stable_sort(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) {
    return a.wall.storey < b.wall.storey;
  });
  closeCorners(pieces);
  std::vector<ModelWall> walls;
  for (const WallPiece& piece : pieces)
    if (lengthOf(piece.wall) >= least_wall)
      walls.push_back(piece.wall);
  return walls;
}

} // namespace pcl::indoor
