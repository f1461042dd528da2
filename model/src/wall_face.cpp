/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/model/wall_face.h>

#include "internal/cross.h"
#include "wall_dimensions.h"

#include <pcl/indoor/parallel_for.h>
#include <pcl/model/model_columns.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

namespace pcl::indoor {
namespace {

using Ring = std::vector<Eigen::Vector2d>;

constexpr double one_run = 0.1; // sine of the turn within one straight run, 6 degrees
constexpr double outline_reach = 0.25; // metres: outlines lie within 1.5 voxels of
                                       // walls, or of the glass in them
constexpr double niche_depth = 0.45; // metres: of walls in which leaves and panes stand

/** Whether a corner lies on the straight line between its neighbours. */
bool
isStraight(const Eigen::Vector2d& before,
           const Eigen::Vector2d& corner,
           const Eigen::Vector2d& after)
{
  const Eigen::Vector2d way = corner - before, on = after - corner;
  const double lengths = way.norm() * on.norm();
  if (lengths == 0.0)
    return true;
  if (way.dot(on) <= 0.0 || std::abs(crossOf(way, on)) > one_run * lengths)
    return false;
  const Eigen::Vector2d whole = after - before;
  return std::abs(crossOf(whole, way)) <= same_line * whole.norm();
}

Ring
straightRuns(const std::vector<Eigen::Vector3d>& line)
{
  Ring ring;
  for (const auto& corner : line)
    ring.push_back(corner.head<2>());
  for (std::size_t i = 0; i < ring.size() && ring.size() > 3;) {
    const auto n = ring.size();
    if (isStraight(ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]))
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  }
  return ring;
}

/** Whether the corners after the first one are those of niches in one wall: none lies
 * far behind the line from the first corner to the one after them or comes back, and
 * the first or the last run lies on that line. */
bool
areOfNiches(const Ring& ring, std::size_t first, std::size_t corners)
{
  constexpr double beside = 0.2; // metres of wall
  constexpr double slack = 0.1;  // metres: where walls were hardly seen
  const auto at = [&](std::size_t k) { return ring[(first + k) % ring.size()]; };
  const Eigen::Vector2d whole = at(corners + 1) - at(0);
  const double length = whole.norm();
  const Eigen::Vector2d along = whole / length;
  double last = 0.0;
  for (std::size_t k = 1; k <= corners; ++k) {
    const Eigen::Vector2d from = at(k) - at(0);
    const double before = crossOf(along, from), place = along.dot(from);
    if (before > slack || before < -niche_depth || place < last - slack ||
        place > length)
      return false;
    last = place;
  }
  const auto isOnLine = [&](std::size_t k) {
    return std::abs(crossOf(along, at(k) - at(0))) <= same_line;
  };
  return (isOnLine(1) && along.dot(at(1) - at(0)) >= beside) ||
         (isOnLine(corners) && along.dot(at(corners + 1) - at(corners)) >= beside);
}

/** Leave out the corners of niches, those of the longest wall first. */
void
bridgeNiches(Ring& ring)
{
  while (ring.size() > 4) {
    double longest = 0.0;
    std::size_t from = 0, corners = 0;
    for (std::size_t first = 0; first < ring.size(); ++first)
      for (std::size_t count = 2; count + 2 < ring.size(); ++count) {
        const double length =
            (ring[(first + count + 1) % ring.size()] - ring[first]).norm();
        if (length > longest && areOfNiches(ring, first, count)) {
          longest = length;
          from = first;
          corners = count;
        }
      }
    if (corners == 0)
      return;
    std::rotate(
        ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(from), ring.end());
    ring.erase(ring.begin() + 1,
               ring.begin() + 1 + static_cast<std::ptrdiff_t>(corners));
  }
}

/** A line before a run: its distance at the begin, and its rise along it. */
struct Offset {
  double at_begin = 0.0, rise = 0.0;
};

/** Numbers of points in bands before a run, for the turn that gives each the most. */
struct BandProfile {
  static constexpr int width = 4; ///< bins of a band: as wide as the noise
  static constexpr double bin = noise_band / width;
  static constexpr int bins = static_cast<int>(2.0 * outline_reach / bin);

  std::array<std::size_t, bins> counts{}; ///< by the first bin
  std::array<double, bins> rises{};

