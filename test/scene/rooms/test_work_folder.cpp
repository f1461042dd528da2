/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/digest.h"
#include "rooms/scene_record.h"
#include "rooms/work_folder.h"
#include "support/folder_test.h"
#include "support/some_records.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;
using pcl::indoor::test::someRoom;
using pcl::indoor::test::someScene;

namespace {

class WorkFolderTest : public test::FolderTest {};

} // namespace

TEST(Records, HoldRoomsAndScenes)
{
  const auto room = roomOf(roomBytes(someRoom()));
  ASSERT_TRUE(room);
  EXPECT_EQ(room->objects.object_of_point, someRoom().objects.object_of_point);
  EXPECT_EQ(room->objects.structure_of_point, someRoom().objects.structure_of_point);
  EXPECT_EQ(room->measures[1].upper, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(room->measures[1].upright.yaw, 0.5);
  EXPECT_EQ(room->classes[0].top, someRoom().classes[0].top);
  const auto scene = sceneOf(sceneBytes(someScene()));
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->room_of_point, someScene().room_of_point);
  EXPECT_EQ(scene->rooms[0].footprint, someScene().rooms[0].footprint);
  EXPECT_EQ(scene->building.maps[0].labels.values, (std::vector<std::int32_t>{1, -1}));
  EXPECT_EQ(scene->frame.pose.matrix(), someScene().frame.pose.matrix());
  EXPECT_EQ(scene->frame.offset, someScene().frame.offset);
  EXPECT_EQ(scene->frame.metres_per_unit, someScene().frame.metres_per_unit);
  EXPECT_EQ(scene->report.warnings, someScene().report.warnings);
  EXPECT_EQ(sceneBytes(*scene), sceneBytes(someScene()));
}

TEST(Records, ThatAreCutOrTooLongAreNone)
{
  for (const auto& bytes : {roomBytes(someRoom()), sceneBytes(someScene())}) {
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      EXPECT_FALSE(roomOf(bytes.substr(0, size))) << size;
      EXPECT_FALSE(sceneOf(bytes.substr(0, size))) << size;
    }
    EXPECT_FALSE(roomOf(bytes + "x"));
    EXPECT_FALSE(sceneOf(bytes + "x"));
  }
  EXPECT_FALSE(roomOf(std::string(64, '\xff'))); // lists longer than any memory
}

TEST(Digests, ChangeWithEachByteAndTheLength)
{
  const std::string text = "a text of more than one word of memory";
  std::set<std::uint64_t> digests = {digestOf(text), digestOf(text, 1), digestOf("")};
  for (std::size_t i = 0; i < text.size(); ++i) {
    auto other = text;
    other[i] ^= 1;
    digests.insert(digestOf(other));
    digests.insert(digestOf(text.substr(0, i) + std::string(1, '\0')));
  }
  EXPECT_EQ(digests.size(), 3 + 2 * text.size());
}

TEST_F(WorkFolderTest, GivesBackWhatWasWrittenForTheSameRunOnly)
{
  const auto folder = path("work");
  WorkFolder work(folder, 7);
  EXPECT_FALSE(std::filesystem::exists(folder)); // nothing is finished yet
  work.write("room_1", "some bytes");
  EXPECT_EQ(work.read("room_1"), "some bytes");
  EXPECT_EQ(WorkFolder(folder, 7).read("room_1"), "some bytes");
  EXPECT_FALSE(WorkFolder(folder, 8).read("room_1"));
  EXPECT_FALSE(work.read("room_2"));
  WorkFolder(folder, 7).removeOutdated();
  EXPECT_TRUE(work.read("room_1"));
  WorkFolder(folder, 8).removeOutdated();
  EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST_F(WorkFolderTest, TakesNoDamagedFile)
{
  WorkFolder work(path("work"), 7);
  work.write("room_1", "some bytes");
  const auto whole = test::bytesOf(path("work/room_1"));
  for (std::size_t i = 0; i < whole.size(); ++i) {
    auto damaged = whole;
    damaged[i] ^= 4;
    write("work/room_1", damaged);
    EXPECT_FALSE(work.read("room_1")) << i;
    write("work/room_1", whole.substr(0, i));
    EXPECT_FALSE(work.read("room_1")) << i;
  }
  write("work/room_1", whole);
  EXPECT_TRUE(work.read("room_1"));
}

TEST_F(WorkFolderTest, LeavesWhatOthersHavePutThere)
{
  WorkFolder work(path("work"), 7);
  work.write("room_1", "some bytes");
  write("work/notes", "mine");
  work.remove();
  EXPECT_FALSE(work.read("room_1"));
  EXPECT_EQ(test::bytesOf(path("work/notes")), "mine");
}
