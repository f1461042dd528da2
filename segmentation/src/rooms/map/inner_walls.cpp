/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/inner_walls.h"

#include "rooms/space/map_regions.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl {
namespace indoor {

namespace {

using Rooms = PixelMap<std::int32_t>;

/** \brief Walks the lines along a direction; each pixel lies on exactly one. */
class LineWalker {
public:
  LineWalker(const Rooms& rooms, const Eigen::Vector2d& direction)
  : rooms_(rooms)
  , along_x_(std::abs(direction.x()) >= std::abs(direction.y()))
  , slope_(along_x_ ? direction.y() / direction.x() : direction.x() / direction.y())
  {}

  /** \brief Call visit(pixels of a line) for each line. */
  template <typename Visitor>
  void
  forEach(const Visitor& visit) const
  {
    const int steps = along_x_ ? rooms_.nx : rooms_.ny;
    const int width = along_x_ ? rooms_.ny : rooms_.nx;
    const int last = shift(steps - 1);
    std::vector<std::size_t> line;
    for (int start = -std::max(last, 0); start < width - std::min(last, 0); ++start) {
      line.clear();
      for (int i = 0; i < steps; ++i) {
        const int across = start + shift(i);
        if (across >= 0 && across < width)
          line.push_back(along_x_ ? rooms_.index(i, across) : rooms_.index(across, i));
      }
      visit(line);
    }
  }

  /** \brief The room on both sides of a pixel, across the line; 0 if they differ or one
   * is farther than a wall is thick. */
  std::int32_t
  roomOnBothSides(std::size_t pixel, int thickness) const
  {
    int gap = 1;
    const auto look = [&](int sign) {
      for (int k = 1; k <= thickness; ++k, ++gap) {
        const int x = static_cast<int>(pixel / rooms_.ny) + (along_x_ ? 0 : sign * k);
        const int y = static_cast<int>(pixel % rooms_.ny) + (along_x_ ? sign * k : 0);
        if (!rooms_.contains(x, y))
          return 0;
        if (const std::int32_t room = rooms_.at(x, y))
          return room;
      }
      return 0;
    };
    const std::int32_t left = look(-1), right = look(1);
    return left == right && gap <= thickness ? left : 0;
  }

private:
  int
  shift(int step) const
  {
    return static_cast<int>(std::floor(step * slope_ + 0.5));
  }

  const Rooms& rooms_;
  bool along_x_;
  double slope_;
};

/** \brief Take the lines on which an inner wall goes on out of the rooms. */
void
cutAlong(const Eigen::Vector2d& direction,
         int thickness,
         double min_share,
         const Rooms& rooms,
         Rooms& cut)
{
  const LineWalker lines(rooms, direction);
  std::vector<std::int32_t> owner;
  lines.forEach([&](const std::vector<std::size_t>& line) {
    owner.resize(line.size());
    for (std::size_t i = 0; i < line.size(); ++i)
      owner[i] = rooms.values[line[i]] != 0 ? rooms.values[line[i]]
                                            : lines.roomOnBothSides(line[i], thickness);
    for (std::size_t begin = 0, end = 0; begin < line.size(); begin = end) {
      std::size_t wall = 0;
      for (end = begin; end < line.size() && owner[end] == owner[begin]; ++end)
        wall += rooms.values[line[end]] == 0;
      if (owner[begin] == 0 ||
          static_cast<double>(wall) < min_share * static_cast<double>(end - begin))
        continue;
      for (std::size_t i = begin; i < end; ++i)
        cut.values[line[i]] = 0;
    }
  });
}

} // namespace

void
divideAtInnerWalls(PixelMap<std::int32_t>& rooms,
                   std::int32_t& count,
                   const std::vector<Eigen::Vector2d>& directions,
                   int max_thickness,
                   double min_share,
                   double min_area)
{
  Rooms cut = rooms;
  for (const auto& direction : directions)
    cutAlong(direction, max_thickness, min_share, rooms, cut);
  if (cut.values == rooms.values)
    return;
  // The largest piece keeps the number of its room; others are rooms from some size on.
  std::vector<std::size_t> largest(count + 1, 0);
  forEachRegion(cut, Neighbours::Four, [&](const auto& piece) {
    std::size_t& size = largest[cut.values[piece.front()]];
    size = std::max(size, piece.size());
  });
  Rooms labels{rooms.nx, rooms.ny, {}};
  labels.values.assign(rooms.size(), 0);
  std::vector<std::uint8_t> is_taken(count + 1, 0);
  forEachRegion(cut, Neighbours::Four, [&](const auto& piece) {
    const std::int32_t room = cut.values[piece.front()];
    const bool is_first = !is_taken[room] && piece.size() == largest[room];
    if (!is_first && static_cast<double>(piece.size()) < min_area)
      return;
    is_taken[room] |= is_first;
    const std::int32_t label = is_first ? room : ++count;
    for (const std::size_t pixel : piece)
      labels.values[pixel] = label;
  });
  spreadValues(labels, [&](std::size_t from, std::size_t to) {
    return rooms.values[from] == rooms.values[to];
  });
  rooms = std::move(labels);
}

} // namespace indoor
} // namespace pcl
