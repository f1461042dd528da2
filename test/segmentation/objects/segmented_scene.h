/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "support/labelled_cloud.h"
#include "support/labelled_points.h"

#include <pcl/segmentation/noise_resilient_lccp.h>
#include <pcl/segmentation/segmentation_metrics.h>

namespace pcl::indoor {
namespace test {

using Segmentation = pcl::NoiseResilientLCCP<pcl::PointXYZ>;

inline Labels
segmentedObjects(const Cloud::ConstPtr& cloud)
{
  Segmentation segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setViewPoint(2, 1, 3);
  Labels labels;
  segmentation.segment(labels);
  return labels;
}

inline pcl::PointCloud<pcl::Normal>::Ptr
normalsOf(const LabelledPoints& scene)
{
  const pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
  for (const auto& normal : scene.normals)
    normals->emplace_back(normal.x(), normal.y(), normal.z());
  return normals;
}

/** A closed room around the boxes, each wall an object of its own. */
inline LabelledPoints
roomWithTwoBoxes()
{
  auto scene = floorWithTwoBoxes();
  std::mt19937 rng(8);
  const Eigen::Vector3f x(4, 0, 0), y(0, 2.5f, 0), z(0, 0, 2.4f);
  scene.addRoomSide(z, x, y, {0, 0, -1}, 4, rng);
  scene.addRoomSide({0, 0, 0}, x, z, {0, 1, 0}, 5, rng);
  scene.addRoomSide(y, x, z, {0, -1, 0}, 6, rng);
  scene.addRoomSide({0, 0, 0}, y, z, {1, 0, 0}, 7, rng);
  scene.addRoomSide(x, y, z, {-1, 0, 0}, 8, rng);
  return scene;
}

inline double
agreement(const Labels& truth, const Labels& labels)
{
  return adjustedRandIndex(countOverlaps(truth, labels));
}

} // namespace test
} // namespace pcl::indoor
