/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "objects/join/direction_hull.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <random>

using namespace pcl::indoor;

namespace {

using Places = std::vector<Eigen::Vector3f>;

const Eigen::Matrix3f upright = Eigen::Matrix3f::Identity();

/** The eight corners of a box around a middle, turned. */
Places
cornersOf(const Eigen::Vector3f& size,
          const Eigen::Vector3f& middle = Eigen::Vector3f::Zero(),
          const Eigen::Matrix3f& rotation = upright)
{
  Places corners;
  for (const float x : {-0.5f, 0.5f})
    for (const float y : {-0.5f, 0.5f})
      for (const float z : {-0.5f, 0.5f})
        corners.emplace_back(middle +
                             rotation * size.cwiseProduct(Eigen::Vector3f(x, y, z)));
  return corners;
}

Eigen::Matrix3f
turn(float degrees, const Eigen::Vector3f& axis)
{
  return Eigen::AngleAxisf(degrees * static_cast<float>(M_PI) / 180, axis.normalized())
      .toRotationMatrix();
}

double
volumeOf(const Places& places)
{
  const DirectionHulls hulls;
  return hulls.volume(hulls.kDopOf(places, 0));
}

/** The directions of the faces, as documented. */
Places
faceNormals()
{
  Places normals;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      for (int z = -2; z <= 2; ++z) {
        const int length = x * x + y * y + z * z;
        if (length == 1 || length == 2 || length == 3 || length == 5)
          normals.push_back(Eigen::Vector3f(x, y, z).normalized());
      }
  return normals;
}

/** Share of the box around the places whose points are below all faces, times the box.
 */
double
volumeBySamples(const Places& places, int samples, std::mt19937& rng)
{
  const auto normals = faceNormals();
  std::vector<float> heights;
  for (const auto& normal : normals) {
    float height = normal.dot(places.front());
    for (const auto& place : places)
      height = std::max(height, normal.dot(place));
    heights.push_back(height);
  }
  Eigen::Vector3f low = places.front(), high = low;
  for (const auto& place : places) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  const auto random = [&] { return static_cast<float>(rng() % 100000) / 100000; };
  int inside = 0;
  for (int i = 0; i < samples; ++i) {
    const Eigen::Vector3f at =
        low + (high - low).cwiseProduct(Eigen::Vector3f(random(), random(), random()));
    bool below = true;
    for (std::size_t n = 0; n < normals.size() && below; ++n)
      below = normals[n].dot(at) <= heights[n];
    inside += below;
  }
  return static_cast<double>((high - low).prod()) * inside / samples;
}

} // namespace

TEST(DirectionHull, BoxesAlongTheAxesAreExact)
{
  EXPECT_NEAR(volumeOf(cornersOf({1, 1, 1})), 1, 1e-6);
  EXPECT_NEAR(volumeOf(cornersOf({2, 0.5f, 0.02f}, {7, -3, 1})), 0.02, 1e-5);
}

TEST(DirectionHull, SolidsWithFacesInItsDirectionsAreExact)
{
  Places octahedron, dodecahedron = cornersOf({2, 2, 2});
  for (int axis = 0; axis < 3; ++axis)
    for (const float sign : {-1.0f, 1.0f}) {
      octahedron.push_back(sign * Eigen::Vector3f::Unit(axis));
      dodecahedron.push_back(2 * octahedron.back());
    }
  EXPECT_NEAR(volumeOf(octahedron), 4.0 / 3, 1e-5);
  EXPECT_NEAR(volumeOf(dodecahedron), 16, 1e-4); // rhombic, faces along edges' normals
  const auto plate = cornersOf({1, 1, 0.02f}, {3, 0, 0}, turn(45, {0, 1, 0}));
  EXPECT_NEAR(volumeOf(plate), 0.02, 1e-5); // few samples of a box would be in it
}

