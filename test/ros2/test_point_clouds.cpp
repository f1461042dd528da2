/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl_indoor_ros/point_clouds.h>

#include "ros2/messages.h"

#include <pcl/conversions.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

using namespace pcl_indoor_ros;
using pcl::PointXYZL;
using pcl::indoor::test::PointCloud2;

namespace {

/** Two rows of three points with bytes between the rows. */
PointCloud2
twoRows(std::uint32_t gap)
{
  PointCloud2 message;
  message.header.frame_id = "map";
  message.width = 3;
  message.height = 2;
  message.point_step = 16;
  message.row_step = 3 * 16 + gap;
  const char* const names[] = {"x", "y", "z", "label"};
  for (std::uint32_t i = 0; i < 4; ++i)
    message.fields.push_back({names[i], 4 * i, std::uint8_t(i < 3 ? 7 : 6), 1});
  message.data.assign(2 * message.row_step, 0xee);
  for (std::uint32_t i = 0; i < 6; ++i) {
    const float place[] = {float(i), float(2 * i), float(3 * i)};
    auto* const point = &message.data[i / 3 * message.row_step + i % 3 * 16];
    std::memcpy(point, place, sizeof(place));
    std::memcpy(point + 12, &i, sizeof(i));
  }
  message.is_dense = true;
  return message;
}

pcl::PointCloud<PointXYZL>
pointsOf(const pcl::PCLPointCloud2& cloud)
{
  pcl::PointCloud<PointXYZL> points;
  pcl::fromPCLPointCloud2(cloud, points);
  return points;
}

} // namespace

TEST(PointClouds, OfMessagesHaveTheirPoints)
{
  for (const std::uint32_t gap : {0u, 5u}) {
    const auto cloud = cloudOf(twoRows(gap));
    EXPECT_EQ(cloud.header.frame_id, "map");
    EXPECT_EQ(cloud.row_step, 48u);
    EXPECT_EQ(cloud.data.size(), 96u);
    const auto points = pointsOf(cloud);
    ASSERT_EQ(points.size(), 6u);
    EXPECT_EQ(points.height, 2u);
    EXPECT_EQ(points[4].z, 12.0f);
    EXPECT_EQ(points[5].label, 5u);
  }
}

TEST(PointClouds, ThatAreShorterThanTheySayAreRefused)
{
  auto message = twoRows(5);
  message.data.resize(message.data.size() - 5); // the last row needs no gap
  EXPECT_NO_THROW(cloudOf(message));
  message.data.pop_back();
  EXPECT_THROW(cloudOf(message), pcl::indoor::InputError);
  message = twoRows(0);
  message.row_step = 47;
  EXPECT_THROW(cloudOf(message), pcl::indoor::InputError);
  message = twoRows(0);
  message.width = message.height = message.row_step = 0xffffffffu;
  EXPECT_THROW(cloudOf(message), pcl::indoor::InputError);
  message.height = 0;
  EXPECT_TRUE(cloudOf(message).data.empty());
}

TEST(PointClouds, BecomeTheSameMessageAgain)
{
  const auto message = twoRows(0);
  const auto again = messageOf<PointCloud2>(cloudOf(message), message.header);
  EXPECT_EQ(again.data, message.data);
  EXPECT_EQ(again.header.frame_id, "map");
  EXPECT_EQ(again.row_step, message.row_step);
  EXPECT_EQ(again.is_dense, message.is_dense);
  ASSERT_EQ(again.fields.size(), 4u);
  EXPECT_EQ(again.fields[3].name, "label");
  EXPECT_EQ(again.fields[3].datatype, 6);
  EXPECT_EQ(again.fields[3].offset, 12u);
}

TEST(PointClouds, GetLabels)
{
  const auto cloud = cloudOf(twoRows(5));
  const std::vector<std::uint32_t> values = {10, 11, 12, 13, 14, 15};
  const auto result =
      labelled(cloud, {{"room", {1, 1, 1, 2, 2, 0}}, {"label", values}});
  EXPECT_EQ(result.point_step, 24u);
  ASSERT_EQ(result.fields.size(), 5u); // the old label is gone
  EXPECT_EQ(result.fields[3].name, "room");
  const auto points = pointsOf(result);
  ASSERT_EQ(points.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(points[i].label, values[i]);
    EXPECT_EQ(points[i].y, 2.0f * static_cast<float>(i));
  }
  std::uint32_t room = 0;
  std::memcpy(&room, &result.data[3 * 24 + result.fields[3].offset], sizeof(room));
  EXPECT_EQ(room, 2u);
}

TEST(PointClouds, LabelsAreThoseOfTheScene)
{
  pcl::indoor::Scene scene;
  scene.room_of_point = {1, 1, 0};
  scene.object_of_point = {2, 0, 1};
  scene.structure_of_point = {0, 4, 1};
  scene.classes.objects.resize(2);
  scene.classes.objects[1].category = 7;
  const auto labels = pointLabels(scene);
  ASSERT_EQ(labels.size(), 4u);
  EXPECT_EQ(labels[0].values, scene.room_of_point);
  EXPECT_EQ(labels[1].values, scene.object_of_point);
  EXPECT_EQ(labels[2].values, scene.structure_of_point);
  EXPECT_EQ(labels[3].name, "category");
  EXPECT_EQ(labels[3].values, (std::vector<std::uint32_t>{7, 0, 0}));
  scene.classes.objects.clear(); // without a model
  EXPECT_EQ(pointLabels(scene)[3].values, (std::vector<std::uint32_t>{0, 0, 0}));
}
