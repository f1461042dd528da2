/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// What changes of the cloud do to the points that filters keep, over random scenes: of
// ScanOutlierRemoval and of NonConvexPointsRemoval.
#include "support/cloud_changes.h"
#include "support/labelled_cloud.h"

#include <pcl/filters/non_convex_points_removal.h>
#include <pcl/filters/scan_outlier_removal.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <numeric>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

constexpr unsigned trials = 5;
using Kept = std::vector<std::uint8_t>; ///< 1 for a point that is kept

/** Points with normals and curvatures. */
struct Scene {
  std::vector<Eigen::Vector3f> points, normals;
  std::vector<float> curvatures;

  Scene
  inOrder(const std::vector<std::size_t>& order) const
  {
    return {test::inOrder(points, order),
            test::inOrder(normals, order),
            test::inOrder(curvatures, order)};
  }
};

/** A floor and a wall, a box before them, points in the air, and rows of points in all
 * directions that get sparser: how far apart is too far must not depend on the
 * direction. */
Scene
randomScene(unsigned seed)
{
  std::mt19937 rng(seed);
  LabelledPoints made;
  made.addRectangle(
      {0, 0, 0}, {1.5f, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1, 0.03f, 0.004f, rng);
  made.addRectangle(
      {0, 1, 0}, {1.5f, 0, 0}, {0, 0, 1}, {0, -1, 0}, 2, 0.03f, 0.004f, rng);
  made.addBox({drawn(0.2f, 0.8f, rng), 0.3f, 0},
              {drawn(0.2f, 0.5f, rng), 0.4f, drawn(0.2f, 0.5f, rng)},
              3,
              0.03f,
              0.004f,
              rng);
  Scene scene{made.points, made.normals, {}};
  for (int i = 0; i < 30; ++i) {
    scene.points.emplace_back(
        drawn(-1, 3, rng), drawn(-3, 1, rng), drawn(0.1f, 3, rng));
    scene.normals.push_back(Eigen::Vector3f::UnitX());
  }
  for (int row = 0; row < 10; ++row) {
    const float angle = drawn(0, 6.28f, rng);
    Eigen::Vector3f point(0, 0, 4 + static_cast<float>(row));
    for (float step = 0.03f; step < 0.6f; step *= 1.1f) {
      scene.points.push_back(point);
      scene.normals.push_back(Eigen::Vector3f::UnitX());
      point += step * Eigen::Vector3f(std::cos(angle), std::sin(angle), 0);
    }
  }
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    scene.curvatures.push_back(drawn(0, 0.2f, rng));
  return scene;
}

/** One of the two filters. */
struct Outliers {
  pcl::ScanOutlierRemoval<pcl::PointXYZ> filter;

  void
  set(const Scene& /*scene*/)
  {}
};

struct NonConvex {
  pcl::NonConvexPointsRemoval<pcl::PointXYZ, pcl::Normal> filter;

  void
  set(const Scene& scene)
  {
    const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
    for (std::size_t i = 0; i < scene.normals.size(); ++i) {
      const auto& n = scene.normals[i];
      normals->emplace_back(n.x(), n.y(), n.z(), scene.curvatures[i]);
    }
    filter.setInputNormals(normals);
  }
};

template <typename Removal>
Kept
keptBy(Removal& removal, const Scene& scene)
{
  const auto cloud = cloudOf(scene.points);
  cloud->is_dense = false;
  removal.filter.setInputCloud(cloud);
  removal.set(scene);
  pcl::Indices indices;
  removal.filter.filter(indices);
  Kept kept(scene.points.size(), 0);
  for (const auto index : indices)
    kept[static_cast<std::size_t>(index)] = 1;
  return kept;
}

template <typename Removal>
class FilterProperties : public testing::Test {
protected:
  static Kept
  kept(const Scene& scene)
  {
    Removal removal;
    const auto result = keptBy(removal, scene);
    const auto count = std::accumulate(result.begin(), result.end(), std::size_t{0});
    EXPECT_GT(count, result.size() / 5);
    EXPECT_LT(count, result.size());
    return result;
  }
};

using Removals = testing::Types<Outliers, NonConvex>;

} // namespace

TYPED_TEST_SUITE(FilterProperties, Removals);

TYPED_TEST(FilterProperties, AnyNumberOfThreadsKeepsTheSamePoints)
{
  for (unsigned seed = 0; seed < trials; ++seed) {
    const auto scene = randomScene(seed);
    TypeParam removal;
    removal.filter.setNumberOfThreads(1);
    const auto one = keptBy(removal, scene);
    for (const unsigned threads : {2u, 7u}) {
      removal.filter.setNumberOfThreads(threads);
      EXPECT_EQ(keptBy(removal, scene), one) << seed << ", " << threads << " threads";
    }
  }
}

