/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/shapes/solids.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace {

// A bar with clothes on hangers, open.
FurnitureClass
clothesRail(const Size& smallest, const Size& largest, bool on_wall)
{
  return fitted(
      "coat_rack",
      smallest,
      largest,
      [on_wall](PartMaker& make, const Size& size, RandomDraw& draw) {
        const double x = size.x() / 2, y = size.y() / 2, z = size.z();
        if (on_wall) {
          make.box("board", {-x, -y, x, -y + 0.02}, z - 0.1, z);
          for (int i = 0; i < 5; ++i)
            tube(make,
                 "hook",
                 {{(i - 2) * 0.42 * x, -y + 0.02, z - 0.05},
                  {(i - 2) * 0.42 * x, -0.5 * y, z - 0.09},
                  {(i - 2) * 0.42 * x, -0.4 * y, z - 0.02}},
                 0.006,
                 5);
        }
        else {
          for (const double s : {-x + 0.02, x - 0.02}) {
            tube(make, "post", {{s, 0, 0.02}, {s, 0, z - 0.02}}, 0.014);
            tube(make, "foot", {{s, -y, 0.015}, {s, y, 0.015}}, 0.014);
          }
          tube(make, "rail", {{-x, 0, z - 0.02}, {x, 0, z - 0.02}}, 0.014);
        }
        const int coats = 2 + draw.pick(4);
        for (int i = 0; i < coats; ++i) {
          const double at = draw.uniform(-0.85, 0.85) * x,
                       length = draw.uniform(0.45, 0.75) * z,
                       phase = draw.uniform(0, 6);
          const double wide = on_wall ? 0.5 * x / 2 : 0.03,
                       deep = on_wall ? 0.05 : 0.8 * y;
          sheet(
              make, "coat", {8, 5, 0.035}, [&](double u, double v) -> Eigen::Vector3d {
                const double t = (v + 1) / 2, shoulder = 0.06 * std::abs(u) * (1 - t);
                const Eigen::Vector3d along =
                    on_wall
                        ? Eigen::Vector3d(wide * u, -0.4 * y + deep * (1 - u * u), 0)
                        : Eigen::Vector3d(wide * (1 - u * u), deep * u, 0);
                return Eigen::Vector3d(at, 0, z - 0.06 - t * length - shoulder) +
                       along +
                       0.02 * t *
                           Eigen::Vector3d(
                               std::sin(6 * u + phase), std::sin(7 * u + phase), 0);
              });
        }
      },
      on_wall ? by_number : 0);
}

enum class Doors { Swing, Slide, Mirror, Louvre, Open };

/** A wardrobe. */
struct WardrobeStyle {
  Doors doors;
  Legs legs = Legs::Plinth;
  bool rounded = false, drawers = false;
};

void
slidingDoors(PartMaker& make, const Size& size, double low, bool mirror)
{
  const double x = size.x() / 2, y = size.y() / 2;
  const int doors = size.x() > 2.0 ? 3 : 2;
  const double width = (size.x() + 0.05 * (doors - 1)) / doors;
  for (int i = 0; i < doors; ++i) {
    const double left = -x + i * (width - 0.05), f = i % 2 == 0 ? y - 0.03 : y - 0.065;
    make.box("door", {left, f, left + width, f + 0.02}, low, size.z() - 0.04);
    if (mirror)
      make.box("mirror",
               {left + 0.1, f, left + width - 0.1, f + 0.05},
               low + 0.15,
               size.z() - 0.2);
  }
  make.box("track", {-x, y - 0.07, x, y}, size.z() - 0.04, size.z());
}

void
buildWardrobe(PartMaker& make,
              const Size& size,
              RandomDraw& draw,
              const WardrobeStyle& style)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               low = style.legs == Legs::Plinth ? 0.06 : 0.14;
  const double split = style.drawers ? low + 0.45 : low;
  const int columns = partsIn(size.x(), 0.5, 2);
  const bool slides = style.doors == Doors::Slide || style.doors == Doors::Mirror;
  legs(make, style.legs, {x, y - 0.03}, low, draw);
  if (style.doors == Doors::Open) {
    openCase(
        make, {Eigen::Vector3d(-x, -y, low), Eigen::Vector3d(x, y, z)}, 2, 1, true);
    row(make,
        "shelf",
        {{-x + 0.03, -y + 0.02, low + 0.3}, {-0.02, y - 0.02, low + 0.32}},
        {0, 0, 0.33},
        4);
    tube(make, "rail", {{0.02, 0, z - 0.12}, {x - 0.03, 0, z - 0.12}}, 0.012);
    for (int i = 0; i < 7; ++i)
      roundBox(make,
               "clothes",
               {0.06 + i * 0.12 * x, -0.8 * y, 0.11 + i * 0.12 * x, 0.8 * y},
               z - draw.uniform(0.8, 1.3),
               z - 0.15,
               0.024);
    return;
  }
  const Rectangle body{-x, -y, x, y - (slides ? 0.07 : 0.04)};
  style.rounded ? roundBox(make, "body", body, low, z, 0.05)
                : make.box("body", body, low, z);
  if (style.drawers)
    front(make, size, {std::max(1, columns / 2), 2, true, 1, low + 0.01, split});
  if (slides)
    return slidingDoors(make, size, low, style.doors == Doors::Mirror);
  front(make, size, {columns, 1, false, 1 + draw.pick(2), split + 0.01, z - 0.02});
  if (style.doors == Doors::Louvre)
    row(make,
        "louvre",
        {{-x + 0.06, y - 0.02, split + 0.1}, {x - 0.06, y - 0.01, split + 0.14}},
        {0, 0, 0.08},
        std::max(1, static_cast<int>((z - split - 0.2) / 0.08)));
}

FurnitureClass
wardrobe(const WardrobeStyle& style)
{
  return styled("wardrobe", {0.9, 0.5, 1.7}, {2.2, 0.68, 2.3}, style, buildWardrobe);
}

} // namespace

std::vector<FurnitureClass>
wardrobeShapes()
{
  return {
      clothesRail({0.8, 0.4, 1.4}, {1.4, 0.5, 1.7}, false),
      clothesRail({0.6, 0.15, 0.9}, {1.1, 0.25, 1.3}, true),
      wardrobe({Doors::Mirror}),
      wardrobe({Doors::Slide, Legs::Straight}),
      wardrobe({Doors::Swing, Legs::Plinth, true}),
      wardrobe({Doors::Swing, Legs::Tapered, false, true}),
      wardrobe({Doors::Louvre}),
      wardrobe({Doors::Open}),
  };
}

} // namespace pcl::indoor
