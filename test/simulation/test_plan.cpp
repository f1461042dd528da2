/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/simulation/building.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

namespace {

using namespace pcl::indoor;

const std::string good = R"({
  "name": "two rooms", "wall_thickness": 0.2, "seed": 4,
  "storeys": [{
    "name": "ground", "elevation": 0, "ceiling_height": 2.6,
    "rooms": [
      {"name": "left", "polygon": [[0, 0], [4, 0], [4, 3], [0, 3]]},
      {"name": "right", "polygon": [[4, 3], [4, 0], [7, 0], [7, 3]],
       "ceiling": {"height": 2.4, "at": [4, 0], "slope": [0.2, 0]}}
    ],
    "doors": [{"at": [4, 1.5], "width": 0.9, "angle": 90, "into": "right"}],
    "windows": [{"at": [2, 0], "width": 1.5, "height": 1.2, "sill": 0.9}],
    "passages": [],
    "furniture": [{"class": "chair", "at": [1, 1], "rotation": 30}]
  }]
})";

std::string
with(const std::string& before, const std::string& after)
{
  std::string text = good;
  const auto at = text.find(before);
  EXPECT_NE(at, std::string::npos) << before;
  return text.replace(at, before.size(), after);
}

// What is wrong with the plan, or nothing.
std::string
errorOf(const std::string& text)
{
  try {
    buildBuilding(parsePlan(text, "house.json"), "house.json");
    return "";
  } catch (const PlanError& error) {
    return error.what();
  }
}

struct Case {
  const char *before, *after; // replacement in the good plan
  const char* mention;        // that the message must contain
};

