/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "internal/extent_along.h"
#include "rooms/floor_side.h"
#include "rooms/scan_sample.h"

#include <pcl/segmentation/building_frame.h> // for turnUpright
#include <pcl/segmentation/scan_overview.h>
#include <pcl/segmentation/scan_warnings.h> // for metresPerUnit

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl::indoor {
namespace {

using Points = std::vector<Eigen::Vector3f>;
using Pieces = std::vector<SurfacePiece>;

constexpr double degree = M_PI / 180.0;

/** Maps are seldom more level than this, and rooms come out the same: a corridor of
 * 40 m rises by 0.7 m. */
constexpr double level_tilt = 1.0 * degree;

constexpr double coarse_limit = 10.0 * degree; // twice the step of the directions

/** How a piece of surface lies to a direction: 1 across it, as floors do, -1 along it,
 * as walls do, and nearer to 0 the more it is inclined, up to a limit. */
double
alignment(const SurfacePiece& piece, const Eigen::Vector3d& direction, double limit)
{
  const double cosine = piece.normal.dot(direction);
  const double along = cosine * cosine, most = std::pow(std::sin(limit), 2);
  return std::max(0.0, 1.0 - (1.0 - along) / most) - std::max(0.0, 1.0 - along / most);
}

/** The share of the pieces that lie across a direction or along it. */
double
agreement(const Pieces& pieces, const Eigen::Vector3d& direction)
{
  double sum = 0.0;
  for (const auto& piece : pieces)
    sum += std::abs(alignment(piece, direction, coarse_limit));
  return sum / static_cast<double>(pieces.size());
}

/** A direction that might be the vertical. */
struct Candidate {
  Eigen::Vector3d direction;
  double agreement = 0.0;
  double across = 0.0; ///< share of the pieces that tell the direction from others
  double along = 0.0;  ///< share of walls
  double uprightness = 0.0;
  double room_height = 0.0;
  bool is_covered = false; ///< most columns have something below and above
  bool has_rooms = false;  ///< the same, as far apart as floors and ceilings

  /** Sine of the angle to +z or -z. */
  double
  tilt() const
  {
    return std::hypot(direction.x(), direction.y());
  }
};

/** What the normals of floors are most along and those of walls least: the last of the
 * eigenvectors of their moments, with shares of all surface as eigenvalues. */
Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>
solved(const Pieces& pieces, const Eigen::Vector3d& direction, double limit)
{
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const auto& piece : pieces)
    sum += alignment(piece, direction, limit) * piece.normal * piece.normal.transpose();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(
      sum / static_cast<double>(pieces.size()));
}

/** The candidate near a direction. */
Candidate
refined(const Pieces& pieces, Eigen::Vector3d direction)
{
  for (const double limit : {10.0, 5.0, 3.0, 3.0}) { // degrees
    const Eigen::Vector3d turned =
        solved(pieces, direction, limit * degree).eigenvectors().col(2);
    direction = turned.dot(direction) < 0.0 ? Eigen::Vector3d(-turned) : turned;
  }
  Candidate candidate;
  const Eigen::Vector3d shares = solved(pieces, direction, coarse_limit).eigenvalues();
  candidate.across = shares[2] - shares[1];
  candidate.along = -shares[0] - std::min(0.0, shares[1]);
  candidate.direction = direction.z() < 0.0 ? Eigen::Vector3d(-direction) : direction;
  candidate.agreement = agreement(pieces, direction);
  return candidate;
}

/** Directions all over the half sphere, from +z. */
std::vector<Eigen::Vector3d>
directionsAllOver()
{
  constexpr int rings = 18; // 5 degrees apart
  std::vector<Eigen::Vector3d> directions;
  for (int ring = 0; ring <= rings; ++ring) {
    const double polar = 0.5 * M_PI * ring / rings;
    const int count = std::max(1, static_cast<int>(4.0 * rings * std::sin(polar)));
    for (int i = 0; i < count; ++i) {
      const double azimuth = 2.0 * M_PI * i / count;
      directions.emplace_back(std::sin(polar) * std::cos(azimuth),
                              std::sin(polar) * std::sin(azimuth),
                              std::cos(polar));
    }
  }
  return directions;
}

/** The directions that most of the surface agrees with, compared with others near them;
 * the best first. */
std::vector<Candidate>
candidatesOf(const Pieces& pieces)
{
  constexpr double enough = 0.55; // floors have at least 0.63 of the best
  const double near = std::cos(15.0 * degree);
  const auto directions = directionsAllOver();
  std::vector<double> agreements;
  for (const auto& direction : directions)
    agreements.push_back(agreement(pieces, direction));
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const auto is_beaten_by = [&](std::size_t j) {
      return (agreements[j] > agreements[i] ||
              (agreements[j] == agreements[i] && j < i)) &&
             std::abs(directions[i].dot(directions[j])) > near;
    };
    bool is_best = agreements[i] > 0.0;
    for (std::size_t j = 0; is_best && j < directions.size(); ++j)
      is_best = !is_beaten_by(j);
    if (is_best)
      candidates.push_back(refined(pieces, directions[i]));
  }
  std::stable_sort(
      candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
        return a.agreement > b.agreement;
      });
  const auto is_weak = [&](const Candidate& candidate) {
    return candidate.agreement < enough * candidates.front().agreement;
  };
  candidates.erase(std::find_if(candidates.begin(), candidates.end(), is_weak),
                   candidates.end());
  return candidates;
}

