/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/exceptions.h>
#include <pcl/ml/retrieval.h>

#include <gtest/gtest.h>

#include <limits>

namespace pcl::indoor {
namespace {

const float infinity = std::numeric_limits<float>::infinity();

TEST(Retrieval, TakesTheNearestOther)
{
  const DistanceTable table{3, 3, {0, 2, 1, 2, 0, 5, 1, 5, 0}};
  EXPECT_EQ(leaveOneOutLabels(table, {7, 8, 9}), (std::vector<int>{9, 7, 7}));
  EXPECT_EQ(nearestLabels(table, {7, 8, 9}), (std::vector<int>{7, 8, 9}));
}

TEST(Retrieval, ADuplicateIsFoundAlthoughItsDistanceIsZero)
{
  const DistanceTable table{2, 2, {0, 0, 0, 0}};
  EXPECT_EQ(leaveOneOutLabels(table, {4, 5}), (std::vector<int>{5, 4}));
}

TEST(Retrieval, OfEquallyNearOnesTheFirst)
{
  const DistanceTable table{1, 3, {2, 1, 1}};
  EXPECT_EQ(nearestLabels(table, {4, 5, 6}), (std::vector<int>{5}));
}

TEST(Retrieval, NothingFiniteMeansNoLabel)
{
  const DistanceTable table{2, 2, {infinity, infinity, infinity, 0}};
  EXPECT_EQ(leaveOneOutLabels(table, {4, 5}), (std::vector<int>{no_label, no_label}));
  EXPECT_EQ(nearestLabels({1, 0, {}}, {}), (std::vector<int>{no_label}));
  EXPECT_TRUE(leaveOneOutLabels({}, {}).empty());
  EXPECT_EQ(leaveOneOutLabels({1, 1, {0}}, {3}), (std::vector<int>{no_label}));
}

TEST(Retrieval, RefusesWhatDoesNotFit)
{
  EXPECT_THROW(nearestLabels({1, 2, {0, 0}}, {1}), BadArgumentException);
  EXPECT_THROW(leaveOneOutLabels({1, 2, {0, 0}}, {1, 2}), BadArgumentException);
}

} // namespace
} // namespace pcl::indoor
