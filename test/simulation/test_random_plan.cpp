/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "footprint.h"

#include <pcl/simulation/building.h>
#include <pcl/simulation/furniture.h>
#include <pcl/simulation/random_plan.h>
#include <pcl/simulation/trajectory.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace {

using namespace pcl::indoor;
using pcl::indoor::test::footprintOf;

constexpr std::uint32_t seeds = 30;
constexpr PlanKind kinds[] = {PlanKind::Home, PlanKind::Office};
constexpr PlanKind all_kinds[] = {PlanKind::Home, PlanKind::Office, PlanKind::Table};

bool
isSeat(const FurniturePlan& item)
{
  return item.category == "chair" || item.category == "office_chair" ||
         item.category == "stool";
}

bool
isTable(const FurniturePlan& item)
{
  return item.category.find("table") != std::string::npos || item.category == "desk";
}

bool
mayOverlap(const FurniturePlan& a, const FurniturePlan& b)
{
  return (isSeat(a) && isTable(b)) || (isTable(a) && isSeat(b));
}

bool
collide(const FurniturePlan& a, const FurniturePlan& b)
{
  const double tolerance = 0.001; // metres
  const double low = std::max(*a.elevation, *b.elevation);
  const double high = std::min(*a.elevation + a.size->z(), *b.elevation + b.size->z());
  return high - low > tolerance &&
         overlap(inset(footprintOf(a), tolerance), footprintOf(b));
}

TEST(RandomPlan, SaysWhatItsRoomsAreFor)
{
  const std::map<std::string, std::string> homes = {{"hall", "corridor"},
                                                    {"living room", "living"},
                                                    {"kitchen", "kitchen"},
                                                    {"bathroom", "bath"},
                                                    {"bedroom", "bedroom"},
                                                    {"study", "office"}},
                                           offices = {{"hall", "corridor"},
                                                      {"kitchen", "kitchen"},
                                                      {"bathroom", "toilet"},
                                                      {"office", "office"},
                                                      {"meeting room", "meeting"},
                                                      {"storage", "storage"}};
  std::set<std::string> seen;
  for (const auto kind : kinds)
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
      const auto plan = randomPlan(seed, kind);
      for (const auto& storey : plan.storeys)
        for (const auto& room : storey.rooms) {
          const auto& purposes = kind == PlanKind::Home ? homes : offices;
          auto name = room.name.substr(0, room.name.find_last_of(' '));
          name = name.substr(name.rfind("upper ", 0) == 0 ? 6 : 0);
          ASSERT_EQ(purposes.count(name), 1u) << room.name;
          EXPECT_EQ(room.kind, purposes.at(name)) << room.name;
          seen.insert(room.kind);
        }
    }
  EXPECT_EQ(seen.size(), 9u);
}

TEST(RandomPlan, EveryPlanBuildsAndEveryRoomIsVisited)
{
  for (const auto kind : kinds)
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
      const auto plan = randomPlan(seed, kind);
      SCOPED_TRACE(plan.name);
      const auto building = buildBuilding(plan);
      EXPECT_GE(building.rooms.size(), 4u);
      EXPECT_GE(building.objects.size(), 20u);
      const auto poses = planTrajectory(building, TrajectoryOptions());
      for (const auto& room : building.rooms)
        EXPECT_TRUE(std::any_of(poses.begin(), poses.end(), [&](const auto& p) {
          return p.z() > room.floor && p.z() < room.floor + 2 &&
                 contains(room.polygon, p.template head<2>());
        })) << room.name;
    }
}

TEST(RandomPlan, FurnitureDoesNotCollide)
{
  for (const auto kind : all_kinds)
    for (std::uint32_t seed = 0; seed < 2 * seeds; ++seed) {
      const auto plan = randomPlan(
          seed / 2, kind, seed % 2 == 1 ? PlanFilling::Cluttered : PlanFilling::Plain);
      for (const auto& storey : plan.storeys)
        for (std::size_t i = 0; i < storey.furniture.size(); ++i)
          for (std::size_t k = i + 1; k < storey.furniture.size(); ++k) {
            const auto &a = storey.furniture[i], &b = storey.furniture[k];
            EXPECT_FALSE(!mayOverlap(a, b) && collide(a, b))
                << plan.name << ": " << a.category << " and " << b.category << " at "
                << a.at.transpose();
          }
    }
}

TEST(RandomPlan, DoorsJoinAllRooms)
{
  for (const auto kind : kinds)
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
      const auto plan = randomPlan(seed, kind);
      for (const auto& storey : plan.storeys) {
        std::vector<int> group(storey.rooms.size()); // joined rooms have one number
        for (std::size_t r = 0; r < group.size(); ++r)
          group[r] = static_cast<int>(r);
        for (const auto& opening : storey.openings) {
          std::vector<int> joined;
          for (std::size_t r = 0; r < group.size(); ++r)
            if (distanceToBoundary(storey.rooms[r].polygon, opening.at) < 1e-6)
              joined.push_back(group[r]);
          if (opening.kind != OpeningKind::Window && joined.size() == 2)
            std::replace(group.begin(), group.end(), joined[0], joined[1]);
        }
        EXPECT_EQ(std::set<int>(group.begin(), group.end()).size(), 1u) << plan.name;
      }
    }
}

TEST(RandomPlan, EveryClassAppears)
{
  std::set<std::string> seen;
  for (const auto kind : all_kinds)
    for (const auto filling : {PlanFilling::Cluttered, PlanFilling::LivedIn})
      for (std::uint32_t seed = 0; seed < seeds; ++seed)
        for (const auto& storey : randomPlan(seed, kind, filling).storeys)
          for (const auto& item : storey.furniture)
            seen.insert(item.category);
  for (const auto* part_of_building : {"beam", "column", "railing"})
    seen.insert(part_of_building);
  for (const auto& category : furnitureCategories())
    EXPECT_EQ(seen.count(category), 1u) << category;
}

