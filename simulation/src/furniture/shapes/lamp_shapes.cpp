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

using P = Eigen::Vector3d;

enum class Shade { Cone, Drum, Bowl, Globe, Dish, Lantern, Bare, Bell };

// Open below, its upper end at z1.
void
addShade(PartMaker& make,
         Shade kind,
         const Eigen::Vector2d& at,
         double radius,
         double z0,
         double z1)
{
  const double h = z1 - z0, r = radius;
  const auto hollow = [&](std::vector<Turn> outside) {
    std::vector<Turn> both;
    for (auto turn = outside.rbegin(); turn != outside.rend(); ++turn)
      both.push_back({0.92 * turn->radius, turn->z - 0.004});
    both.insert(both.end(), outside.begin(), outside.end());
    lathe(make, "shade", at, both, 18);
  };
  switch (kind) {
  case Shade::Cone:
    return hollow({{r, z0}, {0.45 * r, z1}});
  case Shade::Drum:
    return hollow({{r, z0}, {r, z1}});
  case Shade::Bowl:
    return lathe(make,
                 "shade",
                 at,
                 {{0.3 * r, z0},
                  {0.7 * r, z0 + 0.15 * h},
                  {r, z1},
                  {0.9 * r, z1},
                  {0.4 * r, z0 + 0.3 * h}},
                 18);
  case Shade::Globe:
    return ellipsoid(make, "globe", {at.x(), at.y(), (z0 + z1) / 2}, {r, r, h / 2});
  case Shade::Dish:
    return hollow(
        {{r, z0}, {0.8 * r, z0 + 0.4 * h}, {0.2 * r, z0 + 0.7 * h}, {0.15 * r, z1}});
  case Shade::Bell:
    return hollow(
        {{r, z0}, {0.6 * r, z0 + 0.25 * h}, {0.5 * r, z0 + 0.7 * h}, {0.15 * r, z1}});
  case Shade::Lantern:
    for (const double sx : {-0.9, 0.9})
      for (const double sy : {-0.9, 0.9})
        tube(make,
             "post",
             {{at.x() + sx * r, at.y() + sy * r, z0},
              {at.x() + 0.9 * sx * r, at.y() + 0.9 * sy * r, z1 - 0.02}},
             0.008,
             4);
    make.box(
        "bottom", {at.x() - r, at.y() - r, at.x() + r, at.y() + r}, z0, z0 + 0.015);
    make.frustum(
        "roof",
        {at.x() - r, at.y() - r, at.x() + r, at.y() + r},
        z1 - 0.03,
        {at.x() - 0.3 * r, at.y() - 0.3 * r, at.x() + 0.3 * r, at.y() + 0.3 * r},
        z1);
    return lathe(make, "light", at, {{0.35 * r, z0 + 0.015}, {0.35 * r, z1 - 0.05}});
  case Shade::Bare:
    return lathe(make,
                 "bulb",
                 at,
                 {{0.1 * r, z0},
                  {0.35 * r, z0 + 0.3 * h},
                  {0.3 * r, z0 + 0.6 * h},
                  {0.14 * r, z1}});
  }
}

enum class Stem { Straight, Tripod, Arc, Bent, Column, Reading, Multi, Body };

/** A lamp that stands on a foot or legs. */
struct StandingStyle {
  Stem stem;
  Shade shade;
};

