/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/room_labels.h"

#include <pcl/console/print.h>

#include <gtest/gtest.h>

#include <functional>
#include <limits>

using namespace pcl::indoor::test;

namespace {

using RoomSegmentationXYZ = pcl::RoomSegmentation<pcl::PointXYZ>;

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

class QuietRoomSegmentation : public testing::Test {
protected:
  void
  SetUp() override
  {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  }

  void
  TearDown() override
  {
    pcl::console::setVerbosityLevel(pcl::console::L_INFO);
  }
};

} // namespace

TEST(RoomSegmentation, PointIndicesAreConsistentWithLabels)
{
  const auto cloud = cloudOf(twoRooms().points);
  cloud->header.frame_id = "map";
  RoomSegmentationXYZ segmentation;
  segmentation.setInputCloud(cloud);
  std::vector<pcl::PointIndices> rooms(7);
  segmentation.segment(rooms);
  const auto labels = segmented(cloud);
  ASSERT_EQ(rooms.size(), roomCount(labels));
  std::size_t labelled = 0;
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    EXPECT_EQ(rooms[r].header.frame_id, "map");
    EXPECT_TRUE(std::is_sorted(rooms[r].indices.begin(), rooms[r].indices.end()));
    for (const auto index : rooms[r].indices)
      ASSERT_EQ(labels[index], r + 1);
    labelled += rooms[r].indices.size();
  }
  EXPECT_EQ(labelled + std::count(labels.begin(), labels.end(), 0u), labels.size());
}

TEST(RoomSegmentation, RunTwiceGivesTheSame)
{
  const auto cloud = cloudOf(twoRooms().points);
  RoomSegmentationXYZ segmentation;
  segmentation.setInputCloud(cloud);
  Labels first, second{7};
  segmentation.segment(first);
  segmentation.segment(second);
  EXPECT_EQ(roomCount(first), 2u);
  EXPECT_EQ(first, second);
  EXPECT_EQ(segmentation.getRooms().size(), 2u);
}

