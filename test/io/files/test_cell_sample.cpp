/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cell_sample.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
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
randomPoints(std::size_t count, std::uint32_t seed)
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

/** Each point has the one of its cell that was first, by its number. */
void
expectFound(const std::vector<Eigen::Vector3f>& points,
            const std::map<Cell, std::size_t>& first,
            CellSample& sample)
{
  const auto indices = listOf(sample.indices());
  for (const auto& point : points) {
    const auto found = sample.find(point);
    ASSERT_TRUE(found);
    ASSERT_LT(*found, indices.size());
    EXPECT_EQ(indices[*found], 10 * first.at(cellOf(point, sample.cellSize())));
    EXPECT_EQ((*sample.points())[*found].getVector3fMap(),
              points[indices[*found] / 10]);
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
  for (std::size_t i = 0; i < points.size(); ++i)
    sample.add(points[i], 10 * i);
  ASSERT_EQ(sample.cellSize(), expected_size);
  std::map<Cell, std::size_t> first;
  std::vector<std::uint64_t> indices;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (first.emplace(cellOf(points[i], expected_size), i).second)
      indices.push_back(10 * i);
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
    expectFirstPoints(randomPoints(20000, seed), 0.25, 1000000, 0.25); // 4096 cells
}

TEST(CellSample, CellsGrowWhereThereAreTooMany)
{
  const auto points = randomPoints(20000, 7);
  expectFirstPoints(points, 0.25, 4000, 0.5);
  expectFirstPoints(points, 0.25, 511, 1.0);
  expectFirstPoints(points, 0.25, 10, 1.0); // no farther
}

TEST(CellSample, PointsFarAwayShareCells)
{
  CellSample sample(0.01, 100);
  sample.add({1e9f, 0, 0}, 0);
  sample.add({9e8f, 0, 0}, 1);
  sample.add({-1e9f, 0, 0}, 2);
  sample.add({0, 0, 0}, 3);
  EXPECT_EQ(listOf(sample.indices()), (std::vector<std::uint64_t>{0, 2, 3}));
  EXPECT_EQ(sample.find({9e8f, 0, 0}), 0u);
  EXPECT_FALSE(sample.find({1, 0, 0}));
}
