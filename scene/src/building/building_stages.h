/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/scan_content.h"
#include "rooms/room_store.h"
#include "rooms/scene_rooms.h"
#include "rooms/spooled_rooms.h"
#include "text/stage_report.h"

#include <pcl/indoor/exports.h>
#include <pcl/scene/scene.h>
#include <pcl/scene/scene_options.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The options with sizes of voxels and supervoxels that fit each other, and
 * checked.
 * \throws ToolError if one is none */
PCL_INDOOR_EXPORTS SceneOptions
checkedOptions(SceneOptions options);

/** \brief Read a scan that stays in its files, keeping a point per cell.
 * \param[in] most_points from which on cells become larger */
PCL_INDOOR_EXPORTS void
drawSample(const SceneOptions& options,
           std::uint64_t most_points,
           ScanContent& scan,
           StageReport& report);

/** \brief What the objects of each room are looked for with, but for the
 * building's frame, which is not known yet. */
PCL_INDOOR_EXPORTS RoomWork
roomWork(const SceneOptions& options);

/** \brief Of a scan that is read in parts: where its points are, and what is to be
 * added to the numbers of objects, per room. */
struct RoomFiles {
  SpooledRooms spooled;
  std::vector<std::uint32_t> first_object;
};

/** \brief How the objects of all rooms are found. */
struct ObjectSearch {
  RoomWork work;
  RoomStore& store;
  StageReport& report;
  int threads = 0;
  bool ignore_normals = false;
  ShareRooms share = {}; ///< see finishRooms()
};

/** \brief A scene whose rooms and walls are found, and the points that its objects are
 * looked for in: z up, metres, what lies beyond the building not finite. */
struct FoundBuilding {
  Scene scene;
  PointCloud<PointXYZ>::ConstPtr upright;
};

/** \brief Find the rooms of the scan, unless the store has them, their walls, doors and
 * windows.
 * \param[in,out] options unit and axis become those that were used
 * \param[in,out] scan a sample waits in a file meanwhile, see PointsAside
 * \param[in,out] search gets the building's frame */
PCL_INDOOR_EXPORTS FoundBuilding
findBuilding(SceneOptions& options,
             ScanContent& scan,
             const UnderstoodScan& understood,
             ObjectSearch& search);

/** \brief Find the objects of the rooms of a scan in memory, room by room, and what
 * they are. */
PCL_INDOOR_EXPORTS void
findObjects(const ObjectSearch& search, const CloudFile& file, FoundBuilding& building);

/** \brief The same of a scan that is read in parts: it is divided into the files of its
 * rooms. The points of the sample get their objects by labelSample(), or when the
 * cloud is written. */
PCL_INDOOR_EXPORTS RoomFiles
findObjectsInParts(const ObjectSearch& search,
                   WorkFolder& folder,
                   ScanContent& scan,
                   FoundBuilding& building);

/** \brief Gives the points of a sample their objects and structure, from the labels of
 * all points, one by one. */
class SampleLabels {
public:
  SampleLabels(const AscendingNumbers& sampled, Scene& scene);

  void
  add(std::uint64_t point, const SpooledLabels::Label& label);

private:
  AscendingNumbers::Reader next_;
  bool has_more_;
  Scene& scene_;
};

/** \brief Object and structure of each point of the sample. */
void
labelSample(const RoomFiles& files,
            const WorkFolder& folder,
            const AscendingNumbers& sampled,
            Scene& scene);

} // namespace pcl::indoor::tool
