/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/model/room_names.h>

namespace pcl::indoor {

constexpr std::size_t rooms_of_home = 4; // at least, with a bath and a largest room

/** \brief What rooms of a name are like, before anything stands in them. Set by what is
 * usual, not counted; docs/method/room_names.md says how. */
struct RoomCustom {
  double in_home, in_offices; ///< how many there are in a home, on a floor of offices
  double home_area, offices_area; ///< median, m^2
  double spread;                  ///< of areas: the factor of one standard deviation
  double stretch;                 ///< median of the perimeter over that of the square
  double lit;                     ///< share with windows
  double ways[3];                 ///< shares that lead to one room, two, or more
  double levels[3];               ///< shares in the cellar, at the entrance, above
  double largest;                 ///< share that is the largest room of a home
  double tall;                    ///< share that is much higher than most rooms
};

constexpr RoomCustom room_customs[room_name_count] = {
    // clang-format off
    // number    area, m^2 spread stretch lit   ways: 1, 2, more    cellar, entrance, up largest tall
    {1.0, 0.70,   10, 15, 1.5,    1.05,    0.90, {0.60, 0.30, 0.10}, {0.02, 0.85, 0.13},   0.10,    0.01}, // kitchen
    {1.0, 0.10,   24, 24, 1.5,    1.05,    0.97, {0.40, 0.30, 0.30}, {0.02, 0.85, 0.13},   0.70,    0.05}, // living
    {2.0, 0.00,   13, 13, 1.4,    1.05,    0.95, {0.80, 0.15, 0.05}, {0.04, 0.36, 0.60},   0.12,    0.01}, // bedroom
    {1.0, 0.00,    6,  6, 1.5,    1.05,    0.50, {0.85, 0.13, 0.02}, {0.04, 0.36, 0.60},   0.03,    0.01}, // bath
    {0.5, 1.00,    2,  8, 1.8,    1.08,    0.30, {0.90, 0.08, 0.02}, {0.05, 0.70, 0.25},   0.03,    0.01}, // toilet
    {1.5, 1.50,    8, 25, 2.0,    1.30,    0.30, {0.10, 0.25, 0.65}, {0.20, 0.40, 0.40},   0.10,    0.01}, // corridor
    {0.3, 0.70,    6, 15, 1.7,    1.15,    0.20, {0.20, 0.40, 0.40}, {0.20, 0.40, 0.40},   0.03,    0.50}, // stairs
    {0.3, 6.00,   12, 18, 1.8,    1.05,    0.95, {0.75, 0.20, 0.05}, {0.04, 0.46, 0.50},   0.03,    0.01}, // office
    {0.0, 1.20,   25, 25, 1.5,    1.05,    0.90, {0.70, 0.25, 0.05}, {0.04, 0.46, 0.50},   0.03,    0.01}, // meeting
    {0.8, 0.80,    6, 10, 2.5,    1.08,    0.10, {0.80, 0.16, 0.04}, {0.50, 0.30, 0.20},   0.10,    0.01}, // storage
    {0.4, 0.50,    6, 10, 2.0,    1.08,    0.15, {0.80, 0.16, 0.04}, {0.70, 0.20, 0.10},   0.03,    0.01}, // technical
    {0.0, 0.40,   40, 60, 2.2,    1.10,    0.50, {0.10, 0.20, 0.70}, {0.05, 0.80, 0.15},   0.03,    0.40}, // hall
    {0.2, 0.05,    6,  6, 1.8,    1.15,    0.60, {0.85, 0.13, 0.02}, {0.00, 0.50, 0.50},   0.03,    0.01}, // balcony
    {0.3, 0.50,   20, 20, 2.7,    1.15,    0.50, {0.50, 0.30, 0.20}, {0.20, 0.40, 0.40},   0.20,    0.10}, // other
    // clang-format on
};

/** \brief The share of the rooms of a name that hold an object. */
struct ObjectShares {
  const char* name;
  bool several; ///< three or more
  /** Of kitchen, living, bedroom, bath, toilet, corridor, office, meeting, storage. */
  double shares[9];
};

/** Counted by models/make_room_objects in simulated homes and offices; stairs are set.
 */
constexpr ObjectShares object_shares[] = {
    {"armchair", false, {0.00, 0.58, 0.08, 0.00, 0.00, 0.00, 0.04, 0.00, 0.00}},
    {"bath", false, {0.00, 0.00, 0.00, 0.59, 0.00, 0.00, 0.00, 0.00, 0.00}},
    {"bed", false, {0.00, 0.00, 0.88, 0.00, 0.00, 0.00, 0.00, 0.00, 0.00}},
    {"bin", false, {0.81, 0.16, 0.25, 0.49, 1.00, 0.08, 0.71, 0.00, 0.25}},
    {"bookcase", false, {0.15, 0.72, 0.45, 0.00, 0.00, 0.00, 0.79, 0.00, 0.96}},
    {"bookcase", true, {0.00, 0.16, 0.00, 0.00, 0.00, 0.00, 0.12, 0.00, 0.37}},
    {"box", true, {0.13, 0.13, 0.10, 0.00, 0.00, 0.09, 0.24, 0.03, 0.81}},
    {"cabinet", true, {0.80, 0.06, 0.40, 0.00, 0.00, 0.01, 0.32, 0.00, 0.12}},
    {"chair", false, {0.59, 0.31, 0.24, 0.00, 0.00, 0.26, 0.98, 1.00, 0.00}},
    {"chair", true, {0.47, 0.12, 0.00, 0.00, 0.00, 0.02, 0.62, 1.00, 0.00}},
    {"counter", false, {0.16, 0.00, 0.00, 0.00, 0.00, 0.00, 0.00, 0.00, 0.00}},
    {"desk", false, {0.00, 0.00, 0.21, 0.00, 0.00, 0.00, 0.97, 0.00, 0.00}},
    {"desk", true, {0.00, 0.00, 0.00, 0.00, 0.00, 0.00, 0.25, 0.00, 0.00}},
    {"pillow", false, {0.05, 0.35, 0.22, 0.00, 0.00, 0.00, 0.05, 0.03, 0.00}},
    {"screen", false, {0.04, 0.34, 0.41, 0.00, 0.00, 0.00, 0.92, 0.86, 0.00}},
    {"screen", true, {0.00, 0.00, 0.00, 0.00, 0.00, 0.00, 0.32, 0.15, 0.00}},
    {"shower", false, {0.00, 0.00, 0.00, 0.50, 0.00, 0.00, 0.00, 0.00, 0.00}},
    {"sink", false, {0.56, 0.00, 0.00, 0.99, 1.00, 0.00, 0.00, 0.00, 0.00}},
    {"sofa", false, {0.18, 0.89, 0.00, 0.00, 0.00, 0.00, 0.07, 0.00, 0.00}},
    {"stairs", false, {0.00, 0.19, 0.00, 0.00, 0.00, 0.20, 0.00, 0.00, 0.00}},
    {"stool", false, {0.23, 0.19, 0.00, 0.39, 0.00, 0.00, 0.00, 0.00, 0.00}},
    {"table", false, {0.81, 0.69, 0.00, 0.00, 0.00, 0.00, 0.37, 1.00, 0.00}},
    {"toilet", false, {0.00, 0.00, 0.00, 1.00, 1.00, 0.00, 0.00, 0.00, 0.00}},
    {"wall cabinet", false, {0.75, 0.00, 0.00, 0.00, 0.00, 0.00, 0.00, 0.00, 0.00}},
    {"wall cabinet", true, {0.38, 0.00, 0.00, 0.00, 0.00, 0.00, 0.00, 0.00, 0.00}},
};
constexpr std::size_t object_count = sizeof(object_shares) / sizeof(object_shares[0]);

constexpr double lowest_wall_cabinet = 1.1; ///< metres: its foot above the floor

} // namespace pcl::indoor