void
buildStanding(PartMaker& make,
              const Size& size,
              RandomDraw& draw,
              const StandingStyle& style)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(), r = std::min(x, y),
               h = draw.uniform(0.16, 0.28) * z, thin = std::min(0.012, 0.02 * z);
  const double foot = 0.7 * r;
  const auto disc = [&](double px) {
    lathe(make, "foot", {px, 0}, {{foot, 0}, {foot, 0.012}, {0.3 * foot, 0.03}}, 16);
  };
  switch (style.stem) {
  case Stem::Straight:
    disc(0);
    tube(make, "stem", {{0, 0, 0.02}, {0, 0, z - 0.4 * h}}, thin);
    return addShade(make, style.shade, {0, 0}, r, z - h, z);
  case Stem::Tripod:
    for (int i = 0; i < 3; ++i)
      tube(make,
           "leg",
           {{0.95 * r * std::cos(2.1 * i), 0.95 * r * std::sin(2.1 * i), 0},
            {0, 0, z - 0.8 * h}},
           1.2 * thin);
    return addShade(make, style.shade, {0, 0}, 0.8 * r, z - h, z);
  case Stem::Arc:
    disc(-x + foot);
    tube(make,
         "stem",
         arc({0.25 * x - 0.5 * foot, 0, 0.55 * z},
             {-(0.75 * x - 0.5 * foot), 0, 0},
             {0, 0, 0.45 * z - thin},
             -0.4,
             M_PI * 0.95,
             12),
         thin);
    return addShade(
        make, style.shade, {x - 0.8 * y, 0}, 0.8 * y, 0.62 * z, 0.62 * z + h);
  case Stem::Bent:
    disc(-0.3 * x);
    tube(make,
         "stem",
         {{-0.3 * x, 0, 0.02},
          {-0.3 * x, 0, 0.5 * z},
          {-0.15 * x, 0, 0.85 * z},
          {0.1 * x, 0, z},
          {0.4 * x, 0, 0.97 * z},
          {0.55 * x, 0, 0.9 * z}},
         thin);
    return addShade(make, style.shade, {0.6 * x, 0}, 0.4 * r, 0.9 * z - h, 0.9 * z);
  case Stem::Column:
    make.box("foot", {-0.6 * r, -0.6 * r, 0.6 * r, 0.6 * r}, 0, 0.02);
    return style.shade == Shade::Lantern
               ? roundBox(make,
                          "light",
                          {-0.5 * r, -0.5 * r, 0.5 * r, 0.5 * r},
                          0.02,
                          z,
                          0.03)
               : lathe(make,
                       "light",
                       {0, 0},
                       {{0.5 * r, 0.02},
                        {r, 0.3 * z},
                        {0.7 * r, 0.6 * z},
                        {0.9 * r, 0.85 * z},
                        {0.5 * r, z}},
                       16);
  case Stem::Reading:
    disc(-0.2 * x);
    tube(make,
         "arm",
         {{-0.2 * x, 0, 0.02},
          {-0.7 * x, 0, 0.5 * z},
          {0.2 * x, 0, z - 0.02},
          {0.6 * x, 0, 0.85 * z}},
         thin);
    return addShade(make, style.shade, {0.6 * x, 0}, 0.38 * x, 0.85 * z - h, 0.87 * z);
  case Stem::Multi:
    disc(0);
    tube(make, "stem", {{0, 0, 0.02}, {0, 0, 0.95 * z}}, thin);
    for (int i = 0; i < 3; ++i) {
      const double a = 2.1 * i, top = z * (1 - 0.15 * i);
      tube(make,
           "arm",
           {{0, 0, top - 0.12 * z},
            {0.6 * x * std::cos(a), 0.6 * y * std::sin(a), top - 0.05 * z}},
           0.7 * thin);
      addShade(make,
               style.shade,
               {0.6 * x * std::cos(a), 0.6 * y * std::sin(a)},
               0.35 * r,
               top - 0.12 * z,
               top);
    }
    return;
  case Stem::Body: {
    const double b = draw.uniform(0.45, 0.75) * r;
    lathe(make,
          "body",
          {0, 0},
          {{0.6 * b, 0},
           {b, 0.2 * z},
           {0.8 * b, 0.4 * z},
           {0.2 * b, 0.55 * z},
           {0.15 * b, 0.7 * z}});
    return addShade(make, style.shade, {0, 0}, r, 0.6 * z, z);
  }
  }
}

FurnitureClass
standing(const char* name,
         const Size& smallest,
         const Size& largest,
         const StandingStyle& style)
{
  return styled(name, smallest, largest, style, buildStanding);
}

/** A lamp below a ceiling. */
struct HangingStyle {
  Shade shade;
  int count = 1; ///< of shades, in a row or (above 4) around a ring
  bool ring = false;
};

