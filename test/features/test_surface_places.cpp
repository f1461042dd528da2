/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/surface_places.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include "features/eppf_oracle.h"
#include "features/oriented_shapes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl {
namespace indoor {
namespace {

const Eigen::Vector3f box_size(1.0f, 0.6f, 0.3f);
const PlaceBins default_bins{5, 5, 4};

double
difference(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0;
  for (std::size_t bin = 0; bin < a.size(); ++bin)
    sum += std::abs(a[bin] - b[bin]);
  return sum;
}

// Every point is 24 parts, each rounded by half of 2^-16; single precision moves the
// rest by less. Of a point at a border between inward and outward, or whose normal is
// as good as across its offset from the middle, all may go to the other side: some of
// a thousand.
double
roundingBound(std::size_t point_count)
{
  return 24 * 0.5 / 65536 + 1e-5 + 2 * 3.0 / static_cast<double>(point_count);
}

TEST(PrincipalFrame, OfABoxAreItsEdges)
{
  const auto points = boxSurface({0.3f, 1.0f, 0.6f}, 5000, 1);
  const auto frame = principalFrame(points);
  // The mean of 5,000 points that deviate by at most half a metre: 0.5 / sqrt(5000).
  EXPECT_LT((frame.center - Eigen::Vector3d(0.15, 0.5, 0.3)).norm(), 5 * 0.007);
  const int longest_first[] = {1, 2, 0};
  for (int k = 0; k < 3; ++k)
    EXPECT_GT(std::abs(frame.axes(k, longest_first[k])), 0.99);
  EXPECT_NEAR(
      (frame.axes * frame.axes.transpose() - Eigen::Matrix3d::Identity()).norm(),
      0.0,
      1e-12);
}

TEST(SurfacePlaces, EqualTheFormulas)
{
  for (const auto& points :
       {randomSurflets(1000, 1), boxSurface(box_size, 1000, 2), randomSurflets(3, 3)})
    for (const auto& bins : {default_bins, PlaceBins{1, 7, 2}, PlaceBins{3, 1, 1}})
      for (const double scale : {0.4, 1.3}) {
        const auto places = surfacePlaces(points, scale, bins);
        ASSERT_EQ(places.size(), bins.size());
        EXPECT_NEAR(std::accumulate(places.begin(), places.end(), 0.0), 1.0, 1e-12);
        EXPECT_LT(difference(places, slowPlaces(points, scale, bins)),
                  roundingBound(points.size()));
      }
}

TEST(SurfacePlaces, OnePointOfARod)
{
  // A rod along y: the end counts in the last bin, the normal's squares go to its axes.
  std::vector<OrientedPoint> points(2);
  points[0] = {{0.0f, -1.0f, 0.0f}, {0.0f, -0.6f, 0.8f}};
  points[1] = {{0.0f, 1.0f, 0.0f}, {0.0f, 0.6f, 0.8f}};
  const auto places = surfacePlaces(points, 2.0, {4, 1, 1});
  EXPECT_NEAR(places[3 * 6], 0.36, 1e-4); // outward along the rod
  double across = 0.0;
  for (int direction = 2; direction < 6; ++direction)
    across += places[3 * 6 + direction];
  EXPECT_NEAR(across, 0.64, 1e-4);
  // At a fifth of the half scale, 0.8 bins: 0.7 in the first, 0.3 in the second.
  const auto shared = surfacePlaces(points, 10.0, {4, 1, 1});
  EXPECT_NEAR(shared[0], 0.7 * 0.36, 1e-4);
  EXPECT_NEAR(shared[6], 0.3 * 0.36, 1e-4);
}

TEST(SurfacePlaces, InwardIsTowardsTheMiddleOfItsAxis)
{
  // Two plates face each other, left and right of the middle of a long rod: turned away
  // from the centre, the normals of their far ends lean back along the rod.
  std::vector<OrientedPoint> points(4);
  points[0] = {{-2.0f, 0.0f, 1.0f}, {0.6f, 0.0f, 0.8f}};
  points[1] = {{2.0f, 0.0f, 1.0f}, {-0.6f, 0.0f, 0.8f}};
  points[2] = {{-2.0f, 0.0f, -1.0f}, {0.6f, 0.0f, -0.8f}};
  points[3] = {{2.0f, 0.0f, -1.0f}, {-0.6f, 0.0f, -0.8f}};
  const auto places = surfacePlaces(points, 4.0, {1, 1, 1});
  // Away from the centre is -0.6 * -2 - 0.8 < 0 along the rod: (0.6, 0, -0.8) for the
  // second point, outward along the rod and inward across it.
  EXPECT_NEAR(places[0], 0.36, 1e-4);
  EXPECT_NEAR(places[1], 0.0, 1e-4);
  EXPECT_NEAR(places[2] + places[4], 0.0, 1e-4);
  EXPECT_NEAR(places[3] + places[5], 0.64, 1e-4);
}

TEST(SurfacePlaces, TurningMirroringAndSidesChangeOnlyRounding)
{
  const auto points = boxSurface(box_size, 2000, 4);
  const auto places = surfacePlaces(points, 1.2, default_bins);
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(1.1f, Eigen::Vector3f(1.0f, 2.0f, 3.0f).normalized())
          .toRotationMatrix();
  auto turned = points;
  for (std::size_t k = 0; k < turned.size(); ++k) {
    turned[k].position = turn * turned[k].position + Eigen::Vector3f(3.0f, 1.0f, 2.0f);
    turned[k].normal = turn * turned[k].normal * (k % 3 == 0 ? -1.0f : 1.0f);
    turned[k].position.x() *= -1.0f;
    turned[k].normal.x() *= -1.0f;
  }
  std::reverse(turned.begin(), turned.end());
  // Positions of size 4 are rounded to 2.4e-7, the axes by a few times as much.
  EXPECT_LT(difference(places, surfacePlaces(turned, 1.2, default_bins)),
            roundingBound(points.size()) + 1e-4);
}

TEST(SurfacePlaces, ThreadsChangeNoBit)
{
  const auto points = boxSurface(box_size, 5000, 5);
  const auto places = surfacePlaces(points, 1.2, default_bins);
  for (const unsigned int threads : {2u, 3u, 8u, 0u})
    EXPECT_EQ(places, surfacePlaces(points, 1.2, default_bins, threads));
}

TEST(SurfacePlaces, TellShapesApart)
{
  const auto places = surfacePlaces(boxSurface(box_size, 3000, 6), 1.2, default_bins);
  const double own = difference(
      places, surfacePlaces(boxSurface(box_size, 3000, 7), 1.2, default_bins));
  const double noisy = difference(
      places, surfacePlaces(noisyBox(box_size, 0.05f, 3000, 7), 1.2, default_bins));
  const double other = difference(
      places,
      surfacePlaces(boxSurface({1.0f, 0.4f, 0.4f}, 3000, 6), 1.2, default_bins));
  EXPECT_LT(2 * own, other);
  EXPECT_LT(noisy, other);
}

} // namespace
} // namespace indoor
} // namespace pcl
