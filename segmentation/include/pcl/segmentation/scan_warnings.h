/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/segmentation/building_rooms.h>
#include <pcl/segmentation/rooms/scan_signs.h>
#include <pcl/types.h> // for Indices

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief What was found out about the points of a room segmentation. */
struct ScanReport {
  std::vector<std::string> warnings; ///< a line each: what is wrong, and what mends it
  double voxel_size = 0.0;           ///< that was used, metres
  Indices outside; ///< points beyond the extent of the building, in no room; ascending
};

/** \brief Warn if the height of the rooms suggests another unit than the one set.
 * \param[in] signs of the points in metres, as they were given
 * \param[in] metres_per_unit that the user has set (> 0)
 * \return one line; empty if the height is plausible, or not known
 */
std::string
unitWarning(const ScanSigns& signs, double metres_per_unit);

/** \brief Warn if the unit seems to be feet: most rooms and doors are too high for
 * metres and right for feet. At least five rooms are needed, as halls and churches have
 * few; so small homes in feet are not noticed.
 * \return one line; empty if metres are plausible
 */
std::string
feetWarning(const std::vector<Room>& rooms,
            const std::vector<RoomOpening>& openings,
            double metres_per_unit);

/** \brief Warn if the scan lies on its side.
 * \param[in] signs of the points with z as up axis
 * \param[in] turn from that frame to the frame of the cloud
 * \return one line; empty if not
 */
std::string
axisWarning(const ScanSigns& signs, const Eigen::Matrix3d& turn);

/** \brief The distance between a float of this size and the next one. */
double
floatStep(double value);

/** \brief Warn if coordinates are too coarse for the voxels.
 * \param[in] step between two of them, metres
 * \param[in] voxel_size metres, 0 = automatic
 * \return one line; empty if not
 */
std::string
stepWarning(double step, double voxel_size);

/** \brief Warn if a tenth or more of a cloud lies beyond the extent of the building.
 * \return one line; empty if less than a tenth
 */
std::string
outsideWarning(std::size_t outside, std::size_t all);

/** \brief Say what the scan does not show, and what that means for its rooms: floors,
 * ceilings, walls (a slice, a flat map); spaces that were hardly seen.
 * \return a line each; none if the scan shows all
 */
std::vector<std::string>
unseenWarnings(const BuildingRooms& building);

} // namespace indoor
} // namespace pcl