TEST(RandomPlan, ClutterIsAddedToTheSamePlan)
{
  for (const auto kind : kinds)
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
      const auto plain = randomPlan(seed, kind),
                 cluttered = randomPlan(seed, kind, PlanFilling::Cluttered);
      ASSERT_EQ(plain.storeys.size(), cluttered.storeys.size());
      std::size_t few = 0, many = 0;
      for (std::size_t s = 0; s < plain.storeys.size(); ++s) {
        const auto& rest = cluttered.storeys[s].furniture;
        auto next = rest.begin();
        for (const auto& item : plain.storeys[s].furniture) {
          next = std::find_if(next, rest.end(), [&](const auto& other) {
            return other.category == item.category && other.seed == item.seed &&
                   other.at == item.at;
          });
          ASSERT_NE(next, rest.end()) << plain.name << ": " << item.category;
        }
        few += plain.storeys[s].furniture.size();
        many += rest.size();
      }
      EXPECT_GT(many, few) << plain.name;
      EXPECT_NO_THROW(buildBuilding(cluttered)) << plain.name;
    }
}

// What a home is for: a bed in each bedroom, something to cook on in the kitchen.
TEST(RandomPlan, MostHomesHaveTheirMainPieces)
{
  int beds = 0, bedrooms = 0, toilets = 0, cookers = 0, sofas = 0;
  for (std::uint32_t seed = 0; seed < seeds; ++seed)
    for (const auto& storey : randomPlan(seed, PlanKind::Home).storeys) {
      for (const auto& room : storey.rooms)
        bedrooms += room.name.find("bedroom") != std::string::npos ? 1 : 0;
      for (const auto& item : storey.furniture) {
        beds += item.category == "bed" || item.category == "bunk_bed" ? 1 : 0;
        toilets += item.category == "toilet" ? 1 : 0;
        cookers += item.category == "cooker" ? 1 : 0;
        sofas += item.category == "sofa" ? 1 : 0;
      }
    }
  EXPECT_GT(beds, 0.8 * bedrooms);
  EXPECT_LE(beds, bedrooms);
  for (const int count : {toilets, cookers, sofas})
    EXPECT_GT(count, 0.8 * seeds);
}

TEST(RandomPlan, ATableHasSmallObjectsOnIt)
{
  std::size_t alone[2] = {0, 0};
  for (std::uint32_t seed = 0; seed < 2 * seeds; ++seed) {
    const bool cluttered = seed % 2 == 1;
    const auto plan =
        randomPlan(seed / 2,
                   PlanKind::Table,
                   cluttered ? PlanFilling::Cluttered : PlanFilling::Plain);
    ASSERT_EQ(plan.storeys.size(), 1u);
    EXPECT_EQ(buildBuilding(plan).rooms.size(), 1u);
    const auto& furniture = plan.storeys[0].furniture;
    const auto& table = furniture.at(0);
    EXPECT_TRUE(isTable(table)) << table.category;
    EXPECT_EQ(table.at, Eigen::Vector2d(0, 0));
    const double top = table.size->z();
    for (std::size_t i = 1; i < furniture.size(); ++i) {
      const auto& piece = furniture[i];
      if (isSeat(piece))
        continue;
      ++alone[cluttered];
      EXPECT_GE(*piece.elevation, top - 1e-9) << piece.category;
      EXPECT_LE(piece.size->maxCoeff(), 0.3) << piece.category;
    }
  }
  EXPECT_GE(alone[0], 2 * seeds);
  EXPECT_GE(alone[1], 2 * alone[0]) << "cluttered";
}

TEST(RandomPlan, TheSameSeedGivesTheSamePlan)
{
  for (const auto kind : all_kinds) {
    const auto a = buildBuilding(randomPlan(3, kind));
    const auto b = buildBuilding(randomPlan(3, kind));
    const auto c = buildBuilding(randomPlan(4, kind));
    ASSERT_EQ(a.triangles.size(), b.triangles.size());
    for (std::size_t i = 0; i < a.triangles.size(); ++i)
      ASSERT_EQ(a.triangles[i].a, b.triangles[i].a);
    EXPECT_NE(a.triangles.size(), c.triangles.size());
  }
}

TEST(RandomPlan, NamesOfPlans)
{
  EXPECT_FALSE(randomPlanNamed("plans/house.json"));
  EXPECT_EQ(randomPlanNamed("random:home:7")->name, "random home 7");
  EXPECT_EQ(randomPlanNamed("random:office:4294967295")->seed, 4294967295u);
  EXPECT_EQ(randomPlanNamed("random:table:3")->name, "random table 3");
  const auto furniture = [](const std::string& name) {
    return randomPlanNamed(name)->storeys[0].furniture.size();
  };
  EXPECT_GT(furniture("random:home:7:cluttered"), furniture("random:home:7"));
  EXPECT_GT(furniture("random:home:7:lived_in"), furniture("random:home:7:cluttered"));
  for (const auto* wrong : {"random:home:",
                            "random:home::cluttered",
                            "random:home:7:tidy",
                            "random:home:7:lived_in:cluttered",
                            "random:home:-1",
                            "random:home:4294967296",
                            "random:castle:1",
                            "random:",
                            "random:home:1x"})
    EXPECT_THROW(randomPlanNamed(wrong), PlanError) << wrong;
}

} // namespace
