/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/segmentation/building_rooms.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace pcl::indoor {

/** \brief How a building lies in its scan: brings places from one frame into another.
 *
 * There are four:
 * - the file's: coordinates as users know them, in their unit;
 * - the scan's: those of the file less an offset, since floats cannot hold large ones;
 * - upright: those of the scan, with z up and in metres; objects are found in it;
 * - the building's: upright, moved near the origin; rooms and walls are found in it.
 */
struct PCL_INDOOR_EXPORTS BuildingFrame {
  Eigen::Vector3d offset = Eigen::Vector3d::Zero(); ///< of the scan in the file
  double metres_per_unit = 1.0;                     ///< of file and scan (> 0)
  /** Turns and moves the building's frame into the scan's, both in metres. */
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();

  /** \brief Is the scan's frame the upright one? */
  bool
  isScanUpright() const
  {
    return metres_per_unit == 1.0 && pose.linear() == Eigen::Matrix3d::Identity();
  }

  Eigen::Vector3d
  scanToUpright(const Eigen::Vector3d& place) const
  {
    return metres_per_unit * pose.linear().transpose() * place;
  }

  Eigen::Vector3d
  scanToBuilding(const Eigen::Vector3d& place) const
  {
    return pose.inverse() * (metres_per_unit * place);
  }

  Eigen::Vector3d
  buildingToScan(const Eigen::Vector3d& place) const
  {
    return pose * place / metres_per_unit;
  }

  Eigen::Affine3d
  uprightToFile() const;

  Eigen::Affine3d
  buildingToFile() const;

  /** \brief The building's origin in the upright frame. */
  Eigen::Vector3d
  origin() const
  {
    return pose.linear().transpose() * pose.translation();
  }

  /** \brief What to add to places of the building to get those of the file, turned
   * upright and in metres. */
  Eigen::Vector3d
  originInFile() const
  {
    return pose.linear().transpose() * (pose.translation() + metres_per_unit * offset);
  }
};

/** \brief The turn from a cloud's frame into one with z up; of zeros and ones, and thus
 * exact, where an axis of the cloud points up.
 * \param[in] up_axis of any length but 0
 */
PCL_INDOOR_EXPORTS Eigen::Matrix3d
turnUpright(const Eigen::Vector3f& up_axis);

/** \brief Turn, scale and move the points of a cloud so that z points up, their unit is
 * the metre and they lie near the origin, as segmentBuilding() needs them.
 * No bit of a coordinate is lost where an axis of the cloud points up and its unit is
 * the metre. Points kilometres away do not change where the others come to lie.
 * \param[in,out] points finite; beyond 10^6 km they come to lie there
 * \param[in] up_axis of any length but 0
 * \param[in] metres_per_unit of the cloud (> 0)
 * \return of a scan without offset
 */
PCL_INDOOR_EXPORTS BuildingFrame
moveIntoBuildingFrame(std::vector<Eigen::Vector3f>& points,
                      const Eigen::Vector3f& up_axis,
                      double metres_per_unit = 1.0);

/** \brief Take out what lies kilometres away from a building's points.
 * \param[in,out] points in the building's frame
 * \return where they were in \a points, ascending
 */
PCL_INDOOR_EXPORTS std::vector<std::size_t>
takeOutFarPoints(std::vector<Eigen::Vector3f>& points);

/** \brief Bring rooms and openings into the frame and the unit of the scan; areas,
 * heights, volumes and widths stay in metres.
 * \param[in] boxes per room: around its points, in the scan's frame and unit (turned,
 * the building's boxes would be too large)
 */
PCL_INDOOR_EXPORTS void
placeInScan(const BuildingFrame& frame,
            const std::vector<Eigen::AlignedBox3f>& boxes,
            std::vector<Room>& rooms,
            std::vector<RoomOpening>& openings);

} // namespace pcl::indoor
