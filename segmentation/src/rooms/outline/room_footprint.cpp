/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/outline/room_footprint.h"

#include "rooms/outline/line_meeting.h"
#include "rooms/outline/place_profile.h"
#include "rooms/outline/room_outline.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl::indoor {
namespace {

using Ring = std::vector<Eigen::Vector2d>;

/** A line with the room on its left. */
struct Line {
  Eigen::Vector2d point, along; ///< along is a unit vector

  Eigen::Vector2d
  outward() const
  {
    return {along.y(), -along.x()};
  }

  double
  distance(const Eigen::Vector2d& place) const
  {
    return outward().dot(place - point);
  }

  Eigen::Vector2d
  foot(const Eigen::Vector2d& place) const
  {
    return place - distance(place) * outward();
  }
};

struct Side {
  Eigen::Vector2d begin; ///< its first corner in the ring
  Line line;
  bool is_wall = false;
};

constexpr double before = 0.7, behind_side = 2.0; // where walls are looked for, pixels
constexpr double crowd_pixels =
    0.4; // pixels: two standard deviations of a scanner's noise
constexpr double long_enough = 4.0; // pixels; shorter sides tell no direction

/** Fits a line to the face behind a side. */
class FaceFit {
public:
  FaceFit(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const WallPoints& points)
  : side_{a, (b - a).normalized()}
  , length_((b - a).norm())
  , margin_(length_ > 3.0 ? 1.0 : 0.0) // at the ends the next walls begin
  {
    points.alongLine(a, b, behind_side, near_);
  }

  /** The side as a whole, or turned, if more points lie on it then. */
  std::optional<Line>
  fit() const
  {
    const auto whole = face(side_, margin_, length_ - margin_);
    if (!whole)
      return std::nullopt;
    const Line moved{side_.point + *whole * side_.outward(), side_.along};
    if (length_ < long_enough)
      return moved;
    Line turned = side_;
    for (int round = 0; round < 2; ++round) {
      const double middle = 0.5 * length_;
      const auto first = face(turned, margin_, middle);
      const auto second = face(turned, middle, length_ - margin_);
      if (!first || !second)
        return moved;
      const double apart = 0.5 * length_ - margin_ + 0.5 * margin_;
      const Eigen::Vector2d from = turned.point +
                                   0.5 * (margin_ + middle) * turned.along +
                                   *first * turned.outward();
      const Eigen::Vector2d along =
          apart * turned.along + (*second - *first) * turned.outward();
      turned.along = along.normalized();
      turned.point = from - 0.5 * (margin_ + middle) * turned.along;
    }
    return pointsOn(turned) > pointsOn(moved) ? turned : moved;
  }

  /** Whether enough of a side lies on a line: two thirds of it, or
   * five pixels. What crosses it covers a piece. */
  bool
  covers(const Line& line) const
  {
    constexpr double enough = 5.0; // pixels
    std::vector<std::uint8_t> is_covered(static_cast<std::size_t>(length_) + 1, 0);
    for (const auto& point : near_) {
      const double place = line.along.dot(point - line.point);
      if (place >= 0.0 && place <= length_ && isOn(line, point))
        is_covered[static_cast<std::size_t>(place)] = 1;
    }
    return std::count(is_covered.begin(), is_covered.end(), 1) >=
           std::min(enough, 2.0 / 3.0 * static_cast<double>(is_covered.size()));
  }

private:
  static bool
  isOn(const Line& line, const Eigen::Vector2d& point)
  {
    return std::abs(line.distance(point)) <= 0.5 * crowd_pixels;
  }

  /** How far behind a part of a line the first face is. */
  std::optional<double>
  face(const Line& line, double begin, double end) const
  {
    PlaceProfile profile(-before, behind_side, crowd_pixels);
    for (const auto& point : near_) {
      const double place = line.along.dot(point - line.point);
      if (place >= begin && place <= end)
        profile.add(line.distance(point));
    }
    return profile.firstFace(
        static_cast<std::uint32_t>(std::ceil(std::max(3.0, end - begin))));
  }

  std::size_t
  pointsOn(const Line& line) const
  {
    return std::count_if(near_.begin(), near_.end(), [&](const auto& point) {
      const double place = line.along.dot(point - line.point);
      return place >= margin_ && place <= length_ - margin_ && isOn(line, point);
    });
  }

