/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "joint_names.h"

#include "room_tables.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace pcl::indoor {

namespace {

bool
isWay(RoomName name)
{
  return name == RoomName::Corridor || name == RoomName::Stairs ||
         name == RoomName::Hall;
}

/** A side of a door: what the room behind it says, and where that room hears back. */
struct Door {
  std::size_t room = 0; ///< behind it
  std::size_t back = 0; ///< place of this door among those of that room
  double says = 0.0;    ///< logarithm of a factor of all names that are no ways
};

/** A room among others. Only these groups of names matter to them. */
struct JoinedRoom {
  double way = 1e-12; ///< shares by the room itself; a way is never impossible
  double bath = 0.0, other = 0.0;
  std::vector<Door> doors;
  double needs_bath = 0.0; ///< logarithm of a factor of the name bath

  double
  fromDoors() const
  {
    double sum = 0.0;
    for (const auto& door : doors)
      sum += door.says;
    return sum;
  }

  /** The share of ways, but for what is heard through a door. */
  double
  wayWithout(const Door& door) const
  {
    const double no_way =
        std::exp(fromDoors() - door.says) * (other + bath * std::exp(needs_bath));
    return way / (way + no_way);
  }

  /** The share of baths, but for whether a bath is missing. */
  double
  bathByItself() const
  {
    const double factor = std::exp(fromDoors());
    return factor * bath / (way + factor * (bath + other));
  }
};

std::vector<JoinedRoom>
joinedRooms(const std::vector<NameScores>& scores,
            const std::vector<RoomEvidence>& rooms)
{
  std::vector<JoinedRoom> joined(rooms.size());
  std::set<std::pair<std::size_t, std::size_t>> doors;
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    const auto shares = sharesOf(scores[r]);
    for (std::size_t n = 0; n < room_name_count; ++n) {
      const auto name = static_cast<RoomName>(n);
      (isWay(name)              ? joined[r].way
       : name == RoomName::Bath ? joined[r].bath
                                : joined[r].other) += shares[n];
    }
    for (const auto other : rooms[r].neighbours)
      if (other != r)
        doors.emplace(std::min(r, other), std::max(r, other));
  }
  for (const auto& [a, b] : doors) {
    joined[a].doors.push_back({b, joined[b].doors.size()});
    joined[b].doors.push_back({a, joined[a].doors.size() - 1});
  }
  return joined;
}

/** All rooms tell those behind their doors at once how likely they are no ways. */
void
tellNeighbours(std::vector<JoinedRoom>& rooms)
{
  constexpr double no_way = 0.3; // of doors: docs/method/room_names.md
  const auto before = rooms;
  for (auto& room : rooms)
    for (auto& door : room.doors) {
      const auto& other = before[door.room];
      const double way = other.wayWithout(other.doors[door.back]);
      door.says = std::log(way + no_way * (1.0 - way));
    }
}

/** The product of all but one factor each: zeros are no trouble. */
std::vector<double>
productsOfOthers(const std::vector<double>& factors)
{
  std::vector<double> products(factors.size(), 1.0);
  double before = 1.0, behind = 1.0;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    products[i] *= before;
    before *= factors[i];
  }
  for (std::size_t i = factors.size(); i-- > 0;) {
    products[i] *= behind;
    behind *= factors[i];
  }
  return products;
}

/** The less likely other rooms are baths, the likelier this one is. Half a step at a
 * time: else all rooms would give way at once. */
void
askForBath(std::vector<JoinedRoom>& rooms)
{
  constexpr double without = 0.1; // of homes: a bath may not have been scanned
  std::vector<double> no_bath;
  for (const auto& room : rooms)
    no_bath.push_back(1.0 - room.bathByItself());
  const auto others = productsOfOthers(no_bath);
  for (std::size_t r = 0; r < rooms.size(); ++r)
    rooms[r].needs_bath =
        0.5 * (rooms[r].needs_bath - std::log(1.0 - (1.0 - without) * others[r]));
}

} // namespace

double
sumOf(const NameScores& scores)
{
  const double most = *std::max_element(scores.begin(), scores.end());
  double sum = 0.0;
  for (const double score : scores)
    sum += std::exp(score - most);
  return most + std::log(sum);
}

Shares
sharesOf(const NameScores& scores)
{
  const double sum = sumOf(scores);
  Shares shares{};
  for (std::size_t n = 0; n < shares.size(); ++n)
    shares[n] = std::exp(scores[n] - sum);
  return shares;
}

std::vector<NameScores>
jointNames(std::vector<NameScores> scores,
           const std::vector<RoomEvidence>& rooms,
           bool home)
{
  constexpr int rounds = 20; // what is said fades with every door
  auto joined = joinedRooms(scores, rooms);
  for (int round = 0; round < rounds; ++round) {
    if (home && rooms.size() >= rooms_of_home)
      askForBath(joined);
    tellNeighbours(joined);
  }
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    for (std::size_t n = 0; n < room_name_count; ++n)
      if (!isWay(static_cast<RoomName>(n)))
        scores[r][n] += joined[r].fromDoors();
    scores[r][static_cast<std::size_t>(RoomName::Bath)] += joined[r].needs_bath;
  }
  return scores;
}

} // namespace pcl::indoor
