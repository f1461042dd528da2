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

enum class Growth { Blades, Broad, Tree, Hanging, Cactus, Bamboo, Fern };

/** A plant in a pot. */
struct PlantStyle {
  Growth growth;
  bool square = false; ///< its pot
};

double
pot(PartMaker& make, const Size& size, RandomDraw& draw, bool square)
{
  const double r = std::min({0.5 * size.x(), 0.5 * size.y(), 0.2}) *
                   draw.uniform(0.6, 0.95),
               z = std::min(0.35, draw.uniform(0.15, 0.3) * size.z());
  make.vessel(
      "pot", {-r, -r, r, r}, 0, z, draw.uniform(0.65, 1.0), 1.0, square ? 0.1 : 1.0);
  return z;
}

// A leaf as broad as long, on a stalk.
void
broadLeaves(PartMaker& make, const P& root, const P& reach, int count, RandomDraw& draw)
{
  for (int i = 0; i < count; ++i) {
    const double a = 2 * M_PI * i / count + draw.uniform(0, 0.6),
                 up = draw.uniform(0.3, 1.0),
                 out = draw.uniform(0.4, 0.9) * (1.2 - 0.5 * up),
                 s = draw.uniform(0.5, 1.0);
    const P way(std::cos(a), std::sin(a), 0), side(-way.y(), way.x(), 0);
    const P tip = root + out * way.cwiseProduct(P(reach.x(), reach.y(), 0)) +
                  P(0, 0, up * reach.z());
    tube(make,
         "stalk",
         {root, root + 0.4 * (tip - root) + P(0, 0, 0.2 * reach.z()), tip},
         0.006,
         4);
    const double w = 0.22 * s * std::max(reach.x(), reach.y()) + 0.02;
    sheet(make, "leaf", {2, 4, 0.004}, [&](double u, double v) -> P {
      const double t = (v + 1) / 2, wide = std::sqrt(std::max(0.0, 1 - v * v)) + 0.03;
      return tip + 1.6 * w * t * way + w * 0.7 * wide * u * side +
             P(0, 0, -0.7 * w * t * t + 0.1 * w * std::abs(u));
    });
  }
  make.join(2 * count, "leaves");
}

void
buildPlant(PartMaker& make, const Size& size, RandomDraw& draw, const PlantStyle& style)
{
  const double z = size.z(), low = pot(make, size, draw, style.square);
  const P soil(0, 0, 0.85 * low), reach(0.5 * size.x(), 0.5 * size.y(), z - low);
  switch (style.growth) {
  case Growth::Blades:
    return blades(make,
                  "leaves",
                  soil,
                  reach.cwiseProduct(P(0.7, 0.7, 1)),
                  14 + draw.pick(10),
                  0.05,
                  draw);
  case Growth::Fern:
    return blades(make,
                  "leaves",
                  soil,
                  reach.cwiseProduct(P(1, 1, 0.6)),
                  20 + draw.pick(12),
                  0.035,
                  draw);
  case Growth::Broad:
    return broadLeaves(make, soil, reach, 10 + draw.pick(8), draw);
  case Growth::Tree: {
    const double crown = low + draw.uniform(0.4, 0.6) * (z - low);
    tube(make, "stem", {soil, {0.02, 0.01, 0.5 * crown}, {0, 0, crown + 0.1}}, 0.02);
    return broadLeaves(make,
                       {0, 0, crown},
                       {reach.x(), reach.y(), z - crown},
                       18 + draw.pick(10),
                       draw);
  }
  case Growth::Hanging:
    for (int i = 0; i < 10; ++i) {
      const double a = 0.63 * i, far = draw.uniform(0.7, 1.0),
                   fall = draw.uniform(0.2, 0.9) * low;
      tube(make,
           "shoot",
           {soil,
            {0.5 * far * reach.x() * std::cos(a),
             0.5 * far * reach.y() * std::sin(a),
             low + draw.uniform(0.4, 1.0) * reach.z()},
            {far * reach.x() * std::cos(a), far * reach.y() * std::sin(a), low},
            {0.95 * far * reach.x() * std::cos(a),
             0.95 * far * reach.y() * std::sin(a),
             low - fall}},
           0.02,
           4);
    }
    return make.join(10, "leaves");
  case Growth::Cactus: {
    const double r = 0.3 * std::min(reach.x(), reach.y());
    lathe(make,
          "cactus",
          {0, 0},
          {{0.8 * r, soil.z()},
           {r, low + 0.4 * reach.z()},
           {0.9 * r, z - r},
           {0.5 * r, z - 0.2 * r},
           {0, z}});
    for (const double s : {-1.0, 1.0})
      tube(make,
           "arm",
           {{0, 0, low + 0.3 * reach.z()},
            {s * 0.8 * reach.x(), 0, low + 0.35 * reach.z()},
            {s * 0.85 * reach.x(), 0, low + draw.uniform(0.5, 0.8) * reach.z()}},
           0.5 * r);
    return;
  }
  case Growth::Bamboo:
    for (int i = 0; i < 6; ++i) {
      const P foot(
          0.4 * reach.x() * std::cos(i), 0.4 * reach.y() * std::sin(i), soil.z());
      tube(
          make,
          "cane",
          {foot,
           {1.3 * foot.x(), 1.3 * foot.y(), low + draw.uniform(0.7, 0.98) * reach.z()}},
          0.012,
          5);
      broadLeaves(
          make,
          {1.2 * foot.x(), 1.2 * foot.y(), low + draw.uniform(0.4, 0.7) * reach.z()},
          {0.6 * reach.x(), 0.6 * reach.y(), 0.3 * reach.z()},
          5,
          draw);
    }
    return;
  }
}

