/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/indoor/setting.h>
#include <pcl/io/station.h>
#include <pcl/model/building_model.h>
#include <pcl/segmentation/building_frame.h>
#include <pcl/segmentation/building_rooms.h>
#include <pcl/segmentation/room_objects.h>
#include <pcl/segmentation/scan_overview.h>
#include <pcl/segmentation/scan_warnings.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pcl::indoor {

/** \brief What an object was taken for. */
struct ObjectClass {
  std::uint32_t category = 0; ///< position in SceneClasses::names; 0, "none", of
                              ///< floors, walls and ceilings, which are no objects
  float confidence = 0.0f; ///< probability of that class; 0 of objects too small to be
                           ///< described, which are "other"
  std::vector<std::pair<std::uint32_t, float>>
      top; ///< up to three, the likeliest first
};

/** \brief The classes of a scene's objects. */
struct SceneClasses {
  std::vector<std::string> names;   ///< names[0] is "none", then those of the model
  std::vector<ObjectClass> objects; ///< one per object; empty without a model
};

/** \brief Where the normals of a scan come from. */
enum class NormalsFrom { File, NoneInFile, NoneUsable, Ignored };

/** \brief What was understood of a scan before the work. */
struct PCL_INDOOR_EXPORTS UnderstoodScan {
  ScanOverview overview; ///< in the unit and with the up axis that are used
  std::uint64_t points = 0, finite_points = 0; ///< of the whole scan
  bool is_sample = false;                      ///< only some of them were looked at
  std::string unit;                            ///< that is used
  std::string likely_unit; ///< that the height of the rooms suggests; empty if no other
  ScanCoordinates coordinates;
  bool up_is_set = false;         ///< by the user
  bool end_is_recognised = false; ///< by objects that are recognised with it up
  NormalsFrom normals = NormalsFrom::NoneInFile;
  bool has_colors = false;
  std::size_t stations = 1;

  /** \brief Stand it the other way up if the rooms were found so. */
  void
  settle(const ScanReport& report);
};

/** \brief The scan that a scene was found in. */
struct SceneInput {
  std::string path; ///< of the scan's file, or what several are called
  std::vector<Station> stations;
  /** What has to be added to the coordinates of the scan when it is written again: its
   * floats cannot hold large ones. */
  Eigen::Vector3d cloud_offset = Eigen::Vector3d::Zero();
};

/** \brief An object of a scene; but for the upright box in the frame of Scan::points().
 */
struct SceneObject : ObjectMeasures {
  std::uint32_t room = 0;
};

/** \brief Numbers of points of a scan. */
struct PointCounts {
  std::uint64_t all = 0, finite = 0, in_rooms = 0;
  std::uint64_t outside = 0; ///< beyond the extent of the building
};

/** \brief What was found in a scan; positions in the frame of Scan::points(). Of a scan
 * that is read in parts, points are those of its sample. */
struct Scene {
  SceneInput input;
  BuildingFrame frame;           ///< how file, scan and building lie to each other
  std::vector<Setting> settings; ///< that were used, for the record
  PointCounts counts;            ///< of the whole scan
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
  BuildingModel model; ///< walls, doors and windows, in the frame of the building
  ScanReport report;
  UnderstoodScan understood;
};

} // namespace pcl::indoor
