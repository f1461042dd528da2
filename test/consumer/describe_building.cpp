/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/io/scan_file.h>
#include <pcl/scene/describe_building.h>
#include <pcl/scene/scene_file.h>

int
main(int, char** argv)
{
  const auto scan = pcl::indoor::loadScan(argv[1]);
  const auto scene = pcl::indoor::describeBuilding(scan);
  pcl::indoor::saveScene(argv[2], scene); // scene.json
}
