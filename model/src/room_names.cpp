/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/model/room_names.h>

#include "joint_names.h"
#include "room_traits.h"

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::indoor {

namespace {

enum class BuildingUse { Home, Offices };

// Of the doubts about what is seen: how often a window is found that is there
// (docs/experiments/openings.md), and an object is found and named as what it is
// (docs/experiments/objects.md and classes.md: 64 % whole, 63 % of them named right).
constexpr double found_windows = 0.8, found_objects = 0.4;
constexpr double trust = 0.9; // in the confidence of a class: it is a little too high

/** Logarithm of the density of what varies by a factor around its median. */
double
around(double median, double factor, double value)
{
  const double deviation = std::log(value / median) / std::log(factor);
  return -0.5 * deviation * deviation - std::log(std::log(factor));
}

double
chance(double share, bool is)
{
  return std::log(is ? share : 1.0 - share);
}

double
levelChance(const RoomCustom& custom, std::size_t level, const BuildingTraits& building)
{
  constexpr double least = 0.01;
  double possible = 0.0;
  for (std::size_t l = 0; l < building.levels.size(); ++l)
    possible += building.levels[l] ? custom.levels[l] : 0.0;
  return std::log(std::max(least, custom.levels[level] / std::max(least, possible)));
}

/** A room without stairs that are seen is hardly ever one for them. */
double
stairsChance(const RoomTraits& room)
{
  constexpr double unseen = 0.3, impossible = 0.05;
  const auto stairs = std::find_if(
      std::begin(object_shares), std::end(object_shares), [](const auto& object) {
        return object.name == std::string("stairs");
      });
  const double seen = room.seen[stairs - std::begin(object_shares)];
  return std::log(seen + (1.0 - seen) * (room.may_have_stairs ? unseen : impossible));
}

/** How many rooms of a name there are. */
double
numberIn(BuildingUse use, const RoomCustom& custom)
{
  return use == BuildingUse::Home ? custom.in_home : custom.in_offices;
}

/** What size, shape, light, ways and storey say for a name. */
double
spaceScore(const RoomTraits& room,
           RoomName name,
           BuildingUse use,
           const BuildingTraits& building)
{
  const bool home = use == BuildingUse::Home;
  const auto& custom = room_customs[static_cast<std::size_t>(name)];
  const double number = numberIn(use, custom);
  if (!(number > 0.0))
    return -std::numeric_limits<double>::infinity();
  constexpr double smallest = 0.3; // m^2
  double score = std::log(number) + std::log(custom.ways[room.ways]);
  if (room.area)
    score += around(home ? custom.home_area : custom.offices_area,
                    custom.spread,
                    std::max(smallest, *room.area));
  if (room.stretch)
    score +=
        around(custom.stretch, name == RoomName::Corridor ? 1.3 : 1.12, *room.stretch);
  if (room.lit)
    score += chance(found_windows * custom.lit, *room.lit);
  if (room.level)
    score += levelChance(custom, *room.level, building);
  if (room.largest && home)
    score += chance(custom.largest, *room.largest);
  if (room.tall)
    score += std::log(custom.tall);
  if (name == RoomName::Stairs)
    score += stairsChance(room);
  return score;
}

NameScores
spaceScores(const RoomTraits& room, BuildingUse use, const BuildingTraits& building)
{
  double numbers = 0.0;
  for (const auto& custom : room_customs)
    numbers += numberIn(use, custom);
  NameScores scores{};
  for (std::size_t n = 0; n < room_name_count; ++n)
    scores[n] =
        spaceScore(room, static_cast<RoomName>(n), use, building) - std::log(numbers);
  return scores;
}

/** The share of the rooms of each name that hold an object. */
Shares
sharesWith(const ObjectShares& object)
{
  constexpr double least = 0.05, in_stairs = 0.95;
  constexpr RoomName counted[] = {RoomName::Kitchen,
                                  RoomName::Living,
                                  RoomName::Bedroom,
                                  RoomName::Bath,
                                  RoomName::Toilet,
                                  RoomName::Corridor,
                                  RoomName::Office,
                                  RoomName::Meeting,
                                  RoomName::Storage};
  double mean = 0.0;
  for (const double share : object.shares)
    mean += share / static_cast<double>(std::size(counted));
  Shares shares{};
  shares.fill(mean);
  for (std::size_t c = 0; c < std::size(counted); ++c)
    shares[static_cast<std::size_t>(counted[c])] = object.shares[c];
  const auto of = [&shares](RoomName name) -> double& {
    return shares[static_cast<std::size_t>(name)];
  };
  of(RoomName::Technical) = of(RoomName::Storage);
  of(RoomName::Stairs) =
      object.name == std::string("stairs") ? in_stairs : of(RoomName::Corridor);
  for (auto& share : shares)
    share = std::max(least, share);
  return shares;
}

std::array<Shares, object_count>
allObjectShares()
{
  std::array<Shares, object_count> all{};
  for (std::size_t t = 0; t < object_count; ++t)
    all[t] = sharesWith(object_shares[t]);
  return all;
}

/** Scores of a room's names, if the building is a home and if it is offices. */
struct Views {
  std::array<NameScores, 2> scores; ///< as a home, as offices
};

/** How much more often an object is seen, or not seen, in rooms of each name than in
 * all that the room may be (Jeffrey's rule: the class is sure to a degree).
 * \param[in] seen whether the object is there
 * \param[in] share of the rooms of a name that hold it
 * \param[in] of_all the same share of all that the room may be
 */
double
objectFactor(double seen, bool furnished, double share, double of_all)
{
  const double unseen =
      furnished ? (1.0 - found_objects * share) / (1.0 - found_objects * of_all) : 1.0;
  return seen * share / of_all + (1.0 - seen) * unseen;
}

/** What the objects in a room say, added to what it is like. */
Views
withObjects(const Views& space, const RoomTraits& room, double home)
{
  static const auto shares = allObjectShares();
  const std::array<double, 2> weights = {home, 1.0 - home};
  const std::array<Shares, 2> before = {sharesOf(space.scores[0]),
                                        sharesOf(space.scores[1])};
  Views views = space;
  for (std::size_t t = 0; t < object_count; ++t) {
    double of_all = 0.0;
    for (std::size_t use = 0; use < 2; ++use)
      for (std::size_t n = 0; n < room_name_count; ++n)
        of_all += weights[use] * before[use][n] * shares[t][n];
    for (auto& scores : views.scores)
      for (std::size_t n = 0; n < room_name_count; ++n)
        scores[n] += std::log(
            objectFactor(trust * room.seen[t], room.furnished, shares[t][n], of_all));
  }
  return views;
}

/** Sums of logarithms of probabilities: what all rooms say for a home over offices. */
double
votesOf(const std::vector<Views>& rooms)
{
  double votes = 0.0;
  for (const auto& room : rooms)
    votes += sumOf(room.scores[0]) - sumOf(room.scores[1]);
  return votes;
}

double
logistic(double odds)
{
  return 1.0 / (1.0 + std::exp(-odds));
}

/** What the area of a storey says for a home, and the rooms as so many as are unlike:
 * those of a building are alike. */
double
votesFor(const BuildingTraits& building, const std::vector<Views>& rooms)
{
  constexpr double unlike = 3.0;                                // rooms
  constexpr double home_floor = 70.0, home_spread = 1.8;        // m^2
  constexpr double offices_floor = 400.0, offices_spread = 2.2; // m^2
  constexpr double least = 5.0;                                 // m^2
  double votes =
      votesOf(rooms) * std::min(1.0, unlike / static_cast<double>(rooms.size()));
  if (building.floor_area) {
    const double floor = std::max(least, *building.floor_area);
    votes += around(home_floor, home_spread, floor) -
             around(offices_floor, offices_spread, floor);
  }
  return votes;
}

/** The names of all rooms as those of a home or of offices. */
std::vector<NameScores>
jointScores(const std::vector<Views>& views,
            const std::vector<RoomEvidence>& rooms,
            BuildingUse use)
{
  std::vector<NameScores> scores;
  for (const auto& room : views)
    scores.push_back(room.scores[static_cast<std::size_t>(use)]);
  return jointNames(std::move(scores), rooms, use == BuildingUse::Home);
}

NamedRoom
namedRoom(const NameScores& as_home, const NameScores& as_offices, double home)
{
  const Shares shares[] = {sharesOf(as_home), sharesOf(as_offices)};
  NamedRoom named;
  for (std::size_t n = 0; n < room_name_count; ++n)
    named.probabilities[n] = home * shares[0][n] + (1.0 - home) * shares[1][n];
  return named;
}

bool
isAmount(double value)
{
  return std::isfinite(value) && value >= 0.0;
}

void
requireValid(const std::vector<RoomEvidence>& rooms)
{
  for (const auto& room : rooms) {
    bool is_valid = isAmount(room.area) && isAmount(room.perimeter) &&
                    isAmount(room.height) && isAmount(room.window_area);
    for (const auto neighbour : room.neighbours)
      is_valid = is_valid && neighbour < rooms.size();
    for (const auto& object : room.objects) {
      is_valid = is_valid && std::isfinite(object.foot);
      for (const auto& each : object.classes)
        is_valid = is_valid && isAmount(each.second) && each.second <= 1.0 + 1e-6;
    }
    if (!is_valid)
      PCL_THROW_EXCEPTION(BadArgumentException,
                          "a room has an area, length, height, position, probability "
                          "or neighbour out of range");
  }
}

} // namespace

const char*
nameOf(RoomName name)
{
  constexpr const char* names[room_name_count] = {"kitchen",
                                                  "living",
                                                  "bedroom",
                                                  "bath",
                                                  "toilet",
                                                  "corridor",
                                                  "stairs",
                                                  "office",
                                                  "meeting",
                                                  "storage",
                                                  "technical",
                                                  "hall",
                                                  "balcony",
                                                  "other"};
  return names[static_cast<std::size_t>(name)];
}

RoomName
NamedRoom::likeliest() const
{
  return static_cast<RoomName>(
      std::max_element(probabilities.begin(), probabilities.end()) -
      probabilities.begin());
}

double
NamedRoom::probability() const
{
  return probabilities[static_cast<std::size_t>(likeliest())];
}

bool
NamedRoom::isKnown() const
{
  return probability() > 0.5;
}

std::string
NamedRoom::text() const
{
  return isKnown() ? nameOf(likeliest()) : "unknown";
}

std::vector<NamedRoom>
nameRooms(const std::vector<RoomEvidence>& rooms)
{
  constexpr double doubt = 0.05; // before the objects are looked at
  requireValid(rooms);
  if (rooms.empty())
    return {};
  const auto building = buildingTraits(rooms);
  std::vector<Views> space, full;
  for (const auto& room : building.rooms)
    space.push_back({{spaceScores(room, BuildingUse::Home, building),
                      spaceScores(room, BuildingUse::Offices, building)}});
  const double before =
      std::clamp(logistic(votesFor(building, space)), doubt, 1.0 - doubt);
  for (std::size_t r = 0; r < rooms.size(); ++r)
    full.push_back(withObjects(space[r], building.rooms[r], before));
  const double home = logistic(votesFor(building, full));
  const auto as_home = jointScores(full, rooms, BuildingUse::Home),
             as_offices = jointScores(full, rooms, BuildingUse::Offices);
  std::vector<NamedRoom> named;
  for (std::size_t r = 0; r < rooms.size(); ++r)
    named.push_back(namedRoom(as_home[r], as_offices[r], home));
  return named;
}

} // namespace pcl::indoor