TEST(RoomSegmentation, PointOrderChangesNamesOnly)
{
  std::mt19937 rng(5);
  const auto points = twoRooms().points;
  const auto order = shuffledOrder(points.size(), rng);
  std::vector<Eigen::Vector3f> shuffled;
  for (const auto index : order)
    shuffled.push_back(points[index]);
  const auto labels = segmented(cloudOf(points));
  const auto shuffled_labels = segmented(cloudOf(shuffled));
  Labels back(labels.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    back[order[i]] = shuffled_labels[i];
  EXPECT_EQ(roomCount(labels), 2u);
  EXPECT_EQ(renamed(back), renamed(labels));
}

TEST(RoomSegmentation, TheNumberOfThreadsChangesNothing)
{
  const auto cloud = cloudOf(turned(bentCorridorWithThreeRooms().points, 0.3));
  Labels labels[2];
  for (int i = 0; i < 2; ++i) {
    RoomSegmentationXYZ segmentation;
    segmentation.setInputCloud(cloud);
    segmentation.setNumberOfThreads(i + 1);
    segmentation.segment(labels[i]);
  }
  EXPECT_EQ(labels[0].size(), cloud->size());
  EXPECT_EQ(labels[0], labels[1]);
}

TEST(RoomSegmentation, IndicesAreRespected)
{
  const auto scene = twoRooms();
  const auto cloud = cloudOf(scene.points);
  const pcl::IndicesPtr second(new pcl::Indices);
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (scene.objects[i] == 2) {
      second->push_back(static_cast<pcl::index_t>(i));
      points.push_back(scene.points[i]);
    }
  RoomSegmentationXYZ segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setIndices(second);
  Labels labels;
  segmentation.segment(labels);
  ASSERT_EQ(labels.size(), cloud->size());
  const auto alone = segmented(cloudOf(points));
  EXPECT_EQ(roomCount(alone), 1u);
  Labels expected(cloud->size(), 0);
  for (std::size_t k = 0; k < second->size(); ++k)
    expected[(*second)[k]] = alone[k];
  EXPECT_EQ(labels, expected);
}

TEST(RoomSegmentation, PointsThatAreNotFiniteGetNoRoom)
{
  const auto points = twoRooms().points;
  const auto cloud = cloudOf(points);
  const auto expected = segmented(cloud);
  Cloud::Ptr broken(new Cloud);
  broken->is_dense = false;
  for (const auto& point : *cloud) {
    const float inf = std::numeric_limits<float>::infinity();
    broken->push_back(point);
    broken->emplace_back(nan_value, 1.0f, 1.0f);
    broken->emplace_back(1.0f, 1.0f, -inf);
  }
  const auto labels = segmented(broken);
  ASSERT_EQ(labels.size(), 3 * expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_EQ(labels[3 * i], expected[i]);
    ASSERT_EQ(labels[3 * i + 1], 0u);
    ASSERT_EQ(labels[3 * i + 2], 0u);
  }
}

TEST(RoomSegmentation, TheHollowOfAThickWallIsNoRoom)
{
  // 0.8 m between the faces, of which nobody sees the inside; storeys below and above
  const auto scene = rooms({{{0, 0, 0}, {4, 3, 2.5f}, 1},
                            {{4.8f, 0, 0}, {8.8f, 3, 2.5f}, 2},
                            {{0, 0, -2.8f}, {8.8f, 3, -0.3f}, 3},
                            {{0, 0, 2.8f}, {8.8f, 3, 5.3f}, 4}},
                           {});
  EXPECT_EQ(roomCount(segmented(cloudOf(scene.points))), 4u);
}

TEST(RoomSegmentation, OnePointGivesNoRoom)
{
  EXPECT_EQ(segmented(cloudOf({{1, 2, 3}})), Labels{0});
}

TEST_F(QuietRoomSegmentation, UnusableInputGivesNothing)
{
  const auto cloud = cloudOf(twoRooms().points);
  const auto nothing = [](const std::function<void(RoomSegmentationXYZ&)>& prepare) {
    RoomSegmentationXYZ segmentation;
    prepare(segmentation);
    Labels labels{7, 7};
    std::vector<pcl::PointIndices> rooms(2);
    segmentation.segment(labels);
    segmentation.segment(rooms);
    return labels.empty() && rooms.empty() && segmentation.getRooms().empty();
  };
  EXPECT_TRUE(nothing([](RoomSegmentationXYZ&) {})) << "no cloud";
  EXPECT_TRUE(nothing([](auto& s) { s.setInputCloud(cloudOf({})); })) << "empty cloud";
  EXPECT_TRUE(nothing([](auto& s) {
    s.setInputCloud(
        cloudOf(std::vector<Eigen::Vector3f>(5, Eigen::Vector3f::Constant(nan_value))));
  })) << "all NaN";
  const auto indices = [&](const pcl::Indices& chosen) {
    return [&cloud, chosen](RoomSegmentationXYZ& s) {
      s.setInputCloud(cloud);
      s.setIndices(pcl::IndicesPtr(new pcl::Indices(chosen)));
    };
  };
  const auto size = static_cast<pcl::index_t>(cloud->size());
  EXPECT_TRUE(nothing(indices({}))) << "no indices";
  EXPECT_TRUE(nothing(indices({0, 1, size}))) << "index beyond the end";
  EXPECT_TRUE(nothing(indices({0, -1, 1}))) << "negative index";
}

TEST_F(QuietRoomSegmentation, EveryParameterIsRejected)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using Set = std::function<void(RoomSegmentationXYZ&)>;
  const std::vector<std::pair<const char*, Set>> table{
      {"voxel size -0.1", [](auto& s) { s.setVoxelSize(-0.1); }},
      {"voxel size NaN", [=](auto& s) { s.setVoxelSize(nan); }},
      {"voxel size infinite", [](auto& s) { s.setVoxelSize(infinity); }},
      {"voxel size too small for the grid", [](auto& s) { s.setVoxelSize(1e-7); }},
      {"area -1", [](auto& s) { s.setMinRoomArea(-1.0); }},
      {"area NaN", [=](auto& s) { s.setMinRoomArea(nan); }},
      {"width -1", [](auto& s) { s.setMinRoomWidth(-1.0); }},
      {"width NaN", [=](auto& s) { s.setMinRoomWidth(nan); }},
      {"persistence -0.1", [](auto& s) { s.setPersistence(-0.1); }},
      {"persistence 1.1", [](auto& s) { s.setPersistence(1.1); }},
      {"persistence NaN", [=](auto& s) { s.setPersistence(nan); }},
      {"habitable area -1", [](auto& s) { s.setHabitableArea(-1.0); }},
      {"habitable area NaN", [=](auto& s) { s.setHabitableArea(nan); }},
      {"open share -0.1", [](auto& s) { s.setOpenShare(-0.1); }},
      {"open share 1.1", [](auto& s) { s.setOpenShare(1.1); }},
      {"open share NaN", [=](auto& s) { s.setOpenShare(nan); }},
      {"metres per unit 0", [](auto& s) { s.setMetresPerUnit(0.0); }},
      {"metres per unit NaN", [=](auto& s) { s.setMetresPerUnit(nan); }},
      {"metres per unit infinite", [](auto& s) { s.setMetresPerUnit(infinity); }},
      {"up axis 0", [](auto& s) { s.setUpAxis(Eigen::Vector3f::Zero()); }},
      {"up axis NaN",
       [](auto& s) {
         s.setUpAxis({nan_value, 0, 1});
       }},
      {"threads -1", [](auto& s) {
         auto options = s.getOptions();
         options.threads = -1;
         s.setOptions(options);
       }}};
  const auto cloud = cloudOf(twoRooms().points);
  for (const auto& [what, set] : table) {
    RoomSegmentationXYZ segmentation;
    segmentation.setInputCloud(cloud);
    set(segmentation);
    Labels labels{7};
    EXPECT_NO_THROW(segmentation.segment(labels)) << what;
    EXPECT_TRUE(labels.empty()) << what;
    segmentation.setOptions({}); // usable again
    segmentation.setUpAxis(Eigen::Vector3f::UnitZ());
    segmentation.setMetresPerUnit(1.0);
    segmentation.segment(labels);
    EXPECT_EQ(roomCount(labels), 2u) << what;
  }
}

