/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/part_maker.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace {

using Size = Eigen::Vector3d;

void
wardrobe(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               plinth = draw.uniform(0.03, 0.1);
  make.box("plinth", {-x + 0.01, -y, x - 0.01, y - 0.06}, 0, plinth);
  make.box("body", {-x, -y, x, y - 0.04}, plinth, z);
  const int doors = partsIn(size.x(), draw.uniform(0.4, 0.55));
  fronts(make, size, doors, plinth, z - 0.01, draw.pick(4) > 0);
}

// With a cornice and drawers below the doors.
void
farmWardrobe(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               low = draw.uniform(0.3, 0.5);
  cornerPosts(make, "foot", {-x + 0.03, -y, x - 0.09, y - 0.1}, 0.06, 0.1);
  make.box("body", {-x + 0.03, -y, x - 0.03, y - 0.04}, 0.1, z - 0.08);
  make.frustum(
      "cornice", {-x + 0.03, -y, x - 0.03, y - 0.03}, z - 0.08, {-x, -y, x, y}, z);
  const Size inner(size.x() - 0.06, size.y(), z);
  fronts(make, inner, 2, low + 0.02, z - 0.1, true);
  make.box("drawer", {-x + 0.05, y - 0.04, x - 0.05, y - 0.02}, 0.13, low);
}

// Two doors that slide before each other.
void
slidingWardrobe(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.box("body", {-x, -y, x, y - 0.08}, 0, z);
  const int doors = size.x() > 2.0 ? 3 : 2;
  const double width = (size.x() + 0.06 * (doors - 1)) / doors;
  for (int i = 0; i < doors; ++i) {
    const double left = -x + i * (width - 0.06),
                 front = i % 2 == 0 ? y - 0.005 : y - 0.045;
    make.box("door", {left, front - 0.03, left + width, front}, 0.02, z - 0.03);
  }
  make.box("track", {-x, y - 0.08, x, y}, z - 0.03, z);
  if (draw.pick(2) == 0)
    make.box("track", {-x, y - 0.08, x, y}, 0, 0.02);
}

// Boards, seen through, with some books and boxes on them.
void
openShelves(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               t = draw.uniform(0.018, 0.03);
  make.box("side", {-x, -y, -x + t, y}, 0, z);
  make.box("side", {x - t, -y, x, y}, 0, z);
  if (draw.pick(2) == 0)
    make.box("back", {-x + t, -y, x - t, -y + 0.008}, 0, z);
  const int columns = size.x() > 1.1 ? 2 : 1,
            rows = partsIn(z, draw.uniform(0.28, 0.42));
  if (columns == 2)
    make.box("side", {-t / 2, -y + 0.01, t / 2, y}, 0, z);
  const double pitch = (z - t) / rows, share = draw.uniform();
  for (int i = 0; i <= rows; ++i) {
    make.box("shelf", {-x + t, -y + 0.01, x - t, y}, i * pitch, i * pitch + t);
    if (i == rows || draw.uniform() > share)
      continue;
    const double left = draw.uniform(-x + t, 0.3 * x),
                 wide = draw.uniform(0.1, 0.6) * x;
    const double high = pitch * draw.uniform(0.3, 0.85),
                 front = draw.uniform(0.2, 0.9) * y;
    make.box("things",
             {left, -y + 0.02, std::min(left + wide, x - t), front},
             i * pitch + t,
             i * pitch + t + high);
  }
}

// Shelves above, doors below.
void
dresser(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               low = draw.uniform(0.3, 0.45) * z;
  make.box("body", {-x, -y, x, y - 0.04}, 0, low);
  fronts(make, size, partsIn(size.x(), 0.5), 0.05, low - 0.01, true);
  for (const double s : {-x, x - 0.02})
    make.box("side", {s, -y, s + 0.02, 0.7 * y}, low, z);
  const int rows = 2 + draw.pick(2);
  for (int i = 1; i <= rows; ++i) {
    const double at = low + (z - low) * i / rows - 0.02;
    make.box("shelf", {-x + 0.02, -y, x - 0.02, 0.7 * y}, at, at + 0.02);
    if (draw.pick(2) == 0)
      make.box("things",
               {draw.uniform(-0.9, -0.2) * x,
                -y + 0.02,
                draw.uniform(0.0, 0.9) * x,
                0.5 * y},
               at - 0.6 * (z - low) / rows,
               at - 0.02);
  }
  make.box("back", {-x + 0.02, -y, x - 0.02, -y + 0.01}, low, z);
}

// A long low one on legs.
void
sideboard(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               leg = draw.uniform(0.08, 0.2);
  roundLegs(make, x - 0.06, y - 0.06, 0.02, leg, 0.02);
  make.box("body", {-x, -y, x, y - 0.04}, leg, z);
  const bool handles = draw.pick(2) == 0;
  fronts(make, size, 2 + draw.pick(3), leg + 0.02, z - 0.02, handles);
}

// Metal, for papers: two doors or drawers, no plinth.
void
filingCabinet(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.box("body", {-x, -y, x, y - 0.03}, 0, z);
  if (draw.pick(2) == 0)
    return fronts(make, {size.x(), size.y() - 0.01, z}, 2, 0.05, z - 0.02, true);
  const int count = partsIn(z, 0.35, 2);
  for (int i = 0; i < count; ++i) {
    const double low = 0.04 + i * (z - 0.06) / count;
    make.box("drawer",
             {-x + 0.01, y - 0.03, x - 0.01, y - 0.01},
             low,
             low + (z - 0.06) / count - 0.015);
    make.box("handle", {-0.06, y - 0.01, 0.06, y}, low + 0.15, low + 0.17);
  }
}

void
chestOfDrawers(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               leg = draw.uniform(0.0, 0.15);
  if (leg > 0.04)
    roundLegs(make, x - 0.02, y - 0.04, 0.02, leg, 0.0);
  const double low = leg > 0.04 ? leg : 0.0;
  make.box("body", {-x + 0.01, -y, x - 0.01, y - 0.04}, low, z - 0.025);
  make.box("top", {-x, -y, x, y - 0.01}, z - 0.025, z);
  const int rows = 3 + draw.pick(3), columns = size.x() > 0.95 ? 2 : 1;
  const double pitch = (z - low - 0.05) / rows, width = (2 * x - 0.04) / columns;
  for (int i = 0; i < rows * columns; ++i) {
    const double left = -x + 0.02 + (i % columns) * width,
                 bottom = low + 0.02 + (i / columns) * pitch;
    make.box("drawer",
             {left + 0.005, y - 0.04, left + width - 0.005, y - 0.02},
             bottom,
             bottom + pitch - 0.012);
    make.box("knob",
             {left + width / 2 - 0.02, y - 0.02, left + width / 2 + 0.02, y},
             bottom + pitch / 2,
             bottom + pitch / 2 + 0.025);
  }
}

void
tvUnit(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(), t = 0.025;
  const int bays = 2 + draw.pick(2);
  make.box("top", {-x, -y, x, y}, z - t, z);
  make.box("bottom", {-x, -y, x, y - 0.02}, 0.04, 0.04 + t);
  make.box("plinth", {-x + 0.03, -y + 0.03, x - 0.03, y - 0.05}, 0, 0.04);
  for (int i = 0; i <= bays; ++i) {
    const double at = -x + i * (2 * x - t) / bays;
    make.box("side", {at, -y, at + t, y - 0.01}, 0.04 + t, z - t);
    if (i < bays && draw.pick(2) == 0)
      make.box("door",
               {at + t, y - 0.04, at + (2 * x - t) / bays, y - 0.02},
               0.06 + t,
               z - t - 0.005);
  }
}

// Boards on a wall with objects on them.
void
wallShelf(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  const int boards = z > 0.4 ? 2 : 1;
  for (int i = 0; i < boards; ++i) {
    const double low = i * 0.6 * z;
    make.box("shelf", {-x, -y, x, y}, low, low + 0.025);
    double left = -x + draw.uniform(0.0, 0.3);
    while (left < x - 0.1) {
      const double wide = std::min(draw.uniform(0.03, 0.15), x - left);
      const double top =
                       std::min(z, low + 0.025 + draw.uniform(0.25, 0.6) * z / boards),
                   front = draw.uniform(-0.2, 0.9) * y;
      make.box("thing", {left, -y + 0.01, left + wide, front}, low + 0.025, top);
      left += wide + (draw.pick(2) == 0 ? 0.0 : draw.uniform(0.05, 0.4));
    }
  }
}

// A rail with coats.
void
coatRack(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.loft("foot", {-0.7 * x, -0.7 * y, 0.7 * x, 0.7 * y}, {{1, 0}, {0.9, 0.03}});
  make.rod("pole", {0, 0, 0.03}, {0, 0, z}, 0.02, 8);
  for (int i = 0; i < 6; ++i) {
    const double c = std::cos(M_PI * i / 3), s = std::sin(M_PI * i / 3);
    make.rod("hook", {0, 0, z - 0.18}, {0.8 * x * c, 0.8 * y * s, z - 0.06}, 0.012);
    if (draw.pick(2) == 0)
      make.loft("coat",
                {0.3 * x * c - 0.4 * x,
                 0.3 * y * s - 0.4 * y,
                 0.3 * x * c + 0.4 * x,
                 0.3 * y * s + 0.4 * y},
                {{0.9, z - 1.1}, {1, z - 0.6}, {0.4, z - 0.15}},
                10);
  }
}

} // namespace

