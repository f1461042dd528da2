/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/exceptions.h>
#include <pcl/features/pfh_tools.h>
#include <pcl/features/surflet_pair.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include "features/oriented_shapes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace pcl::indoor {
namespace {

Eigen::Vector4f
homogeneous(const Eigen::Vector3f& vector)
{
  return {vector.x(), vector.y(), vector.z(), 0.0f};
}

TEST(SurfletPairFeatures, EqualPCLsWhereBothChooseTheSameOrigin)
{
  // PCL starts from the surflet whose normal lies nearer to the line, the paper from
  // the other one. With cosines of one magnitude both may start from the same.
  std::mt19937 rng(1);
  int compared = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    auto points = randomSurflets(2, static_cast<std::uint32_t>(trial));
    const Eigen::Vector3f line = (points[1].position - points[0].position).normalized();
    // The second normal: turned about the line from the mirrored first one.
    const float angle = drawBetween(-3.0f, 3.0f, rng);
    points[1].normal = Eigen::AngleAxisf(angle, line) * points[0].normal;
    float f[4];
    ASSERT_TRUE(computePairFeatures(homogeneous(points[0].position),
                                    homogeneous(points[0].normal),
                                    homogeneous(points[1].position),
                                    homogeneous(points[1].normal),
                                    f[0],
                                    f[1],
                                    f[2],
                                    f[3]));
    const auto ours = surfletPairFeatures(points[0], points[1]);
    // Rounding decides which is the origin; gamma tells whether both chose the same
    // one.
    if (std::abs(ours[2] - f[2]) > 1e-4f || std::abs(ours[2]) < 1e-3f)
      continue;
    ++compared;
    EXPECT_NEAR(ours[0], f[0], 1e-3f);
    EXPECT_NEAR(ours[1], f[1], 1e-3f);
    EXPECT_NEAR(ours[3], f[3], 1e-5f);
  }
  EXPECT_GT(compared, 100);
}

TEST(SurfletPairFeatures, HandMadePair)
{
  // n1 = z up from the origin, n2 = x along the line: n1 is the upright one.
  const OrientedPoint one{{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
  const OrientedPoint two{{2.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}};
  // u = z, v = x cross z = -y, w = u cross v = z cross -y = x.
  // alpha = atan2(w.n2, u.n2) = atan2(1, 0), beta = v.n2 = 0, gamma = u.d = 0.
  const auto f = surfletPairFeatures(one, two);
  EXPECT_NEAR(f[0], 1.5707963f, 1e-6f);
  EXPECT_NEAR(f[1], 0.0f, 1e-6f);
  EXPECT_NEAR(f[2], 0.0f, 1e-6f);
  EXPECT_NEAR(f[3], 2.0f, 1e-6f);
  // Given the other way round the origin is still the first, the line the same.
  EXPECT_EQ(surfletPairFeatures(two, one), f);
}

TEST(SurfletPairFeatures, BothNormalsAlongTheLine)
{
  const OrientedPoint one{{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
  const OrientedPoint two{{0.0f, 0.0f, 3.0f}, {0.0f, 0.0f, -1.0f}};
  const auto f = surfletPairFeatures(one, two);
  EXPECT_EQ(f[0], 0.0f);
  EXPECT_EQ(f[1], 0.0f);
  EXPECT_NEAR(f[2], 1.0f, 1e-6f);
}

TEST(SurfletPairHistogram, TurningChangesOnlyRounding)
{
  const auto points = randomSurflets(1000, 3);
  auto turned = points;
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(0.8f, Eigen::Vector3f(1.0f, 2.0f, -1.0f).normalized())
          .toRotationMatrix();
  for (auto& point : turned) {
    point.position = turn * point.position;
    point.normal = turn * point.normal;
  }
  const auto histogram = surfletPairHistogram(points, {});
  const auto other = surfletPairHistogram(turned, {});
  EXPECT_NEAR(std::accumulate(histogram.begin(), histogram.end(), 0.0), 1.0, 1e-6);
  double difference = 0.0;
  for (std::size_t bin = 0; bin < histogram.size(); ++bin)
    difference += std::abs(histogram[bin] - other[bin]);
  // A handful of the 20,000 pairs lies within rounding of a border.
  EXPECT_LE(difference, 10 * 2.0 / 20000);
}

TEST(SurfletPairHistogram, ThreadsChangeNoBitAndSeedsDo)
{
  const auto points = boxSurface({1.0f, 0.5f, 0.25f}, 1000, 4);
  SurfletPairOptions options;
  const auto histogram = surfletPairHistogram(points, options);
  options.number_of_threads = 3;
  EXPECT_EQ(histogram, surfletPairHistogram(points, options));
  options.seed = 1;
  EXPECT_NE(histogram, surfletPairHistogram(points, options));
}

TEST(SurfletPairHistogram, DegenerateObjectsAndOptions)
{
  for (const float value : surfletPairHistogram({}, {}))
    EXPECT_TRUE(std::isnan(value));
  std::vector<OrientedPoint> same(4);
  EXPECT_TRUE(std::isnan(surfletPairHistogram(same, {}).front()));
  SurfletPairOptions options;
  options.bin_count = 6;
  EXPECT_EQ(surfletPairHistogram(same, options).size(), 1296u);
  options.bin_count = 0;
  EXPECT_THROW(surfletPairHistogram(same, options), BadArgumentException);
  options.bin_count = 5;
  options.pair_count = 0;
  EXPECT_THROW(surfletPairHistogram(same, options), BadArgumentException);
  options.pair_count = 5;
  options.scale = -2.0;
  EXPECT_THROW(surfletPairHistogram(same, options), BadArgumentException);
}

template <typename SignatureT>
PointCloud<SignatureT>
describe(const PointCloud<PointNormal>::ConstPtr& cloud)
{
  SurfletPairEstimation<PointNormal, PointNormal, SignatureT> estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(cloud);
  estimation.setScale(2.0);
  estimation.setPairCount(5000);
  PointCloud<SignatureT> output;
  estimation.compute(output);
  return output;
}

TEST(SurfletPairEstimation, GivesTheCoresHistogram)
{
  const auto points = randomSurflets(300, 5);
  auto cloud = make_shared<PointCloud<PointNormal>>();
  for (const auto& point : points) {
    PointNormal both;
    both.getVector3fMap() = point.position;
    both.getNormalVector3fMap() = point.normal;
    cloud->push_back(both);
  }
  SurfletPairOptions options;
  options.scale = 2.0;
  options.pair_count = 5000;
  const auto expected = surfletPairHistogram(points, options);
  const auto output = describe<SurfletPairSignature625>(cloud);
  ASSERT_EQ(output.size(), 1u);
  double difference = 0.0;
  for (std::size_t bin = 0; bin < expected.size(); ++bin)
    difference += std::abs(expected[bin] - output[0].histogram[bin]);
  // Moved by the first point: a handful of 5,000 pairs lies within rounding of a
  // border.
  EXPECT_LT(difference, 10 * 2.0 / 5000);
  EXPECT_EQ(describe<SurfletPairSignature1296>(cloud).size(), 1u);
  EXPECT_TRUE(describe<SurfletPairSignature625>(make_shared<PointCloud<PointNormal>>())
                  .empty());
}

} // namespace
} // namespace pcl::indoor
