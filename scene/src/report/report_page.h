/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "pictures/floor_plan.h"
#include "scene/scene_json.h"

#include <pcl/indoor/exports.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The objects of a scene from above, larger ones first, so that smaller ones
 * are drawn upon them. */
PCL_INDOOR_EXPORTS std::vector<PlanObject>
objectsFromAbove(const Scene& scene);

/** \brief What the report shows. */
struct ReportInput {
  const Scene& scene;
  const nlohmann::ordered_json& json;  ///< of the scene, see sceneJson()
  const FloorPlan& plan;               ///< with objects
  const std::string& field;            ///< SVG
  const PointCloud<PointXYZ>& upright; ///< points of the scene, z up, metres
};

/** \brief The report: an HTML page that needs no other file and no network, made of
 * what lies in scene/report. The same input gives the same bytes. */
PCL_INDOOR_EXPORTS std::string
reportPage(const ReportInput& input);

} // namespace pcl::indoor::tool
