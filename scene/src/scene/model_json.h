/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/model/building_model.h>

#include <nlohmann/json.hpp>

#include <Eigen/Geometry>

namespace pcl::indoor::tool {

/** \brief As scene.json calls it. */
const char*
nameOf(ModelOpeningKind kind);

/** \brief Doors, windows and passages, as scene.json has them.
 * \param[in] to_file brings places of the building's frame into the file's
 */
nlohmann::ordered_json
openingsJson(const BuildingModel& model, const Eigen::Affine3d& to_file);

/** \brief Walls, as scene.json has them.
 * \param[in] to_file brings places of the building's frame into the file's
 */
nlohmann::ordered_json
wallsJson(const BuildingModel& model, const Eigen::Affine3d& to_file);

/** \brief Columns, as scene.json has them.
 * \param[in] to_file brings places of the building's frame into the file's
 */
nlohmann::ordered_json
columnsJson(const BuildingModel& model, const Eigen::Affine3d& to_file);

} // namespace pcl::indoor::tool
