/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"

#include <pcl/indoor/exports.h>
#include <pcl/ml/object_context.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/room_objects.h>

#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief All clouds but .txt files, and all meshes (OFF, OBJ), of a folder and the
 * folders in it, by their endings, sorted by path.
 * \return paths relative to the folder
 * \throws ToolError if it is no folder or holds none
 */
PCL_INDOOR_EXPORTS std::vector<std::string>
objectFilesIn(const std::string& folder);

/** \brief The class that a path relative to a folder of classes tells: its first
 * folder; empty if it has none. */
std::string
classFolder(const std::string& path);

/** \brief Estimate the normals of the finite points from their neighbours' plane.
 *
 * They point towards the centroid: towards the file's origin, as by default, they would
 * tell where in its file an object lies. The others' normals are NaN.
 */
PCL_INDOOR_EXPORTS void
estimateNormals(PointCloud<PointNormal>& cloud, int neighbor_count);

/** \brief The same by RRHT, as the thesis has it on samples of meshes (Sec. 5.3), with
 * the parameters of HoughNormalEstimation.
 *
 * Points at which no plane is found have the normal NaN.
 */
PCL_INDOOR_EXPORTS void
estimateHoughNormals(PointCloud<PointNormal>& cloud);

/** \brief Points that are drawn on a mesh. */
constexpr std::size_t mesh_point_count = 2048;

/** \brief Read the points and normals of an object; estimate normals if the file has
 * none. Of a mesh (OFF, OBJ, or PLY with faces) mesh_point_count points are drawn.
 * \throws ToolError as loadCloud() and readMesh()
 */
PCL_INDOOR_EXPORTS PointCloud<PointNormal>::Ptr
loadObject(const std::string& path, int neighbor_count);

/** \brief An object as a classifier wants it. */
struct PlacedObject {
  PointCloud<PointNormal>::Ptr cloud;
  ObjectPlace place; ///< as saveObject() has saved it, see readPlace()
};

/** \brief An object that was read; normals are estimated where it has none. */
PCL_INDOOR_EXPORTS PlacedObject
placedObject(const CloudFile& file, int neighbor_count);

/** \brief As loadObject(), with the place. */
PCL_INDOOR_EXPORTS PlacedObject
loadPlacedObject(const std::string& path, int neighbor_count);

/** \brief The points of a cloud for the classifier: those with a place and a normal. */
PCL_INDOOR_EXPORTS std::vector<OrientedPoint>
classifierPoints(const PointCloud<PointNormal>& cloud);

/** \brief Save an object as a cloud with normals and, in the field floor_distance, how
 * far it is above the floor.
 * \throws ToolError as saveCloud()
 */
PCL_INDOOR_EXPORTS void
saveObject(const std::string& path, const ObjectSurface& object);

/** \brief The place of an object in its room, as saveObject() has saved it.
 * \return an unknown place if the file has no such field
 */
PCL_INDOOR_EXPORTS ObjectPlace
readPlace(const CloudFile& file);

} // namespace pcl::indoor::tool
