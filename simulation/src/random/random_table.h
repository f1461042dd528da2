/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/random_plan.h>

#include <cstdint>

namespace pcl::indoor {

/** \brief A table in the middle of a room, above the origin, with two to eight small
 * objects on it, some against or on each other.
 * \param[in] filling Cluttered: 8 to 16 objects, one of eight 22 to 32, so close
 * that a third of all points is table; LivedIn: 8 to 32 of many more shapes */
Plan
randomTable(std::uint32_t seed, PlanFilling filling);

} // namespace pcl::indoor
