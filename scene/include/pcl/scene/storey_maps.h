/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor {

/** \brief Where a robot can go on a storey, in square cells. */
struct StoreyMap {
  int nx = 0, ny = 0;      ///< cells along x and y; 0 of a storey without rooms
  double resolution = 0.0; ///< side of a cell, metres
  /** On the floor, in the frame and the unit of the scan's file. */
  Eigen::Vector3d lower_left_corner = Eigen::Vector3d::Zero();
  /** Turns x along a row, y to the next row and z up into the frame of the file. */
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  std::vector<std::int8_t> cells; ///< row by row from below: 0 free, 100 occupied, -1
                                  ///< not known
};

/** \brief The maps of all storeys, the lowest first, as pcl_indoor_export writes them.
 * \param[in] scene as sceneText() gives it, or a scene.json
 * \param[in] resolution side of a cell, metres
 * \param[in] with_furniture objects below head height and closed doors are occupied
 * \throws InputError if it is no whole scene, or if there would be too many cells
 */
PCL_INDOOR_EXPORTS std::vector<StoreyMap>
storeyMaps(const std::string& scene, double resolution, bool with_furniture);

} // namespace pcl::indoor
