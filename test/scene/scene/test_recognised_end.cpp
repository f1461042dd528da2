/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/recognised_end.h"
#include "support/room_with_chairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;
using pcl::indoor::test::emptyRoom;
using pcl::indoor::test::roomWithChairs;
using pcl::indoor::test::upsideDown;

namespace {

TEST(RecognisedEnd, is_that_with_which_chairs_stand)
{
  auto points = roomWithChairs({20.0f, -3.0f, 5.0f});
  EXPECT_EQ(recognisedEnd(points), 1);
  EXPECT_EQ(recognisedEnd(upsideDown(points)), -1);
  std::shuffle(points.begin(), points.end(), std::mt19937(1));
  EXPECT_EQ(recognisedEnd(points), 1);
}

TEST(RecognisedEnd, is_that_of_the_square_that_shows_most)
{
  auto points = roomWithChairs({0.0f, 0.0f, 0.0f});
  points.insert(points.end(), 100, Eigen::Vector3f(500.0f, 0.0f, 900.0f));
  EXPECT_EQ(recognisedEnd(points), 1);
  EXPECT_EQ(recognisedEnd(upsideDown(points)), -1);
}

TEST(RecognisedEnd, is_not_told_by_points_that_are_too_sparse)
{
  const auto dense = roomWithChairs({0.0f, 0.0f, 0.0f});
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u, 6u, 7u, 8u}) {
    auto sparse = dense;
    std::shuffle(sparse.begin(), sparse.end(), std::mt19937(seed));
    sparse.resize(dense.size() / 40); // one per 0.2 m
    EXPECT_EQ(recognisedEnd(sparse), 0) << seed;
    EXPECT_EQ(recognisedEnd(upsideDown(sparse)), 0) << seed;
  }
}

TEST(RecognisedEnd, is_not_known_of_an_empty_room)
{
  EXPECT_EQ(recognisedEnd({}), 0);
  const auto points = emptyRoom({0.0f, 0.0f, 0.0f});
  EXPECT_EQ(recognisedEnd(points), 0);
  EXPECT_EQ(recognisedEnd(upsideDown(points)), 0);
}

} // namespace
