/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "export/saved_scene.h"
#include "pictures/floor_plan.h"

namespace pcl::indoor::tool {

/** \brief The plan of a scene, to be drawn: rooms, doors and passages, objects. */
FloorPlan
scenePlan(const SavedScene& scene);

} // namespace pcl::indoor::tool
