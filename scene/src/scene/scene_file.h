/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"
#include "scene/object_classes.h"
#include "scene/scan_frame.h"
#include "scene/understood_scan.h"
#include "text/setting.h"

#include <pcl/segmentation/building_rooms.h>
#include <pcl/segmentation/room_objects.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief An object of a scene; but for the upright box in the frame of
 * CloudFile::points. */
struct SceneObject : ObjectMeasures {
  std::uint32_t room = 0;
};

/** \brief Numbers of points of a scan. */
struct PointCounts {
  std::uint64_t all = 0, finite = 0, in_rooms = 0;
  std::uint64_t outside = 0; ///< beyond the extent of the building
};

/** \brief What was found in a scan; positions in the frame of CloudFile::points. Of a
 * scan that is read in parts, points are those of its sample. */
struct Scene {
  PointCounts counts;                            ///< of the whole scan
  std::vector<std::size_t> remainders;           ///< points per room, last in none
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
  UnderstoodScan understood;
};

/** \brief A scene, as scene/schema/scene.schema.json has it; positions
 * in the frame and the unit of the file, areas and lengths in metres.
 * \param[in] settings the values that were used, for the record
 */
nlohmann::ordered_json
sceneJson(const Scene& scene,
          const CloudFile& file,
          const ScanFrame& frame,
          const std::vector<Setting>& settings);

} // namespace pcl::indoor::tool
