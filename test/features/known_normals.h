/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// A surface whose normals are known, and how many of the estimated ones are wrong.
#pragma once

#include "support/labelled_points.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cmath>
#include <random>
#include <vector>

namespace pcl::indoor {
namespace test {

/** A box with noise (metres), and the faces' normals. */
inline LabelledPoints
noisyBox(float noise)
{
  std::mt19937 rng(2);
  LabelledPoints box;
  box.addBox({0, 0, 0}, {0.5f, 0.4f, 0.3f}, 1, 0.012f, noise, rng);
  return box;
}

/** Share of the normals that are more than ten degrees off, 0 to 1. */
inline double
shareOfBad(const PointCloud<Normal>& normals, const std::vector<Eigen::Vector3f>& truth)
{
  std::size_t bad = 0;
  for (std::size_t i = 0; i < normals.size(); ++i)
    bad += !(std::abs(normals[i].getNormalVector3fMap().dot(truth[i])) >
             std::cos(10 * 3.14159265f / 180));
  return static_cast<double>(bad) / static_cast<double>(normals.size());
}

} // namespace test
} // namespace pcl::indoor
