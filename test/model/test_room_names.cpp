/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "room_tables.h"

#include <pcl/exceptions.h>
#include <pcl/model/room_names.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <set>

namespace {

using namespace pcl::indoor;

double
of(const NamedRoom& room, RoomName name)
{
  return room.probabilities[static_cast<std::size_t>(name)];
}

RoomEvidence
room(double area, double window_area = 0.0, std::vector<std::size_t> neighbours = {})
{
  RoomEvidence evidence;
  evidence.area = area;
  evidence.perimeter = 4.2 * std::sqrt(area);
  evidence.height = 2.5;
  evidence.window_area = window_area;
  evidence.neighbours = std::move(neighbours);
  return evidence;
}

RoomObject
object(const char* name, double probability = 0.9)
{
  return {{{name, probability}}, 0.0};
}

/** A flat without furniture: a corridor, 0, with five rooms at it. */
std::vector<RoomEvidence>
flat()
{
  auto corridor = room(8.0, 0.0, {1, 2, 3, 4, 5});
  corridor.perimeter = 18.0;
  return {corridor,
          room(25.0, 4.0, {0}),
          room(12.0, 2.0, {0}),
          room(10.0, 1.5, {0}),
          room(6.0, 0.0, {0}),
          room(1.6, 0.0, {0})};
}

std::vector<RoomEvidence>
randomBuilding(std::mt19937& rng)
{
  const auto uniform = [&rng](double low, double high) {
    return low + (high - low) * static_cast<double>(rng() % 1000) / 999.0;
  };
  std::vector<RoomEvidence> rooms(1 + rng() % 9);
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    rooms[r] = room(uniform(0.2, 60.0), rng() % 2 == 0 ? uniform(0.0, 5.0) : 0.0);
    rooms[r].perimeter *= uniform(0.9, 2.0);
    rooms[r].height = uniform(2.2, 5.0);
    rooms[r].storey = rng() % 3;
    for (std::size_t n = rng() % 4; n > 0; --n)
      rooms[r].neighbours.push_back(rng() % rooms.size());
    for (std::size_t t = rng() % 8; t > 0; --t)
      rooms[r].objects.push_back(
          {{{object_shares[rng() % object_count].name, uniform(0.0, 1.0)},
            {"cabinet", uniform(0.0, 0.3)},
            {"what no model knows", 0.5}},
           uniform(-0.1, 2.0)});
  }
  return rooms;
}

TEST(RoomNames, ProbabilitiesSumToOne)
{
  std::mt19937 rng(1);
  for (int trial = 0; trial < 200; ++trial)
    for (const auto& named : nameRooms(randomBuilding(rng))) {
      const auto& p = named.probabilities;
      EXPECT_NEAR(std::accumulate(p.begin(), p.end(), 0.0), 1.0, 1e-9);
      EXPECT_GE(*std::min_element(p.begin(), p.end()), 0.0);
      EXPECT_EQ(named.probability(), *std::max_element(p.begin(), p.end()));
      EXPECT_EQ(named.text() == "unknown", named.probability() <= 0.5);
    }
}

TEST(RoomNames, DependNeitherOnTheOrderOfRoomsNorOfObjects)
{
  std::mt19937 rng(2);
  for (int trial = 0; trial < 100; ++trial) {
    const auto rooms = randomBuilding(rng);
    std::vector<std::size_t> order(rooms.size()), place(rooms.size());
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = order.size(); i > 1; --i)
      std::swap(order[i - 1], order[rng() % i]);
    std::vector<RoomEvidence> mixed;
    for (std::size_t i = 0; i < order.size(); ++i) {
      place[order[i]] = i;
      mixed.push_back(rooms[order[i]]);
      std::reverse(mixed.back().objects.begin(), mixed.back().objects.end());
    }
    for (auto& each : mixed)
      for (auto& neighbour : each.neighbours)
        neighbour = place[neighbour];
    const auto straight = nameRooms(rooms), turned = nameRooms(mixed);
    for (std::size_t r = 0; r < rooms.size(); ++r)
      for (std::size_t n = 0; n < room_name_count; ++n) // sums in another order
        EXPECT_NEAR(
            straight[r].probabilities[n], turned[place[r]].probabilities[n], 1e-9)
            << "trial " << trial;
  }
}

/** Normal density of the logarithm, but for a factor. */
double
spread(double median, double factor, double value)
{
  const double z = std::log(value / median) / std::log(factor);
  return std::exp(-0.5 * z * z) / std::log(factor);
}

/** Products of the table's numbers for rooms on one storey with light, without objects,
 * three rooms at most that lead nowhere: no largest one. */
