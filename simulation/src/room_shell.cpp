/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "room_shell.h"

#include <algorithm>

namespace pcl {
namespace indoor {

namespace {

using Face = ShellPiece::Face;

void
addQuad(std::vector<ShellPiece>& pieces,
        Face face,
        const Eigen::Vector3d& a,
        const Eigen::Vector3d& b,
        const Eigen::Vector3d& c,
        const Eigen::Vector3d& d)
{
  pieces.push_back({{a.cast<float>(), b.cast<float>(), c.cast<float>()}, face});
  pieces.push_back({{a.cast<float>(), c.cast<float>(), d.cast<float>()}, face});
}

// One wall: upright strips between the ends of the holes, each cut at its holes.
void
addWall(std::vector<ShellPiece>& pieces,
        const RoomInfo& room,
        const Eigen::Vector2d& a,
        const Eigen::Vector2d& b,
        std::vector<WallHole> holes)
{
  const double length = (b - a).norm();
  const Eigen::Vector2d along = (b - a) / length;
  std::sort(holes.begin(), holes.end(), [](const auto& p, const auto& q) {
    return p.z0 < q.z0;
  });
  std::vector<double> cuts{0.0, length};
  for (const auto& hole : holes) {
    cuts.push_back(std::clamp(hole.s0, 0.0, length));
    cuts.push_back(std::clamp(hole.s1, 0.0, length));
  }
  std::sort(cuts.begin(), cuts.end());
  const auto at = [&](double s, double z) {
    const Eigen::Vector2d p = a + s * along;
    return Eigen::Vector3d(p.x(), p.y(), z);
  };
  const auto top = [&](double s) {
    return room.floor + room.ceiling.heightAt(a + s * along);
  };
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double s0 = cuts[i], s1 = cuts[i + 1], middle = (s0 + s1) / 2;
    if (s1 - s0 < 1e-9)
      continue;
    double low = room.floor;
    for (const auto& hole : holes)
      if (hole.s0 < middle && middle < hole.s1) {
        if (hole.z0 > low)
          addQuad(pieces,
                  Face::Wall,
                  at(s1, low),
                  at(s0, low),
                  at(s0, hole.z0),
                  at(s1, hole.z0));
        low = hole.z1;
      }
    addQuad(
        pieces, Face::Wall, at(s1, low), at(s0, low), at(s0, top(s0)), at(s1, top(s1)));
  }
}

} // namespace

std::vector<ShellPiece>
roomShell(const RoomInfo& room, const std::vector<WallHole>& holes)
{
  std::vector<ShellPiece> pieces;
  const auto& polygon = room.polygon;
  for (const auto& t : triangulate(polygon)) {
    Eigen::Vector3f floor[3], ceiling[3];
    for (int k = 0; k < 3; ++k) {
      const auto& p = polygon[t[k]];
      floor[k] = Eigen::Vector3d(p.x(), p.y(), room.floor).cast<float>();
      ceiling[k] = Eigen::Vector3d(p.x(), p.y(), room.floor + room.ceiling.heightAt(p))
                       .cast<float>();
    }
    pieces.push_back({{floor[0], floor[1], floor[2]}, Face::Floor});
    pieces.push_back({{ceiling[0], ceiling[2], ceiling[1]}, Face::Ceiling});
  }
  for (std::size_t e = 0; e < polygon.size(); ++e) {
    std::vector<WallHole> here;
    for (const auto& hole : holes)
      if (hole.edge == static_cast<int>(e))
        here.push_back(hole);
    addWall(pieces, room, polygon[e], polygon[(e + 1) % polygon.size()], here);
  }
  return pieces;
}

std::vector<ShellPiece>
reveal(const PlacedOpening& opening, double y)
{
  std::vector<ShellPiece> pieces;
  const double x = opening.plan.width / 2, z = opening.plan.height;
  const auto at = [&](double px, double py, double pz) {
    const Eigen::Vector2d p =
        opening.origin.head<2>() + px * opening.along + py * opening.towards;
    return Eigen::Vector3d(p.x(), p.y(), opening.origin.z() + pz);
  };
  const double y0 = std::min(y, 0.0), y1 = std::max(y, 0.0);
  const bool threshold = opening.plan.sill < 0.05; // metres: a step, not a parapet
  addQuad(pieces,
          threshold ? Face::Floor : Face::Wall,
          at(-x, y0, 0),
          at(x, y0, 0),
          at(x, y1, 0),
          at(-x, y1, 0));
  addQuad(pieces, Face::Wall, at(-x, y1, z), at(x, y1, z), at(x, y0, z), at(-x, y0, z));
  addQuad(
      pieces, Face::Wall, at(-x, y0, 0), at(-x, y1, 0), at(-x, y1, z), at(-x, y0, z));
  addQuad(pieces, Face::Wall, at(x, y1, 0), at(x, y0, 0), at(x, y0, z), at(x, y1, z));
  return pieces;
}

} // namespace indoor
} // namespace pcl