std::vector<FurnitureClass>
storageVariants()
{
  return {{"wardrobe", {0.8, 0.45, 1.65}, {1.8, 0.62, 2.3}, wardrobe},
          {"wardrobe", {0.9, 0.5, 1.7}, {1.3, 0.62, 2.1}, farmWardrobe},
          {"wardrobe", {1.2, 0.55, 1.9}, {2.4, 0.68, 2.3}, slidingWardrobe},
          {"bookcase", {0.7, 0.25, 0.8}, {1.6, 0.42, 2.2}, openShelves},
          {"bookcase", {0.4, 0.25, 1.6}, {0.7, 0.35, 2.1}, openShelves},
          {"cabinet", {0.9, 0.38, 1.6}, {1.4, 0.5, 2.1}, dresser},
          {"cabinet", {1.2, 0.38, 0.6}, {2.2, 0.5, 0.95}, sideboard},
          {"cabinet", {0.8, 0.4, 0.7}, {1.2, 0.5, 1.95}, filingCabinet},
          {"drawers", {0.7, 0.4, 0.7}, {1.4, 0.56, 1.2}, chestOfDrawers},
          {"tv_unit", {1.0, 0.36, 0.35}, {2.0, 0.5, 0.6}, tvUnit},
          {"tv_unit", {1.2, 0.36, 0.4}, {2.0, 0.48, 0.6}, sideboard},
          {"shelf", {0.5, 0.16, 0.25}, {1.2, 0.28, 0.7}, wallShelf},
          {"coat_rack", {0.45, 0.45, 1.6}, {0.6, 0.6, 1.85}, coatRack}};
}

} // namespace pcl::indoor