std::vector<std::array<double, room_name_count>>
plainProducts(const std::vector<RoomEvidence>& rooms)
{
  std::vector<std::array<double, room_name_count>> products[2];
  double votes[2] = {1.0, 1.0};
  double floor = 0.0;
  for (const auto& each : rooms)
    floor += each.area;
  for (const int offices : {0, 1}) {
    double all = 0.0, joint = 1.0;
    for (const auto& custom : room_customs)
      all += offices ? custom.in_offices : custom.in_home;
    for (const auto& each : rooms) {
      products[offices].emplace_back();
      double sum = 0.0;
      for (std::size_t n = 0; n < room_name_count; ++n) {
        const auto& custom = room_customs[n];
        const bool corridor = static_cast<RoomName>(n) == RoomName::Corridor;
        const bool stairs = static_cast<RoomName>(n) == RoomName::Stairs;
        const double lit = 0.8 * custom.lit;
        double& p = products[offices].back()[n];
        p = (offices ? custom.in_offices : custom.in_home) / all *
            spread(offices ? custom.offices_area : custom.home_area,
                   custom.spread,
                   each.area) *
            spread(custom.stretch,
                   corridor ? 1.3 : 1.12,
                   std::max(1.0, each.perimeter / 4.0 / std::sqrt(each.area))) *
            (each.window_area * 16.0 >= each.area ? lit : 1.0 - lit) * custom.ways[0] *
            (stairs ? 0.05 : 1.0);
        sum += p;
      }
      joint *= sum;
      for (auto& p : products[offices].back())
        p /= sum;
    }
    votes[offices] = std::pow(joint, 3.0 / std::max<double>(3.0, rooms.size())) *
                     (offices ? spread(400.0, 2.2, floor) : spread(70.0, 1.8, floor));
  }
  const double home = votes[0] / (votes[0] + votes[1]);
  for (std::size_t r = 0; r < rooms.size(); ++r)
    for (std::size_t n = 0; n < room_name_count; ++n)
      products[0][r][n] = home * products[0][r][n] + (1.0 - home) * products[1][r][n];
  return products[0];
}

TEST(RoomNames, AreProductsOfTheTablesNumbers)
{
  std::mt19937 rng(3);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<RoomEvidence> rooms(1 + rng() % 3);
    for (auto& each : rooms) {
      each = room(5.0 + static_cast<double>(rng() % 400) / 10.0,
                  static_cast<double>(rng() % 50) / 10.0);
    }
    rooms[0].window_area = rooms[0].area / 2.0;
    const double all =
        std::accumulate(rooms.begin(), rooms.end(), 0.0, [](double sum, const auto& r) {
          return sum + r.area;
        });
    rooms[0].window_area = std::max(rooms[0].window_area, all / 8.0);
    if (0.3 * rooms[0].area * 16.0 < all)
      continue; // glass of one room does not light the storey
    const auto expected = plainProducts(rooms);
    const auto named = nameRooms(rooms);
    for (std::size_t r = 0; r < rooms.size(); ++r)
      for (std::size_t n = 0; n < room_name_count; ++n)
        EXPECT_NEAR(named[r].probabilities[n], expected[r][n], 1e-9)
            << "trial " << trial << ", " << nameOf(static_cast<RoomName>(n));
  }
}

TEST(RoomNames, AreUnknownWhereNothingIsKnown)
{
  EXPECT_TRUE(nameRooms({}).empty());
  const auto named = nameRooms({RoomEvidence()});
  ASSERT_EQ(named.size(), 1u);
  EXPECT_EQ(named[0].text(), "unknown");
  for (const auto& each : nameRooms(std::vector<RoomEvidence>(9)))
    EXPECT_EQ(each.text(), "unknown");
  auto strange = room(12.0, 2.0);
  strange.objects = {object("what no model knows"), object("lamp")};
  EXPECT_EQ(nameRooms({strange})[0].probabilities,
            nameRooms({room(12.0, 2.0)})[0].probabilities);
}

TEST(RoomNames, TellAFlatWithoutFurnitureByItsSpaces)
{
  const auto named = nameRooms(flat());
  EXPECT_EQ(named[0].text(), "corridor");
  EXPECT_EQ(named[1].text(), "living");
  EXPECT_EQ(named[2].likeliest(), RoomName::Bedroom);
  EXPECT_EQ(named[4].likeliest(), RoomName::Bath);
  EXPECT_EQ(named[5].likeliest(), RoomName::Toilet);
}

TEST(RoomNames, ObjectsTellWhatSpacesDoNot)
{
  auto rooms = flat();
  const auto empty = nameRooms(rooms);
  rooms[2].objects = {object("bed"), object("cabinet"), object("pillow")};
  rooms[3].objects = {
      object("table"), object("sink"), object("cabinet"), object("cabinet")};
  rooms[3].objects.back().foot = 1.5;
  rooms[4].objects = {object("bath"), object("sink"), object("toilet")};
  const auto full = nameRooms(rooms);
  EXPECT_EQ(full[2].text(), "bedroom");
  EXPECT_EQ(full[3].text(), "kitchen");
  EXPECT_EQ(full[4].text(), "bath");
  EXPECT_GT(of(full[2], RoomName::Bedroom), of(empty[2], RoomName::Bedroom));
  EXPECT_GT(of(full[3], RoomName::Kitchen), of(empty[3], RoomName::Kitchen));
  EXPECT_GT(of(full[4], RoomName::Bath), of(empty[4], RoomName::Bath));
}

