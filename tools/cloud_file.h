/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "options.h" // for ToolError

#include <pcl/PCLPointCloud2.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief A point cloud as its file gave it, and its points for computing. */
struct CloudFile {
  std::string path;
  PCLPointCloud2 cloud; ///< every field of the file, bytes unchanged
  Eigen::Vector4f origin = Eigen::Vector4f::Zero(); ///< the sensor's pose
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();

  /** The points in the file's order and arrangement, each coordinate minus \a offset;
   * NaN where one is not finite. */
  PointCloud<PointXYZ>::Ptr points;
  /** Whole metres near the middle of large (for example UTM) coordinates, otherwise
   * zero. */
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  std::size_t finite_count = 0; ///< points without NaN or infinity
  bool has_normals = false;     ///< the file has normal_x, normal_y, normal_z
};

/** \brief Read a PCD (ascii, binary, binary_compressed) or PLY file; which one it is,
 * its content says.
 *
 * Prints nothing.
 * \throws ToolError if the file is missing, is no cloud, is shorter than its header
 * says, lacks float x, y, z, or holds fewer than \a least_points finite points
 */
CloudFile
loadCloud(const std::string& path, std::size_t least_points = 2);

/** \brief The normals of a cloud with \a has_normals, in its order; curvature 0 where
 * the file has none. */
PointCloud<Normal>::Ptr
readNormals(const CloudFile& file);

/** \brief Does the cloud have such a field? */
bool
hasField(const PCLPointCloud2& cloud, const std::string& name);

/** \brief A field of whole numbers, one value per point.
 * \throws ToolError if the field is missing or a value is negative, fractional or too
 * large
 */
std::vector<std::uint32_t>
readLabels(const CloudFile& file, const std::string& name);

/** \brief Append a field of unsigned integers; a field of that name is replaced.
 * \param[in] values one per point
 */
void
appendField(PCLPointCloud2& cloud,
            const std::string& name,
            const std::vector<std::uint32_t>& values);

/** \brief Find out, before the long work, that a file cannot be written there.
 * \throws ToolError naming the folder that is missing or not writable
 */
void
requireWritable(const std::string& path);

/** \brief Find out, before the long work, that a folder cannot be used or made for
 * results. \throws ToolError naming it and the reason
 */
void
requireFolder(const std::string& folder);

/** \brief Make a folder, and those above it, unless it is there. */
void
makeFolder(const std::string& folder);

/** \brief Write all fields, binary compressed: first beside the file, then renamed, so
 * none is left half-written. \throws ToolError if it cannot be written; then nothing is
 * left behind and an older file is unchanged
 */
void
saveCloud(const std::string& path,
          const PCLPointCloud2& cloud,
          const Eigen::Vector4f& origin = Eigen::Vector4f::Zero(),
          const Eigen::Quaternionf& orientation = Eigen::Quaternionf::Identity());

/** \brief Write a text file in the same way. */
void
saveText(const std::string& path, const std::string& text);

/** \brief The way of both: \a write makes the file of the name it is given, which then
 * takes the place of \a path. \throws ToolError if write returns false or the file
 * cannot be put in place
 */
void
saveAtomically(const std::string& path,
               const std::function<bool(const std::string& temporary)>& write);

} // namespace pcl::indoor::tool
