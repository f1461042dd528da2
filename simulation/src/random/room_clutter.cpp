/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "random/room_furnisher.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::indoor {

namespace {

// What has a level top to put objects on.
constexpr std::array<const char*, 12> supports{"bedside_table",
                                               "bench",
                                               "box",
                                               "cabinet",
                                               "coffee_table",
                                               "desk",
                                               "drawers",
                                               "kitchen_unit",
                                               "round_table",
                                               "table",
                                               "tv_unit",
                                               "washing_machine"};

constexpr double highest_support = 1.5;    // metres, which people still reach
constexpr double objects_per_metre2 = 8.0; // at most

Piece
smallObject(RoomFurnisher& room)
{
  constexpr std::array<const char*, 16> objects{"books",
                                                "books",
                                                "bottle",
                                                "box",
                                                "clutter",
                                                "clutter",
                                                "clutter",
                                                "clutter",
                                                "cup",
                                                "cup",
                                                "keyboard",
                                                "laptop",
                                                "monitor",
                                                "table_lamp",
                                                "vase",
                                                "printer"};
  return room.piece(objects[room.pick(static_cast<int>(objects.size()))]);
}

} // namespace

void
RoomFurnisher::pushTogether()
{
  constexpr std::array<const char*, 4> pushed{"desk", "table", "cabinet", "drawers"};
  const int count = static_cast<int>(furniture_.size());
  for (int i = 0; i < count; ++i) {
    const std::string category = furniture_[i].category;
    if (std::find(pushed.begin(), pushed.end(), category) == pushed.end() ||
        !chance(0.5))
      continue;
    Piece other = piece(category);
    if (chance(0.7)) // of one height
      other.size.z() = pieces_[i].size.z();
    const double gap = chance(0.6) ? 0.0 : between(0.0, 0.03);
    if (chance(0.6))
      beside(i, other, chance(0.5) ? 1 : -1, gap);
    else
      before(i, other, gap, 0.0, 0.0);
  }
}

void
RoomFurnisher::clutter()
{
  pushTogether();
  const int count = static_cast<int>(furniture_.size());
  for (int i = 0; i < count; ++i) {
    const auto& size = pieces_[i].size;
    const double top = *furniture_[i].elevation + size.z();
    if (std::find(supports.begin(), supports.end(), furniture_[i].category) ==
            supports.end() ||
        top > highest_support || !chance(0.7))
      continue;
    const double most = objects_per_metre2 * size.x() * size.y();
    int last = -1;
    for (int k = 1 + pick(1 + static_cast<int>(most)); k > 0; --k) {
      const Piece object = smallObject(*this);
      const double turn = chance(0.4) ? 0.0 : between(-M_PI, M_PI);
      const bool touches = last >= 0 && chance(0.35);
      int placed = -1;
      if (touches) {
        const double gap = between(0.0, 0.02);
        placed = beside(last, object, chance(0.5) ? 1 : -1, gap, top);
      }
      else
        placed = onTop(i, object, turn, chance(0.3));
      last = placed >= 0 ? placed : last;
      if (last >= 0 && chance(0.15)) {
        const double way = between(-M_PI, M_PI);
        onTop(last, smallObject(*this), way);
      }
    }
  }
  for (int i = pick(2 + static_cast<int>(size().prod() / 4)); i > 0; --i) {
    const Piece object =
        piece(chance(0.5) ? "clutter" : (chance(0.7) ? "box" : "chair"));
    if (chance(0.5))
      anywhere(object);
    else
      atWall(object);
  }
}

} // namespace pcl::indoor
