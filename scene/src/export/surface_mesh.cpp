/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/surface_mesh.h"

#include "export/plan_boxes.h"

#include <algorithm>
#include <vector>

namespace pcl::indoor::tool {
namespace {

/** A convex face, its corners counter-clockwise; some may fall together. */
void
addFace(SurfaceMesh& mesh,
        const std::vector<Eigen::Vector3d>& corners,
        const Eigen::Vector3d& normal)
{
  const auto first = static_cast<std::uint32_t>(mesh.corners.size());
  for (const auto& corner : corners) {
    mesh.corners.push_back(corner.cast<float>());
    mesh.normals.push_back(normal.cast<float>());
  }
  for (std::uint32_t i = 2; i < corners.size(); ++i)
    for (const std::uint32_t corner : {0u, i - 1, i})
      mesh.triangles.push_back(first + corner);
}

/** Where a side that crosses a band of heights lies at its lower and upper end. */
struct BandSide {
  double low = 0.0, high = 0.0;

  bool
  operator<(const BandSide& other) const
  {
    return low + high < other.low + other.high;
  }
};

std::vector<BandSide>
sidesAcross(const std::vector<PlanRing>& rings, double low, double high)
{
  std::vector<BandSide> sides;
  forEachSideAcross(rings, 0.5 * (low + high), [&](const auto& a, const auto& b) {
    sides.push_back({xOfSide(a, b, low), xOfSide(a, b, high)});
  });
  std::sort(sides.begin(), sides.end());
  return sides;
}

/** A part of a wall's side: along the wall from its begin, and upwards. */
struct WallPart {
  double begin, end, bottom, top;
};

/** What of a wall is left beside its openings, below and above them. */
std::vector<WallPart>
partsOf(const SavedScene& scene, std::size_t index)
{
  const auto& wall = scene.walls[index];
  const Eigen::Vector2d way = wall.end - wall.begin;
  std::vector<WallPart> holes;
  std::vector<double> cuts = {0.0, way.norm()};
  for (const auto& opening : scene.openings) {
    if (opening.wall != index)
      continue;
    const double at = (opening.position.head<2>() - wall.begin).dot(way.normalized());
    const double bottom = opening.position.z();
    holes.push_back({at - 0.5 * opening.width,
                     at + 0.5 * opening.width,
                     bottom,
                     bottom + opening.height});
    for (const double cut : {holes.back().begin, holes.back().end})
      cuts.push_back(std::clamp(cut, 0.0, way.norm()));
  }
  std::sort(cuts.begin(), cuts.end());
  std::vector<WallPart> parts;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double middle = 0.5 * (cuts[i] + cuts[i + 1]);
    if (!(cuts[i + 1] > cuts[i]))
      continue;
    std::vector<WallPart> here;
    for (const auto& hole : holes)
      if (hole.begin < middle && hole.end > middle)
        here.push_back(hole);
    std::sort(here.begin(), here.end(), [](const auto& a, const auto& b) {
      return a.bottom < b.bottom;
    });
    double height = wall.floor;
    const double top = wall.floor + wall.height;
    for (const auto& hole : here) {
      if (hole.bottom > height)
        parts.push_back({cuts[i], cuts[i + 1], height, std::min(hole.bottom, top)});
      height = std::max(height, hole.top);
    }
    if (top > height)
      parts.push_back({cuts[i], cuts[i + 1], height, top});
  }
  return parts;
}

} // namespace

SurfaceMesh
flatMesh(const std::vector<PlanRing>& rings, double height)
{
  SurfaceMesh mesh;
  std::vector<double> heights;
  for (const auto& ring : rings)
    for (const auto& corner : ring)
      heights.push_back(corner.y());
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    const double low = heights[i], high = heights[i + 1];
    const auto sides = sidesAcross(rings, low, high);
    for (std::size_t s = 0; s + 1 < sides.size(); s += 2) {
      const auto &left = sides[s], &right = sides[s + 1];
      addFace(mesh,
              {Eigen::Vector3d(left.low, low, height),
               Eigen::Vector3d(right.low, low, height),
               Eigen::Vector3d(right.high, high, height),
               Eigen::Vector3d(left.high, high, height)},
              Eigen::Vector3d::UnitZ());
    }
  }
  return mesh;
}

void
addPrism(SurfaceMesh& mesh, const PlanRing& corners, double bottom, double top)
{
  std::vector<Eigen::Vector3d> lower, upper;
  for (const auto& corner : corners) {
    lower.emplace_back(corner.x(), corner.y(), bottom);
    upper.emplace_back(corner.x(), corner.y(), top);
  }
  std::reverse(lower.begin(), lower.end());
  addFace(mesh, lower, -Eigen::Vector3d::UnitZ());
  addFace(mesh, upper, Eigen::Vector3d::UnitZ());
  for (std::size_t i = 0; i < upper.size(); ++i) {
    const auto& next = upper[(i + 1) % upper.size()];
    const Eigen::Vector3d way = (next - upper[i]).normalized();
    const Eigen::Vector3d down(0.0, 0.0, top - bottom);
    addFace(mesh,
            {upper[i] - down, next - down, next, upper[i]},
            Eigen::Vector3d(way.y(), -way.x(), 0.0));
  }
}

SurfaceMesh
wallMesh(const SavedScene& scene, std::size_t index)
{
  SurfaceMesh mesh;
  const auto& wall = scene.walls[index];
  const Eigen::Vector2d way = (wall.end - wall.begin).normalized();
  for (const auto& part : partsOf(scene, index)) {
    auto piece = wall;
    piece.begin = wall.begin + part.begin * way;
    piece.end = wall.begin + part.end * way;
    addPrism(mesh, wallBox(piece), part.bottom, part.top);
  }
  return mesh;
}

} // namespace pcl::indoor::tool
