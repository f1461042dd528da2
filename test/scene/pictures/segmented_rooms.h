/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "support/synthetic_scenes.h"

namespace pcl::indoor::test {

/** \brief Two rooms with a door between them, segmented once. */
inline const BuildingRooms&
segmentedRooms()
{
  static const auto building = segmentBuilding(twoRooms().points);
  return building;
}

} // namespace pcl::indoor::test
