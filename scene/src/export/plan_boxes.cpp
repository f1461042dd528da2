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
  const Eigen::Vector2d way = (wall.end - wall.begin).normalized();
  const bool is_known = wall.thickness > 0.0;
  const Eigen::Vector2d left = is_known ? 0.5 * wall.thickness * leftOf(way)
                                        : Eigen::Vector2d(Eigen::Vector2d::Zero());
  const Eigen::Vector2d right = is_known
                                    ? Eigen::Vector2d(-left)
                                    : Eigen::Vector2d(-unknown_thickness * leftOf(way));
  return {wall.begin + right, wall.end + right, wall.end + left, wall.begin + left};
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
