/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "features/known_normals.h"
#include "support/labelled_cloud.h"
#include "support/labelled_points.h"

#include <pcl/features/hough_normals.h>
#include <pcl/features/normal_3d.h>

#include <gtest/gtest.h>

using namespace pcl::indoor;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;
using HoughEstimation = pcl::HoughNormalEstimation<pcl::PointXYZ>;

Cloud::Ptr
plane(const Eigen::Vector3f& corner)
{
  std::mt19937 rng(1);
  test::LabelledPoints scene;
  scene.addRectangle(corner, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1, 0.05f, 0, rng);
  return test::cloudOf(scene.points);
}

Normals
estimated(const Cloud::Ptr& cloud, double radius, unsigned threads = 1)
{
  HoughEstimation estimation(threads);
  estimation.setInputCloud(cloud);
  estimation.setRadiusSearch(radius);
  Normals normals;
  estimation.compute(normals);
  return normals;
}

void
expectSame(const Normals& a, const Normals& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].getNormalVector3fMap(), b[i].getNormalVector3fMap()) << i;
    EXPECT_EQ(a[i].curvature, b[i].curvature) << i;
  }
}

} // namespace

TEST(HoughNormalEstimation, APlaneIsExactAlsoInLargeCoordinates)
{
  for (const float shift : {0.0f, 4096.0f}) { // where a float holds a twentieth exactly
    const auto cloud = plane({shift, shift, 1});
    for (auto& point : *cloud)
      point.x = shift + std::round((point.x - shift) * 32) / 32;
    auto normals = estimated(cloud, 0.2);
    ASSERT_EQ(normals.size(), cloud->size());
    EXPECT_TRUE(normals.is_dense);
    for (const auto& normal : normals) {
      EXPECT_NEAR(normal.normal_z, -1, 1e-5f); // towards the origin
      EXPECT_NEAR(normal.curvature, 0, 1e-6f);
    }
  }
}

TEST(HoughNormalEstimation, EdgesStaySharp)
{
  const auto box = test::noisyBox(0.003f);
  const auto cloud = test::cloudOf(box.points);
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> least_squares;
  least_squares.setInputCloud(cloud);
  least_squares.setRadiusSearch(0.06);
  Normals rounded;
  least_squares.compute(rounded);
  const auto sharp = estimated(cloud, 0.06);
  EXPECT_GT(test::shareOfBad(rounded, box.normals), 0.3);
  // One point in fifteen lies on an edge, where both faces are right.
  EXPECT_LT(test::shareOfBad(sharp, box.normals), 0.08);
  for (std::size_t i = 0; i < sharp.size(); ++i) // Eq. (2.8) of the same neighbours
    EXPECT_NEAR(sharp[i].curvature, rounded[i].curvature, 1e-3f);
}