/** The mean size of the plane that a piece of surface across a direction lies in, as
 * share of all surface. */
double
planeShare(const Pieces& pieces, const Eigen::Vector3d& direction, double thickness)
{
  std::vector<double> at;
  for (const auto& piece : pieces)
    if (std::abs(piece.normal.dot(direction)) > std::cos(14.0 * degree))
      at.push_back(piece.place.dot(direction));
  if (at.empty())
    return 0.0;
  std::sort(at.begin(), at.end());
  double together = 0.0;
  for (std::size_t i = 0, from = 0, to = 0; i < at.size(); ++i) {
    for (; at[i] - at[from] > thickness; ++from)
      ;
    for (; to < at.size() && at[to] - at[i] <= thickness; ++to)
      ;
    together += static_cast<double>(to - from);
  }
  return together / static_cast<double>(at.size() * pieces.size());
}

/** The free space along a direction, in columns that are turned about it. */
FreeSpace
freeSpaceAlong(const Points& sample,
               const Eigen::Vector3d& direction,
               double cell_size,
               double yaw = 0.0)
{
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix() *
      turnUpright(direction.cast<float>());
  Points turned;
  turned.reserve(sample.size());
  for (const auto& point : sample)
    turned.emplace_back((turn * point.cast<double>()).cast<float>());
  return freeSpaceOf(turned, cubeAround(turned, cell_size));
}

/** The share of the columns that have floor and ceiling: 0.4 to 0.9 in complete scans.
 */
double
roomShare(const FreeSpace& space)
{
  return space.columns == 0 ? 0.0
                            : static_cast<double>(space.gaps.size()) /
                                  static_cast<double>(space.columns);
}

/** A free length is the height of rooms in one of the units. */
bool
isRoomHeight(double length)
{
  constexpr double low = 1.9, high = 6.0; // metres
  const double height = length * likelyMetresPerUnit(length);
  return low <= height && height <= high;
}

/** Floors and ceilings lie in few planes with little space between them, so the
 * vertical has the largest plane share over free length. */
void
measure(const Pieces& pieces,
        const Points& sample,
        double cell_size,
        std::vector<Candidate>& candidates)
{
  constexpr double enough = 0.3; // of the columns
  for (auto& candidate : candidates) {
    const double share = planeShare(pieces, candidate.direction, 0.25 * cell_size);
    const auto space = freeSpaceAlong(sample, candidate.direction, cell_size);
    candidate.room_height = space.length();
    candidate.is_covered = roomShare(space) > enough;
    candidate.has_rooms = candidate.is_covered && isRoomHeight(candidate.room_height);
    if (candidate.room_height > 0.0)
      candidate.uprightness = share / candidate.room_height;
  }
}

/** A map may be tilted by 45 degrees; more needs stronger evidence. */
bool
isNearZ(const Candidate& candidate)
{
  return candidate.tilt() < std::sin(46.0 * degree);
}

/** The candidate that is nearest to z, but for one that is clearly more upright.
 * \param[out] doubtful another one that might be the vertical */
Candidate
mostUpright(std::vector<Candidate> candidates,
            const Pieces& pieces,
            const Points& sample,
            double cell_size,
            Eigen::Vector3f& doubtful)
{
  constexpr double clearly = 1.6; // few scans that stand upright have another with it
  std::sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
    return a.tilt() < b.tilt();
  });
  measure(pieces, sample, cell_size, candidates);
  const auto& first = candidates.front();
  const auto best = *std::max_element(
      candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
        return a.uprightness < b.uprightness;
      });
  // Rooms, and buildings, are wider than high.
  const bool is_clear = first.uprightness > 0.0 &&
                        best.uprightness > clearly * first.uprightness &&
                        best.room_height < first.room_height &&
                        extentAlong(best.direction.cast<float>(), sample) <
                            extentAlong(first.direction.cast<float>(), sample);
  const bool is_far = first.tilt() > 0.5 && isNearZ(best); // both by 30 to 46 degrees
  if (is_clear && !best.has_rooms && !is_far)
    doubtful = best.direction.cast<float>();
  return is_clear && (best.has_rooms || is_far) ? best : first;
}

