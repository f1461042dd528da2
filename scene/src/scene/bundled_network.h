/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/ml/voxel_network.h>

namespace pcl::indoor::tool {

/** \brief The bundled voxel network; its file is read once, when it is first needed.
 * \throws what loadVoxelNetwork() throws; the next call reads again
 */
const VoxelNetwork&
bundledNetwork();

} // namespace pcl::indoor::tool