TEST(RoomSegmentation, DefaultsAreAsDocumented)
{
  const RoomSegmentationXYZ segmentation;
  EXPECT_EQ(segmentation.getVoxelSize(), 0.0); // automatic
  EXPECT_EQ(segmentation.getMetresPerUnit(), 1.0);
  EXPECT_EQ(segmentation.getMinRoomArea(), 0.5);
  EXPECT_EQ(segmentation.getMinRoomWidth(), 0.5);
  EXPECT_EQ(segmentation.getPersistence(), 0.5);
  EXPECT_EQ(segmentation.getOpenShare(), 0.55);
  EXPECT_EQ(segmentation.getHabitableArea(), 6.5);
  EXPECT_EQ(segmentation.getUpAxis(), Eigen::Vector3f(0, 0, 1));
  EXPECT_EQ(segmentation.getNumberOfThreads(), 0);
}

TEST(RoomSegmentation, SettersAndOptionsAreTheSameParameters)
{
  RoomSegmentationXYZ segmentation;
  segmentation.setVoxelSize(0.15);
  segmentation.setMinRoomArea(1.0);
  segmentation.setMinRoomWidth(0.8);
  segmentation.setPersistence(0.6);
  segmentation.setOpenShare(0.5);
  segmentation.setHabitableArea(8.0);
  segmentation.setNumberOfThreads(2);
  RoomSegmentationXYZ other;
  other.setOptions(segmentation.getOptions());
  EXPECT_EQ(other.getVoxelSize(), 0.15);
  EXPECT_EQ(other.getMinRoomArea(), 1.0);
  EXPECT_EQ(other.getMinRoomWidth(), 0.8);
  EXPECT_EQ(other.getPersistence(), 0.6);
  EXPECT_EQ(other.getOpenShare(), 0.5);
  EXPECT_EQ(other.getHabitableArea(), 8.0);
  EXPECT_EQ(other.getNumberOfThreads(), 2);
}

TEST(RoomSegmentation, TheParametersHaveAnEffect)
{
  auto cloud = cloudOf(twoRooms().points);
  const auto count = [&](const std::function<void(RoomSegmentationXYZ&)>& set) {
    RoomSegmentationXYZ segmentation;
    segmentation.setInputCloud(cloud);
    set(segmentation);
    Labels labels;
    segmentation.segment(labels);
    EXPECT_EQ(labels.size(), cloud->size());
    return roomCount(labels);
  };
  EXPECT_EQ(count([](auto& s) { s.setMinRoomArea(10.0); }), 1u); // 9 m^2 are too few
  EXPECT_EQ(count([](auto& s) { s.setMinRoomArea(20.0); }), 0u);
  EXPECT_EQ(count([](auto& s) { s.setMinRoomWidth(4.0); }), 0u);
  EXPECT_EQ(count([](auto& s) { s.setPersistence(0.0); }), 2u); // a lintel parts them
  // a passage as high as the rooms
  const auto open =
      rooms({{{0, 0, 0}, {4, 3, 2.5f}, 1}, {{4.1f, 0, 0}, {7.1f, 3, 2.5f}, 2}},
            {doorway(3.95f, 4.15f, 1.0f, 2.2f, 2.6f)});
  cloud = cloudOf(open.points);
  EXPECT_EQ(count([](auto&) {}), 2u);
  EXPECT_EQ(count([](auto& s) { s.setPersistence(0.0); }), 2u); // an open plan
  const double never = std::numeric_limits<double>::infinity();
  EXPECT_EQ(count([=](auto& s) { s.setHabitableArea(never); }), 2u);
  EXPECT_EQ(count([=](auto& s) { s.setHabitableArea(never), s.setPersistence(0.0); }),
            1u);
  EXPECT_EQ(count([=](auto& s) { s.setHabitableArea(never), s.setOpenShare(0.05); }),
            1u);
}

template <typename PointT>
class RoomSegmentationOfType : public testing::Test {};
using RoomPointTypes = testing::
    Types<pcl::PointXYZ, pcl::PointXYZRGB, pcl::PointXYZRGBA, pcl::PointNormal>;
TYPED_TEST_SUITE(RoomSegmentationOfType, RoomPointTypes);

TYPED_TEST(RoomSegmentationOfType, IsInstantiated)
{
  const auto points = twoRooms().points;
  typename pcl::PointCloud<TypeParam>::Ptr cloud(new pcl::PointCloud<TypeParam>);
  for (const auto& point : points) {
    TypeParam typed;
    typed.getVector3fMap() = point;
    cloud->push_back(typed);
  }
  const typename pcl::RoomSegmentation<TypeParam>::Ptr segmentation(
      new pcl::RoomSegmentation<TypeParam>);
  segmentation->setInputCloud(cloud);
  Labels labels;
  segmentation->segment(labels);
  EXPECT_EQ(labels, segmented(cloudOf(points)));
}
