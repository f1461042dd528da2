/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "rooms/room_store.h"

#include "support/folder_test.h"
#include "support/some_records.h"

#include <gtest/gtest.h>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;
using pcl::indoor::test::someRoom;
using pcl::indoor::test::someScene;

namespace {

class RoomStoreTest : public test::FolderTest {};

/** A room is given back if it has as many points as it should. */
void
expectRooms(RoomStore& store)
{
  const auto count = someRoom().objects.object_of_point.size();
  EXPECT_FALSE(store.room(2, count));
  store.putRoom(2, someRoom());
  ASSERT_TRUE(store.room(2, count));
  EXPECT_EQ(store.room(2, count)->objects.object_of_point,
            someRoom().objects.object_of_point);
  EXPECT_EQ(store.room(2, count)->measures.size(), someRoom().measures.size());
  EXPECT_FALSE(store.room(2, count + 1));
  EXPECT_FALSE(store.room(1, count));
  EXPECT_NE(store.absence(1).find('2'), std::string::npos); // for people from 1
}

} // namespace

TEST_F(RoomStoreTest, InMemoryGivesRoomsBack)
{
  RoomsInMemory store;
  expectRooms(store);
}

TEST_F(RoomStoreTest, InFilesGivesRoomsBackAlsoToTheNextRun)
{
  WorkFolder folder(path("work"), 7);
  RoomsInFiles store(folder);
  expectRooms(store);
  EXPECT_FALSE(store.scene());
  store.putScene(someScene());
  WorkFolder again(path("work"), 7);
  const RoomsInFiles next(again);
  EXPECT_TRUE(next.room(2, someRoom().objects.object_of_point.size()));
  ASSERT_TRUE(next.scene());
  EXPECT_EQ(next.scene()->room_of_point, someScene().room_of_point);
  next.await({2}); // is there: does not wait
}

TEST_F(RoomStoreTest, InMemoryKeepsSurfaces)
{
  RoomsInMemory store;
  auto room = someRoom();
  room.objects.surfaces.resize(2);
  store.putRoom(0, room);
  EXPECT_EQ(store.room(0, room.objects.object_of_point.size())->objects.surfaces.size(),
            2u);
}