// In one line that says where and why.
void
expectRefused(const Case& c)
{
  const auto message = errorOf(with(c.before, c.after));
  EXPECT_EQ(message.rfind("house.json: ", 0), 0u) << c.after << ": " << message;
  EXPECT_NE(message.find(c.mention), std::string::npos) << c.after << ": " << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST(Plan, ReadsEveryValue)
{
  const auto plan = parsePlan(good, "house.json");
  EXPECT_EQ(plan.name, "two rooms");
  EXPECT_EQ(plan.seed, 4u);
  ASSERT_EQ(plan.storeys.size(), 1u);
  const auto& storey = plan.storeys[0];
  ASSERT_EQ(storey.rooms.size(), 2u);
  EXPECT_DOUBLE_EQ(storey.rooms[0].ceiling.heightAt({3, 3}), 2.6);
  EXPECT_DOUBLE_EQ(storey.rooms[1].ceiling.heightAt({6, 3}), 2.8);
  // The second polygon is given counter-clockwise as well, from another corner.
  EXPECT_EQ(storey.rooms[1].polygon[0], Eigen::Vector2d(4, 3));
  ASSERT_EQ(storey.openings.size(), 2u);
  EXPECT_EQ(storey.openings[0].kind, OpeningKind::Door);
  EXPECT_NEAR(storey.openings[0].leaf_angle, M_PI / 2, 1e-12);
  EXPECT_EQ(storey.openings[0].height, OpeningPlan().height);
  EXPECT_EQ(storey.openings[1].kind, OpeningKind::Window);
  ASSERT_EQ(storey.furniture.size(), 1u);
  EXPECT_NEAR(storey.furniture[0].rotation, M_PI / 6, 1e-12);
  EXPECT_FALSE(storey.furniture[0].size);
  EXPECT_EQ(errorOf(good), "");
}

TEST(Plan, TurnsClockwisePolygonsAround)
{
  const auto plan = parsePlan(
      with("[[0, 0], [4, 0], [4, 3], [0, 3]]", "[[0, 3], [4, 3], [4, 0], [0, 0]]"), "");
  EXPECT_GT(signedArea(plan.storeys[0].rooms[0].polygon), 0.0);
}

TEST(Plan, RefusesWhatCannotBeRead)
{
  const Case cases[] = {
      {"\"seed\": 4,", "\"seed\": 4,,", "line 2"},
      {"\"seed\": 4", "\"sede\": 4", "sede"},
      {"\"seed\": 4", "\"seed\": -4", "seed"},
      {"\"wall_thickness\": 0.2", "\"wall_thickness\": -0.2", "wall_thickness"},
      {"\"wall_thickness\": 0.2, ", "", "wall_thickness"},
      {"\"wall_thickness\": 0.2", "\"wall_thickness\": \"0.2\"", "wall_thickness"},
      {"\"elevation\": 0", "\"elevation\": 1e300", "storeys[0].elevation"},
      {"\"ceiling_height\": 2.6", "\"ceiling_height\": 0.5", "storeys[0].rooms[0]"},
      {"[7, 0], [7, 3]]", "[7]]", "storeys[0].rooms[1].polygon[2]"},
      {"[[0, 0], [4, 0], [4, 3], [0, 3]]", "[[0, 0], [4, 0]]", "at least 3"},
      {"[[0, 0], [4, 0], [4, 3], [0, 3]]",
       "[[0, 0], [4, 3], [4, 0], [0, 3]]",
       "crosses"},
      {"\"angle\": 90", "\"angle\": 190", "storeys[0].doors[0].angle"},
      {"\"width\": 0.9", "\"width\": 0", "storeys[0].doors[0].width"},
      {"\"sill\": 0.9", "\"sill\": -0.9", "storeys[0].windows[0].sill"},
      {", \"sill\": 0.9", "", "sill"},
      {"\"chair\"", "\"throne\"", "throne"},
      {"\"rotation\": 30", "\"size\": [1, 1]", "storeys[0].furniture[0].size"},
      {"\"rotation\": 30", "\"size\": [1, 1, -1]", "storeys[0].furniture[0].size"},
      {"\"height\": 2.4", "\"height\": 1.1", "storeys[0].rooms[1].ceiling"},
      {"\"name\": \"right\"", "\"name\": \"left\"", "left"},
  };
  for (const auto& c : cases)
    expectRefused(c);
}

TEST(Plan, RefusesWhatContradictsItself)
{
  const Case cases[] = {
      {"\"at\": [4, 1.5]", "\"at\": [3.5, 1.5]", "lies in no wall"},
      {"\"at\": [4, 1.5]", "\"at\": [4, 0.4]", "wider than its wall"},
      {"\"width\": 0.9, \"angle\"", "\"width\": 3, \"angle\"", "wider than its wall"},
      {"\"angle\": 90", "\"height\": 3.0", "ceiling"},
      {"\"into\": \"right\"", "\"into\": \"cellar\"", "cellar"},
      {"\"at\": [2, 0]", "\"at\": [0.5, 0]", "wider than its wall"},
      {"\"passages\": []",
       "\"passages\": [{\"at\": [4, 1.9], \"width\": 0.6}]",
       "overlaps another opening"},
      {"[[4, 3], [4, 0], [7, 0], [7, 3]]",
       "[[3.5, 3], [3.5, 0], [7, 0], [7, 3]]",
       "overlap"},
      {"[[4, 3], [4, 0], [7, 0], [7, 3]]", "[[4, 3], [4, 0], [4.3, 1]]", "vanishes"},
      {"\"at\": [1, 1]", "\"at\": [9, 1]", "stands in no room"},
      {"\"at\": [1, 1]", "\"at\": [0.2, 1]", "reaches through a wall"},
      {"\"rotation\": 30", "\"elevation\": -0.5", "below the floor"},
      {"\"rotation\": 30", "\"elevation\": 2.5", "higher than its room"},
      {"\"rotation\": 30", "\"room\": \"cellar\"", "unknown room 'cellar'"},
      {"\"slope\": [0.2, 0]", "\"slope\": [-0.9, 0]", "ceiling below its floor"},
  };
  for (const auto& c : cases)
    expectRefused(c);
}

// A key that is added to the good plan behind another, and what the message must
// contain; empty: the plan stays good.
struct Addition {
  std::string behind, added;
  const char* mention;
};

void
expectAdded(const Addition& c)
{
  const auto message = errorOf(with(c.behind, c.behind + ", " + c.added));
  EXPECT_EQ(message.empty(), *c.mention == 0) << c.added << ": " << message;
  EXPECT_NE(message.find(c.mention), std::string::npos) << c.added << ": " << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST(Plan, RefusesLeansThatCannotBe)
{
  const std::string plan = "\"seed\": 4";
  const std::string wall = "\"leaning_walls\": [{\"from\": [4, 0], \"to\": ";
  const Addition cases[] = {
      {plan, "\"lean\": 10", "lean must be an object"},
      {plan, "\"lean\": {\"angle\": 50, \"towards\": 0}", "lean.angle"},
      {plan, "\"lean\": {\"angle\": -5, \"towards\": 0}", "lean.angle"},
      {plan, "\"lean\": {\"angle\": 5}", "towards"},
      {plan, wall + "[4, 3], \"angle\": 46}]", "leaning_walls[0].angle"},
      {plan, wall + "[4, 0], \"angle\": 5}]", "leaning_walls[0] must be at least"},
      {plan, wall + "[4, 2], \"angle\": 5}]", "covers only a part of a wall"},
      {plan, wall + "[6, 3], \"angle\": 5}]", "lies on no wall"},
  };
  for (const auto& c : cases)
    expectAdded(c);
  const auto apart = R"({"name": "", "wall_thickness": 0.2, "leaning_walls": [
    {"from": [0, 0], "to": [2, 0], "angle": 5}], "storeys": [{"name": "", "elevation":
    0, "ceiling_height": 2.6, "rooms": [{"name": "a", "polygon": [[0, 0], [2, 0],
    [4, 0], [4, 3], [0, 3]]}]}]})";
  const auto narrow = R"({"name": "", "wall_thickness": 0.2, "leaning_walls": [
    {"from": [0, 0], "to": [2, 0], "angle": 40}], "storeys": [{"name": "", "elevation":
    0, "ceiling_height": 2.6, "rooms": [{"name": "a", "polygon": [[0, 0], [2, 0],
    [2, 2], [0, 2]]}]}]})";
  EXPECT_NE(errorOf(narrow).find("closes below its ceiling"), std::string::npos)
      << errorOf(narrow);
  EXPECT_NE(errorOf(apart).find("lean apart at (2, 0)"), std::string::npos)
      << errorOf(apart);
}

