/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/building.h>
#include <pcl/simulation/random_draw.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::indoor {

constexpr double radians = M_PI / 180;
constexpr double rounding = 2e-5; // metres, of coordinates of some metres in float

inline Building
buildText(const std::string& text)
{
  return buildBuilding(parsePlan(text, "test"), "test");
}

inline Eigen::Vector3d
randomDirection(RandomDraw& draw)
{
  return Eigen::Vector3d(draw.gaussian(), draw.gaussian(), draw.gaussian())
      .normalized();
}

/** \brief Finds what a ray meets in a building. */
class Prober {
public:
  explicit Prober(const Building& building)
  : building_(building)
  , tracer_(building.triangles)
  {}

  RayHit
  hit(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const
  {
    return tracer_.trace(from.cast<float>(), direction.cast<float>());
  }

  double
  distance(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const
  {
    return hit(from, direction).distance;
  }

  /** \brief Number of the room of the surface that a ray meets; 0: nothing. */
  std::uint32_t
  room(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const
  {
    const auto found = hit(from, direction);
    return found.triangle < 0 ? 0 : building_.surfaces[found.triangle].labels.room;
  }

  std::string
  category(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const
  {
    const auto found = hit(from, direction);
    return found.triangle < 0
               ? "nothing"
               : building_
                     .categories[building_.surfaces[found.triangle].labels.category];
  }

  Eigen::Vector3d
  normal(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const
  {
    const auto& t = building_.triangles.at(hit(from, direction).triangle);
    return (t.b - t.a).cross(t.c - t.a).normalized().cast<double>();
  }

  /** \brief Every ray from a place in a room meets something, walls from their front.
   */
  void
  expectClosed(const Eigen::Vector3d& from, int rays, RandomDraw& draw) const
  {
    for (int i = 0; i < rays; ++i) {
      const auto direction = randomDirection(draw);
      const auto found = hit(from, direction);
      if (found.triangle < 0 && passesUnderADoor(from, direction))
        continue;
      ASSERT_GE(found.triangle, 0)
          << "out at " << from.transpose() << " towards " << direction.transpose();
      if (building_.surfaces[found.triangle].kind != SurfaceKind::Shell)
        continue;
      ASSERT_LT(normal(from, direction).dot(direction), 1e-5)
          << "behind a wall at " << from.transpose() << " towards "
          << direction.transpose() << " after " << found.distance;
    }
  }

private:
  // A leaf ends a centimetre above its floor; behind an outer door there is nothing.
  bool
  passesUnderADoor(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const
  {
    for (const auto& object : building_.objects) {
      const double way = (object.position.z() + 0.005 - from.z()) / direction.z();
      const Eigen::Vector3d at = from + way * direction;
      if (object.category == "door" && way > 0 &&
          (at - object.position).norm() < object.size.x() / 2 + object.size.y())
        return true;
    }
    return false;
  }

  const Building& building_;
  RayTracer tracer_;
};

/** \brief The volume within the shell of a room without openings, cubic metres. */
inline double
shellVolume(const Building& building, std::uint32_t room)
{
  double volume = 0;
  for (std::size_t i = 0; i < building.triangles.size(); ++i) {
    const auto& surface = building.surfaces[i];
    const auto& t = building.triangles[i];
    if (surface.labels.room == room && surface.kind == SurfaceKind::Shell)
      volume -=
          t.a.cast<double>().dot(t.b.cast<double>().cross(t.c.cast<double>())) / 6;
  }
  return volume;
}

} // namespace pcl::indoor
