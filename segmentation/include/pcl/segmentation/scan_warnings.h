/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/segmentation/building_rooms.h>
#include <pcl/segmentation/scan_overview.h>
#include <pcl/types.h> // for Indices

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace pcl::indoor {

/** \brief What was found out about the points of a room segmentation. */
struct ScanReport : ScanCoordinates {
  std::vector<std::string> warnings; ///< a line each: what is wrong, and what mends it
  double voxel_size = 0.0;           ///< that was used, metres
  bool end_is_recognised = false;    ///< the upper one, by an EndFinder
  Indices outside; ///< points beyond the extent of the building, in no room; ascending
};

/** \brief Tells which end of a scan is up, of points in metres, the vertical along z.
 * Returns 1: as they are; -1: the other way up; 0: not known */
using EndFinder = std::function<int(const std::vector<Eigen::Vector3f>& points)>;

/** \brief The unit of a scan that no one has told.
 * \param[in] room_height in the unit of the points; 0 = not known
 * \return metres per unit: 1, but for millimetres, centimetres or inches where no room
 * would be so high in metres
 */
PCL_INDOOR_EXPORTS double
metresPerUnit(double room_height);

/** \brief Say that another unit than metres was taken without being told.
 * \return one line; empty if metres were taken
 */
PCL_INDOOR_EXPORTS std::string
unitNote(double room_height, double metres_per_unit);

/** \brief Warn if the height of the rooms suggests another unit, or another scale.
 * \param[in] vertical of the points in their unit
 * \param[in] metres_per_unit that is used (> 0)
 * \return one line; empty if the height is plausible, or not known
 */
PCL_INDOOR_EXPORTS std::string
unitWarning(const Vertical& vertical, double metres_per_unit);

/** \brief Warn if the unit seems to be feet: most rooms and doors are too high for
 * metres and right for feet. At least five rooms are needed, as halls and churches have
 * few; so small homes in feet are not noticed.
 * \return one line; empty if metres are plausible
 */
PCL_INDOOR_EXPORTS std::string
feetWarning(const std::vector<Room>& rooms,
            const std::vector<RoomOpening>& openings,
            double metres_per_unit);

/** \brief Which end of the rooms their passages begin at, as doors do at the floor.
 * \return -1 = the lower one, 1 = the upper one; 0 if fewer than two begin at one of
 * them only, or a quarter of these at the other one
 */
PCL_INDOOR_EXPORTS int
endOfPassages(const std::vector<RoomOpening>& openings);

/** \brief Whether two passages or more begin at the lower end, and none at the upper
 * one. */
PCL_INDOOR_EXPORTS bool
allPassagesStand(const std::vector<RoomOpening>& openings);

/** \brief Warn if passages have sills and no lintels, so that floors seem to be
 * ceilings.
 * \param[in] up_axis that the rooms were found with
 * \return one line; empty
 * if endOfPassages() is not the upper one
 */
PCL_INDOOR_EXPORTS std::string
endWarning(const std::vector<RoomOpening>& openings, const Eigen::Vector3f& up_axis);

/** \brief Say that nothing tells which end is up.
 * \param[in] up_axis that was taken
 * \return one line */
PCL_INDOOR_EXPORTS std::string
unclearEndNote(const Eigen::Vector3f& up_axis);

/** \brief Say that the scan was taken the other way up for its passages.
 * \param[in] openings that were found before
 * \param[in] vertical that was taken then
 * \return one line, in place of verticalNote(); empty if the scan is level now
 */
PCL_INDOOR_EXPORTS std::string
reversedNote(const std::vector<RoomOpening>& openings, const Vertical& vertical);

/** \brief Say how a scan stands that was stood upright, or that it might lie on its
 * side.
 * \return one line; empty if it is level
 */
PCL_INDOOR_EXPORTS std::string
verticalNote(const Vertical& vertical);

/** \brief The distance between a float of this size and the next one. */
PCL_INDOOR_EXPORTS double
floatStep(double value);

/** \brief Warn if coordinates are too coarse for the voxels.
 * \param[in] step between two of them, metres
 * \param[in] voxel_size metres, 0 = automatic
 * \return one line; empty if not
 */
PCL_INDOOR_EXPORTS std::string
stepWarning(double step, double voxel_size);

/** \brief Warn if a tenth or more of a cloud lies beyond the extent of the building.
 * \return one line; empty if less than a tenth
 */
PCL_INDOOR_EXPORTS std::string
outsideWarning(std::size_t outside, std::size_t all);

/** \brief Say what the scan does not show, and what that means for its rooms: floors,
 * ceilings, walls (a slice, a flat map); spaces that were hardly seen.
 * \return a line each; none if the scan shows all
 */
PCL_INDOOR_EXPORTS std::vector<std::string>
unseenWarnings(const BuildingRooms& building);

} // namespace pcl::indoor
