/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/shapes/solids.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace pcl::indoor {

namespace {

/** A case: how it stands, its doors or drawers, and what is open. */
struct CaseStyle {
  Legs legs = Legs::Plinth;
  double open = 0.0; ///< share of its height that is open shelves, above
  int columns = 0;   ///< of doors; 0: as wide as 0.5 m
  int rows = 1;      ///< of doors or drawers
  bool drawers = false;
  int handle = 1;       ///< as Front
  bool round = false;   ///< rounded edges
  bool cornice = false; ///< a moulding along its top
  bool back = true;     ///< open shelves have a back
};

void
buildCase(PartMaker& make, const Size& size, RandomDraw& draw, const CaseStyle& style)
{
  const double x = size.x() / 2, y = size.y() / 2,
               low = style.legs == Legs::Plinth ? draw.uniform(0.04, 0.1)
                                                : draw.uniform(0.1, 0.2);
  const double high = size.z() - (style.cornice ? 0.07 : 0.0),
               split = high - style.open * (high - low);
  const int columns =
      style.columns > 0 ? style.columns : partsIn(size.x(), draw.uniform(0.42, 0.58));
  legs(make, style.legs, {x, y - 0.02}, low, draw);
  if (style.open < 1) {
    if (style.round)
      roundBox(make, "body", {-x, -y, x, y - 0.04}, low, split, 0.03);
    else
      make.box("body", {-x, -y, x, y - 0.04}, low, split);
    front(make,
          size,
          {columns, style.rows, style.drawers, style.handle, low + 0.01, split - 0.01});
  }
  if (style.open > 0)
    openCase(make,
             {Eigen::Vector3d(-x, -y, split),
              Eigen::Vector3d(x, y - (style.open < 1 ? 0.05 : 0.0), high)},
             std::max(1, columns / 2),
             partsIn(high - split, draw.uniform(0.28, 0.4)),
             style.back);
  if (style.cornice)
    make.frustum("cornice",
                 {-x + 0.02, -y, x - 0.02, y - 0.02},
                 high,
                 {-x - 0.02, -y, x + 0.02, y + 0.02},
                 size.z());
}

FurnitureClass
cased(const char* name,
      const Size& smallest,
      const Size& largest,
      const CaseStyle& style,
      int like = 0)
{
  return styled(name, smallest, largest, style, buildCase, like);
}

// A grid of square bays, some of them with drawers or doors.
void
cubes(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2;
  const int columns = partsIn(size.x(), 0.36), rows = partsIn(size.z(), 0.36);
  openCase(make,
           {Eigen::Vector3d(-x, -y, 0), Eigen::Vector3d(x, y, size.z())},
           columns,
           rows,
           draw.pick(2) == 0);
  const double wide = size.x() / columns, pitch = size.z() / rows;
  for (int i = 0; i < columns * rows; ++i)
    if (draw.pick(4) == 0) {
      const double left = -x + (i % columns) * wide + 0.025,
                   low = (i / columns) * pitch + 0.025;
      make.box("drawer",
               {left, -y + 0.02, left + wide - 0.05, y - 0.01},
               low,
               low + pitch - 0.06);
    }
}

// Boards that lean on a wall, deeper below: a ladder.
void
ladderShelf(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  const int boards = 4 + draw.pick(2);
  for (const double s : {-x + 0.015, x - 0.015}) {
    tube(make, "post", {{s, y - 0.02, 0}, {s, -y + 0.02, z}}, 0.015, 4);
    tube(make, "post", {{s, -y + 0.02, 0}, {s, -y + 0.02, z}}, 0.015, 4);
  }
  for (int i = 0; i < boards; ++i) {
    const double t = (i + 0.4) / boards;
    make.box("shelf",
             {-x + 0.03, -y, x - 0.03, y - 0.04 - t * (2 * y - 0.1)},
             t * z,
             t * z + 0.02);
  }
}

// Boards on posts of wire or wood.
FurnitureClass
posted(const char* name, const Size& smallest, const Size& largest, bool wire)
{
  return fitted(name,
                smallest,
                largest,
                [wire](PartMaker& make, const Size& size, RandomDraw& draw) {
                  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
                               r = wire ? 0.01 : 0.02;
                  const int boards = 3 + draw.pick(3);
                  for (const double sx : {-x + r, x - r})
                    for (const double sy : {-y + r, y - r})
                      tube(make, "post", {{sx, sy, 0}, {sx, sy, z}}, r, wire ? 6 : 4);
                  for (int i = 0; i < boards; ++i) {
                    const double low = 0.1 + i * (z - 0.15) / (boards - 1);
                    if (!wire) {
                      make.box("shelf",
                               {-x + 0.01, -y + 0.01, x - 0.01, y - 0.01},
                               low,
                               low + 0.025);
                      continue;
                    }
                    row(make,
                        "wire",
                        {{-x + r, -y + r, low}, {x - r, -y + r + 0.012, low + 0.012}},
                        {0, (2 * y - 2 * r) / 12, 0},
                        12);
                    make.join(12, "shelf");
                  }
                });
}

// Boards around a corner or of different lengths on a wall.
void
staggeredShelf(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  const int boards = 2 + draw.pick(2);
  for (int i = 0; i < boards; ++i) {
    const double low = i * (z - 0.03) / (boards - 1 > 0 ? boards - 1 : 1),
                 left = i % 2 == 0 ? -x : -0.4 * x, right = i % 2 == 0 ? 0.4 * x : x;
    roundBox(make, "shelf", {left, -y, right, y}, low, low + 0.03, 0.01);
    for (const double s : {left + 0.08, right - 0.1})
      make.frustum("bracket",
                   {s, -y, s + 0.02, -y + 0.03},
                   std::max(0.0, low - 0.1),
                   {s, -y, s + 0.02, 0.6 * y},
                   low + 0.005);
  }
}

void
boxShelf(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2;
  const int rows = 1 + draw.pick(2), bays = 1 + draw.pick(3);
  openCase(make,
           {Eigen::Vector3d(-x, -y, 0), Eigen::Vector3d(x, y, size.z())},
           bays,
           rows,
           true);
}

// A case with a curved front, or one that stands in a corner.
void
bowFront(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  legs(make, Legs::Tapered, {0.9 * x, 0.8 * y}, 0.14, draw);
  sheet(make, "body", {10, 1, 1.2 * y}, [&](double u, double v) -> Eigen::Vector3d {
    return {x * u, 0.35 * y * (1 - u * u) - 0.3 * y, 0.14 + (v + 1) / 2 * (z - 0.16)};
  });
  make.loft("top", {-x, -y, x, y}, {{1, z - 0.03, 0.4}, {1, z, 0.4}}, 28);
  for (int i = 0; i < 3; ++i)
    ellipsoid(
        make, "knob", {0, 0.68 * y, 0.25 + i * 0.28 * (z - 0.2)}, {0.02, 0.02, 0.02});
}

// A block of drawers on castors.
void
pedestalDrawers(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  for (const double sx : {-x + 0.04, x - 0.04})
    for (const double sy : {-y + 0.04, y - 0.08})
      ellipsoid(make, "castor", {sx, sy, 0.025}, {0.022, 0.022, 0.025});
  roundBox(make, "body", {-x, -y, x, y - 0.04}, 0.05, z, 0.015);
  front(make, size, {1, 3 + draw.pick(2), true, 3, 0.06, z - 0.01});
}

} // namespace

std::vector<FurnitureClass>
storageShapes()
{
  const Size tall_low(0.6, 0.26, 1.5), tall_high(1.4, 0.4, 2.2),
      low_low(0.8, 0.28, 0.7), low_high(1.6, 0.4, 1.2);
  const Size side_low(1.0, 0.38, 0.65), side_high(2.0, 0.5, 0.95),
      high_low(0.7, 0.38, 1.3), high_high(1.2, 0.5, 2.1);
  const Size chest_low(0.5, 0.4, 0.6), chest_high(1.4, 0.55, 1.25),
      tv_low(1.0, 0.36, 0.32), tv_high(2.0, 0.5, 0.6);
  CaseStyle glazed{Legs::Straight, 0.6, 2, 1, false, 2},
      hutch{Legs::Plinth, 0.5, 0, 1, false, 1};
  hutch.cornice = true;
  return {
      cased("bookcase", tall_low, tall_high, {Legs::Plinth, 1.0}),
      cased("bookcase",
            tall_low,
            tall_high,
            {Legs::Straight, 1.0, 2, 1, false, 0, false, false, false}),
      cased("bookcase", tall_low, tall_high, {Legs::Plinth, 0.65, 2}),
      cased("bookcase", low_low, low_high, {Legs::Tapered, 1.0}),
      fitted("bookcase", {0.7, 0.3, 0.75}, {1.5, 0.4, 1.9}, cubes),
      fitted("bookcase", {0.5, 0.35, 1.6}, {0.9, 0.5, 2.0}, ladderShelf),
      posted("bookcase", {0.6, 0.28, 1.2}, {1.1, 0.4, 2.0}, false),
      cased("cabinet", side_low, side_high, {Legs::Tapered, 0.0, 0, 1, false, 3}),
      cased("cabinet", side_low, side_high, {Legs::Plinth, 0.0, 0, 1, false, 2, true}),
      cased("cabinet", side_low, side_high, {Legs::Hairpin, 0.4, 0, 1, false, 1}),
      cased("cabinet", high_low, high_high, {Legs::Plinth, 0.0, 2, 2, false, 1}),
      cased("cabinet", high_low, high_high, hutch),
      cased("cabinet", high_low, high_high, glazed),
      cased("cabinet",
            high_low,
            {1.2, 0.5, 1.5},
            {Legs::Sled, 0.0, 2, 1, false, 2, true}),
      fitted("cabinet", {0.8, 0.4, 0.75}, {1.3, 0.5, 1.0}, bowFront),
      cased("drawers", chest_low, chest_high, {Legs::Tapered, 0.0, 1, 4, true, 2}, 1),
      cased("drawers", chest_low, chest_high, {Legs::Plinth, 0.0, 2, 3, true, 3}, 1),
      cased("drawers",
            {0.35, 0.4, 0.9},
            {0.5, 0.5, 1.4},
            {Legs::Plinth, 0.0, 1, 6, true, 1},
            1),
      fitted("drawers", {0.38, 0.45, 0.52}, {0.48, 0.6, 0.68}, pedestalDrawers, 0),
      posted("rack", {0.8, 0.35, 1.5}, {1.3, 0.6, 2.0}, true),
      posted("rack", {0.8, 0.4, 1.5}, {1.8, 0.6, 2.2}, false),
      fitted("rack", {0.6, 0.25, 1.2}, {1.0, 0.4, 1.8}, ladderShelf),
      fitted("shelf", {0.6, 0.18, 0.3}, {1.4, 0.28, 0.8}, staggeredShelf),
      fitted("shelf", {0.4, 0.18, 0.3}, {1.2, 0.3, 0.9}, boxShelf),
      cased("tv_unit", tv_low, tv_high, {Legs::Tapered, 0.5, 4, 1, false, 0}),
      cased("tv_unit", tv_low, tv_high, {Legs::Plinth, 0.0, 3, 1, true, 3}),
      cased("tv_unit", tv_low, tv_high, {Legs::Sled, 1.0, 4}),
      cased("tv_unit", tv_low, tv_high, {Legs::Hairpin, 0.0, 0, 1, false, 2, true}),
  };
}

} // namespace pcl::indoor
