/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "features/oriented_shapes.h"

#include <pcl/features/eppf.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>

namespace pcl::indoor {
namespace test {

template <typename SignatureT>
using EstimationOf =
    pcl::EPPFEstimation<pcl::PointNormal, pcl::PointNormal, SignatureT>;

// What holds for any output is tested with the one that has all parts.
using Signature = pcl::PairHarmonicsSignature1200;
using Estimation = EstimationOf<Signature>;
using Descriptors = pcl::PointCloud<Signature>;

inline pcl::PointCloud<pcl::PointNormal>::Ptr
boxCloud(std::size_t count, std::uint32_t seed)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  for (const auto& point : pcl::indoor::boxSurface(box_size, count, seed)) {
    pcl::PointNormal both;
    both.getVector3fMap() = point.position;
    both.getNormalVector3fMap() = point.normal;
    cloud->push_back(both);
  }
  return cloud;
}

inline Descriptors
describe(const pcl::PointCloud<pcl::PointNormal>::ConstPtr& cloud)
{
  Estimation estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(cloud);
  Descriptors output;
  estimation.compute(output);
  return output;
}

inline bool
isSame(const Signature& a, const Signature& b)
{
  return std::equal(a.histogram, a.histogram + 1200, b.histogram);
}

inline double
difference(const Signature& a, const Signature& b)
{
  double sum = 0.0;
  for (int bin = 0; bin < 1200; ++bin)
    sum += std::abs(a.histogram[bin] - b.histogram[bin]);
  return sum;
}

} // namespace test
} // namespace pcl::indoor