TEST(Plan, RefusesLevelsThatCannotBe)
{
  const std::string room = "\"name\": \"left\"", storey = "\"passages\": []";
  const std::string item = "\"rotation\": 30";
  const std::string part =
      "\"ceiling_parts\": [{\"polygon\": [[0, 1], [2, 1], [2, 2]], \"ceiling\": 2}";
  const std::string square = "[{\"polygon\": [[1, 1], [2, 1], [2, 2], [1, 2]]";
  const std::string hole = "[{\"polygon\": [[1, 1], [9, 1], [9, 2], [1, 2]]";
  const Addition cases[] = {
      {room, part + "]", ""},
      {room, part + ", " + part.substr(18) + "]", "ceiling_parts[1] overlaps"},
      {room, part + "], \"ceiling\": []", "ceiling must hold at least one"},
      {room,
       "\"ceiling\": {\"ridge\": [[0, 0]], \"height\": 3, \"pitch\": 30}",
       "ridge"},
      {room,
       "\"ceiling\": {\"ridge\": [[0, 1], [3, 1]], \"height\": 3, \"pitch\": 90}",
       "pitch must lie between"},
      {room,
       "\"ceiling\": {\"ridge\": [[0, 1], [3, 1]], \"height\": 3, \"pitch\": 80}",
       "below its floor"},
      {room,
       "\"ceiling\": {\"vault\": [[0, 1], [3, 1]], \"height\": 3, \"radius\": -1}",
       "radius must be positive"},
      {storey, "\"ceiling\": 3", "both ceiling and ceiling_height"},
      {storey, "\"platforms\": " + square + ", \"height\": 0.5}]", ""},
      {storey, "\"platforms\": " + square + "}]", "height"},
      {storey, "\"platforms\": " + square + ", \"height\": 2.7}]", "above the ceiling"},
      {storey, "\"platforms\": " + square + ", \"height\": -0.1}]", "below the floor"},
      {storey,
       "\"platforms\": " + square + ", \"height\": 1, \"thickness\": 1.2}]",
       "below the floor"},
      {storey,
       "\"platforms\": " + square + ", \"height\": 1, \"thickness\": 0}]",
       "thickness must be positive"},
      {storey, "\"platforms\": " + hole + ", \"height\": 1}]", "within a room"},
      {storey,
       "\"platforms\": " + square + ", \"height\": 1, \"room\": \"right\"}]",
       "within room 'right'"},
      {storey, "\"wells\": " + square + "}]", "lies above no room"},
      {storey, "\"wells\": " + hole + "}]", "lies in no room"},
      {storey,
       "\"wells\": [{\"polygon\": [[1, 1], [2, 1], [1.2, 1.2], [1, 2]]}]",
       "wells[0].polygon must be convex"},
      {item, "\"turn\": \"half\"", "only stairs"},
      {item, "\"lies\": \"over\"", "only blanket"},
      {item, "\"variant\": -1", "whole number from 0"},
      {item, "\"variant\": 0.5", "whole number from 0"},
      {item, "\"variant\": 99", "whole number from 0"},
  };
  for (const auto& c : cases)
    expectAdded(c);
}

