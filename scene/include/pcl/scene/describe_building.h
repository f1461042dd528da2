/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/io/scan_file.h>
#include <pcl/scene/scene.h>
#include <pcl/scene/scene_options.h>

namespace pcl::indoor {

/** \brief Find the rooms of a building's scan, its walls, doors and windows, the
 * objects in each room and the class of each object, as pcl_indoor_pipeline does.
 *
 * The result depends neither on the number of threads nor on the machine. Time is about
 * linear in the points; memory follows them, or, of a scan that is read in parts, its
 * largest rooms.
 * \param[in,out] scan of one that is read in parts the points are read
 * \throws InputError if an option is none, the model cannot be read, or too few points
 * are finite
 * \throws pcl::BadArgumentException if an option is out of range
 */
PCL_INDOOR_EXPORTS Scene
describeBuilding(const Scan& scan, const SceneOptions& options = {});

} // namespace pcl::indoor
