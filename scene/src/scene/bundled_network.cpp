/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/bundled_network.h"

#include <pcl/ml/bundled_model.h>

namespace pcl::indoor::tool {

const VoxelNetwork&
bundledNetwork()
{
  static const auto network = loadVoxelNetwork(bundledNetworkFile());
  return network;
}

} // namespace pcl::indoor::tool