TEST(Plan, RefusesArcsThatCannotBe)
{
  const auto arc = [](const std::string& text) {
    return errorOf(with("[[0, 0], [4, 0], [4, 3], [0, 3]]",
                        "[[0, 0], [4, 0], " + text + ", [4, 3], [0, 3]]"));
  };
  const std::string good_arc = R"({"around": [4, 1.5], "sides": 4, "turn": "right"})";
  const auto mentions = [&](const std::string& text, const char* mention) {
    const auto message = arc(text);
    EXPECT_NE(message.find(mention), std::string::npos) << text << ": " << message;
  };
  mentions(R"({"around": [4, 1.6], "sides": 4})", "as far");
  mentions(R"({"around": [4, 1.5], "sides": 2.5})", "whole number");
  mentions(R"({"around": [4, 1.5], "sides": 1})", "whole number");
  mentions(R"({"around": [4, 1.5], "sides": 4, "turn": "up"})", "'left' or 'right'");
  mentions(good_arc + ", " + good_arc, "between two vertices");
  mentions(R"({"around": [4, 1.5]})", "sides");
}

TEST(Plan, LeansByAnotherAngle)
{
  auto plan = parsePlan(with("\"seed\": 4",
                             "\"leaning_walls\": [{\"from\": [4, 0], \"to\": [4, 3], "
                             "\"angle\": -10}]"),
                        "");
  setLean(plan, 0.2);
  EXPECT_DOUBLE_EQ(plan.leaning_walls[0].angle, -0.2);
  EXPECT_FALSE(plan.lean);
  setLean(plan, {0.1, 0.5});
  EXPECT_TRUE(plan.leaning_walls.empty());
  ASSERT_TRUE(plan.lean);
  EXPECT_DOUBLE_EQ(plan.lean->angle, 0.1);
  plan.lean.reset();
  EXPECT_THROW(setLean(plan, 0.1), PlanError);
}

TEST(Plan, RefusesDocumentsOfAnotherKind)
{
  for (const char* text : {"", "[]", "3", "{}", "null", "{\"name\": 3}"})
    EXPECT_NE(errorOf(text), "") << text;
}

TEST(Plan, NumbersTooLargeAreRefused)
{
  EXPECT_EQ(errorOf(R"({"wall_thickness": 1e999})"),
            "house.json: a number is too large");
}

TEST(Plan, NamesAFileThatIsMissing)
{
  try {
    readPlan("no/such/plan.json");
    FAIL() << "a missing file was read";
  } catch (const PlanError& error) {
    EXPECT_STREQ(error.what(), "no/such/plan.json: cannot be read");
  }
}

} // namespace
