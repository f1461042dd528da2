/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace pcl::indoor {

/** \brief A simple polygon without holes; the last vertex is joined to the first. */
using Polygon = std::vector<Eigen::Vector2d>;

/** \brief Area in square metres, positive if the vertices run counter-clockwise. */
PCL_INDOOR_EXPORTS double
signedArea(const Polygon& polygon);

/** \brief True if the point lies inside; on the boundary either answer may come. */
PCL_INDOOR_EXPORTS bool
contains(const Polygon& polygon, const Eigen::Vector2d& point);

/** \brief Distance of a point to the segment from \a a to \a b. */
PCL_INDOOR_EXPORTS double
distanceToSegment(const Eigen::Vector2d& point,
                  const Eigen::Vector2d& a,
                  const Eigen::Vector2d& b);

/** \brief Distance of a point to the boundary. */
PCL_INDOOR_EXPORTS double
distanceToBoundary(const Polygon& polygon, const Eigen::Vector2d& point);

/** \brief True if two edges that are not neighbours meet, or an edge has no length. */
PCL_INDOOR_EXPORTS bool
crossesItself(const Polygon& polygon);

/** \brief True if the insides of two simple polygons share more than their boundary. */
PCL_INDOOR_EXPORTS bool
overlap(const Polygon& a, const Polygon& b);

/** \brief Move every edge of a counter-clockwise polygon inwards by \a distance.
 * Edge i of the result is parallel to edge i of the input.
 */
PCL_INDOOR_EXPORTS Polygon
inset(const Polygon& polygon, double distance);

/** \brief The points p with normal.dot(p) <= offset. */
struct HalfPlane {
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();
  double offset = 0.0;
};

/** \brief What lies to the left of the way from \a a to \a b. */
PCL_INDOOR_EXPORTS HalfPlane
leftOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b);

/** \brief The part of a convex polygon that lies in a half-plane; empty if none does.
 */
PCL_INDOOR_EXPORTS Polygon
clip(const Polygon& convex, const HalfPlane& half_plane);

/** \brief A convex polygon without a convex, counter-clockwise hole, in convex pieces.
 */
PCL_INDOOR_EXPORTS std::vector<Polygon>
subtract(const Polygon& convex, const Polygon& hole);

/** \brief True if a counter-clockwise polygon turns to the right nowhere. */
PCL_INDOOR_EXPORTS bool
isConvex(const Polygon& polygon);

/** \brief Cut a simple counter-clockwise polygon into triangles by clipping ears.
 * \return vertex numbers, counter-clockwise; polygon.size() - 2 triangles
 */
PCL_INDOOR_EXPORTS std::vector<std::array<int, 3>>
triangulate(const Polygon& polygon);

} // namespace pcl::indoor
