/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/plan_boxes.h"

#include <cmath>

namespace pcl::indoor::tool {
namespace {

Eigen::Vector2d
leftOf(const Eigen::Vector2d& way)
{
  return {-way.y(), way.x()};
}

} // namespace

PlanRing
boxFromAbove(const UprightBox& box)
{
  const Eigen::Vector2d way(std::cos(box.yaw), std::sin(box.yaw));
  const Eigen::Vector2d length = 0.5 * box.size.x() * way;
  const Eigen::Vector2d width = 0.5 * box.size.y() * leftOf(way);
  const Eigen::Vector2d center = box.center.head<2>();
  return {center - length - width,
          center + length - width,
          center + length + width,
          center - length + width};
}

PlanRing
wallBox(const SavedWall& wall)
{
  const double half = 0.5 * wall.thickness;
  return wall.thickness > 0.0
             ? bandAround(wall.begin, wall.end, half, half)
             : bandAround(wall.begin, wall.end, 0.0, unknown_thickness);
}

PlanRing
openingBox(const OpeningPlace& place, double width, double more)
{
  const Eigen::Vector2d half = 0.5 * width * place.along;
  const Eigen::Vector2d left = (place.left + more) * leftOf(place.along);
  const Eigen::Vector2d right = -(place.right + more) * leftOf(place.along);
  return {place.middle - half + right,
          place.middle + half + right,
          place.middle + half + left,
          place.middle - half + left};
}

} // namespace pcl::indoor::tool
