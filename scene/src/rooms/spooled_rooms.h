/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/scan_content.h"
#include "rooms/scene_rooms.h"
#include "rooms/work_folder.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The points of a room, all together. */
struct RoomExtent {
  std::size_t point_count = 0;
  Eigen::Vector3f lower = Eigen::Vector3f::Zero(), upper = lower; ///< corners
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
};

/** \brief What was put into the files of the rooms of a large scan. */
struct SpooledRooms {
  std::vector<RoomExtent> rooms;      ///< of the points in them
  std::vector<std::size_t> sizes;     ///< points of each file: rooms, last the others
  std::uint64_t point_count = 0;      ///< of the scan
  std::uint64_t outside = 0;          ///< finite points beyond the building, in no file
  std::vector<std::uint64_t> digests; ///< of each room's file, and of that of labels
};

/** \brief Put each point of a large scan into the file of the room with which its
 * objects are looked for, see withSurroundings(), in the order of the scan, unless the
 * folder has them undamaged; a point is where the one is that stands for it. Another
 * file tells the room of each point.
 * \param[in] upright the sample, z up, metres; not finite where outside
 * \param[in] scene with the rooms of the sample; boxes, centres and numbers of points
 * of its rooms are made those of all points
 */
SpooledRooms
spoolRooms(ScanContent& scan,
           bool with_normals,
           WorkFolder& folder,
           const PointCloud<PointXYZ>& upright,
           Scene& scene,
           const PointsDone& report);

/** \brief The rooms as their files hold them. */
RoomSource
spooledSource(const SpooledRooms& spooled, bool with_normals, const WorkFolder& folder);

/** \brief Tells room, object and structure of each point of a large scan, in its order.
 */
class SpooledLabels {
public:
  /** \param[in] first_object per room, what is added to the numbers of its objects */
  SpooledLabels(const SpooledRooms& spooled,
                const WorkFolder& folder,
                const std::vector<std::uint32_t>& first_object);

  struct Label {
    std::uint32_t room = 0, object = 0, structure = 0;
  };

  /** \brief Of the next point.
   * \throws ToolError if a file is gone or too short */
  Label
  next();

private:
  /** What comes next of a room. */
  struct Cursor {
    std::vector<std::uint32_t> objects, structures;
    std::size_t at = 0, taken = 0;
  };

  void
  refill(std::size_t room);

  const SpooledRooms& filed_;
  const WorkFolder& folder_;
  const std::vector<std::uint32_t>& first_object_;
  std::ifstream rooms_;
  std::vector<Cursor> cursors_;
};

} // namespace pcl::indoor::tool
