/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/outline/room_outline.h"

#include "rooms/outline/line_meeting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace pcl::indoor {
namespace {

/** Twice the area of a triangle, positive if it runs counter-clockwise. */
std::int64_t
turn(const Eigen::Vector2i& a, const Eigen::Vector2i& b, const Eigen::Vector2i& c)
{
  return std::int64_t(b.x() - a.x()) * (c.y() - a.y()) -
         std::int64_t(b.y() - a.y()) * (c.x() - a.x());
}

/** Walks around regions with the region on the left. */
class OutlineTracer {
public:
  explicit OutlineTracer(const PixelMap<std::int32_t>& labels)
  : labels_(labels)
  , visited_(labels.size(), 0)
  {}

  /** Whether the lower side of a pixel is a border on no ring yet. */
  bool
  beginsAt(int x, int y) const
  {
    const std::int32_t label = labels_.at(x, y);
    return !holds(x, y - 1, label) && !visited_[labels_.index(x, y)];
  }

  /** The ring that the lower side of a pixel lies on. */
  OutlineRing
  trace(int x, int y)
  {
    const std::int32_t label = labels_.at(x, y);
    static constexpr std::array<std::array<int, 2>, 4> steps{
        {{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    // from a corner: the pixels ahead to the left and to the right, per direction
    static constexpr std::array<std::array<int, 2>, 4> left{
        {{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
    OutlineRing ring;
    Eigen::Vector2i corner(x, y);
    int direction = 0;
    do {
      if (direction == 0) // the pixel above the line belongs to it
        visited_[labels_.index(corner.x(), corner.y())] = 1;
      corner += Eigen::Vector2i(steps[direction][0], steps[direction][1]);
      const auto& to_left = left[direction];
      const auto& to_right = left[(direction + 3) % 4];
      if (!holds(corner.x() + to_left[0], corner.y() + to_left[1], label)) {
        ring.push_back(corner);
        direction = (direction + 1) % 4;
      }
      else if (holds(corner.x() + to_right[0], corner.y() + to_right[1], label)) {
        ring.push_back(corner);
        direction = (direction + 3) % 4;
      }
    } while (direction != 0 || corner != Eigen::Vector2i(x, y));
    return ring;
  }

private:
  bool
  holds(int x, int y, std::int32_t label) const
  {
    return labels_.contains(x, y) && labels_.at(x, y) == label;
  }

  const PixelMap<std::int32_t>& labels_;
  std::vector<std::uint8_t> visited_; ///< lower sides of pixels
};

double
distanceToSegment(const Eigen::Vector2i& point,
                  const Eigen::Vector2i& begin,
                  const Eigen::Vector2i& end)
{
  const Eigen::Vector2d along = (end - begin).cast<double>();
  const Eigen::Vector2d to_point = (point - begin).cast<double>();
  const double squared = along.squaredNorm();
  const double part =
      squared > 0 ? std::clamp(to_point.dot(along) / squared, 0.0, 1.0) : 0.0;
  return (to_point - part * along).norm();
}

/** Mark the points between two kept ones that have to stay. */
void
keepNeededPoints(const OutlineRing& ring,
                 std::size_t begin,
                 std::size_t end,
                 double tolerance,
                 std::vector<std::uint8_t>& kept)
{
  std::vector<std::pair<std::size_t, std::size_t>> open{{begin, end}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    std::size_t farthest = first;
    double distance = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double here =
          distanceToSegment(ring[i], ring[first], ring[last % ring.size()]);
      if (here > distance) {
        distance = here;
        farthest = i;
      }
    }
    if (farthest == first)
      continue;
    kept[farthest] = 1;
    open.emplace_back(first, farthest);
    open.emplace_back(farthest, last);
  }
}

bool
segmentsMeet(const Eigen::Vector2i& a,
             const Eigen::Vector2i& b,
             const Eigen::Vector2i& c,
             const Eigen::Vector2i& d)
{
  const auto sign = [](std::int64_t value) { return (value > 0) - (value < 0); };
  const auto apart = [](int p, int q, int r, int s) {
    return std::max(p, q) < std::min(r, s) || std::max(r, s) < std::min(p, q);
  };
  if (apart(a.x(), b.x(), c.x(), d.x()) || apart(a.y(), b.y(), c.y(), d.y()))
    return false;
  return sign(turn(a, b, c)) * sign(turn(a, b, d)) <= 0 &&
         sign(turn(c, d, a)) * sign(turn(c, d, b)) <= 0;
}

/** Whether two sides that are no neighbours meet. */
bool
crossesItself(const OutlineRing& ring)
{
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = i + 2; k < n; ++k)
      if ((k + 1) % n != i &&
          segmentsMeet(ring[i], ring[i + 1], ring[k], ring[(k + 1) % n]))
        return true;
  return false;
}

/** The line that a side of a simplified ring lies on. */
struct FittedSide {
  Eigen::Vector2d point;
  Eigen::Vector2d direction;
};

/** Fit a line to a part of a ring: where most of it is one straight line, that one,
 * otherwise least squares over its length. */
FittedSide
fittedSide(const OutlineRing& ring, std::size_t begin, std::size_t end)
{
  FittedSide longest{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  double length = 0.0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  const Eigen::Vector2d start = ring[begin].cast<double>();
  for (std::size_t i = begin; i < end; ++i) {
    const Eigen::Vector2d from = ring[i].cast<double>() - start;
    const Eigen::Vector2d to = ring[(i + 1) % ring.size()].cast<double>() - start;
    const Eigen::Vector2d middle = 0.5 * (from + to), along = to - from;
    const double weight = along.norm();
    if (weight > longest.direction.norm())
      longest = {start + from, along};
    length += weight;
    sum += weight * middle;
    squares +=
        weight * (middle * middle.transpose() + along * along.transpose() / 12.0);
  }
  constexpr double long_enough = 8.0; // pixels; the stairs of a turned line are shorter
  const double straight = longest.direction.norm();
  if (straight == length || straight > std::max(0.5 * length, long_enough))
    return longest;
  const Eigen::Vector2d mean = sum / length;
  const Eigen::Matrix2d spread = squares / length - mean * mean.transpose();
  const double angle =
      0.5 * std::atan2(2.0 * spread(0, 1), spread(0, 0) - spread(1, 1));
  return {start + mean, {std::cos(angle), std::sin(angle)}};
}

/** Where two sides meet, or the corner itself if that is farther from it: sides that
 * are nearly parallel meet anywhere. */
Eigen::Vector2d
meetingNear(const Eigen::Vector2d& corner,
            const FittedSide& before,
            const FittedSide& after,
            double distance)
{
  const Eigen::Vector2d meeting =
      lineMeeting(before.point, before.direction, after.point, after.direction);
  return (meeting - corner).norm() <= distance ? meeting : corner;
}

/** The corners of a simplified ring with fitted sides.
 * \param[in] places of the corners in the ring */
std::vector<Eigen::Vector2d>
fittedCorners(const OutlineRing& ring,
              const std::vector<std::size_t>& places,
              double tolerance)
{
  std::vector<FittedSide> sides;
  for (std::size_t k = 0; k < places.size(); ++k)
    sides.push_back(fittedSide(
        ring, places[k], k + 1 < places.size() ? places[k + 1] : ring.size()));
  std::vector<Eigen::Vector2d> corners;
  for (std::size_t k = 0; k < sides.size(); ++k)
    corners.push_back(meetingNear(ring[places[k]].cast<double>(),
                                  sides[(k + sides.size() - 1) % sides.size()],
                                  sides[k],
                                  2.0 * tolerance));
  return corners;
}

} // namespace

double
ringArea(const std::vector<Eigen::Vector2d>& ring)
{
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d a = ring[i] - ring[0];
    const Eigen::Vector2d b = ring[(i + 1) % ring.size()] - ring[0];
    twice += crossOf(a, b);
  }
  return 0.5 * twice;
}

double
ringArea(const OutlineRing& ring)
{
  std::int64_t twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2i& next = ring[(i + 1) % ring.size()];
    twice +=
        std::int64_t(ring[i].x()) * next.y() - std::int64_t(next.x()) * ring[i].y();
  }
  return 0.5 * static_cast<double>(twice);
}

std::vector<std::vector<OutlineRing>>
traceOutlines(const PixelMap<std::int32_t>& labels, std::int32_t region_count)
{
  std::vector<std::vector<OutlineRing>> outlines(std::max(region_count, 0) + 1);
  OutlineTracer tracer(labels);
  for (int x = 0; x < labels.nx; ++x)
    for (int y = 0; y < labels.ny; ++y) {
      const std::int32_t label = labels.at(x, y);
      if (label > 0 && label <= region_count && tracer.beginsAt(x, y))
        outlines[label].push_back(tracer.trace(x, y));
    }
  for (auto& rings : outlines) {
    const auto largest = std::max_element(
        rings.begin(), rings.end(), [](const auto& first, const auto& second) {
          return ringArea(first) < ringArea(second);
        });
    if (largest != rings.end())
      std::rotate(rings.begin(), largest, largest + 1);
  }
  return outlines;
}

std::vector<Eigen::Vector2d>
simplifyOutline(const OutlineRing& ring, double tolerance)
{
  // Two points that stay: the lowest one on the left, and the one farthest from it.
  OutlineRing turned = ring;
  const auto less = [](const Eigen::Vector2i& a, const Eigen::Vector2i& b) {
    return std::make_pair(a.x(), a.y()) < std::make_pair(b.x(), b.y());
  };
  std::rotate(turned.begin(),
              std::min_element(turned.begin(), turned.end(), less),
              turned.end());
  const auto farthest = std::max_element(
      turned.begin(), turned.end(), [&](const auto& first, const auto& second) {
        return (first - turned[0]).squaredNorm() < (second - turned[0]).squaredNorm();
      });
  const std::size_t middle = farthest - turned.begin();
  std::vector<std::uint8_t> kept(turned.size(), 0);
  kept[0] = kept[middle] = 1;
  keepNeededPoints(turned, 0, middle, tolerance, kept);
  keepNeededPoints(turned, middle, turned.size(), tolerance, kept);
  OutlineRing simple;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < turned.size(); ++i)
    if (kept[i]) {
      simple.push_back(turned[i]);
      places.push_back(i);
    }
  const bool lost = simple.size() < 3 || ringArea(simple) * ringArea(ring) <= 0.0;
  if (lost || crossesItself(simple)) {
    std::vector<Eigen::Vector2d> same;
    for (const auto& corner : ring)
      same.push_back(corner.cast<double>());
    return same;
  }
  return fittedCorners(turned, places, tolerance);
}

} // namespace pcl::indoor