  Line side_;
  double length_, margin_;
  std::vector<Eigen::Vector2d> near_;
};

std::vector<Side>
fittedSides(const Ring& ring, const FootprintWalls& behind)
{
  std::vector<Side> sides;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Eigen::Vector2d& next = ring[(k + 1) % ring.size()];
    if (next == ring[k])
      continue;
    Side side{ring[k], {ring[k], (next - ring[k]).normalized()}};
    const FaceFit walls(ring[k], next, behind.walls);
    const auto wall = walls.fit();
    side.is_wall = wall && walls.covers(*wall);
    side.line = side.is_wall
                    ? *wall
                    : FaceFit(ring[k], next, behind.others).fit().value_or(side.line);
    sides.push_back(side);
  }
  return sides;
}

/** Where two lines meet. */
Eigen::Vector2d
meeting(const Line& a, const Line& b)
{
  return lineMeeting(a.point, a.along, b.point, b.along);
}

/** Where the walls before and after some sides meet behind them.
 * \param[in] chain the corners of these sides
 */
std::optional<Eigen::Vector2d>
cornerBehind(const Line& one, const Line& next, const Ring& chain, double reach)
{
  const Eigen::Vector2d first = one.foot(chain.front()), last = next.foot(chain.back());
  const double turn = crossOf(one.along, next.along);
  if (std::abs(turn) < 0.3) { // one wall: sides lie that far from it
    const bool is_one = one.along.dot(next.along) > 0.0 &&
                        std::abs(one.distance(last)) <= behind_side &&
                        one.along.dot(last - first) > 0.0;
    return is_one ? std::make_optional<Eigen::Vector2d>(0.5 * (first + last))
                  : std::nullopt;
  }
  const Eigen::Vector2d corner = meeting(one, next);
  const double ahead = one.along.dot(corner - first);
  const double back = next.along.dot(last - corner);
  if (ahead < -behind_side || back < -behind_side || std::min(ahead, back) > reach)
    return std::nullopt;
  return corner;
}

/** Leave out what is no wall between walls that meet behind it. */
std::vector<Side>
withoutHangingSides(std::vector<Side> sides, const FootprintWalls& behind)
{
  const auto wall = std::find_if(
      sides.begin(), sides.end(), [](const auto& side) { return side.is_wall; });
  if (wall == sides.end() || !behind.may_cover)
    return sides;
  std::rotate(sides.begin(), wall, sides.end());
  std::vector<Side> kept{sides.front()};
  for (std::size_t k = 1; k <= sides.size();) {
    std::size_t end = k;
    while (end < sides.size() && !sides[end].is_wall)
      ++end;
    Side& next = end < sides.size() ? sides[end] : kept.front();
    Ring part; // between the sides and the walls
    for (std::size_t i = k; i <= end; ++i)
      part.push_back(i < sides.size() ? sides[i].begin : sides.front().begin);
    const auto corner =
        end > k ? cornerBehind(kept.back().line, next.line, part, behind.reach)
                : std::nullopt;
    bool is_left_out = false;
    if (corner) {
      part.push_back(*corner);
      std::reverse(part.begin(), part.end());
      is_left_out = ringArea(part) > 0.0 && behind.may_cover(part);
    }
    if (is_left_out)
      next.begin = *corner;
    else
      kept.insert(kept.end(), sides.begin() + k, sides.begin() + end);
    if (end < sides.size())
      kept.push_back(next);
    k = end + 1;
  }
  return kept;
}

} // namespace

std::vector<Eigen::Vector2d>
moveToWalls(const std::vector<Eigen::Vector2d>& ring, const FootprintWalls& behind)
{
  std::vector<Side> sides = fittedSides(ring, behind);
  const double area = ringArea(ring);
  const bool is_held = std::any_of(
      sides.begin(), sides.end(), [](const auto& side) { return side.is_wall; });
  if (area < 0.0 && !is_held && behind.may_cover) {
    Ring hole(ring.rbegin(), ring.rend());
    if (behind.may_cover(hole))
      return {};
  }
  sides = withoutHangingSides(std::move(sides), behind);
  Ring corners;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const Line& last = sides[(k + sides.size() - 1) % sides.size()].line;
    const Line& line = sides[k].line;
    const Eigen::Vector2d& begin = sides[k].begin;
    const Eigen::Vector2d moved = 0.5 * (last.foot(begin) + line.foot(begin));
    const Eigen::Vector2d corner = meeting(last, line);
    // Sides that are nearly parallel meet anywhere.
    corners.push_back((corner - moved).norm() <= 3.0 ? corner : moved);
  }
  // Both sides of a thin wall may have been moved to, or past, its middle.
  return ringArea(corners) * area > 0.0 ? corners : ring;
}

} // namespace pcl::indoor
