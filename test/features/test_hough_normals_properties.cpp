/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// What changes of the cloud do to normals, over random boxes.
#include "support/cloud_changes.h"
#include "support/labelled_cloud.h"

#include <pcl/features/hough_normals.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <set>

using namespace pcl::indoor;
using namespace pcl::indoor::test;
using Points = std::vector<Eigen::Vector3f>;

namespace {

constexpr unsigned random_boxes = 3;

/** The bits that a normal and its curvature have, so that NaN equals
 * itself. */
using Bits = std::vector<std::array<std::uint32_t, 4>>;

Points
randomBox(unsigned seed)
{
  std::mt19937 rng(seed);
  LabelledPoints box;
  box.addBox({0, 0, 0},
             {drawn(0.3f, 0.8f, rng), drawn(0.3f, 0.8f, rng), drawn(0.2f, 0.5f, rng)},
             1,
             0.02f,
             0.003f,
             rng);
  box.points.emplace_back(5.0f, 5.0f, 5.0f); // alone
  return box.points;
}

class NormalsOfBoxes {
public:
  pcl::HoughNormalEstimation<pcl::PointXYZ> estimation;

  NormalsOfBoxes() { estimation.setViewPoint(-2, -3, 4); }

  pcl::PointCloud<pcl::Normal>
  of(const Points& points)
  {
    estimation.setInputCloud(cloudOf(points));
    pcl::PointCloud<pcl::Normal> normals;
    estimation.compute(normals);
    return normals;
  }

  Bits
  bitsOf(const Points& points)
  {
    Bits bits;
    for (const auto& normal : of(points)) {
      const float values[] = {
          normal.normal_x, normal.normal_y, normal.normal_z, normal.curvature};
      bits.emplace_back();
      std::memcpy(bits.back().data(), values, sizeof(values));
    }
    return bits;
  }
};

} // namespace

TEST(HoughNormalProperties, AnyNumberOfThreadsGivesTheSameBits)
{
  for (unsigned seed = 0; seed < random_boxes; ++seed) {
    const auto points = randomBox(seed);
    NormalsOfBoxes normals;
    normals.estimation.setNumberOfThreads(1);
    const auto one = normals.bitsOf(points);
    ASSERT_EQ(one.size(), points.size());
    for (const unsigned threads : {2u, 7u}) {
      normals.estimation.setNumberOfThreads(threads);
      EXPECT_EQ(normals.bitsOf(points), one) << seed << ", " << threads << " threads";
    }
  }
}

TEST(HoughNormalProperties, AnotherOrderOfPointsGivesTheSameBits)
{
  for (unsigned seed = 0; seed < random_boxes; ++seed) {
    const auto points = randomBox(seed);
    std::mt19937 rng(seed);
    const auto order = shuffledOrder(points.size(), rng);
    // the automatic radius is that of distances, which have no order
    EXPECT_EQ(NormalsOfBoxes().bitsOf(inOrder(points, order)),
              inOrder(NormalsOfBoxes().bitsOf(points), order))
        << seed;
  }
}

TEST(HoughNormalProperties, TheSamePointsInRowsGiveTheSameBits)
{
  for (unsigned seed = 0; seed < random_boxes; ++seed) {
    auto points = randomBox(seed);
    points.resize(points.size() / 2 * 2);
    const auto in_rows = cloudOf(points);
    in_rows->width = static_cast<std::uint32_t>(points.size() / 2);
    in_rows->height = 2;
    NormalsOfBoxes one_row, rows;
    for (auto* const normals : {&one_row, &rows})
      normals->estimation.setKSearch(20);
    const auto expected = one_row.of(points);
    rows.estimation.setInputCloud(in_rows);
    pcl::PointCloud<pcl::Normal> found;
    rows.estimation.compute(found);
    EXPECT_EQ(found.height, 2u);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      ASSERT_TRUE(found[i].getNormalVector3fMap() ==
                      expected[i].getNormalVector3fMap() ||
                  std::isnan(expected[i].normal_x))
          << seed << ", point " << i;
  }
}

TEST(HoughNormalProperties, CopiesOfPointsHaveTheNormalOfTheirPlace)
{
  for (unsigned seed = 0; seed < random_boxes; ++seed) {
    const auto points = randomBox(seed);
    const auto order = withCopies(points.size());
    const auto bits = NormalsOfBoxes().bitsOf(inOrder(points, order));
    ASSERT_EQ(bits.size(), order.size());
    for (std::size_t k = points.size(); k < order.size(); ++k)
      ASSERT_EQ(bits[k], bits[order[k]]) << seed;
  }
}