void
buildHanging(PartMaker& make,
             const Size& size,
             RandomDraw& draw,
             const HangingStyle& style)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
               high = std::min(z, draw.uniform(0.2, 0.35));
  const double r = style.ring ? 0.3 * std::min(x, y) : std::min(y, x / style.count);
  lathe(make, "rose", {0, 0}, {{0.03, z - 0.03}, {0.05, z - 0.01}, {0.05, z}});
  if (style.ring)
    tube(make,
         "ring",
         arc({0, 0, 0.5 * high}, {x - r, 0, 0}, {0, y - r, 0}, 0, 1.99 * M_PI, 20),
         0.012,
         5);
  else if (style.count > 1)
    make.box("bar", {-x + 0.5 * r, -0.02, x - 0.5 * r, 0.02}, z - 0.03, z);
  for (int i = 0; i < style.count; ++i) {
    const double a = 2 * M_PI * i / style.count;
    const Eigen::Vector2d at =
        style.ring ? Eigen::Vector2d((x - r) * std::cos(a), (y - r) * std::sin(a))
                   : Eigen::Vector2d(-x + (2 * i + 1) * x / style.count, 0);
    const double drop =
        style.count > 1 && !style.ring ? draw.uniform(0, 0.3) * (z - high) : 0.0;
    if (z - high > 0.02)
      tube(make,
           "cord",
           {{style.ring ? 0.0 : at.x(), style.ring ? 0.0 : at.y(), z - 0.02},
            {at.x(), at.y(), drop + 0.8 * high}},
           0.004,
           4);
    addShade(make, style.shade, at, r, drop, drop + high);
  }
}

FurnitureClass
hanging(const Size& smallest, const Size& largest, const HangingStyle& style)
{
  return styled("ceiling_lamp", smallest, largest, style, buildHanging, 1);
}

// Flat on the ceiling: panels, trays, bowls, tubes.
FurnitureClass
flush(const Size& smallest, const Size& largest, double corner, double bulge, int like)
{
  return fitted(
      "ceiling_lamp",
      smallest,
      largest,
      [=](PartMaker& make, const Size& size, RandomDraw&) {
        const double x = size.x() / 2, y = size.y() / 2, z = size.z();
        make.loft("lamp",
                  {-x, -y, x, y},
                  {{1 - bulge, 0, corner},
                   {1 - 0.3 * bulge, 0.3 * z, corner},
                   {1, 0.7 * z, corner},
                   {1, z, corner}},
                  28);
      },
      like);
}

void
tubeLamp(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  make.box("tray", {-x, -0.6 * y, x, 0.6 * y}, 0.6 * z, z);
  for (int i = 0; i < 1 + draw.pick(2); ++i)
    tube(make,
         "tube",
         {{-0.95 * x, (i - 0.5) * y, 0.25 * z}, {0.95 * x, (i - 0.5) * y, 0.25 * z}},
         0.013);
}

void
fan(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double r = size.x() / 2, z = size.z();
  const int count = 3 + draw.pick(3);
  tube(make, "rod", {{0, 0, z}, {0, 0, 0.3 * z}}, 0.015);
  lathe(make,
        "motor",
        {0, 0},
        {{0.05, 0.1 * z}, {0.1, 0.2 * z}, {0.1, 0.35 * z}, {0.03, 0.5 * z}});
  ellipsoid(make, "light", {0, 0, 0.08 * z}, {0.08, 0.08, 0.08 * z});
  for (int i = 0; i < count; ++i) {
    const double a = 2 * M_PI * i / count;
    const P out(std::cos(a), std::sin(a), 0), side(-out.y(), out.x(), 0.2);
    sheet(make, "blade", {2, 3, 0.008}, [&](double u, double v) -> P {
      return P(0, 0, 0.25 * z) + (0.1 + (v + 1) / 2 * (r - 0.1)) * out +
             0.07 * u * side;
    });
  }
}

FurnitureClass
sconce(const Size& smallest, const Size& largest, Shade shade, bool arm)
{
  return fitted(
      "wall_lamp",
      smallest,
      largest,
      [=](PartMaker& make, const Size& size, RandomDraw& draw) {
        const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
                     r = std::min(x, arm ? 0.5 * y : 0.9 * y);
        roundBox(
            make, "plate", {-0.4 * x, -y, 0.4 * x, -y + 0.02}, 0.2 * z, 0.7 * z, 0.008);
        const double at = arm ? y - r : -y + r;
        tube(make,
             "arm",
             {{0, -y + 0.02, 0.3 * z},
              {0, 0.3 * at, draw.uniform(0.15, 0.3) * z},
              {0, at, 0.45 * z}},
             0.008);
        addShade(make, shade, {0, at}, r, 0.4 * z, z);
      });
}

} // namespace

