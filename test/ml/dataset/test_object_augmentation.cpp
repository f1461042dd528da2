/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/object_augmentation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;
using pcl::PointCloud;
using pcl::PointNormal;

namespace {

const ObjectAugmentation nothing;

/** Points of an upright ellipsoid of half axes 1, 2, 3 with outward normals. */
PointCloud<PointNormal>
ellipsoid(int count = 1000)
{
  PointCloud<PointNormal> points;
  for (int k = 0; k < count; ++k) { // a spiral of equal steps in height
    const double height = (2.0 * k + 1.0) / count - 1.0;
    const double radius = std::sqrt(1.0 - height * height);
    const Eigen::Vector3f sphere(static_cast<float>(radius * std::cos(2.399963 * k)),
                                 static_cast<float>(radius * std::sin(2.399963 * k)),
                                 static_cast<float>(height));
    const Eigen::Array3f axes(1, 2, 3);
    PointNormal point;
    point.getVector3fMap() = (sphere.array() * axes).matrix();
    point.getNormalVector3fMap() = (sphere.array() / axes).matrix().normalized();
    points.push_back(point);
  }
  return points;
}

std::vector<std::vector<float>>
drawsOfEllipsoid(const ObjectAugmentation& augmentation, std::uint32_t seed)
{
  DrawOptions options;
  options.input.pair_count = 500;
  options.augmentation = augmentation;
  options.draw_count = 5;
  options.seed = seed;
  return drawsOf(ellipsoid(300), {}, options, 7);
}

} // namespace

TEST(ObjectAugmentation, TurnsAboutTheVerticalOnly)
{
  const auto object = ellipsoid();
  const auto turned = augmentedObject(object, nothing, 10, 5);
  ASSERT_EQ(turned.size(), object.size());
  double moved = 0.0;
  for (std::size_t k = 0; k < object.size(); ++k) {
    EXPECT_FLOAT_EQ(turned[k].z, object[k].z);
    EXPECT_NEAR(std::hypot(turned[k].x, turned[k].y),
                std::hypot(object[k].x, object[k].y),
                1e-5);
    moved += (turned[k].getVector3fMap() - object[k].getVector3fMap()).norm();
    EXPECT_NEAR(turned[k].getNormalVector3fMap().dot(turned[k].getVector3fMap()),
                object[k].getNormalVector3fMap().dot(object[k].getVector3fMap()),
                1e-5);
  }
  EXPECT_GT(moved, 1.0);
}

TEST(ObjectAugmentation, StretchedNormalsStayUprightOnTheSurface)
{
  auto augmentation = nothing;
  augmentation.stretched_share = 1.0;
  augmentation.stretch_percent = 40.0;
  PointCloud<PointNormal> object; // a tilted plate
  for (int k = 0; k < 100; ++k) {
    PointNormal point;
    point.x = static_cast<float>(k % 10);
    point.y = static_cast<float>(k / 10);
    point.z = 0.5f * point.x - 2.0f * point.y + 3.0f;
    point.getNormalVector3fMap() = Eigen::Vector3f(-0.5f, 2.0f, 1.0f).normalized();
    object.push_back(point);
  }
  const auto stretched = augmentedObject(object, augmentation, 10, 6);
  for (const auto& point : stretched) {
    const auto normal = point.getNormalVector3fMap();
    EXPECT_NEAR(normal.norm(), 1.0, 1e-5);
    EXPECT_NEAR(
        normal.dot(point.getVector3fMap() - stretched[0].getVector3fMap()), 0.0, 1e-4);
  }
  const float factor = stretched[0].z / object[0].z;
  EXPECT_GT(std::abs(factor - 1.0f), 0.001f);
  EXPECT_LE(std::abs(factor - 1.0f), 0.4f);
}

TEST(ObjectAugmentation, LeavesOutPointsUpToTheMost)
{
  const auto object = ellipsoid();
  for (const bool hidden : {false, true}) {
    auto augmentation = nothing;
    (hidden ? augmentation.hidden_share : augmentation.thinned_share) = 1.0;
    (hidden ? augmentation.hidden_percent : augmentation.thinned_percent) = 60.0;
    double mean = 0.0;
    constexpr int draws = 200;
    for (std::uint32_t seed = 1; seed <= draws; ++seed) {
      const auto size = augmentedObject(object, augmentation, 10, seed).size();
      EXPECT_GE(size, 400u);
      mean += static_cast<double>(size) / draws;
    }
    EXPECT_NEAR(mean, 700.0, 50.0); // four deviations of the mean: 600 / sqrt(12 * 200)
  }
}

TEST(ObjectAugmentation, ChangesItsShareOfTheDraws)
{
  auto augmentation = nothing;
  augmentation.noisy_share = 0.3;
  augmentation.noise_percent = 5.0;
  const auto object = ellipsoid(100);
  int changed = 0;
  constexpr int draws = 400;
  for (std::uint32_t seed = 1; seed <= draws; ++seed)
    changed += std::abs(augmentedObject(object, augmentation, 10, seed)[50].z -
                        object[50].z) > 1e-6f;
  EXPECT_NEAR(changed, 0.3 * draws, 4 * std::sqrt(0.21 * draws));
}

