/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/scene/scene.h>

#include <string>

namespace pcl::indoor {

/** \brief A scene as a JSON text, as scene.schema.json has it: positions in the frame
 * and the unit of the file, areas and lengths in metres. */
PCL_INDOOR_EXPORTS std::string
sceneText(const Scene& scene);

/** \brief Write it to a file, whole or not at all.
 * \throws InputError naming the file and the reason, if it cannot be written */
PCL_INDOOR_EXPORTS void
saveScene(const std::string& path, const Scene& scene);

} // namespace pcl::indoor