TEST(HoughNormalEstimation, TheDenseSideOfAnEdgeDoesNotOutvoteTheOther)
{
  std::mt19937 rng(3);
  test::LabelledPoints fold;
  fold.addRectangle(
      {0, 0, 0}, {-0.5f, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1, 0.01f, 0.002f, rng);
  const auto dense = fold.points.size();
  fold.addRectangle(
      {0, 0, 0}, {0, 0, -0.5f}, {0, 1, 0}, {1, 0, 0}, 2, 0.035f, 0.002f, rng);
  fold.removeIf(
      [](const auto& p) { return std::abs(p.x()) + std::abs(p.z()) < 0.008f; });
  const auto cloud = test::cloudOf(fold.points);
  const auto badOfSparse = [&](HoughEstimation::Sampling sampling) {
    HoughEstimation estimation;
    estimation.setInputCloud(cloud);
    estimation.setRadiusSearch(0.08);
    auto options = estimation.getOptions();
    options.sampling = sampling;
    options.plane_distance = 1;
    estimation.setOptions(options);
    Normals normals;
    estimation.compute(normals);
    Normals sparse;
    std::vector<Eigen::Vector3f> truth;
    for (std::size_t i = 0; i < normals.size(); ++i)
      if (fold.objects[i] == 2) {
        sparse.push_back(normals[i]);
        truth.push_back(fold.normals[i]);
      }
    EXPECT_LT(sparse.size(), dense / 5);
    return test::shareOfBad(sparse, truth);
  };
  const auto by_cubes = badOfSparse(HoughEstimation::Sampling::Cubes);
  EXPECT_LT(by_cubes, 0.8 * badOfSparse(HoughEstimation::Sampling::Points));
}

TEST(HoughNormalEstimation, ThreadsAndOrderDoNotMatter)
{
  const auto box = test::noisyBox(0.003f);
  const auto one = estimated(test::cloudOf(box.points), 0.05, 1);
  expectSame(one, estimated(test::cloudOf(box.points), 0.05, 4));
  std::mt19937 rng(4);
  const auto order = test::shuffledOrder(box.points.size(), rng);
  std::vector<Eigen::Vector3f> shuffled;
  Normals expected;
  for (const auto i : order) {
    shuffled.push_back(box.points[i]);
    expected.push_back(one[i]);
  }
  expectSame(estimated(test::cloudOf(shuffled), 0.05, 2), expected);
}

TEST(HoughNormalEstimation, RunsTwiceTheSame)
{
  HoughEstimation estimation;
  estimation.setInputCloud(test::cloudOf(test::noisyBox(0.003f).points));
  Normals first, second;
  estimation.compute(first); // with the automatic radius
  EXPECT_EQ(estimation.getRadiusSearch(), 0);
  EXPECT_LT(test::shareOfBad(first, test::noisyBox(0.003f).normals), 0.1);
  estimation.compute(second);
  expectSame(first, second);
  estimation.setKSearch(60);
  estimation.compute(second);
  EXPECT_LT(test::shareOfBad(second, test::noisyBox(0.003f).normals), 0.1);
}

TEST(HoughNormalEstimation, IndicesAndSearchSurfaceAreRespected)
{
  const auto cloud = test::cloudOf(test::noisyBox(0.003f).points);
  const auto all = estimated(cloud, 0.05);
  HoughEstimation estimation;
  estimation.setInputCloud(cloud);
  estimation.setRadiusSearch(0.05);
  const auto indices = pcl::make_shared<pcl::Indices>(pcl::Indices{7, 3, 900});
  estimation.setIndices(indices);
  Normals some;
  estimation.compute(some);
  ASSERT_EQ(some.size(), 3u);
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(some[i].getNormalVector3fMap(),
              all[(*indices)[i]].getNormalVector3fMap());

  HoughEstimation elsewhere;
  elsewhere.setInputCloud(test::cloudOf({{0.5f, 0.5f, 1.01f}}));
  elsewhere.setSearchSurface(plane({0, 0, 1}));
  elsewhere.setRadiusSearch(0.2);
  elsewhere.compute(some);
  ASSERT_EQ(some.size(), 1u);
  EXPECT_NEAR(some[0].normal_z, -1, 1e-4f);
}

TEST(HoughNormalEstimation, PointsWithoutPlaneAreNaN)
{
  const auto cloud = plane({0, 0, 1});
  cloud->emplace_back(std::nanf(""), 0.0f, 0.0f);
  cloud->emplace_back(50.0f, 0.0f, 0.0f);
  cloud->is_dense = false;
  const auto normals = estimated(cloud, 0.2);
  ASSERT_EQ(normals.size(), cloud->size());
  EXPECT_FALSE(normals.is_dense);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    EXPECT_EQ(std::isnan(normals[i].normal_x), i + 2 >= normals.size()) << i;
    EXPECT_EQ(std::isnan(normals[i].curvature), i + 2 >= normals.size()) << i;
  }
  EXPECT_FALSE(estimated(test::cloudOf({{1, 2, 3}}), 0.2).is_dense);
  const auto equal =
      estimated(test::cloudOf(std::vector<Eigen::Vector3f>(9, {1, 2, 3})), 0);
  ASSERT_EQ(equal.size(), 9u);
  EXPECT_TRUE(std::isnan(equal[0].normal_x));
}

