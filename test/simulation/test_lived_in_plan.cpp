/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "footprint.h"

#include <pcl/simulation/building.h>
#include <pcl/simulation/depth_camera.h>
#include <pcl/simulation/furniture.h>
#include <pcl/simulation/random_plan.h>
#include <pcl/simulation/range_sensor.h>
#include <pcl/simulation/trajectory.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace {

using namespace pcl::indoor;
using pcl::indoor::test::footprintOf;

constexpr std::uint32_t lived_in_seeds = 8;
constexpr PlanKind lived_in_kinds[] = {PlanKind::Home, PlanKind::Office};

std::size_t
countFurniture(const Plan& plan)
{
  std::size_t count = 0;
  for (const auto& storey : plan.storeys)
    count += storey.furniture.size();
  return count;
}

// Rooms, doors and windows are those of the plain plan; the furniture is another.
TEST(LivedInPlan, RoomsAreThoseOfThePlainPlan)
{
  for (const auto kind : lived_in_kinds)
    for (std::uint32_t seed = 0; seed < lived_in_seeds; ++seed) {
      const auto plain = randomPlan(seed, kind),
                 lived_in = randomPlan(seed, kind, PlanFilling::LivedIn);
      ASSERT_EQ(plain.storeys.size(), lived_in.storeys.size());
      for (std::size_t s = 0; s < plain.storeys.size(); ++s) {
        const auto &a = plain.storeys[s], &b = lived_in.storeys[s];
        ASSERT_EQ(a.rooms.size(), b.rooms.size());
        for (std::size_t r = 0; r < a.rooms.size(); ++r)
          EXPECT_EQ(a.rooms[r].polygon, b.rooms[r].polygon);
        ASSERT_EQ(a.openings.size(), b.openings.size());
        for (std::size_t o = 0; o < a.openings.size(); ++o)
          EXPECT_EQ(a.openings[o].at, b.openings[o].at);
      }
      EXPECT_GT(countFurniture(lived_in), countFurniture(plain)) << plain.name;
    }
}

TEST(LivedInPlan, TheSameSeedGivesTheSameBuilding)
{
  for (const auto kind : lived_in_kinds) {
    const auto a = buildBuilding(randomPlan(3, kind, PlanFilling::LivedIn));
    const auto b = buildBuilding(randomPlan(3, kind, PlanFilling::LivedIn));
    ASSERT_EQ(a.triangles.size(), b.triangles.size());
    for (std::size_t i = 0; i < a.triangles.size(); ++i)
      ASSERT_EQ(a.triangles[i].a, b.triangles[i].a);
  }
}

// Where boxes share space, an object is within the extent of what it lies in, stands
// under or is laid over.
TEST(LivedInPlan, ObjectsStandInEachOtherOrApart)
{
  const double tolerance = 0.002; // metres
  for (const auto kind : lived_in_kinds)
    for (std::uint32_t seed = 0; seed < lived_in_seeds; ++seed)
      for (const auto& storey : randomPlan(seed, kind, PlanFilling::LivedIn).storeys)
        for (std::size_t i = 0; i < storey.furniture.size(); ++i)
          for (std::size_t k = i + 1; k < storey.furniture.size(); ++k) {
            const auto &a = storey.furniture[i], &b = storey.furniture[k];
            const double low = std::max(*a.elevation, *b.elevation),
                         high = std::min(*a.elevation + a.size->z(),
                                         *b.elevation + b.size->z());
            if (a.draped || b.draped || high - low < tolerance ||
                !overlap(inset(footprintOf(a), tolerance), footprintOf(b)))
              continue;
            const bool is_seat_at_table =
                a.category.find("table") != std::string::npos || a.category == "desk";
            EXPECT_TRUE(is_seat_at_table || contains(footprintOf(a), b.at))
                << a.category << " and " << b.category << " at " << b.at.transpose()
                << ", seed " << seed;
          }
}

// Metres down to the first surface that is none of an object's own.
double
heightAbove(const Building& building, std::uint32_t object, const Eigen::Vector3d& from)
{
  float nearest = 1e9f;
  for (std::size_t i = 0; i < building.triangles.size(); ++i)
    if (building.surfaces[i].labels.object != object)
      nearest = std::min(
          nearest, intersect(from.cast<float>(), {0, 0, -1}, building.triangles[i]));
  return nearest;
}