TYPED_TEST(FilterProperties, AnotherOrderOfPointsKeepsTheSamePoints)
{
  for (unsigned seed = 0; seed < trials; ++seed) {
    const auto scene = randomScene(seed);
    std::mt19937 rng(seed);
    const auto order = shuffledOrder(scene.points.size(), rng);
    EXPECT_EQ(this->kept(scene.inOrder(order)), inOrder(this->kept(scene), order))
        << seed;
  }
}

TYPED_TEST(FilterProperties, CopiesOfAPointShareItsFate)
{
  for (unsigned seed = 0; seed < trials; ++seed) {
    auto scene = randomScene(seed);
    const auto order = withCopies(scene.points.size());
    const auto kept = this->kept(scene.inOrder(order));
    for (std::size_t k = scene.points.size(); k < order.size(); ++k)
      ASSERT_EQ(kept[k], kept[order[k]]) << seed;
  }
}

TYPED_TEST(FilterProperties, BadPointsAreDroppedAndChangeNoOther)
{
  for (unsigned seed = 0; seed < trials; ++seed) {
    const auto scene = randomScene(seed);
    std::mt19937 rng(seed);
    std::vector<std::size_t> places;
    Scene with_bad{withBadPoints(scene.points, rng, places), {}, {}};
    with_bad.normals.resize(with_bad.points.size(), Eigen::Vector3f::UnitZ());
    with_bad.curvatures.resize(with_bad.points.size(), 0.1f);
    for (std::size_t i = 0; i < places.size(); ++i) {
      with_bad.normals[places[i]] = scene.normals[i];
      with_bad.curvatures[places[i]] = scene.curvatures[i];
    }
    Kept expected(with_bad.points.size(), 0);
    const auto alone = this->kept(scene);
    for (std::size_t i = 0; i < places.size(); ++i)
      expected[places[i]] = alone[i];
    TypeParam removal;
    EXPECT_EQ(keptBy(removal, with_bad), expected) << seed;
  }
}

TYPED_TEST(FilterProperties, IndicesAreTheirPointsAlone)
{
  for (unsigned seed = 0; seed < trials; ++seed) {
    const auto scene = randomScene(seed);
    std::mt19937 rng(seed);
    const auto subset = randomSubset(scene.points.size(), rng);
    TypeParam removal;
    removal.filter.setIndices(
        pcl::make_shared<pcl::Indices>(subset.begin(), subset.end()));
    EXPECT_EQ(keptBy(removal, scene),
              backFrom(this->kept(scene.inOrder(subset)), subset, scene.points.size()))
        << seed;
  }
}

TYPED_TEST(FilterProperties, ShiftsThatFloatsHoldKeepTheSamePoints)
{
  for (unsigned seed = 0; seed < trials; ++seed) {
    auto scene = randomScene(seed);
    scene.points = onRaster(scene.points);
    auto far = scene;
    far.points = shifted(scene.points, {16384, -8192, 512});
    EXPECT_EQ(this->kept(far), this->kept(scene)) << seed;
  }
}

TYPED_TEST(FilterProperties, UtmCoordinatesAsFloatsAreTheirPointsNearTheOrigin)
{
  for (unsigned seed = 0; seed < trials; ++seed) {
    auto near = randomScene(seed);
    for (auto& point : near.points)
      point *= 10; // several of the steps of UTM coordinates
    const UtmPoints utm(near.points);
    near.points = utm.near;
    auto far = near;
    far.points = utm.far;
    EXPECT_EQ(this->kept(far), this->kept(near)) << seed;
  }
}

TYPED_TEST(FilterProperties, TurnedAboutTheVerticalItKeepsTheSamePoints)
{
  for (unsigned seed = 0; seed < trials; ++seed) {
    const auto scene = randomScene(seed);
    const auto kept = this->kept(scene);
    for (const float radians : {0.2f, 1.5707963f, 4.0f}) {
      const Eigen::Matrix3f turn =
          Eigen::AngleAxisf(radians, Eigen::Vector3f::UnitZ()).toRotationMatrix();
      auto turned = scene;
      for (auto& point : turned.points)
        point = turn * point;
      for (auto& normal : turned.normals)
        normal = turn * normal;
      const auto other = this->kept(turned);
      // where a distance or a height is at its limit to the last bit
      std::size_t different = 0;
      for (std::size_t i = 0; i < kept.size(); ++i)
        different += kept[i] != other[i];
      EXPECT_LE(different, kept.size() / 1000) << seed << ", " << radians;
    }
  }
}
