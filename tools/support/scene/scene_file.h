/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"
#include "scene/object_classes.h"
#include "scene/scan_frame.h"
#include "scene/upright_box.h"

#include <pcl/segmentation/building_rooms.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief An object of a scene; but for the upright box in the frame of
 * CloudFile::points. */
struct SceneObject {
  std::uint32_t room = 0;
  std::uint32_t structure = 0; ///< a StructureKind
  std::size_t point_count = 0;
  Eigen::Vector3d lower = Eigen::Vector3d::Zero(); ///< corner of the box
  Eigen::Vector3d upper = Eigen::Vector3d::Zero();
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  UprightBox upright; ///< z up, metres
};

/** \brief What was found in a scan; positions in the frame of CloudFile::points. */
struct Scene {
  std::vector<std::uint32_t> room_of_point;      ///< 0 = none
  std::vector<std::uint32_t> object_of_point;    ///< 0 = none
  std::vector<std::uint32_t> structure_of_point; ///< a StructureKind
  std::vector<Room> rooms;                       ///< in the order of their labels
  std::vector<RoomOpening> openings;             ///< between the rooms
  std::vector<SceneObject> objects;              ///< object i + 1 is the i-th
  std::vector<double> object_voxels; ///< per room the voxel size of its objects, last
                                     ///< that of what is in no room; 0 = no points
  double seeds_per_voxel = 0.0;      ///< distance of supervoxels over voxel size
  SceneClasses classes;              ///< of the objects
  BuildingRooms building;
  Eigen::Isometry3d building_pose = Eigen::Isometry3d::Identity(); ///< both in metres
  ScanReport report;
};

/** \brief Room, kind, boxes, centre and number of points of each object.
 * \param[in] points in the frame of the file
 * \param[in] standing the same, z up and in metres
 * \param[in] scene with objects, rooms and structure of the points */
std::vector<SceneObject>
measureObjects(const PointCloud<PointXYZ>& points,
               const PointCloud<PointXYZ>& standing,
               const Scene& scene);

/** \brief A scene, as tools/schema/scene.schema.json has it; positions
 * in the frame and the unit of the file, areas and lengths in metres.
 * \param[in] settings the values that were used, for the record
 */
nlohmann::ordered_json
sceneJson(const Scene& scene,
          const CloudFile& file,
          const ScanFrame& frame,
          const std::vector<Setting>& settings);

} // namespace pcl::indoor::tool