FurnitureClass
plant(const Size& smallest, const Size& largest, const PlantStyle& style, int like)
{
  return styled("plant", smallest, largest, style, buildPlant, like);
}

// A turned vase; with branches if wanted.
FurnitureClass
vase(double foot, double belly, double at, double neck, bool branches)
{
  return fitted("vase",
                {0.1, 0.1, branches ? 0.4 : 0.15},
                {0.28, 0.28, branches ? 0.9 : 0.5},
                [=](PartMaker& make, const Size& size, RandomDraw& draw) {
                  const double z = branches ? 0.45 * size.z() : size.z(),
                               r = (branches ? 0.25 : 0.5) *
                                   std::min(size.x(), size.y());
                  lathe(make,
                        "vase",
                        {0, 0},
                        {{foot * r, 0},
                         {belly * r, at * z},
                         {neck * r, 0.85 * z},
                         {(neck + 0.1) * r, z},
                         {0.85 * neck * r, z},
                         {0.6 * neck * r, 0.5 * z}},
                        18);
                  if (branches)
                    blades(make,
                           "branches",
                           {0, 0, 0.8 * z},
                           {0.5 * size.x(), 0.5 * size.y(), size.z() - 0.8 * z},
                           7 + draw.pick(6),
                           0.02,
                           draw);
                });
}

} // namespace

std::vector<FurnitureClass>
plantShapes()
{
  const Size small(0.2, 0.2, 0.25), large(0.5, 0.5, 0.9), tall_low(0.4, 0.4, 0.9),
      tall_high(0.9, 0.9, 1.9);
  return {
      plant(tall_low, {0.7, 0.7, 1.5}, {Growth::Blades}, 0),
      plant(tall_low, tall_high, {Growth::Broad, true}, 0),
      plant(tall_low, tall_high, {Growth::Tree}, 0),
      plant(tall_low, tall_high, {Growth::Bamboo, true}, 0),
      plant({0.2, 0.2, 0.4}, {0.5, 0.4, 1.4}, {Growth::Cactus}, 0),
      plant(small, large, {Growth::Fern}, 2),
      plant(small, large, {Growth::Broad}, 2),
      plant(small, {0.5, 0.5, 0.5}, {Growth::Hanging}, 2),
      plant({0.12, 0.12, 0.2}, {0.25, 0.25, 0.45}, {Growth::Blades, true}, 2),
      vase(0.5, 1.0, 0.35, 0.3, false),
      vase(1.0, 0.9, 0.5, 0.95, false),
      vase(0.4, 1.0, 0.6, 0.5, true),
      vase(0.9, 0.8, 0.3, 0.35, true),
  };
}

} // namespace pcl::indoor