TEST(HoughNormalEstimation, OrganisedCloudsStayOrganised)
{
  const auto cloud = pcl::make_shared<Cloud>(40, 30);
  for (int row = 0; row < 30; ++row)
    for (int column = 0; column < 40; ++column) {
      const float x = 0.02f * static_cast<float>(column - 20);
      const float y = 0.02f * static_cast<float>(row - 15);
      (*cloud)(column, row) = pcl::PointXYZ(x, y, 1);
    }
  (*cloud)(3, 4).x = std::nanf("");
  cloud->is_dense = false;
  const auto normals = estimated(cloud, 0.07);
  EXPECT_EQ(normals.width, 40u);
  EXPECT_EQ(normals.height, 30u);
  EXPECT_TRUE(std::isnan(normals(3, 4).normal_z));
  EXPECT_NEAR(normals(20, 15).normal_z, -1, 1e-5f);
}

TEST(HoughNormalEstimation, NormalsPointToTheViewpoint)
{
  const auto cloud = plane({0, 0, 0});
  cloud->sensor_origin_ = Eigen::Vector4f(0, 0, 3, 0);
  HoughEstimation estimation;
  estimation.setInputCloud(cloud);
  estimation.setRadiusSearch(0.2);
  Normals normals;
  estimation.compute(normals);
  EXPECT_NEAR(normals[0].normal_z, 1, 1e-5f);
  estimation.setViewPoint(0, 0, -1);
  float x, y, z;
  estimation.getViewPoint(x, y, z);
  EXPECT_EQ(z, -1);
  estimation.compute(normals);
  EXPECT_NEAR(normals[0].normal_z, -1, 1e-5f);
  estimation.useSensorOriginAsViewPoint();
  estimation.getViewPoint(x, y, z);
  EXPECT_EQ(z, 3);
}

TEST(HoughNormalEstimation, NormalsTurnAsTheirNeighbours)
{
  const auto box = test::noisyBox(0.003f);
  const auto cloud = test::cloudOf(box.points);
  // Beside the box: the viewpoint alone is wrong for the far sides.
  cloud->sensor_origin_ = Eigen::Vector4f(0.25f, 0.2f, 9, 0);
  HoughEstimation estimation;
  estimation.setInputCloud(cloud);
  estimation.setRadiusSearch(0.06);
  const auto right = [&](NormalOrientation orientation) {
    estimation.setOrientation(orientation);
    EXPECT_EQ(estimation.getOrientation(), orientation);
    Normals normals;
    estimation.compute(normals);
    std::size_t count = 0;
    for (std::size_t i = 0; i < normals.size(); ++i)
      count += normals[i].getNormalVector3fMap().dot(box.normals[i]) > 0;
    return static_cast<double>(count) / static_cast<double>(normals.size());
  };
  // One point in thirty: on an edge, with the normal of the other face.
  EXPECT_GT(right(NormalOrientation::Graph), 0.95);
  EXPECT_LT(right(NormalOrientation::Viewpoint), 0.8);
  // The free space of a box without a room around it is its inside.
  EXPECT_LT(right(NormalOrientation::FreeSpace), 0.1);
}

TEST(HoughNormalEstimation, SettersReachTheOptions)
{
  HoughEstimation estimation(3);
  EXPECT_EQ(estimation.getNumberOfThreads(), 3u);
  estimation.setNumberOfTriples(99);
  estimation.setConfidenceBounds(0.9, 0.2);
  estimation.setBinAngle(10);
  estimation.setNumberOfRotations(2);
  estimation.setChoice(HoughEstimation::Choice::Mean);
  estimation.setSampling(HoughEstimation::Sampling::Points);
  estimation.setRefinement(false);
  estimation.setSeed(8);
  EXPECT_EQ(estimation.getNumberOfTriples(), 99u);
  EXPECT_EQ(estimation.getConfidence(), 0.9);
  EXPECT_EQ(estimation.getDeviation(), 0.2);
  EXPECT_EQ(estimation.getBinAngle(), 10);
  EXPECT_EQ(estimation.getNumberOfRotations(), 2u);
  EXPECT_EQ(estimation.getChoice(), HoughEstimation::Choice::Mean);
  EXPECT_EQ(estimation.getSampling(), HoughEstimation::Sampling::Points);
  EXPECT_FALSE(estimation.getRefinement());
  EXPECT_EQ(estimation.getSeed(), 8u);
  EXPECT_EQ(estimation.getOptions().triples, 99u);
}

