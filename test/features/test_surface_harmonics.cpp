/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/surface_harmonics.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include "features/harmonics_oracle.h"
#include "features/histogram_bounds.h"
#include "features/oriented_shapes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::indoor {
namespace {

const HarmonicBins default_bins{3, 6, 12};

// Block sums of up to 128 terms in single precision, each within 128 * 2^-24 of the sum
// of magnitudes; a function of degree 6 is at most 13, and the mean magnitude near 1.
// Positions of size 1 and axes are rounded to 2^-24, which the functions' slopes, below
// 100, turn into 1e-5. All relative to a sum of values above 1.
constexpr double rounding = 1e-4;

std::vector<double>
harmonicsOf(const std::vector<OrientedPoint>& points, const HarmonicBins& bins)
{
  return surfaceHarmonics(points, principalFrame(points, 0.5), 1.2, bins);
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

TEST(PrincipalFrame, TheMiddleOfExtentsIsThatOfAnUnevenBox)
{
  // Three of four points of the left half are missing; the axes stay the edges.
  auto points = boxSurface(box_size, 8000, 2);
  std::size_t seen = 0;
  points.erase(std::remove_if(points.begin(),
                              points.end(),
                              [&](const OrientedPoint& point) {
                                return point.position.x() < 0.5f && seen++ % 4 != 0;
                              }),
               points.end());
  const Eigen::Vector3d middle = box_size.cast<double>() / 2;
  const auto frame = principalFrame(points);
  EXPECT_GT((frame.center - middle).norm(), 0.1);
  EXPECT_LT((principalFrame(points, 1.0).center - middle).norm(), 0.03);
  EXPECT_LT((principalFrame(points, 0.5).center -
             (frame.center + principalFrame(points, 1.0).center) / 2)
                .norm(),
            1e-6);
}

TEST(SurfaceHarmonics, EqualTheFormulas)
{
  for (const auto& points :
       {randomSurflets(1000, 1), boxSurface(box_size, 1000, 2), randomSurflets(5, 3)})
    for (const auto& bins : {default_bins,
                             HarmonicBins{2, 4, 40},
                             HarmonicBins{1, 8, 0},
                             HarmonicBins{0, 0, 7}})
      for (const double scale : {0.4, 1.3})
        for (const double middle_share : {0.0, 0.5}) {
          const auto frame = principalFrame(points, middle_share);
          const auto values = surfaceHarmonics(points, frame, scale, bins);
          ASSERT_EQ(values.size(), bins.size());
          EXPECT_NEAR(std::accumulate(values.begin(), values.end(), 0.0), 1.0, 1e-12);
          EXPECT_LT(
              difference(values, slowHarmonics(points, middle_share, scale, bins)),
              rounding);
        }
}

TEST(SurfaceHarmonics, ACenteredBallHasNoneButTheFirst)
{
  // Directions that come in opposite pairs along three axes: the odd functions and
  // those of degree 2 add up to nothing, as they do for a ball.
  std::vector<OrientedPoint> points;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0f, 1.0f}) {
      points.emplace_back();
      points.back().position = side * Eigen::Vector3f::Unit(axis);
      points.back().normal = points.back().position;
    }
  const auto values =
      surfaceHarmonics(points, principalFrame(points), 4.0, HarmonicBins{1, 3, 0});
  // 1 in the first bin of all surface and a third in those of each axis, which face
  // the directions along it only: there Y_20 and Y_22 remain.
  const double unit = values[3 * 16] / 1.002;
  EXPECT_NEAR(values[0] / unit, 1.0 / 3 + 0.002, 1e-5);
  for (int bin = 1; bin < 16; ++bin)
    EXPECT_NEAR(values[3 * 16 + bin] / unit, 0.002, 1e-5);
  EXPECT_NEAR(values[2 * 16 + 6] / unit, std::sqrt(5.0) / 3 + 0.002, 1e-5);
}

TEST(SurfaceHarmonics, OddFunctionsTellWhatIsNotSymmetric)
{
  // In the right half what lies low is lifted to the other side: as much along each
  // axis, but no longer the same in all eight octants.
  const auto box = boxSurface(box_size, 4000, 5);
  auto uneven = box;
  for (auto& point : uneven)
    if (point.position.x() > 0.5f && point.position.z() < 0.15f)
      point.position.z() = 0.3f - point.position.z();
  const HarmonicBins bins{1, 3, 0};
  const int xz = 4 + 2 + 1; // l = 2, m = 1: odd in the longest and the shortest axis
  const auto of_box = harmonicsOf(box, bins);
  const auto of_uneven = harmonicsOf(uneven, bins);
  EXPECT_GT(of_uneven[3 * 16 + xz], 4 * of_box[3 * 16 + xz]);
}

TEST(SurfaceHarmonics, TurningMirroringAndSidesChangeOnlyRounding)
{
  const auto points = boxSurface(box_size, 2000, 4);
  const auto values = harmonicsOf(points, default_bins);
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
  EXPECT_LT(difference(values, harmonicsOf(turned, default_bins)), 2 * rounding);
}

TEST(SurfaceHarmonics, ThreadsChangeNoBit)
{
  const auto points = boxSurface(box_size, 5000, 5);
  const auto frame = principalFrame(points, 0.5);
  const auto values = surfaceHarmonics(points, frame, 1.2, default_bins);
  for (const unsigned int threads : {2u, 3u, 8u, 0u})
    EXPECT_EQ(values, surfaceHarmonics(points, frame, 1.2, default_bins, threads));
}

TEST(SurfaceHarmonics, TellShapesApart)
{
  const auto values = harmonicsOf(boxSurface(box_size, 3000, 6), default_bins);
  const double own =
      difference(values, harmonicsOf(boxSurface(box_size, 3000, 7), default_bins));
  const double noisy =
      difference(values, harmonicsOf(noisyBox(box_size, 0.05f, 3000, 7), default_bins));
  const double other = difference(
      values, harmonicsOf(boxSurface({1.0f, 0.4f, 0.4f}, 3000, 6), default_bins));
  EXPECT_LT(2 * own, other);
  EXPECT_LT(noisy, other);
}

} // namespace
} // namespace pcl::indoor