/** Point upwards as far as furniture tells. */
void
chooseEnd(const Points& sample,
          const Candidate& candidate,
          double cell_size,
          Vertical& vertical)
{
  constexpr int views = 4; // furniture stands at angles to the columns
  const bool is_near_z = isNearZ(candidate);
  ObjectsAtEnds objects;
  for (int view = 0; view < views && candidate.is_covered; ++view) {
    const double yaw = 0.5 * M_PI * view / views;
    objects +=
        objectsAtEnds(freeSpaceAlong(sample, candidate.direction, cell_size, yaw));
    if (is_near_z && objects.low >= objects.high)
      break; // as it should be
  }
  // Scans that lie upside down are rare, and real ones that stand upright have up
  // to 1.9 times as many objects at their ceilings.
  constexpr double certainly = 3.0; // times as many
  const int certain_end = objects.clearEnd(certainly);
  const int end = candidate.has_rooms ? objects.clearEnd() : certain_end;
  int axis = 0; // that the direction is most along
  candidate.direction.cwiseAbs().maxCoeff(&axis);
  const bool is_turned =
      is_near_z ? candidate.has_rooms && certain_end == 1
                : end == 1 || (end == 0 && candidate.direction[axis] < 0.0);
  vertical.direction = candidate.direction.cast<float>();
  if (is_turned)
    vertical.direction = -vertical.direction;
  vertical.is_end_known = is_near_z ? end != 1 || is_turned : end != 0;
  vertical.is_furnished = objects.clearEnd() != 0; // of halls, too
}

/** 0 if the points are too few for floors and ceilings. */
double
cellSizeOf(const Points& sample)
{
  constexpr std::size_t enough = 1000; // points
  return sample.size() < enough ? 0.0 : cellsOf(sample).size;
}

Vertical
verticalOf(const Points& sample, const Eigen::Vector3d& direction, double cell_size)
{
  Vertical vertical;
  vertical.direction = direction.cast<float>();
  if (!(cell_size > 0.0))
    return vertical;
  const auto space = freeSpaceAlong(sample, direction, cell_size);
  vertical.room_height = space.length();
  vertical.has_rooms = roomShare(space) > 0.45;
  return vertical;
}

} // namespace

double
Vertical::tilt() const
{
  return std::acos(std::clamp(static_cast<double>(direction.z()), -1.0, 1.0));
}

Eigen::Vector3f
Vertical::upAxis() const
{
  if (!is_found)
    return Eigen::Vector3f::UnitZ();
  int axis = 0; // that the direction is most along
  const auto most = static_cast<double>(direction.cwiseAbs().maxCoeff(&axis));
  if (most < std::cos(level_tilt))
    return direction;
  return std::copysign(1.0f, direction[axis]) * Eigen::Vector3f::Unit(axis);
}

Vertical
findVertical(const Points& points)
{
  constexpr std::size_t enough_pieces = 50; // of surface: some walls and a floor
  constexpr double enough_agreement = 0.3;  // buildings have 0.34 to 0.87, a ball 0.1
  constexpr double enough = 0.08;           // of all surface
  const auto sample = samplePoints(points);
  const double cell_size = cellSizeOf(sample);
  if (!(cell_size > 0.0))
    return {};
  const auto pieces = surfacePieces(sample, cubeAround(sample, cell_size));
  auto vertical = verticalOf(sample, Eigen::Vector3d::UnitZ(), cell_size);
  if (pieces.size() < enough_pieces)
    return vertical;
  const auto candidates = candidatesOf(pieces);
  if (candidates.empty())
    return vertical;
  const auto best =
      mostUpright(candidates, pieces, sample, cell_size, vertical.doubtful);
  const bool is_weak =
      best.agreement < enough_agreement || best.across < enough || best.along < enough;
  if (is_weak || !(best.has_rooms || isNearZ(best)))
    return vertical;
  vertical.is_found = true;
  chooseEnd(sample, best, cell_size, vertical);
  if (vertical.upAxis() != Eigen::Vector3f::UnitZ())
    vertical.room_height = best.room_height;
  return vertical;
}

Vertical
verticalAlong(const Eigen::Vector3f& up_axis, const Points& points)
{
  const auto sample = samplePoints(points);
  auto vertical =
      verticalOf(sample, up_axis.normalized().cast<double>(), cellSizeOf(sample));
  vertical.is_found = vertical.is_end_known = true;
  return vertical;
}

ScanCoordinates
scanCoordinates(const Points& points,
                const std::optional<Eigen::Vector3f>& up_axis,
                std::optional<double> metres_per_unit)
{
  ScanCoordinates found;
  found.vertical = up_axis ? verticalAlong(*up_axis, points) : findVertical(points);
  found.up_axis = up_axis ? found.vertical.direction : found.vertical.upAxis();
  found.metres_per_unit =
      metres_per_unit.value_or(metresPerUnit(found.vertical.room_height));
  return found;
}

} // namespace pcl::indoor