  static double
  middle(int band)
  {
    return bin * (band + 0.5 * width) - outline_reach;
  }
};

BandProfile
bandProfile(const std::vector<WallPoint>& points, double length)
{
  constexpr int turns = 10; // to each side
  const double most_rise = std::min(one_run, outline_reach / length);
  BandProfile profile;
  for (int k = 0; k <= 2 * turns; ++k) {
    // the run's own direction first: of equals it stays
    const double rise = most_rise / turns * (k % 2 == 0 ? k / 2 : -(k + 1) / 2);
    std::array<std::size_t, BandProfile::bins> counts{};
    for (const auto& point : points) {
      const double place = point.before - rise * (point.along - 0.5 * length);
      const int i =
          static_cast<int>(std::floor((place + outline_reach) / BandProfile::bin));
      if (i >= 0 && i < BandProfile::bins)
        ++counts[static_cast<std::size_t>(i)];
    }
    for (std::size_t i = 0; i + BandProfile::width <= counts.size(); ++i) {
      const auto first = counts.begin() + static_cast<std::ptrdiff_t>(i);
      const auto count =
          std::accumulate(first, first + BandProfile::width, std::size_t{0});
      if (count <= profile.counts[i])
        continue;
      profile.counts[i] = count;
      profile.rises[i] = rise;
    }
  }
  return profile;
}

/** The line that most points share. */
std::optional<Offset>
fullestLine(const std::vector<WallPoint>& points, double length)
{
  const auto profile = bandProfile(points, length);
  const auto most = std::max_element(profile.counts.begin(), profile.counts.end());
  if (*most < enough_points)
    return std::nullopt;
  const auto band = static_cast<int>(most - profile.counts.begin());
  const double rise = profile.rises[static_cast<std::size_t>(band)];
  return Offset{BandProfile::middle(band) - 0.5 * rise * length, rise};
}

/** The points below the ceiling and beside the corners: a wall goes on to these, leaves
 * and glazed fronts, which may fill most of it, do not. */
std::vector<WallPoint>
atBorders(const std::vector<WallPoint>& points, const WallFace& face)
{
  constexpr double border = 0.35; // metres
  std::vector<WallPoint> found;
  for (const auto& point : points)
    if (point.along < border || point.along > face.length() - border ||
        point.height > face.ceiling - border)
      found.push_back(point);
  return found;
}

/** Least squares of the points within a band around a line. */
std::optional<Offset>
fitted(const std::vector<WallPoint>& points, const Offset& line, double band)
{
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const auto& point : points) {
    const double along = point.along, before = point.before;
    if (std::abs(before - line.at_begin - line.rise * along) > band)
      continue;
    n += 1.0;
    x += along;
    y += before;
    xx += along * along;
    xy += along * before;
  }
  const double spread = n * xx - x * x;
  if (n < static_cast<double>(enough_points) || spread <= 1e-6 * n * n)
    return std::nullopt;
  const double rise = (n * xy - x * y) / spread;
  return Offset{(y - rise * x) / n, rise};
}

/** Move and turn a run to the points that lie on it. */
void
fitToPoints(const PointsOfRooms& points, WallFace& face)
{
  constexpr double from_slabs = 0.1; // metres: floor and ceiling are no wall
  constexpr double from_corners = 0.1;
  FaceStretch stretch{face.begin, face.end, 0.0, outline_reach, outline_reach};
  if (face.length() > 4.0 * from_corners)
    stretch.margin = -from_corners;
  std::vector<WallPoint> near;
  points.beside(stretch, face.room, false, near);
  near.erase(std::remove_if(near.begin(),
                            near.end(),
                            [&](const WallPoint& point) {
                              return point.height < face.floor + from_slabs ||
                                     point.height > face.ceiling - from_slabs;
                            }),
             near.end());
  auto found = fullestLine(atBorders(near, face), face.length());
  if (!found)
    found = fullestLine(near, face.length());
  if (!found)
    return;
  Offset line = *found;
  for (int round = 0; round < 2; ++round)
    if (const auto next = fitted(near, line, scanner_noise);
        next && std::abs(next->rise) < 2.0 * one_run)
      line = *next;
  face.is_seen = true;
  const Eigen::Vector2d inward = face.inward();
  const double length = face.length();
  face.begin += line.at_begin * inward;
  face.end += (line.at_begin + line.rise * length) * inward;
}

/** Let the runs of an outline end where they meet. */
void
joinCorners(const std::vector<WallFace>::iterator& faces, std::size_t count)
{
  const std::vector<WallFace> before(faces, faces + static_cast<std::ptrdiff_t>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t last = (i + count - 1) % count;
    const WallFace &one = before[last], &next = before[i];
    const double turn = crossOf(one.along(), next.along());
    if (std::abs(turn) <= flat_corner)
      continue;
    const double step = crossOf(next.begin - one.begin, next.along()) / turn;
    const Eigen::Vector2d corner = one.begin + step * one.along();
    faces[static_cast<std::ptrdiff_t>(last)].end = corner;
    faces[static_cast<std::ptrdiff_t>(i)].begin = corner;
  }
  for (std::size_t i = 0; i < count; ++i) { // those that turned over stay
    WallFace& face = faces[static_cast<std::ptrdiff_t>(i)];
    if ((face.end - face.begin).dot(before[i].along()) <= 0.0)
      face = before[i];
  }
}

} // namespace

std::vector<WallFace>
wallFaces(const std::vector<Room>& rooms, const PointsOfRooms& points, int threads)
{
  std::vector<WallFace> faces;
  std::vector<std::size_t> outlines; // first face of each
  for (const Room& room : rooms)
    for (const auto& line : room.footprint) {
      if (isColumn(line))
        continue;
      outlines.push_back(faces.size());
      Ring ring = straightRuns(line);
      bridgeNiches(ring);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        WallFace face;
        face.room = room.label;
        face.storey = room.storey;
        face.begin = ring[i];
        face.end = ring[(i + 1) % ring.size()];
        face.floor = line.front().z();
        face.ceiling = face.floor + room.height;
        if (face.length() > 1e-3)
          faces.push_back(face);
      }
    }
  parallelFor(static_cast<std::ptrdiff_t>(faces.size()),
              threads,
              1,
              [&](std::ptrdiff_t i) { fitToPoints(points, faces[i]); });
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    const auto end = k + 1 < outlines.size() ? outlines[k + 1] : faces.size();
    if (end - outlines[k] >= 3)
      joinCorners(faces.begin() + static_cast<std::ptrdiff_t>(outlines[k]),
                  end - outlines[k]);
  }
  return faces;
}

} // namespace pcl::indoor
