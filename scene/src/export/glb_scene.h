/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "export/saved_scene.h"

#include <string>

namespace pcl::indoor::tool {

/** \brief A scene as a binary glTF 2.0 file: a node per storey; in it the floors of
 * rooms, walls with holes where openings are, and objects as boxes with their class and
 * confidence as extras. y is up, as glTF has it; places are without the offset of the
 * scan.
 */
std::string
glbBytes(const SavedScene& scene);

} // namespace pcl::indoor::tool
