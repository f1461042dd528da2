/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/join/piece_graph.h"

#include <pcl/indoor/point_cells.h>
#include <pcl/indoor/quantile.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace {

using pcl::indoor::KDop16;
using pcl::indoor::Piece;
using pcl::indoor::PieceContact;
using pcl::indoor::PieceSurface;

constexpr double cell_voxels = 3; // edge of the cells that tell what is near
constexpr double in_line = 0.5;   // voxels from a tangent plane

using ContactMap = std::map<std::pair<std::uint32_t, std::uint32_t>, PieceContact>;

PieceContact&
contactOf(std::uint32_t a, std::uint32_t b, ContactMap& contacts)
{
  const auto pair = std::minmax(a, b);
  auto& contact = contacts[pair];
  contact.first = pair.first;
  contact.second = pair.second;
  return contact;
}

KDop16
outlineOf(const std::vector<Eigen::Vector3f>& places, float margin)
{
  constexpr auto count = std::tuple_size<KDop16>::value;
  return pcl::indoor::supportsOf<count>(places, margin, [](std::size_t d) {
    const Eigen::Vector2f direction = pcl::indoor::outlineDirection(d).cast<float>();
    return [direction](const Eigen::Vector3f& p) { return direction.dot(p.head<2>()); };
  });
}

/** The voxels in no plane, in the frame of the pieces. */
struct LooseVoxels {
  std::vector<std::uint32_t> voxels, pieces;
  std::vector<Eigen::Vector3f> positions, normals; ///< one per entry of voxels
};

LooseVoxels
looseVoxels(const PieceSurface& surface,
            const std::vector<Eigen::Vector3f>& places,
            const Eigen::Matrix3f& axes)
{
  LooseVoxels loose;
  for (std::uint32_t v = 0; v < surface.scene.voxels.size(); ++v) {
    if (surface.scene.plane_of_voxel[v] != 0)
      continue;
    loose.voxels.push_back(v);
    loose.pieces.push_back(surface.piece_of_voxel[v]);
    loose.positions.push_back(places[v]);
    loose.normals.push_back(axes * surface.scene.voxels.normals[v]);
  }
  return loose;
}

std::vector<Piece>
describePieces(const PieceSurface& surface, const LooseVoxels& loose, double voxel_size)
{
  std::vector<Piece> pieces(surface.piece_count);
  std::vector<std::vector<Eigen::Vector3f>> positions_of(surface.piece_count);
  for (std::size_t i = 0; i < loose.voxels.size(); ++i) {
    auto& piece = pieces[loose.pieces[i]];
    piece.positions.add(loose.positions[i].cast<double>());
    piece.normals.add(loose.normals[i].cast<double>());
    positions_of[loose.pieces[i]].push_back(loose.positions[i]);
  }
  const pcl::indoor::DirectionHulls hulls;
  const float margin = 0.5f * static_cast<float>(voxel_size);
  for (std::uint32_t p = 0; p < surface.piece_count; ++p)
    if (!positions_of[p].empty()) {
      pieces[p].hull = hulls.kDopOf(positions_of[p], margin);
      pieces[p].outline = outlineOf(positions_of[p], margin);
    }
  return pieces;
}

/** What the points of each voxel were taken for, in the mean. */
void
addVotes(const PieceSurface& surface,
         const LooseVoxels& loose,
         const Eigen::Matrix3f& axes,
         std::vector<Piece>& pieces)
{
  const auto& votes = surface.votes;
  for (auto& piece : pieces)
    piece.votes.classes.assign(votes.class_count, 0.0);
  for (std::size_t i = 0; i < loose.voxels.size(); ++i) {
    auto& own = pieces[loose.pieces[i]].votes;
    const auto points = surface.scene.voxels.cells.pointsOf(loose.voxels[i]);
    const double share = 1.0 / static_cast<double>(points.size());
    Eigen::Vector3d middle(0.0, 0.0, 0.0);
    for (const auto point : points) {
      const float* const probabilities = votes.of(point);
      for (std::size_t c = 0; c < votes.class_count; ++c)
        own.classes[c] += share * probabilities[c];
      middle += share * (axes * (surface.scene.points[point] +
                                 votes.to_middle[votes.voxel_of_point[point]]))
                            .cast<double>();
    }
    own.middles.add(middle);
  }
}

/** Where voxels of two pieces are neighbours. */
void
addTouching(const PieceSurface& surface, const LooseVoxels& loose, ContactMap& contacts)
{
  const auto& neighbors = surface.scene.voxels.neighbors;
  std::vector<std::uint32_t> entry_of_voxel(surface.scene.voxels.size(), 0), around;
  for (std::uint32_t i = 0; i < loose.voxels.size(); ++i)
    entry_of_voxel[loose.voxels[i]] = i;
  for (std::uint32_t i = 0; i < loose.voxels.size(); ++i) {
    const auto voxel = loose.voxels[i], own = loose.pieces[i];
    around.clear();
    for (const auto other : neighbors.of(voxel)) {
      const auto piece = surface.piece_of_voxel[other];
      if (surface.scene.plane_of_voxel[other] != 0 || piece == own)
        continue;
      around.push_back(piece);
      if (voxel < other)
        contactOf(own, piece, contacts)
            .places.add(0.5 *
                        (loose.positions[i] + loose.positions[entry_of_voxel[other]])
                            .cast<double>());
    }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    for (const auto piece : around) {
      auto& contact = contactOf(own, piece, contacts);
      ++(own < piece ? contact.first_voxels : contact.second_voxels);
    }
  }
}

/** The voxels of a piece within a cell. */
struct CellShare {
  std::uint32_t piece = 0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
  double count = 0;
};