TEST(RoomNames, ASurerObjectSaysMore)
{
  double before = 0.0;
  for (const double sure : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
    auto rooms = flat();
    rooms[3].objects = {object("bed", sure)};
    const double now = of(nameRooms(rooms)[3], RoomName::Bedroom);
    EXPECT_GT(now, before);
    before = now;
  }
}

TEST(RoomNames, CabinetsHangWhereTheirFootIsHigh)
{
  auto low = flat(), high = flat();
  low[3].objects = {object("cabinet")};
  high[3].objects = {object("cabinet")};
  high[3].objects[0].foot = lowest_wall_cabinet + 0.01;
  EXPECT_GT(of(nameRooms(high)[3], RoomName::Kitchen),
            2.0 * of(nameRooms(low)[3], RoomName::Kitchen));
}

TEST(RoomNames, DarkRoomsBelowTheEntranceAreForStorage)
{
  auto rooms = flat();
  for (auto& each : rooms)
    each.storey = 1;
  rooms.push_back(room(9.0));
  const auto named = nameRooms(rooms);
  EXPECT_GT(of(named[6], RoomName::Storage) + of(named[6], RoomName::Technical), 0.7);
}

TEST(RoomNames, ManyEqualRoomsAtALongCorridorAreOffices)
{
  std::vector<RoomEvidence> rooms{room(60.0)};
  rooms[0].perimeter = 64.0;
  for (std::size_t r = 1; r <= 20; ++r) {
    rooms.push_back(room(18.0, 3.0, {0}));
    rooms[0].neighbours.push_back(r);
  }
  const auto named = nameRooms(rooms);
  EXPECT_EQ(named[0].text(), "corridor");
  for (std::size_t r = 1; r < rooms.size(); ++r)
    EXPECT_EQ(named[r].text(), "office");
}

TEST(RoomNames, TwoEqualHomesAreNoSurerThanOne)
{
  auto rooms = flat();
  for (auto& each : rooms)
    each.area *= 2.0;
  rooms[2].objects = {object("desk"), object("chair"), object("screen")};
  rooms[4].objects = {object("bath"), object("toilet"), object("sink")};
  const auto one = nameRooms(rooms);
  for (std::size_t r = 0; r < 6; ++r) {
    rooms.push_back(rooms[r]);
    for (auto& neighbour : rooms.back().neighbours)
      neighbour += 6;
  }
  const auto two = nameRooms(rooms);
  for (std::size_t r = 0; r < rooms.size(); ++r)
    for (std::size_t n = 0; n < room_name_count; ++n)
      EXPECT_NEAR(two[r].probabilities[n], one[r % 6].probabilities[n], 0.01)
          << "room " << r << ", " << nameOf(static_cast<RoomName>(n));
}

TEST(RoomNames, RefuseWhatCannotBe)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto expect_refused = [](RoomEvidence wrong) {
    EXPECT_THROW(nameRooms({room(5.0), wrong}), pcl::BadArgumentException);
  };
  expect_refused(room(-1.0));
  expect_refused(room(none));
  expect_refused(room(9.0, -0.1));
  expect_refused(room(9.0, none));
  expect_refused(room(9.0, 0.0, {2}));
  auto wrong = room(9.0);
  wrong.height = none;
  expect_refused(wrong);
  wrong = room(9.0);
  wrong.perimeter = -1.0;
  expect_refused(wrong);
  wrong = room(9.0);
  wrong.objects = {object("bed", 1.1)};
  expect_refused(wrong);
  wrong.objects = {object("bed")};
  wrong.objects[0].foot = none;
  expect_refused(wrong);
}

TEST(RoomNames, TablesHoldShares)
{
  for (const auto& custom : room_customs) {
    EXPECT_NEAR(custom.levels[0] + custom.levels[1] + custom.levels[2], 1.0, 1e-9);
    EXPECT_NEAR(custom.ways[0] + custom.ways[1] + custom.ways[2], 1.0, 1e-9);
    for (const double share : {custom.lit, custom.largest, custom.tall}) {
      EXPECT_GT(share, 0.0);
      EXPECT_LT(share, 1.0);
    }
    EXPECT_GT(custom.spread, 1.0);
    EXPECT_GE(custom.stretch, 1.0);
    EXPECT_GT(custom.in_home + custom.in_offices, 0.0);
  }
  for (const auto& each : object_shares)
    for (const double share : each.shares) {
      EXPECT_GE(share, 0.0);
      EXPECT_LE(share, 1.0);
    }
  std::set<std::string> names;
  for (std::size_t n = 0; n < room_name_count; ++n)
    names.insert(nameOf(static_cast<RoomName>(n)));
  EXPECT_EQ(names.size(), room_name_count);
}

} // namespace
