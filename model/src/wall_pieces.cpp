/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "wall_pieces.h"

#include "internal/cross.h"
#include "wall_dimensions.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace pcl::indoor {
namespace {

constexpr double same_thickness = 0.04; // metres
constexpr double same_way = 0.999;      // cosine, 2.6 degrees

WallPiece
pieceOf(const WallFace& face, double from, double to, double gap)
{
  WallPiece piece;
  const Eigen::Vector2d shift = -0.5 * gap * face.inward();
  piece.wall.storey = face.storey;
  piece.wall.begin = face.begin + from * face.along() + shift;
  piece.wall.end = face.begin + to * face.along() + shift;
  piece.wall.floor = face.floor;
  piece.wall.height = face.ceiling - face.floor;
  piece.wall.thickness = gap;
  piece.wall.rooms = {face.room};
  piece.two_sided = gap > 0.0 ? to - from : 0.0;
  return piece;
}

/** What of a side has no partner. Between two partners, or beside one, it may be where
 * another wall meets this one from behind. */
void
addRest(const WallFace& face,
        double depth,
        std::vector<std::pair<double, double>> taken,
        std::vector<WallPiece>& pieces)
{
  const double least = taken.empty() ? least_wall : crossing;
  std::sort(taken.begin(), taken.end());
  taken.emplace_back(face.length(), face.length());
  double from = 0.0;
  for (const auto& [begin, end] : taken) {
    if (begin - from >= least) {
      pieces.push_back(pieceOf(face, from, begin, 0.0));
      pieces.back().depth = depth;
    }
    from = std::max(from, end);
  }
}

/** Whether a pair makes a piece, and not the same one seen from the other side: the
 * longer side is the straighter one. */
bool
isLeading(const FacePair& pair,
          const std::vector<WallFace>& faces,
          const std::vector<FacePair>& pairs)
{
  const double length = faces[pair.face].length(), other = faces[pair.other].length();
  if (length > other || (length == other && pair.face < pair.other))
    return true;
  return std::none_of(pairs.begin(), pairs.end(), [&](const FacePair& each) {
    return each.face == pair.other && each.other == pair.face;
  });
}

/** Where a piece of one side lies on a wall with another thickness. */
ModelWall
thickened(const WallPiece& piece, double thickness)
{
  ModelWall wall = piece.wall;
  const Eigen::Vector2d way = (wall.end - wall.begin).normalized();
  const Eigen::Vector2d outward(way.y(), -way.x());
  wall.begin += 0.5 * thickness * outward;
  wall.end += 0.5 * thickness * outward;
  wall.thickness = thickness;
  return wall;
}

/** Whether two walls lie on one line with no more than a crossing wall between them. */
bool
areOnOneLine(const ModelWall& a, const ModelWall& b)
{
  const double length = lengthOf(a);
  const Eigen::Vector2d along = (a.end - a.begin) / length;
  if (std::abs(along.dot((b.end - b.begin).normalized())) < same_way)
    return false;
  const Eigen::Vector2d middle = 0.5 * (b.begin + b.end) - a.begin;
  if (std::abs(crossOf(along, middle)) > same_line)
    return false;
  const double first = along.dot(b.begin - a.begin), last = along.dot(b.end - a.begin);
  return std::min(first, last) <= length + crossing &&
         std::max(first, last) >= -crossing;
}

/** Whether two pieces belong to one wall, of which the first is the larger part. */
bool
areOne(const WallPiece& a, const WallPiece& b)
{
  const ModelWall &one = a.wall, &other = b.wall;
  if (one.storey != other.storey)
    return false;
  if (a.two_sided > 0.0 && b.two_sided > 0.0)
    return std::abs(one.thickness - other.thickness) <= same_thickness &&
           areOnOneLine(one, other);
  if (a.two_sided > 0.0)
    return lengthOf(other) <= a.two_sided &&
           areOnOneLine(one, thickened(b, one.thickness));
  return b.two_sided == 0.0 &&
         (one.end - one.begin).dot(other.end - other.begin) > 0.0 &&
         areOnOneLine(one, other);
}

/** The line along walls, as far as they go: least squares of all their points. */
std::pair<Eigen::Vector2d, Eigen::Vector2d>
lineAlong(const std::vector<ModelWall>& parts)
{
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  double lengths = 0.0;
  for (const ModelWall& part : parts) {
    mean += 0.5 * lengthOf(part) * (part.begin + part.end);
    lengths += lengthOf(part);
  }
  mean /= lengths;
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const ModelWall& part : parts) {
    const Eigen::Vector2d way = part.end - part.begin;
    const Eigen::Vector2d from = 0.5 * (part.begin + part.end) - mean;
    spread += way.norm() * (way * way.transpose() / 12.0 + from * from.transpose());
  }
  const double angle =
      0.5 * std::atan2(2.0 * spread(0, 1), spread(0, 0) - spread(1, 1));
  Eigen::Vector2d along(std::cos(angle), std::sin(angle));
  if (along.dot(parts.front().end - parts.front().begin) < 0.0)
    along = -along;
  double from = 0.0, to = 0.0;
  for (const ModelWall& part : parts)
    for (const auto& end : {part.begin, part.end}) {
      from = std::min(from, along.dot(end - mean));
      to = std::max(to, along.dot(end - mean));
    }
  return {mean + from * along, mean + to * along};
}

