/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

namespace pcl {
namespace indoor {

/** \brief The metres per unit, of those that clouds come in, with which a length is
 * nearest to the height of a room.
 * \param[in] length along the upright axis, in the unit of the cloud (> 0)
 * \return that of metres, feet, inches, centimetres or millimetres
 */
double
likelyMetresPerUnit(double length);

} // namespace indoor
} // namespace pcl