TEST(HoughNormalEstimation, WrongUseGivesNothing)
{
  const auto expectNothing = [](auto change) {
    HoughEstimation estimation;
    estimation.setInputCloud(plane({0, 0, 0}));
    estimation.setRadiusSearch(0.2);
    change(estimation);
    Normals normals;
    normals.resize(5);
    estimation.compute(normals);
    EXPECT_TRUE(normals.empty());
  };
  expectNothing([](auto& e) { e.setInputCloud(nullptr); });
  expectNothing([](auto& e) { e.setInputCloud(pcl::make_shared<Cloud>()); });
  expectNothing([](auto& e) { e.setRadiusSearch(-1); });
  expectNothing([](auto& e) { e.setRadiusSearch(std::nan("")); });
  expectNothing([](auto& e) { e.setKSearch(5); }); // both
  expectNothing([](auto& e) {
    e.setRadiusSearch(0);
    e.setKSearch(2);
  });
  expectNothing([](auto& e) { e.setBinAngle(0); });
  for (const float far : {1e20f, -3e38f}) { // a search tree would recurse for ever
    auto cloud = plane({0, 0, 0});
    cloud->emplace_back(0.0f, far, 0.0f);
    expectNothing([&](auto& e) { e.setInputCloud(cloud); });
  }
  expectNothing([](auto& e) {
    e.setIndices(pcl::make_shared<pcl::Indices>(pcl::Indices{100000}));
  });
}

TEST(HoughNormalEstimation, PointsInOnePlaceHaveOneNormal)
{
  const auto cloud = plane({0, 0, 0});
  const std::size_t count = cloud->size();
  for (std::size_t i = 0; i < count; i += 7)
    cloud->push_back((*cloud)[i]);
  const auto normals = estimated(cloud, 0.2);
  for (std::size_t i = 0; i < count; i += 7) {
    EXPECT_EQ(normals[i].getNormalVector3fMap(),
              normals[count + i / 7].getNormalVector3fMap());
    EXPECT_NEAR(std::abs(normals[i].normal_z), 1, 1e-3);
  }
}

TEST(HoughNormalEstimation, PointsTooNearToTellTheirDistancesDoNotSearchEachOther)
{
  // 5,000 places 10^-44 to 10^-41 m apart: 25 million neighbours to sort and to vote
  // with, were each to find all
  const auto cloud = pcl::make_shared<Cloud>();
  for (int i = 0; i < 5000; ++i)
    cloud->emplace_back(1e-44f * static_cast<float>(i % 200),
                        1e-43f * static_cast<float>(i / 200),
                        2.0f);
  const auto normals = estimated(cloud, 0);
  ASSERT_EQ(normals.size(), cloud->size());
  EXPECT_TRUE(std::isnan(normals[0].normal_x));
}

TEST(HoughNormalEstimation, EqualPointsDoNotSearchEachOther)
{
  // two places with 300,000 points each: 10^11 neighbours, were each point to find all
  const auto cloud = pcl::make_shared<Cloud>();
  for (int i = 0; i < 600000; ++i)
    cloud->emplace_back(static_cast<float>(i % 2), 2.0f, 3.0f);
  const auto normals = estimated(cloud, 0);
  ASSERT_EQ(normals.size(), cloud->size());
  EXPECT_TRUE(std::isnan(normals[0].normal_x));
}
