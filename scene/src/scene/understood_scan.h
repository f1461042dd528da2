/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"

#include <pcl/indoor/exports.h>
#include <pcl/scene/scene.h>
#include <pcl/scene/scene_options.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief How a scan is looked at. */
struct ScanLook {
  bool ignores_normals = false;
  /** By the bundled voxel network, for which end is up; where rooms are found,
   * segmentRooms() does so. */
  bool at_objects = false;
};

/** \brief Look at a scan, in well under a second; in one to three more where furniture
 * does not clearly tell which end is up.
 * \param[in] points of the whole scan, of which the file has them all or a sample
 */
PCL_INDOOR_EXPORTS UnderstoodScan
understand(const CloudFile& file,
           const CoordinateOptions& coordinates,
           std::uint64_t points,
           const ScanLook& look = {});

/** \brief What lacks most, and what that means for the result; or that all is there
 * that rooms are found from. */
PCL_INDOOR_EXPORTS std::string
verdictOf(const UnderstoodScan& scan);

/** \brief What there is, what lacks and what that means, as one paragraph for a
 * terminal. */
PCL_INDOOR_EXPORTS std::string
paragraphOf(const std::string& path, const UnderstoodScan& scan);

/** \brief All of it, as scene/schema/scene.schema.json has it ("overview"). */
PCL_INDOOR_EXPORTS nlohmann::ordered_json
overviewJson(const UnderstoodScan& scan);

/** \brief Why a result is as good as empty: no room, or most points in none.
 * \param[in] in_rooms points in rooms, of all that are finite
 * \return one line; empty if the result is not
 */
PCL_INDOOR_EXPORTS std::string
emptinessOf(const UnderstoodScan& scan, std::size_t rooms, std::uint64_t in_rooms);

} // namespace pcl::indoor::tool
