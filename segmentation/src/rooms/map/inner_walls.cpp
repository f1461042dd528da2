/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/inner_walls.h"

#include "rooms/space/line_bundle.h"
#include "rooms/space/map_regions.h"

#include <algorithm>
#include <utility>

namespace pcl::indoor {

namespace {

using Rooms = PixelMap<std::int32_t>;

/** \brief Walks the lines along a direction; each pixel lies on exactly one. */
class LineWalker {
public:
  LineWalker(const Rooms& rooms, const Eigen::Vector2d& direction)
  : rooms_(rooms)
  , shape_{rooms.nx, rooms.ny, 1}
  , lines_(shape_, direction)
  {}

  /** \brief Call visit(pixels of a line) for each line. */
  template <typename Visitor>
  void
  forEach(const Visitor& visit) const
  {
    std::vector<std::size_t> line;
    for (int l = 0; l < lines_.count; ++l) {
      line.clear();
      for (int i = 0; i < lines_.steps; ++i) {
        const int across = l + lines_.first + lines_.shift[i];
        if (across >= 0 && across < lines_.width)
          line.push_back(lines_.column(shape_, i, across));
      }
      visit(line);
    }
  }

  /** \brief The rooms, with what separates two parts of one, across the lines, by no
   * more than a wall is thick. */
  Rooms
  overWalls(int thickness) const
  {
    Rooms over = rooms_;
    for (int i = 0; i < lines_.steps; ++i) {
      const auto at = [&](int across) { return lines_.column(shape_, i, across); };
      int last = -1; // pixel of a room before this one
      for (int k = 0; k < lines_.width; ++k) {
        const std::int32_t room = rooms_.values[at(k)];
        if (room == 0)
          continue;
        if (last >= 0 && k - last - 1 <= thickness && rooms_.values[at(last)] == room)
          for (int wall = last + 1; wall < k; ++wall)
            over.values[at(wall)] = room;
        last = k;
      }
    }
    return over;
  }

private:
  const Rooms& rooms_;
  GridShape shape_;
  LineBundle lines_;
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
  const Rooms owner = lines.overWalls(thickness);
  lines.forEach([&](const std::vector<std::size_t>& line) {
    for (std::size_t begin = 0, end = 0; begin < line.size(); begin = end) {
      const std::int32_t room = owner.values[line[begin]];
      std::size_t wall = 0;
      for (end = begin; end < line.size() && owner.values[line[end]] == room; ++end)
        wall += rooms.values[line[end]] == 0;
      if (room == 0 ||
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
  auto labels = Rooms::filled(rooms.nx, rooms.ny, 0);
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

} // namespace pcl::indoor
