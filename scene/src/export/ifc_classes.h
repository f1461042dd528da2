/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "export/saved_scene.h"

#include <string>

namespace pcl::indoor::tool {

/** \brief The entity of IFC that an object is. */
std::string
ifcEntityOf(const SavedObject& object);

/** \brief How IFC calls furniture of a class. */
std::string
ifcFurnitureType(const std::string& name);

} // namespace pcl::indoor::tool
