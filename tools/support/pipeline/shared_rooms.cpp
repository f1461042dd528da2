/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pipeline/shared_rooms.h"

#include "rooms/room_points_file.h"
#include "rooms/scene_record.h"

#include <exception>
#include <mutex>
#include <optional>
#include <thread>

namespace pcl::indoor::tool {
namespace {

/** The rooms that are left, for the threads of the first rank. */
class RoomQueue {
public:
  RoomQueue(const std::vector<std::size_t>& order,
            const std::function<void(std::size_t room)>& is_done)
  : order_(order)
  , is_done_(is_done)
  {}

  std::optional<std::size_t>
  next()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return next_ < order_.size() ? std::optional(order_[next_++]) : std::nullopt;
  }

  void
  done(std::size_t room)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_done_(room);
  }

  /** There are no more rooms. */
  void
  stop()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    next_ = order_.size();
  }

private:
  const std::vector<std::size_t>& order_;
  const std::function<void(std::size_t room)>& is_done_;
  std::size_t next_ = 0;
  std::mutex mutex_;
};

/** Works through the queue in a thread of its own. */
class OwnRooms {
public:
  template <typename Finish>
  OwnRooms(RoomQueue& queue, const Finish& finish)
  : queue_(queue)
  , thread_([this, finish] {
    try {
      while (const auto room = queue_.next())
        finish(*room);
    } catch (...) {
      problem_ = std::current_exception();
      queue_.stop();
    }
  })
  {}

  ~OwnRooms()
  {
    queue_.stop();
    if (thread_.joinable())
      thread_.join();
  }

  /** Wait for the end; throws what has ended it early. */
  void
  join()
  {
    thread_.join();
    if (problem_)
      std::rethrow_exception(problem_);
  }

private:
  RoomQueue& queue_;
  std::exception_ptr problem_;
  std::thread thread_;
};

} // namespace

void
shareRooms(const std::vector<std::size_t>& order,
           const RoomSource& source,
           const RoomWork& work,
           WorkFolder& folder,
           Ranks& ranks,
           const std::function<void(std::size_t room)>& is_done)
{
  RoomQueue queue(order, is_done);
  OwnRooms own(queue, [&](std::size_t room) {
    folder.write(roomFile(room), roomBytes(finishRoom(source.points(room), work)));
    queue.done(room);
  });
  for (int working = ranks.count() - 1; working > 0;) {
    auto [rank, message] = ranks.receive();
    if (message.room >= 0) {
      const auto room = static_cast<std::size_t>(message.room);
      if (!source.is_spooled)
        folder.removeFile(pointsFile(room));
      queue.done(room);
    }
    const auto room = queue.next();
    if (!room) {
      ranks.dismiss(rank);
      --working;
      continue;
    }
    if (!source.is_spooled)
      folder.writePlain(pointsFile(*room), pointBytes(source.points(*room)));
    message.room = static_cast<std::int64_t>(*room);
    message.point_count = source.sizes[*room];
    message.has_normals = source.has_normals ? 1 : 0;
    message.key = folder.key();
    Eigen::Map<Eigen::Matrix4d>(message.pose) = work.frame.pose.matrix();
    message.metres_per_unit = work.frame.metres_per_unit;
    ranks.send(rank, message);
  }
  own.join();
}

void
finishSharedRooms(Ranks& ranks,
                  const std::string& folder,
                  const std::function<RoomWork()>& make_work)
{
  std::optional<RoomWork> work;
  for (RankMessage message;;) {
    ranks.send(0, message);
    message = ranks.receive().second;
    if (message.room < 0)
      return;
    if (!work)
      work = make_work();
    work->frame.pose.matrix() = Eigen::Map<const Eigen::Matrix4d>(message.pose);
    work->frame.metres_per_unit = message.metres_per_unit;
    WorkFolder files(folder, message.key);
    const auto room = static_cast<std::size_t>(message.room);
    auto points = readRoomPoints(files.path(pointsFile(room)),
                                 static_cast<std::size_t>(message.point_count),
                                 message.has_normals != 0);
    files.write(roomFile(room), roomBytes(finishRoom(std::move(points), *work)));
  }
}

} // namespace pcl::indoor::tool