TEST(DirectionHull, AgreesWithSamples)
{
  std::mt19937 rng(5);
  for (int trial = 0; trial < 10; ++trial) {
    const auto random = [&] { return static_cast<float>(rng() % 2001) / 1000 - 1; };
    Places places;
    for (int i = 0; i < 12; ++i)
      places.emplace_back(random(), 0.6f * random(), 0.3f * random());
    // Sampled to a standard deviation of about half a percent
    const double sampled = volumeBySamples(places, 40000, rng);
    EXPECT_NEAR(volumeOf(places), sampled, 0.02 * sampled) << "trial " << trial;
  }
}

TEST(DirectionHull, OtherDirectionsAreOverestimated)
{
  for (const float degrees : {5.0f, 13.0f, 22.0f, 30.0f}) {
    const double volume =
        volumeOf(cornersOf({1, 1, 1}, {0, 0, 0}, turn(degrees, {1, 2, 3})));
    EXPECT_GT(volume, 1);
    EXPECT_LT(volume, 1.67) << degrees << " degrees";
  }
}

TEST(DirectionHull, UnionsAndCommonParts)
{
  const DirectionHulls hulls;
  const auto reach = [&](const Eigen::Vector3f& size, const Eigen::Vector3f& middle) {
    return hulls.kDopOf(cornersOf(size, middle), 0);
  };
  const auto a = reach({1, 1, 1}, {0, 0, 0}), b = reach({1, 1, 1}, {0.75f, 0, 0}),
             apart = reach({1, 1, 1}, {3, 0, 0}),
             inside = reach({0.5f, 0.2f, 0.2f}, {0, 0, 0});
  EXPECT_NEAR(hulls.volume(hullOfBoth(a, b)), 1.75, 1e-5);
  EXPECT_NEAR(hulls.volume(commonHull(a, b)), 0.25, 1e-5);
  EXPECT_DOUBLE_EQ(hulls.volume(commonHull(a, apart)), 0);
  EXPECT_EQ(hullOfBoth(a, inside), a);
  EXPECT_EQ(commonHull(a, inside), inside);
  EXPECT_NEAR(hulls.boxVolume(commonHull(a, b)), 0.25, 1e-5);
  EXPECT_DOUBLE_EQ(hulls.boxVolume(commonHull(a, apart)), 0);
}

TEST(DirectionHull, BoxesGoAroundWhatIsTurned)
{
  const DirectionHulls hulls;
  const auto turned =
      hulls.kDopOf(cornersOf({1, 1, 1}, {4, 5, 6}, turn(45, {0, 0, 1})), 0);
  EXPECT_NEAR(hulls.boxVolume(turned), 2, 1e-4);
  EXPECT_NEAR(hulls.volume(turned), 1, 1e-4);
}

TEST(DirectionHull, FarFromTheOriginOnlyTheFloatsLosePrecision)
{
  EXPECT_NEAR(volumeOf(cornersOf({1, 1, 1}, {1000, -2000, 500})), 1, 2e-3);
}

TEST(DirectionHull, OneOfAHundredIsAnOutlier)
{
  auto places = cornersOf({1, 1, 1});
  places.insert(places.end(), places.begin(), places.begin() + 8);
  places.resize(100, Eigen::Vector3f::Zero());
  places.back() = Eigen::Vector3f(9, 9, 9);
  EXPECT_NEAR(volumeOf(places), 1, 1e-5);
  places.pop_back();
  places.back() = Eigen::Vector3f(9, 9, 9);
  EXPECT_GT(volumeOf(places), 5);
}

TEST(DirectionHull, AMarginGivesOnePlaceAVolume)
{
  const DirectionHulls hulls;
  const Places one{{1, 2, 3}};
  EXPECT_DOUBLE_EQ(hulls.volume(hulls.kDopOf(one, 0)), 0);
  const auto hull = hulls.kDopOf(one, 0.5f);
  EXPECT_GT(hulls.volume(hull), 0.523); // of the ball that its faces touch
  EXPECT_LT(hulls.volume(hull), 0.6);
}
