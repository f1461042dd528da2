/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "rooms/room_preparation.h"
#include "scene/object_classes.h"

#include <pcl/indoor/exports.h>
#include <pcl/segmentation/building_frame.h>
#include <pcl/segmentation/thesis.h>

#include <optional>
#include <vector>

namespace pcl::indoor::tool {

/** \brief How the voxels of the bundled network vote on what objects are. */
struct VotingNetwork {
  bool votes = false;         ///< it is read when it is needed
  bool in_all_rooms = false;  ///< also where a ceiling was seen
  bool names_objects = false; ///< beside telling building from objects
};

/** \brief Options, models and frame that are the same for all rooms of a scan. */
struct RoomWork {
  RoomPreparation preparation;
  ObjectSegmentationOptions options;
  std::optional<thesis::ObjectOptions> thesis; ///< the thesis's way, in place of ours
  std::optional<ObjectNaming> naming;          ///< without it there are no classes
  VotingNetwork network;
  bool keeps_surfaces = false; ///< of the objects, to learn classes from
  BuildingFrame frame;         ///< of the scan
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
PCL_INDOOR_EXPORTS FinishedRoom
finishRoom(RoomPoints room, const RoomWork& work);

} // namespace pcl::indoor::tool
