/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Read the points of a PLY file (ascii, little or big endian) with all their
 * properties.
 *
 * They keep their names, see UsualFields for PCL's. Lists are left out. PCL's own
 * reader is not used because it stops the program at a damaged file. \param[out]
 * origin, orientation the pose of the element "camera", if there is one; its viewport
 * gives rows and columns if these fit the points \return the offset of the header's
 * comment, see offsetText() \throws ToolError if the file is no PLY, has no points, or
 * fewer than its header promises
 */
Eigen::Vector3d
readPly(const std::string& path,
        PCLPointCloud2& cloud,
        Eigen::Vector4f& origin,
        Eigen::Quaternionf& orientation);

/** \brief How the points of a binary PLY file lie in it. */
struct PlyRecords {
  PCLPointCloud2 layout; ///< fields, width and height; no points
  Eigen::Vector4f origin = Eigen::Vector4f::Zero();
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  std::size_t body_begin = 0; ///< bytes from the beginning of the file
  std::size_t record_size = 0;
  /** The points of some records, as readPly() gives them. */
  std::function<PCLPointCloud2(std::string records, std::size_t count)> points;
};

/** \brief Read the header of a PLY file.
 * \return nothing if its points are not records of one size at its beginning, in bytes
 * that follow each other: ASCII, lists, faces
 * \throws ToolError as readPly()
 */
std::optional<PlyRecords>
plyRecords(const std::string& path);

/** \brief Does the header of a file say that it is a PLY with faces?
 * \throws ToolError as readPly()
 */
bool
hasPlyFaces(const std::string& path);

/** \brief Read the faces of a PLY file: per face the numbers of its vertices, from 0.
 * \return none if the file is no PLY or has no faces
 * \throws ToolError if it is damaged or has fewer faces than its header promises
 */
std::vector<std::vector<std::uint32_t>>
readPlyFaces(const std::string& path);

} // namespace pcl::indoor::tool
