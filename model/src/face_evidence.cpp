/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "face_evidence.h"

#include "wall_dimensions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace pcl::indoor {
namespace {

constexpr double least = 0.2; // metres of wall that say something

/** Where an opening lies in a side, from and to along it. */
std::optional<std::pair<double, double>>
stretchIn(const WallFace& face, const ModelOpening& opening)
{
  constexpr double parallel = 0.95; // cosine, 18 degrees
  const Eigen::Vector2d along = face.along();
  const Eigen::Vector2d way = opening.position.head<2>() - face.begin;
  const double middle = along.dot(way);
  if ((opening.room_a != face.room && opening.room_b != face.room) ||
      std::abs(along.dot(opening.along)) < parallel ||
      std::abs(face.inward().dot(way)) > half_thickest ||
      opening.position.z() > face.ceiling ||
      opening.position.z() + opening.height < face.floor)
    return std::nullopt;
  const std::pair stretch(middle - 0.5 * opening.width, middle + 0.5 * opening.width);
  if (stretch.first >= face.length() || stretch.second <= 0.0)
    return std::nullopt;
  return stretch;
}

/** What is seen of a side beside its openings, 0 to 1. */
double
seenShare(const WallFace& face,
          SeenColumns columns,
          const std::vector<ModelOpening>& openings)
{
  if (columns.share.empty())
    return 0.0;
  bool is_door_or_window = false;
  for (const ModelOpening& opening : openings)
    if (const auto stretch = stretchIn(face, opening)) {
      is_door_or_window |= opening.kind != ModelOpeningKind::Passage;
      for (std::size_t i = 0; i < columns.share.size(); ++i) {
        const double place = (static_cast<double>(i) + 0.5) * columns.cell;
        if (place > stretch->first && place < stretch->second)
          columns.share[i] = -1.0;
      }
    }
  double sum = 0.0, count = 0.0;
  for (const double share : columns.share)
    if (share >= 0.0) {
      sum += share;
      count += 1.0;
    }
  if (count * columns.cell >= least)
    return sum / count;
  return is_door_or_window ? 1.0 : 0.0;
}

/** What the sides of a room show in general, though some be open: the value that three
 * quarters of their length do not exceed; 0 of none. */
double
usualShare(std::vector<std::pair<double, double>> shares)
{
  std::sort(shares.begin(), shares.end());
  double all = 0.0, sum = 0.0;
  for (const auto& [share, length] : shares)
    all += length;
  for (const auto& [share, length] : shares) {
    sum += length;
    if (sum >= 0.75 * all)
      return share;
  }
  return 0.0;
}

/** How far behind a side the windows and doors to the outside are, metres. */
double
depthOf(const WallFace& face,
        const FaceHoles& holes,
        const std::vector<ModelOpening>& openings)
{
  double depth = 0.0;
  for (const ModelOpening& opening : openings) {
    const auto stretch = stretchIn(face, opening);
    if (!stretch || opening.room_b > 0 || opening.is_open)
      continue;
    const Eigen::Vector2d middle(0.5 * (stretch->first + stretch->second),
                                 opening.position.z() + 0.5 * opening.height);
    for (const FaceHole& hole : holes)
      if (!hole.is_proud && hole.box.contains(middle))
        depth = std::max(depth, -hole.depth);
  }
  return depth;
}

} // namespace

SeenColumns
seenColumns(const WallImage& image)
{
  SeenColumns columns;
  columns.cell = image.cell;
  for (int x = 0; x < image.cells.nx; ++x) {
    double seen = 0.0, open = 0.0;
    for (int y = 0; y < image.cells.ny; ++y) {
      const WallCell cell = image.cells.at(x, y);
      seen += cell != WallCell::Empty && cell != WallCell::Front;
      open += cell != WallCell::Front;
    }
    columns.share.push_back(open > 0.0 ? seen / open : -1.0);
  }
  return columns;
}

std::vector<FaceEvidence>
faceEvidence(const std::vector<WallFace>& faces,
             const std::vector<SeenColumns>& columns,
             const std::vector<FaceHoles>& holes,
             const std::vector<ModelOpening>& openings)
{
  std::vector<double> seen(faces.size());
  std::map<std::uint32_t, std::vector<std::pair<double, double>>> of_rooms;
  std::vector<FaceEvidence> evidence(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    seen[i] = seenShare(faces[i], columns[i], openings);
    of_rooms[faces[i].room].emplace_back(seen[i], faces[i].length());
    evidence[i].depth = depthOf(faces[i], holes[i], openings);
  }
  for (std::size_t i = 0; i < faces.size(); ++i)
    evidence[i].is_wall = seen[i] >= 0.5 * usualShare(of_rooms[faces[i].room]);
  return evidence;
}

} // namespace pcl::indoor
