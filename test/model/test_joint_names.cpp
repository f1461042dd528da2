/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "joint_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace {

using namespace pcl::indoor;

constexpr auto bath = static_cast<std::size_t>(RoomName::Bath);

bool
isWay(std::size_t name)
{
  return name == static_cast<std::size_t>(RoomName::Corridor) ||
         name == static_cast<std::size_t>(RoomName::Stairs) ||
         name == static_cast<std::size_t>(RoomName::Hall);
}

NameScores
randomScores(std::mt19937& rng)
{
  NameScores scores;
  for (auto& score : scores)
    score = static_cast<double>(rng() % 4000) / 1000.0 - 2.0;
  return scores;
}

/** Each room but the first has a door to one before it, told by either side. */
std::vector<RoomEvidence>
randomTree(std::size_t size, std::mt19937& rng)
{
  std::vector<RoomEvidence> rooms(size);
  for (std::size_t r = 1; r < size; ++r) {
    const std::size_t other = rng() % r;
    if (rng() % 2 == 0)
      rooms[r].neighbours = {other, other};
    else
      rooms[other].neighbours.push_back(r);
  }
  return rooms;
}

/** Sums over all names of all rooms: a door between two rooms that are no ways counts
 * 0.3, a home without a bath 0.1. */
std::vector<NameScores>
bruteForce(const std::vector<NameScores>& scores,
           const std::vector<RoomEvidence>& rooms,
           bool needs_bath)
{
  std::vector<NameScores> sums(rooms.size(), NameScores{});
  std::vector<std::size_t> names(rooms.size(), 0);
  while (true) {
    double product = 1.0;
    for (std::size_t r = 0; r < rooms.size(); ++r)
      product *= std::exp(scores[r][names[r]]);
    for (std::size_t a = 0; a < rooms.size(); ++a)
      for (std::size_t b = 0; b < a; ++b) {
        const auto leads = [&rooms](std::size_t from, std::size_t to) {
          const auto& others = rooms[from].neighbours;
          return std::find(others.begin(), others.end(), to) != others.end();
        };
        if ((leads(a, b) || leads(b, a)) && !isWay(names[a]) && !isWay(names[b]))
          product *= 0.3;
      }
    if (needs_bath && std::count(names.begin(), names.end(), bath) == 0)
      product *= 0.1;
    for (std::size_t r = 0; r < rooms.size(); ++r)
      sums[r][names[r]] += product;
    std::size_t r = 0;
    while (r < names.size() && ++names[r] == room_name_count)
      names[r++] = 0;
    if (r == names.size())
      break;
  }
  for (auto& room : sums)
    for (auto& sum : room)
      sum = std::log(sum);
  return sums;
}

void
expectEqualShares(const std::vector<NameScores>& found,
                  const std::vector<NameScores>& expected,
                  double tolerance)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t r = 0; r < found.size(); ++r) {
    const auto f = sharesOf(found[r]), e = sharesOf(expected[r]);
    for (std::size_t n = 0; n < room_name_count; ++n)
      EXPECT_NEAR(f[n], e[n], tolerance) << "room " << r << ", name " << n;
  }
}

TEST(JointNames, AreExactForDoorsThatFormNoRing)
{
  std::mt19937 rng(1);
  for (int trial = 0; trial < 20; ++trial) {
    const auto rooms = randomTree(2 + rng() % 3, rng);
    std::vector<NameScores> scores;
    for (std::size_t r = 0; r < rooms.size(); ++r)
      scores.push_back(randomScores(rng));
    expectEqualShares(
        jointNames(scores, rooms, false), bruteForce(scores, rooms, false), 1e-9);
  }
}

TEST(JointNames, AHomeOfFourRoomsHasABath)
{
  std::mt19937 rng(2);
  for (int trial = 0; trial < 10; ++trial) {
    std::vector<NameScores> scores;
    for (int r = 0; r < 4; ++r)
      scores.push_back(randomScores(rng));
    const std::vector<RoomEvidence> rooms(4); // without doors: exact, too
    expectEqualShares(
        jointNames(scores, rooms, true), bruteForce(scores, rooms, true), 1e-4);
    scores.pop_back();
    expectEqualShares(
        jointNames(scores, {rooms.begin(), rooms.end() - 1}, true), scores, 1e-9);
  }
}

TEST(JointNames, ARoomAmongRoomsIsAWay)
{
  const NameScores even{};
  std::vector<RoomEvidence> rooms(5);
  rooms[0].neighbours = {1, 2, 3, 4};
  const auto named = jointNames(std::vector<NameScores>(5, even), rooms, false);
  constexpr auto corridor = static_cast<std::size_t>(RoomName::Corridor);
  EXPECT_GT(sharesOf(named[0])[corridor], 2.0 * sharesOf(named[1])[corridor]);
  EXPECT_GT(sharesOf(named[1])[corridor], sharesOf(even)[corridor]);
}

TEST(JointNames, StayNumbersWhereNothingIsLikely)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<NameScores> scores(1001);
  for (auto& each : scores) {
    each.fill(-infinity);
    each[bath] = -1e4;
  }
  std::vector<RoomEvidence> rooms(1001);
  for (std::size_t r = 1; r < rooms.size(); ++r)
    rooms[0].neighbours.push_back(r);
  for (const auto& each : jointNames(scores, rooms, true))
    EXPECT_EQ(sharesOf(each)[bath], 1.0);
  EXPECT_TRUE(jointNames({}, {}, true).empty());
}

} // namespace