/** One wall of several pieces, which goes the way of the first. */
WallPiece
joined(const std::vector<WallPiece>& pieces)
{
  WallPiece whole = pieces.front();
  ModelWall& wall = whole.wall;
  wall.thickness = whole.two_sided = whole.depth = 0.0;
  for (const WallPiece& piece : pieces) {
    wall.thickness += piece.two_sided * piece.wall.thickness;
    whole.two_sided += piece.two_sided;
    whole.depth = std::max(whole.depth, piece.depth);
  }
  if (whole.two_sided > 0.0) {
    wall.thickness /= whole.two_sided;
    whole.depth = 0.0;
  }
  double top = wall.floor + wall.height;
  std::vector<ModelWall> parts;
  for (const WallPiece& piece : pieces) {
    parts.push_back(piece.two_sided > 0.0 ? piece.wall
                                          : thickened(piece, wall.thickness));
    top = std::max(top, piece.wall.floor + piece.wall.height);
    wall.floor = std::min(wall.floor, piece.wall.floor);
    wall.rooms.insert(
        wall.rooms.end(), piece.wall.rooms.begin(), piece.wall.rooms.end());
  }
  std::tie(wall.begin, wall.end) = lineAlong(parts);
  wall.height = top - wall.floor;
  std::sort(wall.rooms.begin(), wall.rooms.end());
  wall.rooms.erase(std::unique(wall.rooms.begin(), wall.rooms.end()), wall.rooms.end());
  return whole;
}

/** A wall that grows. */
struct GrowingWall {
  std::vector<WallPiece> pieces;
  WallPiece whole;
};

/** Let a wall take all that belong to it. \return whether there were any */
bool
takeOthers(std::vector<GrowingWall>& walls, std::size_t number)
{
  bool took = false;
  for (std::size_t i = number + 1; i < walls.size();) {
    GrowingWall& wall = walls[number];
    if (!areOne(wall.whole, walls[i].whole)) {
      ++i;
      continue;
    }
    const auto& pieces = walls[i].pieces;
    wall.pieces.insert(wall.pieces.end(), pieces.begin(), pieces.end());
    wall.whole = joined(wall.pieces);
    walls.erase(walls.begin() + static_cast<std::ptrdiff_t>(i));
    took = true;
  }
  return took;
}

} // namespace

std::vector<WallPiece>
wallPieces(const std::vector<WallFace>& faces,
           const std::vector<FacePair>& pairs,
           const std::vector<double>& depths)
{
  std::vector<WallPiece> pieces;
  std::vector<std::vector<std::pair<double, double>>> taken(faces.size());
  for (const FacePair& pair : pairs) {
    taken[pair.face].emplace_back(pair.from, pair.to);
    if (!isLeading(pair, faces, pairs))
      continue;
    const WallFace &one = faces[pair.face], &other = faces[pair.other];
    WallPiece piece = pieceOf(one, pair.from, pair.to, pair.gap);
    piece.wall.floor = std::min(one.floor, other.floor);
    piece.wall.height = std::max(one.ceiling, other.ceiling) - piece.wall.floor;
    if (other.room != one.room)
      piece.wall.rooms = {std::min(one.room, other.room),
                          std::max(one.room, other.room)};
    pieces.push_back(piece);
  }
  for (std::size_t i = 0; i < faces.size(); ++i)
    addRest(faces[i], depths[i], taken[i], pieces);
  return pieces;
}

std::vector<WallPiece>
joinedPieces(std::vector<WallPiece> pieces)
{
  std::stable_sort(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) {
    const bool has_two = a.two_sided > 0.0;
    if (has_two != (b.two_sided > 0.0))
      return has_two;
    return lengthOf(a.wall) > lengthOf(b.wall);
  });
  std::vector<GrowingWall> walls;
  for (const WallPiece& piece : pieces)
    walls.push_back({{piece}, piece});
  std::vector<WallPiece> found;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    while (takeOthers(walls, i)) {
    }
    found.push_back(walls[i].whole);
  }
  return found;
}

} // namespace pcl::indoor
