/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/cloud_stations.h"

#include "files/station_choice.h"

namespace pcl::indoor::tool {

ScanStations
scanStations(const CloudFile& file)
{
  return {stationPositions(file), stationsOfPoints(file)};
}

} // namespace pcl::indoor::tool
