/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "room_furnisher.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace indoor {

void
RoomFurnisher::putSmallThings(int other, int count)
{
  constexpr const char* things[] = {"books", "bottle", "vase", "cup", "cup", "plant"};
  for (int i = 0; i < count; ++i) {
    const std::string thing = things[pick(6)];
    const Piece small = thing == "plant" ? shaped("plant", 2, 2) : piece(thing);
    if (small.size.z() < 0.6)
      onTop(other, small, between(-0.5, 0.5));
  }
  if (chance(0.15))
    onTop(other, piece("table_lamp"), between(-0.5, 0.5));
}

void
RoomFurnisher::workplace(const Piece& desk_piece, const std::string& chair)
{
  const int desk = chance(0.75) ? atWall(desk_piece) : inTheMiddle(desk_piece, 0.7);
  if (desk < 0)
    return;
  const double width = sizeOf(desk).x();
  before(desk,
         piece(chair),
         between(-0.2, 0.1),
         between(-0.1, 0.1) * width,
         between(-0.7, 0.7));
  if (chance(0.35))
    onTop(desk, piece("laptop"), between(-0.3, 0.3));
  else
    for (int i = 1 + pick(2); i > 0; --i)
      if (onTop(desk, piece("monitor"), between(-0.15, 0.15), true) >= 0 && chance(0.7))
        onTop(desk, piece("keyboard"), between(-0.2, 0.2));
  if (chance(0.5))
    onTop(desk, piece("table_lamp"), between(-0.4, 0.4));
  putSmallThings(desk, pick(4));
  if (chance(0.3))
    onTop(desk, piece("printer"), 0, true);
  if (chance(0.5))
    beside(desk, shaped("drawers", 0, 0), chance(0.5) ? 1 : -1, 0.01);
  else if (chance(0.5))
    beside(desk, piece("computer"), chance(0.5) ? 1 : -1, 0.03);
}

void
RoomFurnisher::kitchenRow(int cabinets)
{
  const double top = between(0.84, 0.92);
  int last = atWall(chance(0.5) ? shaped("kitchen_unit", 2, 2) : shaped("sink", 3, 3));
  const int first = last;
  const double upper = chance(0.8) ? between(1.35, 1.5) : 0.0;
  int side = 1;
  for (int i = 0; i < cabinets && last >= 0; ++i) {
    constexpr const char* kinds[] = {
        "cooker", "dishwasher", "fridge", "washing_machine"};
    Piece next = shaped("kitchen_unit", 1, 1);
    if (i == 0 || chance(0.35))
      next = i == 0 ? piece("cooker") : piece(kinds[pick(4)]);
    if (next.category != "fridge")
      next.size.z() = top;
    int placed = beside(last, next, side, 0.0);
    if (placed < 0 && side > 0) { // go on at the other end
      side = -1;
      placed = beside(first, next, side, 0.0);
    }
    if (placed < 0)
      break;
    last = placed;
    if (next.category == "kitchen_unit") {
      if (chance(0.2))
        onTop(placed, piece("microwave"), 0, true);
      putSmallThings(placed, pick(3));
    }
    const auto& base = furniture_[last];
    Piece over = next.category == "cooker" && chance(0.6) ? piece("range_hood")
                                                          : piece("upper_cabinet");
    over.size.x() = next.size.x();
    const Eigen::Vector2d back(-std::sin(base.rotation), std::cos(base.rotation));
    const Eigen::Vector2d at = base.at - (next.size.y() - over.size.y()) / 2 * back;
    if (upper > 0 && next.category != "fridge")
      put(over, at, base.rotation, upper);
  }
}

void
RoomFurnisher::curtains(double probability)
{
  for (const auto& window : windows_) {
    if (!chance(probability))
      continue;
    Piece cloth = piece("curtain");
    const double low = chance(0.6) ? 0.02 : std::max(0.02, window.sill - 0.1);
    cloth.size.x() = window.width + between(0.2, 0.5);
    cloth.size.z() = std::min(window.top + 0.15, ceiling_) - low;
    const Eigen::Vector2d inwards(-std::sin(window.rotation),
                                  std::cos(window.rotation));
    const Eigen::Vector2d at = window.at + (cloth.size.y() / 2 + 0.01) * inwards;
    for (std::size_t i = 0; i < obstacles_.size(); ++i) // the window's own place
      if (obstacles_[i].piece < 0 && contains(obstacles_[i].footprint, at)) {
        const auto kept = obstacles_[i];
        obstacles_.erase(obstacles_.begin() + static_cast<std::ptrdiff_t>(i));
        put(cloth, at, window.rotation, low);
        obstacles_.push_back(kept);
        break;
      }
  }
}

} // namespace indoor
} // namespace pcl