/** What each piece has in a cell, pieces in ascending order. */
std::vector<CellShare>
sharesOf(const LooseVoxels& loose,
         const pcl::indoor::PointCells& cells,
         std::uint32_t cell)
{
  std::map<std::uint32_t, CellShare> share_of_piece;
  for (const auto entry : cells.pointsOf(cell)) {
    auto& share = share_of_piece[loose.pieces[entry]];
    share.place += loose.positions[entry].cast<double>();
    share.normal += loose.normals[entry].cast<double>();
    ++share.count;
  }
  std::vector<CellShare> shares;
  for (auto& [piece, share] : share_of_piece) {
    share.piece = piece;
    share.place /= share.count;
    share.normal.normalize();
    shares.push_back(share);
  }
  return shares;
}

void
addNearPair(const CellShare& a,
            const CellShare& b,
            double voxel_size,
            PieceContact& contact)
{
  const Eigen::Vector3d between = b.place - a.place;
  const double distance = between.norm();
  contact.gap = contact.near_cells == 0 ? distance : std::min(contact.gap, distance);
  ++contact.near_cells;
  contact.near_in_line += std::abs(a.normal.dot(between)) < in_line * voxel_size &&
                          std::abs(b.normal.dot(between)) < in_line * voxel_size;
}

/** Pieces in the same cell or in cells that touch. */
void
addNear(const LooseVoxels& loose, double voxel_size, ContactMap& contacts)
{
  const auto cells =
      pcl::indoor::groupByCell(loose.positions, cell_voxels * voxel_size);
  const auto around = pcl::indoor::cellAdjacency(cells.keys);
  std::vector<std::vector<CellShare>> shares(cells.size());
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell)
    shares[cell] = sharesOf(loose, cells, cell);
  const auto look = [&](const CellShare& a, const CellShare& b) {
    if (a.piece != b.piece)
      addNearPair(a, b, voxel_size, contactOf(a.piece, b.piece, contacts));
  };
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell)
    for (std::size_t i = 0; i < shares[cell].size(); ++i) {
      for (std::size_t j = i + 1; j < shares[cell].size(); ++j)
        look(shares[cell][i], shares[cell][j]);
      for (const auto neighbor : around.of(cell))
        if (neighbor > cell)
          for (const auto& other : shares[neighbor])
            look(shares[cell][i], other);
    }
}

/** How the supervoxels of two pieces bend where they touch. One that is in two pieces
 * counts to that of its last voxel, by place: so the criterion has learned. */
void
addBends(const PieceSurface& surface, ContactMap& contacts)
{
  using pcl::indoor::Supervoxels;
  std::vector<std::uint32_t> piece_of_supervoxel(surface.supervoxels.size(),
                                                 Supervoxels::none);
  for (std::size_t v = 0; v < surface.scene.voxels.size(); ++v)
    if (const auto supervoxel = surface.supervoxels.label_of_voxel[v];
        supervoxel != Supervoxels::none)
      piece_of_supervoxel[supervoxel] = surface.piece_of_voxel[v];
  for (const auto& border :
       pcl::indoor::bendBorders(surface.supervoxels, surface.edges)) {
    const auto a = piece_of_supervoxel[border.source],
               b = piece_of_supervoxel[border.target];
    if (a == b)
      continue;
    auto& contact = contactOf(a, b, contacts);
    contact.bends += border.length;
    contact.bend_sum += border.length * border.cost;
    contact.bend_squares += border.length * border.cost * border.cost;
    contact.concave_bends += border.cost > 0 ? border.length : 0;
  }
}

} // namespace

namespace pcl::indoor {

PieceVotes&
PieceVotes::operator+=(const PieceVotes& other)
{
  for (std::size_t c = 0; c < classes.size(); ++c)
    classes[c] += other.classes[c];
  middles += other.middles;
  return *this;
}

Piece&
Piece::operator+=(const Piece& other)
{
  positions += other.positions;
  normals += other.normals;
  hull = hullOfBoth(hull, other.hull);
  outline = hullOfBoth(outline, other.outline);
  parts += other.parts;
  votes += other.votes;
  return *this;
}

PieceContact&
PieceContact::operator+=(const PieceContact& other)
{
  const bool same = first == other.first;
  first_voxels += same ? other.first_voxels : other.second_voxels;
  second_voxels += same ? other.second_voxels : other.first_voxels;
  places += other.places;
  bends += other.bends;
  bend_sum += other.bend_sum;
  bend_squares += other.bend_squares;
  concave_bends += other.concave_bends;
  if (near_cells == 0 || (other.near_cells > 0 && other.gap < gap))
    gap = other.gap;
  near_cells += other.near_cells;
  near_in_line += other.near_in_line;
  return *this;
}

PieceGraph
pieceGraph(const PieceSurface& surface, const PieceFrame& frame)
{
  const Eigen::Matrix3f axes = frame.axes.cast<float>();
  std::vector<Eigen::Vector3f> places;
  places.reserve(surface.scene.voxels.size());
  for (const auto& centroid : surface.scene.voxels.centroids)
    places.push_back(axes * centroid);
  const auto loose = looseVoxels(surface, places, axes);
  PieceGraph graph;
  graph.voxel_size = frame.voxel_size;
  graph.floor = frame.floor;
  if (!places.empty())
    graph.columns = {places, frame.floor, frame.voxel_size};
  graph.pieces = describePieces(surface, loose, frame.voxel_size);
  graph.has_votes = surface.votes.class_count > 0;
  if (graph.has_votes)
    addVotes(surface, loose, axes, graph.pieces);
  ContactMap contacts;
  addTouching(surface, loose, contacts);
  addNear(loose, frame.voxel_size, contacts);
  addBends(surface, contacts);
  for (const auto& entry : contacts)
    graph.contacts.push_back(entry.second);
  return graph;
}

} // namespace pcl::indoor
