/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "rooms/object_votes.h"

#include <pcl/ml/bundled_model.h>
#include <pcl/ml/voxel_network.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;

namespace {

/** A room of 4 x 3 m without a ceiling, and a table: objects 1 to 5. */
class SimpleRoom : public testing::Test {
protected:
  void
  SetUp() override
  {
    constexpr float step = 0.03f;
    for (float u = 0; u < 4; u += step)
      for (float v = 0; v < 3; v += step) {
        add(1, u, v, 0);
        if (v < 2.4f) {
          add(2, u, 0, v);
          add(3, u, 3, v);
          if (u < 3)
            add(4, 0, u, v);
        }
      }
    for (float u = 0; u < 1.4f; u += step)
      for (float v = 0; v < 0.8f; v += step)
        add(5, 1.5f + u, 1.2f + v, 0.74f);
    for (float z = 0; z < 0.74f; z += step)
      for (const float x : {1.5f, 2.85f})
        for (const float y : {1.2f, 1.95f})
          for (const float side : {0.0f, 0.04f})
            add(5, x + side, y, z);
  }

  void
  add(std::uint32_t object, float x, float y, float z)
  {
    points.emplace_back(x, y, z);
    objects.push_back(object);
  }

  ObjectVotes
  votes() const
  {
    const auto network = loadVoxelNetwork(bundledNetworkFile());
    RoomObjects room;
    room.object_of_point = objects;
    room.votes = classifyVoxels(points, network);
    auto votes = votesOf(room);
    votes.classes = network.classes;
    return votes;
  }

  std::vector<Eigen::Vector3f> points;
  std::vector<std::uint32_t> objects;
};

TEST_F(SimpleRoom, bundled_network_knows_it)
{
  const auto votes = this->votes();
  ASSERT_EQ(votes.of_object.size(), 5u);
  const auto likeliest = [&](std::size_t object) {
    const auto& of = votes.of_object[object - 1];
    return votes.classes[static_cast<std::size_t>(
        std::max_element(of.begin(), of.end()) - of.begin())];
  };
  EXPECT_EQ(likeliest(1), "floor");
  for (std::size_t wall = 2; wall <= 4; ++wall)
    EXPECT_EQ(likeliest(wall), "wall") << wall;
  EXPECT_TRUE(likeliest(5) == "table" || likeliest(5) == "desk") << likeliest(5);
  for (const auto& of : votes.of_object)
    EXPECT_NEAR(std::accumulate(of.begin(), of.end(), 0.0f), 1.0f, 1e-3f);
}

TEST_F(SimpleRoom, points_of_no_object_have_no_vote)
{
  std::fill(objects.begin(), objects.end(), 0u);
  EXPECT_TRUE(votes().of_object.empty());
  EXPECT_TRUE(votesOf({}).of_object.empty());
}

} // namespace
