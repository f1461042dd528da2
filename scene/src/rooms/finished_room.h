/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "rooms/room_preparation.h"
#include "scene/object_classes.h"

#include <pcl/ml/voxel_network.h>
#include <pcl/segmentation/room_objects.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <future>
#include <optional>
#include <vector>

namespace pcl::indoor::tool {

/** \brief A network whose voxels vote on what objects are. */
struct VotingNetwork {
  std::shared_future<VoxelNetwork> network; ///< read when it is needed; or none
  bool in_all_rooms = false;                ///< also where a ceiling was seen
  bool names_things = false;                ///< beside telling building from things
};

/** \brief What the rooms of a scan have in common. */
struct RoomWork {
  RoomPreparation preparation;
  ObjectSegmentationOptions options;
  std::optional<ObjectNaming> naming; ///< without it there are no classes
  VotingNetwork network;
  bool keeps_surfaces = false; ///< of the objects, to learn classes from
  bool is_standing = true;     ///< z is up and the unit is the metre
  double metres_per_unit = 1.0;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity(); ///< of the building

  /** \brief Set how the building stands in the frame of the scan. */
  void
  setFrame(const Eigen::Isometry3d& building_pose, double unit)
  {
    pose = building_pose;
    metres_per_unit = unit;
    is_standing = unit == 1.0 && pose.linear() == Eigen::Matrix3d::Identity();
  }

  /** \brief A point with z up, in metres. */
  Eigen::Vector3f
  standing(const Eigen::Vector3f& point) const
  {
    return is_standing ? point
                       : Eigen::Vector3f((metres_per_unit * pose.linear().transpose() *
                                          point.cast<double>())
                                             .cast<float>());
  }
};

/** \brief A room with everything that is found in it, in its own numbers. */
struct FinishedRoom {
  RoomObjects objects; ///< without their surfaces, unless these are kept
  std::vector<ObjectMeasures> measures; ///< one per object, but for the upright box
                                        ///< in the frame of CloudFile::points
  std::vector<ObjectClass> classes;     ///< one per object; empty without a model
};

/** \brief Find, measure and name the objects of one room.
 * \param[in] room in the frame of CloudFile::points; may have normals
 */
FinishedRoom
finishRoom(RoomPoints room, const RoomWork& work);

} // namespace pcl::indoor::tool
