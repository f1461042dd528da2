/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "export/saved_scene.h"

#include <nlohmann/json.hpp>

namespace pcl::indoor::tool {

/** \brief Rooms, walls, openings and objects as GeoJSON, for maps: places in metres,
 * offset included; walls of known thickness and objects as polygons, other walls and
 * openings as lines.
 * \param[in] epsg code of the coordinate system, which is named; 0 = not known
 */
nlohmann::ordered_json
geoJson(const SavedScene& scene, int epsg = 0);

/** \brief A feature of GeoJSON. */
nlohmann::ordered_json
geoFeature(const char* geometry,
           const nlohmann::ordered_json& coordinates,
           const nlohmann::ordered_json& properties);

} // namespace pcl::indoor::tool
