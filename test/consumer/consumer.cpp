/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/room_segmentation.h>

#include <pcl/point_types.h>

#include <iostream>

int
main()
{
  // the six sides of a box of 4 x 3 x 2.6 m are a room
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (float a = 0.0f; a <= 1.0f; a += 0.015625f)
    for (float b = 0.0f; b <= 1.0f; b += 0.015625f)
      for (const float c : {0.0f, 1.0f}) {
        cloud->emplace_back(4 * a, 3 * b, 2.6f * c);
        cloud->emplace_back(4 * a, 3 * c, 2.6f * b);
        cloud->emplace_back(4 * c, 3 * a, 2.6f * b);
      }
  pcl::RoomSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setInputCloud(cloud);
  std::vector<std::uint32_t> labels;
  segmentation.segment(labels);
  std::cout << segmentation.getRooms().size() << " room\n";
  return segmentation.getRooms().size() == 1 ? 0 : 1;
}
