/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/model/room_names.h>

namespace pcl::indoor {

/** \brief Probabilities that a room has each name. */
using Shares = std::array<double, room_name_count>;

/** \brief Logarithms of such probabilities, but for a summand. */
using NameScores = Shares;

/** \brief Logarithm of the sum of what the scores stand for. */
double
sumOf(const NameScores& scores);

/** \brief The probabilities that scores stand for. */
Shares
sharesOf(const NameScores& scores);

/** \brief Add to what is seen of each room what the rooms around it say.
 *
 * Doors lead from corridors, halls and stairs: two other rooms that a door joins are
 * less likely by a factor. A home of four rooms or more has a bath. Belief propagation;
 * exact for the doors where they form no ring.
 * \param[in] scores of each room by itself; not all of a room are minus infinity
 * \param[in] rooms their neighbours, in the same order
 * \param[in] home whether the building is a home
 */
std::vector<NameScores>
jointNames(std::vector<NameScores> scores,
           const std::vector<RoomEvidence>& rooms,
           bool home);

} // namespace pcl::indoor
