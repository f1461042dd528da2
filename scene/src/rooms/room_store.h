/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "rooms/finished_room.h"
#include "rooms/work_folder.h"

#include <pcl/indoor/exports.h>
#include <pcl/scene/scene.h>

#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Keeps what is finished of a building: its rooms as they were found, and each
 * room with its objects. */
class RoomStore {
public:
  virtual ~RoomStore() = default;

  /** \brief The scene with its rooms, without objects; nothing if none is kept. */
  virtual std::optional<Scene>
  scene() const = 0;

  virtual void
  putScene(const Scene& scene) = 0;

  /** \brief A room that is finished and has as many points as it should; else nothing.
   */
  virtual std::optional<FinishedRoom>
  room(std::size_t room, std::size_t point_count) const = 0;

  /** \brief Keep a room; from any thread. */
  virtual void
  putRoom(std::size_t room, FinishedRoom finished) = 0;

  /** \brief Wait for rooms that other processes have put there. */
  virtual void
  await(const std::vector<std::size_t>& rooms) const = 0;

  /** \brief Where points may wait while others need the memory, see PointsAside; empty:
   * they are to stay in memory. */
  virtual std::string
  pathAside() const = 0;

  /** \brief What to say of a room that is not there. */
  virtual std::string
  absence(std::size_t room) const = 0;
};

/** \brief Keeps rooms in memory. */
class RoomsInMemory : public RoomStore {
public:
  std::optional<Scene>
  scene() const override;

  void
  putScene(const Scene& scene) override;

  std::optional<FinishedRoom>
  room(std::size_t room, std::size_t point_count) const override;

  void
  putRoom(std::size_t room, FinishedRoom finished) override;

  void
  await(const std::vector<std::size_t>& rooms) const override;

  std::string
  pathAside() const override;

  std::string
  absence(std::size_t room) const override;

private:
  mutable std::mutex mutex_;
  std::map<std::size_t, FinishedRoom> rooms_;
};

/** \brief Keeps them in files: a run that was ended goes on from there. */
class PCL_INDOOR_EXPORTS RoomsInFiles : public RoomStore {
public:
  /** \param[in] folder must outlive this */
  explicit RoomsInFiles(WorkFolder& folder);

  std::optional<Scene>
  scene() const override;

  void
  putScene(const Scene& scene) override;

  std::optional<FinishedRoom>
  room(std::size_t room, std::size_t point_count) const override;

  void
  putRoom(std::size_t room, FinishedRoom finished) override;

  void
  await(const std::vector<std::size_t>& rooms) const override;

  std::string
  pathAside() const override;

  std::string
  absence(std::size_t room) const override;

private:
  WorkFolder& folder_;
};

} // namespace pcl::indoor::tool
