/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "random/room_furnisher.h"

#include "plan/turned_rectangle.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

void
RoomFurnisher::putSmallObjects(int other, int count)
{
  constexpr const char* objects[] = {"books", "bottle", "vase", "cup", "cup", "plant"};
  for (int i = 0; i < count; ++i) {
    const std::string object = objects[pick(6)];
    const Piece small = object == "plant" ? shaped("plant", 2, 2) : piece(object);
    if (small.size.z() < 0.6)
      onTop(other, small, between(-0.5, 0.5));
  }
  if (chance(0.15)) {
    const double turn = between(-0.5, 0.5);
    onTop(other, piece("table_lamp"), turn);
  }
}

void
RoomFurnisher::workplace(const Piece& desk_piece,
                         const std::string& chair,
                         double free_standing)
{
  const int desk =
      chance(free_standing) ? inTheMiddle(desk_piece, 0.7) : atWall(desk_piece);
  if (desk < 0)
    return;
  const double width = sizeOf(desk).x();
  const bool goes_around = lived_in_ && sizeOf(desk).y() > 1.1; // its right end
  const double turn = between(-0.7, 0.7);
  const double aside = (between(-0.1, 0.1) - (goes_around ? 0.2 : 0.0)) * width;
  const double gap = between(-0.2, 0.1) - (goes_around ? sizeOf(desk).y() - 0.75 : 0.0);
  before(desk, piece(chair), gap, aside, turn);
  const auto put_turned = [&](const char* object, double most, bool at_rear = false) {
    const double way = between(-most, most);
    return onTop(desk, piece(object), way, at_rear);
  };
  if (chance(0.35))
    put_turned("laptop", 0.3);
  else
    for (int i = 1 + pick(2); i > 0; --i)
      if (put_turned("monitor", 0.15, true) >= 0 && chance(0.7))
        put_turned("keyboard", 0.2);
  if (chance(0.5))
    put_turned("table_lamp", 0.4);
  putSmallObjects(desk, pick(4));
  if (chance(0.3))
    onTop(desk, piece("printer"), 0, true);
  if (chance(0.5)) {
    const int side = chance(0.5) ? 1 : -1;
    beside(desk, shaped("drawers", 0, 0), side, 0.01);
  }
  else if (chance(0.5)) {
    const int side = chance(0.5) ? 1 : -1;
    beside(desk, piece("computer"), side, 0.03);
  }
}

std::vector<Piece>
RoomFurnisher::drawKitchen(int cabinets)
{
  constexpr const char* devices[] = {
      "dishwasher", "fridge", "washing_machine", "dishwasher"};
  const double top = between(0.84, 0.92);
  std::vector<Piece> row{chance(0.5) ? shaped("kitchen_unit", 2, 2)
                                     : shaped("sink", 3, 3),
                         piece("cooker")};
  for (int i = 0; i < cabinets; ++i)
    row.push_back(chance(0.35) ? piece(devices[pick(4)])
                               : shaped("kitchen_unit", 1, 1));
  for (std::size_t i = 1; i < row.size(); ++i)
    if (row[i].category != "fridge")
      row[i].size.z() = top;
  return row;
}

void
RoomFurnisher::kitchenRow(int cabinets)
{
  constexpr int attempts = 60;
  auto row = drawKitchen(cabinets);
  const double upper = chance(0.85) ? between(1.35, 1.5) : 0.0;
  for (; row.size() > 1; row.pop_back()) // as many as the walls have place for
    for (int attempt = 0; attempt < attempts; ++attempt) {
      Piece all;
      double width = 0;
      for (const auto& next : row) {
        all.size = all.size.cwiseMax(next.size);
        width += next.size.x();
      }
      all.size.x() = width;
      const Wall w = wall(pick(4));
      double along = placeAlong(w, all) - all.size.x() / 2;
      const Eigen::Vector2d middle =
          w.start + (along + all.size.x() / 2) * w.along + all.size.y() / 2 * w.inwards;
      if (!isFree(turnedRectangle(middle, all.size.head<2>(), w.rotation),
                  0.0,
                  all.size.z()))
        continue;
      for (const auto& next : row) {
        putInRow(next, w, along + next.size.x() / 2, upper);
        along += next.size.x();
      }
      return;
    }
}

void
RoomFurnisher::putInRow(const Piece& next, const Wall& w, double along, double upper)
{
  const Eigen::Vector2d at = w.start + along * w.along;
  const int placed = put(next, at + next.size.y() / 2 * w.inwards, w.rotation, 0.0);
  if (next.category == "kitchen_unit" && next.variant == 1) {
    if (chance(0.2))
      onTop(placed, piece("microwave"), 0, true);
    putSmallObjects(placed, pick(3));
  }
  if (upper == 0 || next.category == "fridge")
    return;
  Piece over =
      piece(next.category == "cooker" && chance(0.6) ? "range_hood" : "upper_cabinet");
  over.size.x() = next.size.x();
  put(over, at + over.size.y() / 2 * w.inwards, w.rotation, upper);
}

void
RoomFurnisher::curtains(double probability, const std::string& category)
{
  for (const auto& window : windows_) {
    if (!chance(probability))
      continue;
    Piece cloth = piece(category);
    const bool is_short = category == "blinds" || !chance(0.6);
    const double low = is_short ? std::max(0.02, window.sill - 0.1) : 0.02;
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

} // namespace pcl::indoor
