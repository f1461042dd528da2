/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/indoor/disjoint_sets.h>
#include <pcl/model/model_walls.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl {
namespace indoor {
namespace {

constexpr double thickest = 0.7;    // metres: walls of old houses
constexpr double least_piece = 0.2; // metres
constexpr double parallel = 0.98;   // cosine, 11 degrees
constexpr double same_line = 0.05;  // metres: steps between walls are larger
constexpr double crossing = 0.5;    // metres: what crosses a wall is no thicker

double
crossOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

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
  if (pair.to - pair.from < least_piece)
    return std::nullopt;
  // how far behind the middle of the overlap the other one is
  const Eigen::Vector2d middle = one.begin + 0.5 * (pair.from + pair.to) * along;
  const Eigen::Vector2d way = other.along();
  pair.gap =
      -one.inward().dot(other.begin + way.dot(middle - other.begin) * way - middle);
  if (pair.gap < 0.01 || pair.gap > thickest)
    return std::nullopt;
  return pair;
}

/** A piece of a wall before it is joined with others. */
struct Piece {
  ModelWall wall;
  bool has_two_sides = false;
};

Piece
pieceOf(const WallFace& face, double from, double to, double gap)
{
  Piece piece;
  const Eigen::Vector2d shift = -0.5 * gap * face.inward();
  piece.wall.storey = face.storey;
  piece.wall.begin = face.begin + from * face.along() + shift;
  piece.wall.end = face.begin + to * face.along() + shift;
  piece.wall.floor = face.floor;
  piece.wall.height = face.ceiling - face.floor;
  piece.wall.thickness = gap;
  piece.wall.rooms = {face.room};
  piece.has_two_sides = gap > 0.0;
  return piece;
}

/** What of a side has no partner. Between two partners, or beside one, it may be where
 * another wall meets this one from behind. */
void
addRest(const WallFace& face,
        std::vector<std::pair<double, double>> taken,
        std::vector<Piece>& pieces)
{
  const double least = taken.empty() ? least_piece : crossing;
  std::sort(taken.begin(), taken.end());
  taken.emplace_back(face.length(), face.length());
  double from = 0.0;
  for (const auto& [begin, end] : taken) {
    if (begin - from >= least)
      pieces.push_back(pieceOf(face, from, begin, 0.0));
    from = std::max(from, end);
  }
}

std::vector<Piece>
piecesOf(const std::vector<WallFace>& faces, const std::vector<FacePair>& pairs)
{
  std::vector<Piece> pieces;
  std::vector<std::vector<std::pair<double, double>>> taken(faces.size());
  for (const FacePair& pair : pairs) {
    taken[pair.face].emplace_back(pair.from, pair.to);
    if (pair.face > pair.other)
      continue;
    const WallFace &one = faces[pair.face], &other = faces[pair.other];
    Piece piece = pieceOf(one, pair.from, pair.to, pair.gap);
    piece.wall.floor = std::min(one.floor, other.floor);
    piece.wall.height = std::max(one.ceiling, other.ceiling) - piece.wall.floor;
    if (other.room != one.room)
      piece.wall.rooms = {std::min(one.room, other.room),
                          std::max(one.room, other.room)};
    pieces.push_back(piece);
  }
  for (std::size_t i = 0; i < faces.size(); ++i)
    addRest(faces[i], taken[i], pieces);
  return pieces;
}

/** Whether two pieces belong to one wall. */
bool
areOne(const Piece& a, const Piece& b)
{
  constexpr double same_thickness = 0.04; // metres
  if (a.wall.storey != b.wall.storey || a.has_two_sides != b.has_two_sides ||
      std::abs(a.wall.thickness - b.wall.thickness) > same_thickness)
    return false;
  const Eigen::Vector2d way = a.wall.end - a.wall.begin;
  const double length = way.norm();
  const Eigen::Vector2d along = way / length;
  const double turn = along.dot((b.wall.end - b.wall.begin).normalized());
  if ((a.has_two_sides ? std::abs(turn) : turn) < 0.999) // 2.6 degrees
    return false;
  const Eigen::Vector2d middle = 0.5 * (b.wall.begin + b.wall.end) - a.wall.begin;
  if (std::abs(crossOf(along, middle)) > same_line)
    return false;
  const double first = along.dot(b.wall.begin - a.wall.begin);
  const double last = along.dot(b.wall.end - a.wall.begin);
  return std::min(first, last) <= length + crossing &&
         std::max(first, last) >= -crossing;
}

/** One wall of several pieces: from the first to the last end along the longest. */
ModelWall
joined(const std::vector<const Piece*>& pieces)
{
  const auto length = [](const Piece* piece) {
    return (piece->wall.end - piece->wall.begin).norm();
  };
  const Piece& longest = **std::max_element(
      pieces.begin(), pieces.end(), [&](const auto* a, const auto* b) {
        return length(a) < length(b);
      });
  ModelWall wall = longest.wall;
  const Eigen::Vector2d origin = longest.wall.begin;
  const Eigen::Vector2d along = (longest.wall.end - origin).normalized();
  double from = 0.0, to = length(&longest), thickness = 0.0, lengths = 0.0;
  double beside = 0.0, top = wall.floor + wall.height;
  for (const Piece* piece : pieces) {
    for (const auto& end : {piece->wall.begin, piece->wall.end}) {
      from = std::min(from, along.dot(end - origin));
      to = std::max(to, along.dot(end - origin));
    }
    const double weight = length(piece);
    beside +=
        weight * crossOf(along, 0.5 * (piece->wall.begin + piece->wall.end) - origin);
    thickness += weight * piece->wall.thickness;
    lengths += weight;
    wall.floor = std::min(wall.floor, piece->wall.floor);
    top = std::max(top, piece->wall.floor + piece->wall.height);
    wall.rooms.insert(
        wall.rooms.end(), piece->wall.rooms.begin(), piece->wall.rooms.end());
  }
  const Eigen::Vector2d line =
      origin + beside / lengths * Eigen::Vector2d(-along.y(), along.x());
  wall.begin = line + from * along;
  wall.end = line + to * along;
  wall.height = top - wall.floor;
  wall.thickness = thickness / lengths;
  std::sort(wall.rooms.begin(), wall.rooms.end());
  wall.rooms.erase(std::unique(wall.rooms.begin(), wall.rooms.end()), wall.rooms.end());
  return wall;
}

/** Let walls end on the axes of those that they meet. */
void
closeCorners(std::vector<ModelWall>& walls)
{
  constexpr double flat = 0.5; // sine, 30 degrees
  const auto before = walls;
  for (std::size_t i = 0; i < walls.size(); ++i)
    for (const bool at_end : {false, true}) {
      const Eigen::Vector2d end = at_end ? before[i].end : before[i].begin;
      const Eigen::Vector2d along = (before[i].end - before[i].begin).normalized();
      double nearest = crossing;
      for (std::size_t j = 0; j < walls.size(); ++j) {
        const Eigen::Vector2d way = (before[j].end - before[j].begin).normalized();
        const double turn = crossOf(along, way);
        if (i == j || before[i].storey != before[j].storey || std::abs(turn) < flat)
          continue;
        const double step = crossOf(before[j].begin - end, way) / turn;
        const double place = way.dot(end + step * along - before[j].begin);
        const double most = (before[j].end - before[j].begin).norm() + crossing;
        if (std::abs(step) >= nearest || place < -crossing || place > most)
          continue;
        nearest = std::abs(step);
        (at_end ? walls[i].end : walls[i].begin) = end + step * along;
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
    const double most = circles[i].z() + circles[j].z() + thickest;
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
modelWalls(const std::vector<WallFace>& faces, const std::vector<FacePair>& pairs)
{
  const auto pieces = piecesOf(faces, pairs);
  DisjointSets sets(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t j = i + 1; j < pieces.size(); ++j)
      if (areOne(pieces[i], pieces[j]))
        sets.merge(sets.find(i), sets.find(j));
  const auto wall_of = sets.labels();
  std::vector<std::vector<const Piece*>> groups(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i)
    groups[wall_of[i]].push_back(&pieces[i]);
  std::vector<ModelWall> walls;
  for (const auto& group : groups)
    if (!group.empty())
      walls.push_back(joined(group));
  std::stable_sort(walls.begin(), walls.end(), [](const auto& a, const auto& b) {
    return a.storey < b.storey;
  });
  closeCorners(walls);
  walls.erase(std::remove_if(walls.begin(),
                             walls.end(),
                             [](const auto& wall) {
                               return (wall.end - wall.begin).norm() < least_piece;
                             }),
              walls.end());
  return walls;
}

} // namespace indoor
} // namespace pcl