TEST(ObjectAugmentation, DrawsDifferAndComeAgainWithTheirSeed)
{
  const auto draws = drawsOfEllipsoid(scanAugmentation(), 1);
  ASSERT_EQ(draws.size(), 5u);
  EXPECT_EQ(std::set<std::vector<float>>(draws.begin(), draws.end()).size(), 5u);
  EXPECT_EQ(drawsOfEllipsoid(scanAugmentation(), 1), draws);
  const auto others = drawsOfEllipsoid(scanAugmentation(), 2);
  for (std::size_t k = 0; k < draws.size(); ++k)
    EXPECT_NE(others[k], draws[k]);
  EXPECT_EQ(drawsOfEllipsoid(nothing, 1)[0], draws[0]); // the object as it is
}

TEST(ObjectAugmentation, EveryDrawIsDisturbed)
{
  PointCloud<PointNormal> sphere;
  for (const auto& point : ellipsoid()) {
    sphere.push_back(point);
    sphere.back().getVector3fMap() =
        (point.getArray3fMap() / Eigen::Array3f(1, 2, 3)).matrix();
  }
  DrawOptions options;
  options.input.kind = ClassifierInputKind::Points;
  options.input.point_count = 1000;
  options.augmentation = nothing;
  options.draw_count = 4;
  for (const double percent : {0.0, 2.0, 4.0}) { // of an extent of 2
    options.disturbance.noise_percent = percent;
    const auto draws = drawsOf(sphere, {}, options, 3);
    ASSERT_EQ(draws.size(), 4u);
    for (const auto& draw : draws) {
      double sum = 0.0, squares = 0.0;
      for (std::size_t k = 0; k < 1000; ++k) {
        const double radius =
            Eigen::Vector3f(draw[k], draw[1000 + k], draw[2000 + k]).norm();
        sum += radius / 1000.0;
        squares += radius * radius / 1000.0;
      }
      const double deviation = std::sqrt(std::max(squares / (sum * sum) - 1.0, 0.0));
      EXPECT_NEAR(deviation, 2.0 * percent / 100.0, 0.002 + 0.15 * percent / 100.0);
    }
  }
}

TEST(ObjectAugmentation, FirstDrawIsTheObjectButForTheDisturbance)
{
  const auto object = ellipsoid(300);
  DrawOptions options;
  options.input.pair_count = 500;
  options.draw_count = 1;
  const auto same = firstDrawnObject(object, options, 7);
  ASSERT_EQ(same.size(), object.size());
  for (std::size_t k = 0; k < object.size(); ++k)
    EXPECT_EQ(same[k].getVector3fMap(), object[k].getVector3fMap());
  const auto undisturbed = drawsOf(object, {}, options, 7);
  options.disturbance.hidden_percent = 50.0;
  EXPECT_EQ(firstDrawnObject(object, options, 7).size(), 150u);
  EXPECT_NE(drawsOf(object, {}, options, 7), undisturbed);
  const auto other = firstDrawnObject(object, options, 8); // seen from elsewhere
  EXPECT_NE(other[0].getVector3fMap(),
            firstDrawnObject(object, options, 7)[0].getVector3fMap());
  options.disturbance.hidden_percent = 0.0;
  options.disturbance.noise_percent = 3.0;
  const auto noisy = firstDrawnObject(object, options, 7);
  EXPECT_NE(noisy[0].getVector3fMap(), object[0].getVector3fMap());
  EXPECT_NE(noisy[0].getNormalVector3fMap(), object[0].getNormalVector3fMap());
  options.input.kind = ClassifierInputKind::Points; // which sees no normals
  EXPECT_EQ(firstDrawnObject(object, options, 7)[0].getNormalVector3fMap(),
            object[0].getNormalVector3fMap());
}

TEST(ObjectAugmentation, ObjectsThatCannotBeDescribedHaveNoDraws)
{
  PointCloud<PointNormal> twice;
  twice.push_back(ellipsoid(1)[0]);
  twice.push_back(twice[0]);
  EXPECT_TRUE(drawsOf(twice, {}, {}, 0).empty());
  EXPECT_TRUE(drawsOf({}, {}, {}, 0).empty());
}

TEST(ObjectAugmentation, TakesTheObjectAsItIsWhereTooLittleIsLeft)
{
  DrawOptions options;
  options.draw_count = 20;
  options.input.pair_count = 100;
  options.augmentation = nothing;
  options.augmentation.thinned_share = 1.0;
  options.augmentation.thinned_percent = 99.0;
  const auto draws = drawsOf(ellipsoid(3), {}, options, 0);
  ASSERT_EQ(draws.size(), 20u);
  for (const auto& draw : draws)
    for (const float value : draw)
      ASSERT_TRUE(std::isfinite(value));
}
