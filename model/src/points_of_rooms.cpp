/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/model/points_of_rooms.h>

#include "internal/cross.h"

#include <pcl/exceptions.h>

#include <utility>

namespace pcl::indoor {
namespace {

constexpr double tile_size = 1.0; // metres, at least

/** Turns points into a stretch's own frame. */
class StretchFrame {
public:
  explicit StretchFrame(const FaceStretch& stretch)
  : stretch_(stretch)
  , length_((stretch.end - stretch.begin).norm())
  , along_((stretch.end - stretch.begin) / length_)
  {}

  void
  addIfNear(const Eigen::Vector3f& point, std::vector<WallPoint>& found) const
  {
    const Eigen::Vector2d from = point.head<2>().cast<double>() - stretch_.begin;
    const double before = crossOf(along_, from);
    const double along = along_.dot(from);
    if (before >= -stretch_.behind && before <= stretch_.before &&
        along >= -stretch_.margin && along <= length_ + stretch_.margin)
      found.push_back(
          {static_cast<float>(along), static_cast<float>(before), point.z()});
  }

  /** The corners of the box around it. */
  std::pair<Eigen::Array2d, Eigen::Array2d>
  box() const
  {
    const Eigen::Vector2d left(-along_.y(), along_.x());
    Eigen::Array2d low = stretch_.begin, high = stretch_.begin;
    for (const double u : {-stretch_.margin, length_ + stretch_.margin})
      for (const double v : {-stretch_.behind, stretch_.before}) {
        const Eigen::Array2d corner = stretch_.begin + u * along_ + v * left;
        low = low.min(corner);
        high = high.max(corner);
      }
    return {low, high};
  }

private:
  const FaceStretch& stretch_;
  double length_;
  Eigen::Vector2d along_;
};

} // namespace

PointsOfRooms::PointsOfRooms(const PointCloud<PointXYZ>& points,
                             const std::vector<std::uint32_t>& room_of_point,
                             std::uint32_t room_count,
                             const Eigen::Vector3f& origin)
{
  if (points.size() != room_of_point.size())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        points.size() << " points, but " << room_of_point.size()
                                      << " numbers of rooms");
  std::vector<std::size_t> counts(static_cast<std::size_t>(room_count) + 1, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (room_of_point[i] > room_count)
      PCL_THROW_EXCEPTION(BadArgumentException,
                          "point " << i << " is in room " << room_of_point[i] << " of "
                                   << room_count);
    ++counts[room_of_point[i]];
  }
  std::vector<std::vector<Eigen::Vector3f>> of_rooms(counts.size());
  for (std::size_t room = 0; room < counts.size(); ++room)
    of_rooms[room].reserve(counts[room]);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const Eigen::Vector3f point = points[i].getVector3fMap(); point.allFinite())
      of_rooms[room_of_point[i]].push_back(point - origin);
  for (auto& room : of_rooms) {
    of_rooms_.emplace_back(room, tile_size);
    room = {}; // there may be many
  }
}

void
PointsOfRooms::beside(const FaceStretch& stretch,
                      std::uint32_t room,
                      bool with_none,
                      std::vector<WallPoint>& found) const
{
  found.clear();
  if (!((stretch.end - stretch.begin).norm() > 0.0))
    return;
  const StretchFrame frame(stretch);
  const auto [low, high] = frame.box();
  const auto add = [&](const Eigen::Vector3f* first, const Eigen::Vector3f* end) {
    for (; first != end; ++first)
      frame.addIfNear(*first, found);
  };
  of_rooms_[room].forEachNear(low, high, add);
  if (with_none)
    of_rooms_[0].forEachNear(low, high, add);
}

} // namespace pcl::indoor
