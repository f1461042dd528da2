/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/exports.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pcl::indoor {

/** \brief What a room is for. */
enum class RoomName {
  Kitchen,
  Living,
  Bedroom,
  Bath,
  Toilet,
  Corridor,
  Stairs,
  Office,
  Meeting,
  Storage,
  Technical,
  Hall,
  Balcony,
  Other
};

constexpr std::size_t room_name_count = 14;

/** \brief As users read it, for example "kitchen". */
PCL_INDOOR_EXPORTS const char*
nameOf(RoomName name);

/** \brief An object in a room. */
struct RoomObject {
  /** What it may be and how likely, for example {"chair", 0.8}; names of the bundled
   * model's classes count, others do not. */
  std::vector<std::pair<std::string, double>> classes;
  double foot = 0.0; ///< height of its lower end above the floor, metres
};

/** \brief What is known of a room. */
struct RoomEvidence {
  double area = 0.0;                   ///< of its floor, m^2; 0 = not known
  double perimeter = 0.0;              ///< of its floor, metres; 0 = not known
  double height = 0.0;                 ///< metres
  std::uint32_t storey = 0;            ///< 0 = the lowest
  double window_area = 0.0;            ///< of its windows, m^2
  std::vector<std::size_t> neighbours; ///< rooms that doors and passages lead to, as
                                       ///< places in the list of rooms
  std::vector<RoomObject> objects;
};

/** \brief Names of a room. */
struct PCL_INDOOR_EXPORTS NamedRoom {
  std::array<double, room_name_count> probabilities{}; ///< in the order of RoomName;
                                                       ///< their sum is 1

  /** \brief The likeliest; of equal ones the first. */
  RoomName
  likeliest() const;

  /** \brief Of the likeliest name. */
  double
  probability() const;

  /** \brief Whether the likeliest is likelier than all others together. */
  bool
  isKnown() const;

  /** \brief The likeliest name as users read it; "unknown" if it is not known. */
  std::string
  text() const;
};

/** \brief Tell what the rooms of a building are for.
 *
 * A Bayesian rule: size, shape, light, ways and storey of a room, the objects in it,
 * what the rooms behind its doors may be, and whether the building is a home or has
 * offices, for which all its rooms speak.
 * docs/method/room_names.md has the rule and where its constants come from. Names
 * depend neither on the order of the rooms nor on that of their objects.
 * \param[in] rooms all of a building
 * \return one per room
 * \throws pcl::BadArgumentException if a number is not finite, or below 0 (but for
 * RoomObject::foot), or there is no such neighbour
 */
PCL_INDOOR_EXPORTS std::vector<NamedRoom>
nameRooms(const std::vector<RoomEvidence>& rooms);

} // namespace pcl::indoor
