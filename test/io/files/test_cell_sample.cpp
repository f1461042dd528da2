/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cell_sample.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>

using namespace pcl::indoor::tool;

namespace {

using Cell = std::array<double, 3>;

Cell
cellOf(const Eigen::Vector3f& point, double size)
{
  return {std::floor(point.x() / size),
          std::floor(point.y() / size),
          std::floor(point.z() / size)};
}

std::vector<Eigen::Vector3f>
pointsWithinTwoMetres(std::size_t count, std::uint32_t seed)
{
  std::mt19937 random(seed);
  const auto place = [&random] {
    return static_cast<float>(random() % 4000) * 1e-3f - 2;
  };
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = place(), y = place(), z = place();
    points.emplace_back(x, y, z);
  }
  return points;
}

std::vector<std::uint64_t>
listOf(const AscendingNumbers& numbers)
{
  std::vector<std::uint64_t> list;
  for (AscendingNumbers::Reader reader(numbers); reader.next();)
    list.push_back(reader.number());
  return list;
}

/** A part of them, and one point that is not finite at its end. */
pcl::PointCloud<pcl::PointXYZ>
cloudOfPart(const std::vector<Eigen::Vector3f>& points,
            std::size_t begin = 0,
            std::size_t end = -1)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (std::size_t i = begin; i < std::min(points.size(), end); ++i)
    cloud.emplace_back(points[i].x(), points[i].y(), points[i].z());
  cloud.emplace_back(0.0f, std::numeric_limits<float>::quiet_NaN(), 0.0f);
  return cloud;
}

/** Each point has the one of its cell that was first, by its number. */
void
expectFound(const std::vector<Eigen::Vector3f>& points,
            const std::map<Cell, std::size_t>& first,
            CellSample& sample)
{
  const auto indices = listOf(sample.indices());
  const auto found = sample.find(cloudOfPart(points));
  ASSERT_EQ(found.size(), points.size() + 1);
  EXPECT_EQ(found.back(), CellSample::absent); // not finite
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_LT(found[i], indices.size());
    EXPECT_EQ(indices[found[i]], first.at(cellOf(points[i], sample.cellSize())));
    EXPECT_EQ((*sample.points())[found[i]].getVector3fMap(), points[indices[found[i]]]);
  }
}

/** The first point of each cell, by its number. */
void
expectFirstPoints(const std::vector<Eigen::Vector3f>& points,
                  double first_size,
                  std::size_t limit,
                  double expected_size)
{
  CellSample sample(first_size, limit);
  for (std::size_t begin = 0; begin < points.size(); begin += 700)
    sample.add(cloudOfPart(points, begin, begin + 700), begin);
  ASSERT_EQ(sample.cellSize(), expected_size);
  std::map<Cell, std::size_t> first;
  std::vector<std::uint64_t> indices;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (first.emplace(cellOf(points[i], expected_size), i).second)
      indices.push_back(i);
  EXPECT_EQ(listOf(sample.indices()), indices);
  ASSERT_EQ(sample.points()->size(), indices.size());
  expectFound(points, first, sample);
  sample.shrink();
  EXPECT_EQ(sample.points()->width, indices.size());
  expectFound(points, first, sample); // with a table that is made again
}

} // namespace

TEST(CellSample, KeepsTheFirstPointOfEachCell)
{
  for (std::uint32_t seed = 0; seed < 5; ++seed)
    expectFirstPoints(
        pointsWithinTwoMetres(20000, seed), 0.25, 1000000, 0.25); // 4096 cells
}

TEST(CellSample, CellsGrowWhereThereAreTooMany)
{
  const auto points = pointsWithinTwoMetres(20000, 7);
  expectFirstPoints(points, 0.25, 4000, 0.5);
  expectFirstPoints(points, 0.25, 511, 1.0);
  expectFirstPoints(points, 0.25, 10, 1.0); // no farther
}

TEST(CellSample, PointsFarAwayShareCells)
{
  CellSample sample(0.01, 100);
  sample.add(cloudOfPart({{1e9f, 0, 0}, {9e8f, 0, 0}, {-1e9f, 0, 0}, {0, 0, 0}}), 0);
  EXPECT_EQ(listOf(sample.indices()), (std::vector<std::uint64_t>{0, 2, 3}));
  EXPECT_EQ(sample.find(cloudOfPart({{9e8f, 0, 0}, {1, 0, 0}})),
            (std::vector<std::uint32_t>{0, CellSample::absent, CellSample::absent}));
}

TEST(CellSample, CellsBelowZeroAreNotThoseAbove)
{
  CellSample sample(0.5, 100);
  sample.add(cloudOfPart({{-0.1f, 0, 0}, {0.1f, 0, 0}, {-0.5f, 0, 0}, {-0.6f, 0, 0}}),
             7);
  EXPECT_EQ(listOf(sample.indices()), (std::vector<std::uint64_t>{7, 8, 10}));
}
