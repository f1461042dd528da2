/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "rooms/room_store.h"

#include "rooms/scene_record.h"

#include <chrono>
#include <filesystem>
#include <thread>
#include <utility>

namespace pcl::indoor::tool {

std::optional<Scene>
RoomsInMemory::scene() const
{
  return {};
}

void
RoomsInMemory::putScene(const Scene&)
{}

std::optional<FinishedRoom>
RoomsInMemory::room(std::size_t room, std::size_t point_count) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = rooms_.find(room);
  return found != rooms_.end() &&
                 found->second.objects.object_of_point.size() == point_count
             ? std::optional(found->second)
             : std::nullopt;
}

void
RoomsInMemory::putRoom(std::size_t room, FinishedRoom finished)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  rooms_[room] = std::move(finished);
}

void
RoomsInMemory::await(const std::vector<std::size_t>&) const
{}

std::string
RoomsInMemory::pathAside() const
{
  return {};
}

std::string
RoomsInMemory::absence(std::size_t room) const
{
  return "room " + std::to_string(room + 1) + " is not finished";
}

RoomsInFiles::RoomsInFiles(WorkFolder& folder)
: folder_(folder)
{}

std::optional<Scene>
RoomsInFiles::scene() const
{
  const auto bytes = folder_.read("scene");
  return bytes ? sceneOf(*bytes) : std::nullopt;
}

void
RoomsInFiles::putScene(const Scene& scene)
{
  folder_.write("scene", sceneBytes(scene));
}

std::optional<FinishedRoom>
RoomsInFiles::room(std::size_t room, std::size_t point_count) const
{
  const auto bytes = folder_.read(roomFile(room));
  auto finished = bytes ? roomOf(*bytes) : std::nullopt;
  return finished && finished->objects.object_of_point.size() == point_count
             ? std::move(finished)
             : std::nullopt;
}

void
RoomsInFiles::putRoom(std::size_t room, FinishedRoom finished)
{
  folder_.write(roomFile(room), roomBytes(finished));
}

void
RoomsInFiles::await(const std::vector<std::size_t>& rooms) const
{ // a network's file system may show files up to a minute late
  constexpr int longest = 60; // seconds, for all of them
  int waited = 0;
  for (const auto room : rooms)
    for (; !std::filesystem::exists(folder_.path(roomFile(room))) && waited < longest;
         ++waited)
      std::this_thread::sleep_for(std::chrono::seconds(1));
}

std::string
RoomsInFiles::pathAside() const
{
  return folder_.path("points_aside");
}

std::string
RoomsInFiles::absence(std::size_t room) const
{
  return folder_.path(roomFile(room)) +
         ": the file is gone or damaged; start again to go on";
}

} // namespace pcl::indoor::tool
