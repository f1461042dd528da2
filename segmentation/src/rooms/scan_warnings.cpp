/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/scan_overview.h> // for likelyMetresPerUnit
#include <pcl/segmentation/scan_warnings.h>

#include "rooms/dimensions.h"
#include "rooms/map/building_steps.h"
#include "rooms/map/region_evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace pcl::indoor {
namespace {

constexpr double foot = 0.3048;            // metres
constexpr double highest_room = 50.0;      // metres, the lowest one in inches
constexpr double highest_usual_room = 3.5; // metres

struct Unit {
  double metres;
  const char* text; ///< of these
  const char* name;
  const char* option;
};

constexpr Unit units[] = {{1.0, "1", "metres", "m"},
                          {foot, "0.3048", "feet", "ft"},
                          {0.0254, "0.0254", "inches", "in"},
                          {0.01, "0.01", "centimetres", "cm"},
                          {0.001, "0.001", "millimetres", "mm"}};

/** Both ends belong to it. */
bool
isBetween(double low, double value, double high)
{
  return low <= value && value <= high;
}

/** Rooms as people build them, by their heights in metres. */
bool
isUsualRoom(double height)
{
  return isBetween(2.0, height, highest_usual_room);
}

/** The one of these that has so many metres. */
const Unit&
unitOf(double metres)
{
  for (const Unit& unit : units)
    if (unit.metres == metres)
      return unit;
  return units[0];
}

/** A height in metres, rounded. */
std::string
heightText(double height)
{
  std::ostringstream text;
  text << (height < 10.0 ? 0.1 * std::round(10.0 * height) : std::round(height))
       << " m";
  return text.str();
}

std::string
unitLine(double metres, double height)
{
  const Unit& unit = unitOf(metres);
  return std::string("The scan is probably in ") + unit.name +
         ": its rooms seem to be " + heightText(height) + " high; set " + unit.text +
         " metres per unit (-unit " + unit.option + ").";
}

/** A direction as the option -up has it. */
std::string
directionText(const Eigen::Vector3f& direction)
{
  int axis = 0;
  const float most = direction.cwiseAbs().maxCoeff(&axis);
  std::ostringstream text;
  if (most > 0.9999f) // within 0.8 degrees of an axis
    text << (direction[axis] < 0.0f ? "-" : "") << static_cast<char>('x' + axis);
  else
    for (int i = 0; i < 3; ++i)
      text << (i > 0 ? "," : "")
           << 0.001 * std::round(1000.0 * static_cast<double>(direction[i])) + 0.0;
  return text.str();
}

/** The share of the rooms' borders, by their areas, where a wall or another room was
 * seen; 1 without rooms. */
double
closedShare(const std::vector<Room>& rooms)
{
  double area = 0.0, closed = 0.0;
  for (const Room& room : rooms) {
    area += room.area;
    closed += room.area * room.seen;
  }
  return area > 0.0 ? closed / area : 1.0;
}

/** Passages that begin at one end of the rooms and not at the other one. */
struct Passages {
  explicit Passages(const std::vector<RoomOpening>& openings)
  {
    constexpr double clear = 0.5 * lintel_height; // above the middle of the passage
    for (const RoomOpening& opening : openings) {
      hanging += opening.rise > clear;
      standing += opening.rise < -clear;
    }
  }

  /** What is odd about those that hang. */
  std::string
  text() const
  {
    return std::to_string(hanging) + " of " + std::to_string(hanging + standing) +
           " passages between rooms reach the ceiling, not the floor";
  }

  int hanging = 0, standing = 0;
};

} // namespace

double
likelyMetresPerUnit(double length)
{
  constexpr double room_height = 2.5; // metres
  double best = 1.0;
  for (const Unit& unit : units)
    if (std::abs(std::log(length * unit.metres / room_height)) <
        std::abs(std::log(length * best / room_height)))
      best = unit.metres;
  return best;
}

double
metresPerUnit(double room_height)
{
  return room_height > highest_room ? likelyMetresPerUnit(room_height) : 1.0;
}

