/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <string>

namespace pcl::indoor {

/** \brief The file of the model that comes with this library, of furniture, doors and
 * windows: it is looked for from where the library lies. */
PCL_INDOOR_EXPORTS std::string
bundledModelFile();

/** \brief The same of the voxel network that tells objects from the building where no
 * ceiling was seen. */
PCL_INDOOR_EXPORTS std::string
bundledNetworkFile();

} // namespace pcl::indoor