TEST(LivedInPlan, SmallObjectsDoNotFloat)
{
  constexpr std::uint32_t few = 3; // seeds
  const std::set<std::string> belongings{"bag",
                                         "books",
                                         "bottle",
                                         "bowl",
                                         "box",
                                         "cup",
                                         "kitchenware",
                                         "mug",
                                         "pillow",
                                         "shoes",
                                         "toy"};
  std::size_t floating = 0, all = 0;
  for (const auto kind : lived_in_kinds)
    for (std::uint32_t seed = 0; seed < few; ++seed) {
      const auto building = buildBuilding(randomPlan(seed, kind, PlanFilling::LivedIn));
      for (std::size_t o = 0; o < building.objects.size(); ++o) {
        const auto& object = building.objects[o];
        if (belongings.count(object.category) == 0)
          continue;
        const double above = 0.06; // metres, so that what it sinks into is met
        const double gap = heightAbove(building,
                                       static_cast<std::uint32_t>(o + 1),
                                       object.position + Eigen::Vector3d(0, 0, above)) -
                           above;
        ++all;
        floating += gap > 0.03 ? 1 : 0; // metres: uneven seats
      }
    }
  EXPECT_GT(all, 100 * few);
  EXPECT_LT(static_cast<double>(floating), 0.03 * static_cast<double>(all));
}

// What a sensor sees of a few homes and offices has all that people leave about.
TEST(LivedInPlan, ScansShowBelongings)
{
  RangeSensorOptions sensor;
  sensor.rays_per_pose = 4000;
  std::set<std::string> seen;
  for (const auto kind : lived_in_kinds)
    for (std::uint32_t seed = 0; seed < 3; ++seed) {
      const auto building = buildBuilding(randomPlan(seed, kind, PlanFilling::LivedIn));
      const auto scan =
          scanBuilding(building, planTrajectory(building, TrajectoryOptions()), sensor);
      for (const auto& point : scan.points)
        seen.insert(building.categories.at(point.category));
    }
  for (const auto* name : {"bag",
                           "bin",
                           "blanket",
                           "blinds",
                           "books",
                           "box",
                           "cable",
                           "clothes",
                           "counter",
                           "curtain",
                           "kitchenware",
                           "pillow",
                           "shoes",
                           "towel",
                           "toy"})
    EXPECT_EQ(seen.count(name), 1u) << name;
}

// Numbers of categories that plans without belongings have stay what they are.
TEST(LivedInPlan, NewCategoriesComeLast)
{
  const auto plain = buildBuilding(randomPlan(1, PlanKind::Home)).categories,
             more = buildBuilding(randomPlan(1, PlanKind::Home, PlanFilling::LivedIn))
                        .categories;
  ASSERT_GT(more.size(), plain.size());
  EXPECT_TRUE(std::equal(plain.begin(), plain.end(), more.begin()));
  EXPECT_EQ(std::find(plain.begin(), plain.end(), "pillow"), plain.end());
}

// One of eight cluttered tables is covered: 25 objects, many touch, a third of what a
// camera sees of them and the table is table.
TEST(LivedInPlan, SomeTablesAreCovered)
{
  for (const std::uint32_t seed : {5u, 13u, 21u}) {
    const auto plan = randomPlan(seed, PlanKind::Table, PlanFilling::Cluttered);
    const auto& items = plan.storeys[0].furniture;
    std::size_t belongings = 0, touching = 0;
    for (std::size_t i = 1; i < items.size(); ++i) {
      if (*items[i].elevation < 0.2) // chairs
        continue;
      ++belongings;
      bool touches = false;
      for (std::size_t k = 1; k < items.size(); ++k)
        touches |= k != i && *items[k].elevation > 0.2 &&
                   overlap(inset(footprintOf(items[i]), -0.012), footprintOf(items[k]));
      touching += touches ? 1 : 0;
    }
    EXPECT_GE(belongings, 18u) << seed;
    EXPECT_GE(2 * touching, belongings) << seed;
    const auto building = buildBuilding(plan);
    const double top = items[0].size->z();
    const auto view = viewBuilding(
        building, {{0.6, 0.6, top + 0.7}, {0, 0, top}}, DepthCameraOptions());
    double table = 0, all = 0;
    for (const auto& point : view) {
      table += point.object == 1 ? 1 : 0;
      all += point.object > 0 ? 1 : 0;
    }
    EXPECT_LT(table / all, 0.5) << seed;
    EXPECT_GT(table / all, 0.1) << seed;
  }
}

} // namespace