std::string
unitNote(double room_height, double metres_per_unit)
{
  if (metres_per_unit == 1.0)
    return {};
  return std::string("The scan is taken to be in ") + unitOf(metres_per_unit).name +
         ": in metres its rooms would be " + heightText(room_height) +
         " high; if they are, set the unit (-unit m).";
}

std::string
unitWarning(const Vertical& vertical, double metres_per_unit)
{
  constexpr double lowest = 0.1; // metres; a table's legs
  const double height = vertical.room_height * metres_per_unit;
  if (!(height > 0.0))
    return {};
  if (!isBetween(lowest, height, highest_room)) {
    const double likely = likelyMetresPerUnit(vertical.room_height);
    return likely == metres_per_unit ? std::string() : unitLine(likely, height);
  }
  // objects that stand in rooms of a hall's height are as high as in homes
  if (metres_per_unit == 1.0 && vertical.is_furnished && isUsualRoom(foot * height))
    return unitLine(foot, height);
  if ((vertical.has_rooms && height < standing_height) ||
      (metres_per_unit == 1.0 && vertical.is_furnished &&
       foot * height > highest_usual_room))
    return "The scale of the scan is probably wrong: its rooms seem to be " +
           heightText(height) + " high; scale the points, or set the unit (-unit).";
  return {};
}

std::string
feetWarning(const std::vector<Room>& rooms,
            const std::vector<RoomOpening>& openings,
            double metres_per_unit)
{
  // In feet taken for metres, furniture is taken for storeys in parts, so not all rooms
  // will be as usual.
  const auto is_door = [](double height) { return isBetween(1.8, height, 2.5); };
  constexpr int several = 5; // more than the aisles of a church
  double area = 0.0, fitting = 0.0, height = 0.0;
  int high_rooms = 0, high_doors = 0, doors = 0;
  for (const Room& room : rooms) {
    area += room.area;
    if (!isUsualRoom(foot * room.height))
      continue;
    ++high_rooms;
    fitting += room.area;
    height += room.area * room.height;
  }
  for (const RoomOpening& opening : openings) {
    high_doors += is_door(foot * opening.area / opening.width);
    doors += is_door(opening.area / opening.width);
  }
  const bool in_feet = high_rooms >= several && 3.0 * fitting > 2.0 * area &&
                       high_doors >= several && high_doors > 2 * doors;
  return in_feet && metres_per_unit == 1.0 ? unitLine(foot, height / fitting)
                                           : std::string();
}

std::string
verticalNote(const Vertical& vertical)
{
  if (!vertical.doubtful.isZero()) {
    const auto name = directionText(vertical.doubtful);
    return "The scan may lie on its side: floors and ceilings seem to lie across " +
           name + "; if so, set that as up axis (-up " + name + " or -up " +
           directionText(-vertical.doubtful) + ").";
  }
  const Eigen::Vector3f up = vertical.upAxis();
  if (up == Eigen::Vector3f::UnitZ())
    return vertical.is_found && !vertical.is_end_known
               ? "The scan may be upside down: more objects stand out from the "
                 "ceilings "
                 "than from the floors; if it is, set -up -z."
               : "";
  const double degrees = vertical.tilt() * 180.0 / M_PI;
  std::ostringstream line;
  if (degrees > 135.0)
    line << "The scan is upside down";
  else if (degrees > 46.0)
    line << "The scan lies on its side";
  else
    line << "The scan is tilted by " << 0.1 * std::round(10.0 * degrees) << " degrees";
  line << ": taken as upright along " << directionText(up) << " (-up "
       << directionText(up) << ").";
  if (!vertical.is_end_known)
    line << " Which end is up is not clear: if floors come out on top, set -up "
         << directionText(-up) << ".";
  return line.str();
}

int
endOfPassages(const std::vector<RoomOpening>& openings)
{
  const Passages passages(openings);
  const auto several = [](int most, int others) {
    return most >= 2 && most > 3 * others;
  };
  return several(passages.hanging, passages.standing)   ? 1
         : several(passages.standing, passages.hanging) ? -1
                                                        : 0;
}

bool
allPassagesStand(const std::vector<RoomOpening>& openings)
{
  const Passages passages(openings);
  return passages.standing >= 2 && passages.hanging == 0;
}

