/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "wall_niche.h"

#include "hole_edges.h"
#include "wall_dimensions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pcl::indoor {
namespace {

constexpr double widest_frame = 0.16; // metres

/** A surface that stands out of a wall's plane beside an edge of a hole. */
struct Jamb {
  double beyond = 0.0; ///< the edge, metres
  double share = 0.0;  ///< of the edge along which it is seen
};

/** The jamb beside an edge: where most points before the plane lie within a narrow
 * band.
 * \param[in] points before the plane: beyond the edge, and along it
 */
Jamb
jambOf(std::vector<std::pair<double, double>> points, double length, double piece)
{
  std::sort(points.begin(), points.end());
  std::size_t first = 0, end = 0;
  for (std::size_t i = 0, j = 0; i < points.size(); ++i) {
    while (j < points.size() && points[j].first <= points[i].first + noise_band)
      ++j;
    if (j - i > end - first) {
      first = i;
      end = j;
    }
  }
  Jamb jamb;
  if (end - first < 3)
    return jamb;
  std::vector<std::uint8_t> seen(static_cast<std::size_t>(std::ceil(length / piece)));
  for (std::size_t i = first; i < end; ++i)
    seen[std::min(static_cast<std::size_t>(points[i].second / piece),
                  seen.size() - 1)] = 1;
  jamb.beyond = points[(first + end) / 2].first;
  jamb.share = seenShareOf(seen);
  return jamb;
}

/** The share of what a frame may cover beyond an edge in which objects before the wall
 * hide it. */
double
hiddenShare(const WallImage& image, const FaceHole& hole, std::size_t side)
{
  Eigen::AlignedBox2d beyond = hole.box;
  const Eigen::Index axis = side < 2 ? 0 : 1;
  if (side == 0 || side == 3) {
    beyond.max()[axis] = hole.box.min()[axis];
    beyond.min()[axis] = beyond.max()[axis] - widest_frame;
  }
  else {
    beyond.min()[axis] = hole.box.max()[axis];
    beyond.max()[axis] = beyond.min()[axis] + widest_frame;
  }
  return image.share(beyond, WallCell::Front) + image.share(beyond, WallCell::Proud);
}

using Edges = std::array<Jamb, 4>; ///< left, right, above, below

constexpr double mostly = 0.6; // share of an edge

/** Which point lies how far beyond which edge, and where along it. */
Edges
jambsAround(const WallImage& image,
            const std::vector<WallPoint>& points,
            const Eigen::AlignedBox2d& box)
{
  constexpr double nearest = 0.04, reach = 0.25; // metres, before the plane
  // a ceiling is the end only of a niche that goes down to the floor
  constexpr double slab = 0.05, near_floor = 0.3; // metres
  const Eigen::Vector2d sizes = box.sizes();
  const double ceiling = image.floor + image.cell * (image.cells.ny - 1);
  const double top =
      box.min().y() > image.floor + near_floor ? ceiling - slab : INFINITY;
  std::array<std::vector<std::pair<double, double>>, 4> beside;
  const auto add = [&](std::size_t side, double beyond, double along) {
    const double length = sizes[side < 2];
    if (beyond > -0.02 && beyond < widest_frame && along >= 0.0 && along <= length)
      beside[side].emplace_back(beyond, along);
  };
  for (const auto& point : points) {
    if (point.before < nearest || point.before > reach || point.height > top)
      continue;
    forEachEdge(box, point, add);
  }
  Edges jambs;
  for (std::size_t side = 0; side < 4; ++side)
    jambs[side] = jambOf(std::move(beside[side]), sizes[side < 2], edgePiece(image));
  return jambs;
}

} // namespace

void
growToNiche(const WallImage& image,
            const std::vector<WallPoint>& points,
            FaceHole& hole)
{
  const auto jambs = jambsAround(image, points, hole.box);
  const auto is_seen = [](const Jamb& jamb) { return jamb.share >= mostly; };
  if (std::count_if(jambs.begin(), jambs.end(), is_seen) < 3)
    return;
  for (std::size_t side = 0; side < 4; ++side) {
    double& framed = hole.framed[side];
    if (!is_seen(jambs[side])) { // what hides this side is the niche's, too
      framed = std::max(framed, hiddenShare(image, hole, side));
      continue;
    }
    framed = std::max(framed, jambs[side].share);
    const auto axis = static_cast<Eigen::Index>(side < 2 ? 0 : 1);
    const double beyond = std::max(0.0, jambs[side].beyond);
    if (side == 0 || side == 3)
      hole.box.min()[axis] -= beyond;
    else
      hole.box.max()[axis] += beyond;
  }
}

} // namespace pcl::indoor
