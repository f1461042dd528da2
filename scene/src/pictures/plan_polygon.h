/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl::indoor::tool {

using PlanRing = std::vector<Eigen::Vector2d>;

/** \brief A part of a plan in one piece. */
struct PlanPolygon {
  PlanRing outer; ///< counter-clockwise
  std::vector<PlanRing> holes;
};

/** \brief The area within a ring; negative if it goes clockwise. */
double
signedArea(const PlanRing& ring);

/** \brief The length of a ring. */
double
perimeter(const PlanRing& ring);

/** \brief The pieces that rings enclose: counter-clockwise around them, clockwise
 * around their holes. Rings without area and holes in no piece are left out. */
std::vector<PlanPolygon>
polygonsOf(const std::vector<PlanRing>& rings);

/** \brief Call visit(begin, end) for each side of rings that crosses a y. */
template <typename Visit>
void
forEachSideAcross(const std::vector<PlanRing>& rings, double y, const Visit& visit)
{
  for (const auto& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto& a = ring[i];
      const auto& b = ring[(i + 1) % ring.size()];
      if ((a.y() > y) != (b.y() > y))
        visit(a, b);
    }
}

/** \brief The x at which the line of a side has a y. REQUIRES: it is not level. */
inline double
xOfSide(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double y)
{
  return a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y());
}

/** \brief Is a place within rings, and not in their holes? */
bool
isInside(const std::vector<PlanRing>& rings, const Eigen::Vector2d& place);

/** \brief The corners of a line that is made wide, counter-clockwise.
 * \param[in] left what is added to the left of it, right to its right, metres
 */
PlanRing
bandAround(const Eigen::Vector2d& begin,
           const Eigen::Vector2d& end,
           double left,
           double right);

/** \brief The distance of a place from a line between two others, metres. */
double
distanceToLine(const Eigen::Vector2d& begin,
               const Eigen::Vector2d& end,
               const Eigen::Vector2d& place);

/** \brief The distance of a place from the nearest side, metres; infinite without
 * rings.
 */
double
distanceToSides(const std::vector<PlanRing>& rings, const Eigen::Vector2d& place);

/** \brief The direction of the wall that an opening is in: that of the longest side, up
 * to twice as long as the opening, of those that are about as near as the nearest.
 * \param[in] middle, width of the opening
 * \return unit length; along x without rings
 */
Eigen::Vector2d
directionOfSides(const std::vector<PlanRing>& rings,
                 const Eigen::Vector2d& middle,
                 double width);

/** \brief The place inside that is farthest from the sides, to 2 cm, or in shapes of
 * which that takes long, a wide place. Of no rings, the origin. */
Eigen::Vector2d
widestPlace(const std::vector<PlanRing>& rings);

} // namespace pcl::indoor::tool
