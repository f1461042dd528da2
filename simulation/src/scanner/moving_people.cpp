/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scanner/moving_people.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::indoor {

namespace {

// A grown-up, metres: an upright cylinder and a ball on it.
constexpr double body_radius = 0.2;
constexpr double body_height = 1.5;
constexpr double head_radius = 0.13;
constexpr double head_middle = 1.61;
constexpr double nowhere = std::numeric_limits<double>::infinity();

// The nearer solution of a t^2 + 2 b t + c = 0 if it is in front.
double
firstRoot(double a, double b, double c)
{
  const double discriminant = b * b - a * c;
  if (a <= 0 || discriminant < 0)
    return nowhere;
  const double root = (-b - std::sqrt(discriminant)) / a;
  return root > 0 ? root : nowhere;
}

} // namespace

StandingPerson
personAt(const Building& building, const Eigen::Vector3d& feet)
{
  constexpr double step = 0.5; // metres: the floor of a room may be this far off
  StandingPerson person{feet, 0};
  double nearest = nowhere;
  for (std::size_t i = 0; i < building.rooms.size(); ++i) {
    const auto& room = building.rooms[i];
    if (std::abs(room.floor - feet.z()) > step)
      continue;
    const Eigen::Vector2d drawn = feet.head<2>() - feet.z() * building.lean;
    const double distance =
        contains(room.polygon, drawn) ? 0.0 : distanceToBoundary(room.polygon, drawn);
    if (distance < nearest) {
      nearest = distance;
      person.room = static_cast<std::uint32_t>(i + 1);
    }
  }
  return person;
}

double
distanceTo(const StandingPerson& person,
           const Eigen::Vector3d& origin,
           const Eigen::Vector3d& direction)
{
  const Eigen::Vector3d from = origin - person.feet;
  const Eigen::Vector2d flat = direction.head<2>();
  double body = firstRoot(flat.squaredNorm(),
                          flat.dot(from.head<2>()),
                          from.head<2>().squaredNorm() - body_radius * body_radius);
  const double height = from.z() + body * direction.z();
  if (!(height >= 0 && height <= body_height))
    body = nowhere;
  const Eigen::Vector3d from_head = from - Eigen::Vector3d(0, 0, head_middle);
  const double head = firstRoot(1.0,
                                direction.dot(from_head),
                                from_head.squaredNorm() - head_radius * head_radius);
  return std::min(body, head);
}

} // namespace pcl::indoor