TEST(HoughNormalProperties, BadPointsHaveNoNormalAndChangeNoOther)
{
  for (unsigned seed = 0; seed < random_boxes; ++seed) {
    const auto points = randomBox(seed);
    std::mt19937 rng(seed);
    std::vector<std::size_t> places;
    const auto with_bad = withBadPoints(points, rng, places);
    const auto bits = NormalsOfBoxes().bitsOf(with_bad);
    ASSERT_EQ(bits.size(), with_bad.size());
    EXPECT_EQ(inOrder(bits, places), NormalsOfBoxes().bitsOf(points)) << seed;
    const auto normals = NormalsOfBoxes().of(with_bad);
    EXPECT_FALSE(normals.is_dense);
    for (std::size_t i = 0; i < with_bad.size(); ++i) {
      if (!with_bad[i].allFinite()) {
        ASSERT_TRUE(std::isnan(normals[i].normal_x)) << seed;
      }
    }
  }
}

TEST(HoughNormalProperties, IndicesWithTheirPointsAsSurfaceAreThosePointsAlone)
{
  for (unsigned seed = 0; seed < random_boxes; ++seed) {
    const auto points = randomBox(seed);
    std::mt19937 rng(seed);
    const auto subset = randomSubset(points.size(), rng);
    NormalsOfBoxes normals;
    normals.estimation.setIndices(
        pcl::make_shared<pcl::Indices>(subset.begin(), subset.end()));
    // without a surface all points of the cloud are neighbours, as in PCL's features
    NormalsOfBoxes whole;
    EXPECT_EQ(normals.bitsOf(points), inOrder(whole.bitsOf(points), subset)) << seed;
    normals.estimation.setSearchSurface(cloudOf(inOrder(points, subset)));
    EXPECT_EQ(normals.bitsOf(points), NormalsOfBoxes().bitsOf(inOrder(points, subset)))
        << seed;
  }
}

TEST(HoughNormalProperties, ShiftsThatFloatsHoldChangeNoBit)
{
  for (unsigned seed = 0; seed < random_boxes; ++seed) {
    const auto points = onRaster(randomBox(seed));
    const Eigen::Vector3f by(16384, -8192, 512);
    NormalsOfBoxes normals, moved;
    moved.estimation.setViewPoint(-2 + by.x(), -3 + by.y(), 4 + by.z());
    for (auto* const n : {&normals, &moved})
      n->estimation.setRadiusSearch(0.06); // not that of a tie
    EXPECT_EQ(moved.bitsOf(shifted(points, by)), normals.bitsOf(points)) << seed;
  }
}

TEST(HoughNormalProperties, UtmCoordinatesAsFloatsAreTheirPointsNearTheOrigin)
{
  for (unsigned seed = 0; seed < random_boxes; ++seed) {
    auto points = randomBox(seed);
    for (auto& point : points)
      point *= 10; // several of the steps of UTM coordinates
    const UtmPoints utm(points);
    NormalsOfBoxes normals, moved;
    moved.estimation.setViewPoint(
        -2 + utm.offset.x(), -3 + utm.offset.y(), 4 + utm.offset.z());
    for (auto* const n : {&normals, &moved})
      n->estimation.setRadiusSearch(0.8); // not that of a tie
    const auto bits = normals.bitsOf(utm.near);
    EXPECT_GT(std::set(bits.begin(), bits.end()).size(), 10u) << seed;
    EXPECT_EQ(moved.bitsOf(utm.far), bits) << seed;
  }
}

TEST(HoughNormalProperties, TurnedWithTheCloudNormalsDifferByLessThanTheirNoise)
{
  for (unsigned seed = 0; seed < random_boxes; ++seed) {
    const auto points = randomBox(seed);
    const auto straight = NormalsOfBoxes().of(points);
    for (const float degrees : {17.0f, 90.0f, 230.0f}) {
      const Eigen::Matrix3f turn =
          Eigen::AngleAxisf(degrees * static_cast<float>(M_PI) / 180,
                            Eigen::Vector3f::UnitZ())
              .toRotationMatrix();
      auto turned = points;
      for (auto& point : turned)
        point = turn * point;
      const auto other = NormalsOfBoxes().of(turned);
      std::vector<double> angles;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector3f normal = turn * straight[i].getNormalVector3fMap();
        ASSERT_EQ(normal.allFinite(), std::isfinite(other[i].normal_x)) << seed;
        if (!normal.allFinite())
          continue;
        EXPECT_NEAR(straight[i].curvature, other[i].curvature, 1e-4f);
        const float cosine = std::abs(normal.dot(other[i].getNormalVector3fMap()));
        angles.push_back(std::acos(std::min(1.0f, cosine)) * 180 / M_PI);
      }
      // Bins and cubes do not turn with the cloud: half of the normals are the same
      // plane's fit, and only at edges is another plane chosen.
      std::sort(angles.begin(), angles.end());
      EXPECT_LT(angles[angles.size() / 2], 0.5) << seed << ", " << degrees;
      EXPECT_LT(angles[angles.size() * 9 / 10], 10.0) << seed << ", " << degrees;
    }
  }
}