std::vector<FurnitureClass>
lampShapes()
{
  const Size tall_low(0.3, 0.3, 1.35), tall_high(0.5, 0.5, 1.85),
      long_low(0.5, 0.28, 1.4), long_high(0.9, 0.38, 1.9), desk_low(0.2, 0.2, 0.3),
      desk_high(0.42, 0.42, 0.7);
  const Size hung_low(0.25, 0.25, 0.4), hung_high(0.6, 0.6, 1.0),
      row_low(0.7, 0.2, 0.5), row_high(1.3, 0.32, 1.0);
  return {
      standing("floor_lamp", tall_low, tall_high, {Stem::Straight, Shade::Drum}),
      standing("floor_lamp", tall_low, tall_high, {Stem::Straight, Shade::Bowl}),
      standing("floor_lamp", tall_low, tall_high, {Stem::Tripod, Shade::Drum}),
      standing("floor_lamp", long_low, long_high, {Stem::Bent, Shade::Bell}),
      standing("floor_lamp", long_low, long_high, {Stem::Reading, Shade::Cone}),
      standing(
          "floor_lamp", {1.0, 0.35, 1.7}, {1.5, 0.45, 2.1}, {Stem::Arc, Shade::Dish}),
      standing("floor_lamp",
               {0.25, 0.25, 1.0},
               {0.4, 0.4, 1.6},
               {Stem::Column, Shade::Lantern}),
      standing("floor_lamp", tall_low, tall_high, {Stem::Multi, Shade::Globe}),
      standing("table_lamp", desk_low, desk_high, {Stem::Body, Shade::Cone}),
      standing("table_lamp",
               {0.35, 0.18, 0.35},
               {0.6, 0.22, 0.6},
               {Stem::Reading, Shade::Bell}),
      standing("table_lamp", desk_low, desk_high, {Stem::Straight, Shade::Globe}),
      standing("table_lamp", desk_low, desk_high, {Stem::Tripod, Shade::Drum}),
      standing("table_lamp",
               {0.14, 0.14, 0.25},
               {0.25, 0.25, 0.45},
               {Stem::Column, Shade::Bowl}),
      hanging(hung_low, hung_high, {Shade::Cone}),
      hanging(hung_low, hung_high, {Shade::Dish}),
      hanging(hung_low, hung_high, {Shade::Lantern}),
      hanging(hung_low, hung_high, {Shade::Bell}),
      hanging(row_low, row_high, {Shade::Bell, 3}),
      hanging(row_low, row_high, {Shade::Globe, 4}),
      hanging({0.6, 0.6, 0.5}, {1.0, 1.0, 1.0}, {Shade::Bare, 6, true}),
      hanging({0.6, 0.6, 0.5}, {1.0, 1.0, 1.0}, {Shade::Bowl, 5, true}),
      flush({0.6, 0.6, 0.05}, {0.62, 1.25, 0.1}, 0.05, 0.0, 0),
      flush({0.25, 0.25, 0.06}, {0.6, 0.6, 0.15}, 0.2, 0.15, 3),
      flush({0.3, 0.3, 0.1}, {0.55, 0.55, 0.2}, 1.0, 0.6, 3),
      fitted("ceiling_lamp", {1.1, 0.12, 0.06}, {1.6, 0.2, 0.12}, tubeLamp, 0),
      fitted("ceiling_lamp", {0.9, 0.9, 0.3}, {1.3, 1.3, 0.5}, fan, 3),
      sconce({0.15, 0.15, 0.2}, {0.3, 0.25, 0.35}, Shade::Cone, true),
      sconce({0.12, 0.12, 0.15}, {0.25, 0.2, 0.3}, Shade::Globe, true),
      sconce({0.15, 0.15, 0.25}, {0.22, 0.2, 0.4}, Shade::Drum, false),
      sconce({0.15, 0.18, 0.25}, {0.22, 0.25, 0.4}, Shade::Lantern, false),
  };
}

} // namespace pcl::indoor
