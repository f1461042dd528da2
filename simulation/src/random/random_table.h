/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/plan.h>

#include <cstdint>

namespace pcl {
namespace indoor {

/** \brief A table in the middle of a room, above the origin, with two to eight small
 * things on it, some against or on each other.
 * \param[in] cluttered 8 to 16 things */
Plan
randomTable(std::uint32_t seed, bool cluttered);

} // namespace indoor
} // namespace pcl
