/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/exceptions.h>
#include <pcl/indoor/point_cells.h>

#include <gtest/gtest.h>

#include <random>

using namespace pcl::indoor;

namespace {

std::vector<Eigen::Vector3f>
randomPoints(std::size_t count, float extent, std::mt19937& rng)
{
  const auto coordinate = [&] {
    return extent * static_cast<float>(rng() % 100000) / 100000;
  };
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = coordinate(), y = coordinate(), z = coordinate();
    points.emplace_back(x, y, z);
  }
  return points;
}

} // namespace

TEST(PointCells, PointsAreInTheirCells)
{
  std::mt19937 rng(1);
  for (int trial = 0; trial < 20; ++trial) {
    const auto points = randomPoints(200, 1, rng);
    const double size = 0.13;
    const auto cells = groupByCell(points, size);
    Eigen::Vector3f lower = points[0];
    for (const auto& point : points)
      lower = lower.cwiseMin(point);
    ASSERT_EQ(cells.cell_of_point.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d offset = points[i].cast<double>() - lower.cast<double>();
      EXPECT_EQ(cellIndex(cells.keys[cells.cell_of_point[i]]),
                Eigen::Vector3i((offset / size).array().floor().cast<int>()));
    }
    std::size_t listed = 0;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      EXPECT_LT(cells.offsets[c], cells.offsets[c + 1]) << "cells hold points";
      EXPECT_TRUE(c == 0 || cells.keys[c - 1] < cells.keys[c]);
      EXPECT_EQ(cells.pointsOf(c).size(), cells.offsets[c + 1] - cells.offsets[c]);
      for (const auto point : cells.pointsOf(c)) {
        EXPECT_EQ(cells.cell_of_point[point], c);
        ++listed;
      }
    }
    EXPECT_EQ(listed, points.size());
  }
}

TEST(PointCells, NeighborsAreThoseOfBruteForce)
{
  std::mt19937 rng(2);
  for (int trial = 0; trial < 20; ++trial) {
    const auto cells = groupByCell(randomPoints(150, 1, rng), 0.15);
    const auto adjacency = cellAdjacency(cells.keys);
    for (std::size_t a = 0; a < cells.size(); ++a) {
      std::vector<std::uint32_t> expected;
      for (std::uint32_t b = 0; b < cells.size(); ++b) {
        const Eigen::Vector3i way = cellIndex(cells.keys[a]) - cellIndex(cells.keys[b]);
        if (a != b && way.cwiseAbs().maxCoeff() <= 1)
          expected.push_back(b);
      }
      const auto found = adjacency.of(a);
      EXPECT_EQ(std::vector<std::uint32_t>(found.begin(), found.end()), expected);
    }
  }
}

TEST(PointCells, EmptyAndSingle)
{
  EXPECT_EQ(groupByCell({}, 0.1).size(), 0u);
  EXPECT_EQ(cellAdjacency({}).offsets, std::vector<std::uint32_t>{0});
  const auto one = groupByCell({{5, 5, 5}, {5, 5, 5}}, 0.1);
  EXPECT_EQ(one.size(), 1u);
  EXPECT_EQ(one.points.size(), 2u);
}

TEST(PointCells, RejectsCellsThatAreNotPositiveOrTooSmall)
{
  const std::vector<Eigen::Vector3f> points{{0, 0, 0}, {1000, 0, 0}};
  EXPECT_THROW(groupByCell(points, 0), pcl::BadArgumentException);
  EXPECT_THROW(groupByCell(points, std::nan("")), pcl::BadArgumentException);
  EXPECT_THROW(groupByCell(points, 1e-6), pcl::BadArgumentException);
}