std::string
endWarning(const std::vector<RoomOpening>& openings, const Eigen::Vector3f& up_axis)
{
  if (endOfPassages(openings) != 1)
    return {};
  return "The scan may be upside down: " + Passages(openings).text() +
         "; if it is, set -up " + directionText(-up_axis) + ".";
}

std::string
unclearEndNote(const Eigen::Vector3f& up_axis)
{
  return "Neither furniture nor passages tell which end of the scan is up, taken "
         "along " +
         directionText(up_axis) + ": if floors come out on top, set -up " +
         directionText(-up_axis) + ".";
}

std::string
reversedNote(const std::vector<RoomOpening>& openings, const Vertical& vertical)
{
  const auto note = verticalNote(vertical.reversed());
  return note.empty() ? note
                      : note + " Taken along " + directionText(vertical.upAxis()) +
                            ", " + Passages(openings).text() + ".";
}

double
floatStep(double value)
{
  const auto size = static_cast<float>(std::abs(value));
  return std::nextafter(size, std::numeric_limits<float>::infinity()) - size;
}

std::string
stepWarning(double step, double voxel_size)
{
  const double size = voxel_size > 0.0 ? voxel_size : smallest_automatic_voxel;
  if (!(step > size))
    return {};
  std::ostringstream line;
  line << "The coordinates are stored in steps of " << step
       << " m, coarser than voxels of " << size
       << " m: write the cloud with double coordinates, or subtract an offset before "
          "they become floats.";
  return line.str();
}

std::string
outsideWarning(std::size_t outside, std::size_t all)
{
  if (10 * outside < all || all == 0)
    return {};
  return std::to_string(outside) + " of " + std::to_string(all) +
         " points lie beyond the extent of the building and get no room.";
}

std::vector<std::string>
unseenWarnings(const BuildingRooms& building)
{
  std::vector<std::string> lines;
  const double height = occupiedHeight(stepsOf(building).occupancy.grid);
  if (!building.maps.empty() && height < standing_height) {
    std::ostringstream line;
    line << "All points lie within " << 0.01 * std::round(100.0 * height)
         << " m of height, as in a slice or a flat map: there are no rooms. Rooms need "
            "walls of at least "
         << standing_height << " m.";
    return {line.str()};
  }
  const UnseenSides& unseen = stepsOf(building).interior.unseen;
  const bool floor = unseen.floorIsSeen(), ceiling = unseen.ceilingIsSeen();
  if (!floor && !ceiling)
    lines.emplace_back("Neither floors nor ceilings were seen: rooms are told by their "
                       "walls alone, storeys are not told apart, and heights are those "
                       "of the walls.");
  else if (!floor)
    lines.emplace_back("No floors were seen: rooms are told by their walls and "
                       "ceilings, and they begin where the walls do.");
  else if (!ceiling)
    lines.emplace_back("No ceilings were seen: rooms are told by their walls and "
                       "floors, and they end where the walls do.");
  if (const double closed = closedShare(building.rooms); closed < 0.5) // most are none
    lines.push_back("Walls were seen on only " +
                    std::to_string(static_cast<int>(100.0 * closed)) +
                    " % of the borders of the rooms: elsewhere these end where the "
                    "scan does, or where a passage seems to be.");
  if (building.hardly_seen > 0)
    lines.push_back(std::to_string(building.hardly_seen) +
                    (building.hardly_seen == 1 ? " space is" : " spaces are") +
                    " no room: hardly any points or walls show what is there, as with "
                    "mirror images behind glass and what is seen through doors.");
  if (const auto& stations = building.stations;
      !stations.empty() &&
      std::all_of(stations.begin(), stations.end(), [](const auto& station) {
        return station.room == 0;
      }))
    lines.emplace_back("No station stands in a room: are their positions in the frame "
                       "and the unit of the scan?");
  if (building.never_entered > 0)
    lines.push_back(std::to_string(building.never_entered) +
                    (building.never_entered == 1 ? " space is" : " spaces are") +
                    " no room: no station stands there, and none looked in but through "
                    "walls, panes or windows.");
  return lines;
}

} // namespace pcl::indoor
