/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "pictures/cloud_picture.h"
#include "pictures/comparison_picture.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::indoor::tool;

namespace {

using Points = std::vector<Eigen::Vector3f>;

/** A square at a depth, facing the camera at the origin. */
Points
square(float half_edge, float depth)
{
  Points points;
  for (int i = -20; i <= 20; ++i)
    for (int j = -20; j <= 20; ++j)
      points.emplace_back(half_edge * static_cast<float>(i) / 20,
                          half_edge * static_cast<float>(j) / 20,
                          depth);
  return points;
}

bool
hasColor(const PixelImage& picture, Color color)
{
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const auto pixel = picture.at(x, y);
      if (pixel.red == color.red && pixel.green == color.green &&
          pixel.blue == color.blue)
        return true;
    }
  return false;
}

} // namespace

TEST(CloudView, NearPointsHideFarOnes)
{
  auto points = square(0.5f, 1);
  const auto near_count = points.size();
  for (const auto& point : square(1, 2)) // covers the same pixels
    points.push_back(point);
  points.emplace_back(std::nanf(""), 0.0f, 1.0f);
  std::vector<std::uint32_t> labels(points.size(), 7);
  std::fill_n(labels.begin(), near_count, 3);
  const Points normals(points.size(), Eigen::Vector3f::Zero());
  const auto view = CloudView::fromCamera(points, normals, 60, 60);
  const auto picture = view.draw(labels);
  EXPECT_TRUE(hasColor(picture, labelColor(3)));
  EXPECT_FALSE(hasColor(picture, labelColor(7)));
  EXPECT_GT(view.coveredPixels(), 50u * 50u);
}

TEST(CloudView, ARoomIsSeenFromAboveThroughItsCeiling)
{
  Points points, normals;
  std::vector<std::uint32_t> labels;
  for (const auto& point : square(2, 0)) { // the floor
    points.push_back(point);
    normals.emplace_back(0.0f, 0.0f, 1.0f);
    labels.push_back(1);
  }
  for (const auto& point : square(2, 2.5f)) { // the ceiling
    points.push_back(point);
    normals.emplace_back(0.0f, 0.0f, -1.0f);
    labels.push_back(2);
  }
  const auto view = CloudView::fromAbove(points, normals, 80, 60);
  std::vector<std::uint32_t> floor_only = labels;
  const auto picture = view.draw(labels);
  std::fill(floor_only.begin(), floor_only.end(), 1);
  const auto expected = view.draw(floor_only);
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 80; ++x)
      EXPECT_EQ(picture.at(x, y).green, expected.at(x, y).green) << x << " " << y;
  EXPECT_GT(view.coveredPixels(), 1000u);
  // Without normals, the ceiling is in the way.
  const Points none(points.size(), Eigen::Vector3f::Zero());
  const auto covered = CloudView::fromAbove(points, none, 80, 60);
  EXPECT_TRUE(hasColor(covered.draw(labels), labelColor(2)));
  EXPECT_EQ(CloudView::fromAbove({}, {}, 80, 60).coveredPixels(), 0u);
}

TEST(NamedAsTruth, TheBestSegmentGetsTheName)
{
  const std::vector<std::uint32_t> truth{1, 1, 1, 2, 2, 0, 5, 5};
  const std::vector<std::uint32_t> predicted{9, 9, 4, 8, 8, 8, 8, 0};
  // 9 covers most of 1; 8 covers two points of 2 and one of 5; 4 is left over.
  EXPECT_EQ(namedAsTruth(truth, predicted),
            (std::vector<std::uint32_t>{1, 1, 6, 2, 2, 2, 2, 0}));
  EXPECT_EQ(namedAsTruth(truth, truth), truth);
  EXPECT_TRUE(namedAsTruth({}, {}).empty());
}

TEST(ComparisonPicture, OneTilePerView)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (const auto& point : square(0.5f, 1))
    cloud.emplace_back(point.x(), point.y(), point.z());
  const std::vector<std::uint32_t> truth(cloud.size(), 3), other(cloud.size(), 8);
  const auto one = drawSideBySide(cloud, true, {{"Truth", truth}});
  const auto two = drawSideBySide(cloud, true, {{"Truth", truth}, {"Ours", other}});
  EXPECT_GT(two.width(), 2 * one.width());
  EXPECT_EQ(two.height(), one.height());
  // the other one has the true segment's colour: both tiles are the same
  const auto text = two.str();
  const auto tile = [&](std::size_t from) {
    const auto begin = text.find("base64,", from);
    return text.substr(begin, text.find('"', begin) - begin);
  };
  EXPECT_EQ(tile(0), tile(text.find(">Truth<")));
  EXPECT_GT(tile(0).size(), 100u);
}
