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

enum class Weave { Waves, Pleats, Sheer, Valance };

// Cloth in waves below a rail, drawn aside as far as it may be.
FurnitureClass
curtain(Weave kind)
{
  return fitted(
      "curtain",
      {1.0, 0.08, 1.2},
      {2.6, 0.2, 2.5},
      [kind](PartMaker& make, const Size& size, RandomDraw& draw) {
        const double x = size.x() / 2, y = size.y() / 2, z = size.z(), top = z - 0.03,
                     closed = kind == Weave::Sheer ? 1.0 : draw.uniform(0.25, 0.9);
        tube(make, "rail", {{-x, 0, z - 0.015}, {x, 0, z - 0.015}}, 0.012);
        const double pitch = kind == Weave::Pleats ? 0.09 : 0.15,
                     flare = kind == Weave::Waves ? 0.5 : 0.15;
        for (const double side : {-1.0, 1.0}) {
          const double wide = closed * x, phase = draw.uniform(0, 6);
          const int folds = std::max(2, static_cast<int>(wide / pitch));
          sheet(make,
                "cloth",
                {std::min(60, 8 * folds), 3, 0.006},
                [&](double u, double v) -> P {
                  const double t = (v + 1) / 2, a = M_PI * folds * u;
                  return {side *
                              (x - (u + 1) / 2 * wide * (1 - 0.1 * std::sin(M_PI * t))),
                          0.8 * y * (1 - flare * (1 - t)) *
                              std::sin(a + 0.6 * std::sin(2 * t + phase)),
                          top * (1 - t)};
                });
        }
        if (kind == Weave::Valance)
          sheet(make, "valance", {40, 1, 0.006}, [&](double u, double v) -> P {
            return {
                x * u, y * (0.8 + 0.2 * std::sin(30 * u)), top - (v + 1) / 2 * 0.25};
          });
      });
}

// Before a window: of slats, of cloth on a roll, of strips, folded.
FurnitureClass
blinds(int kind)
{
  return fitted(
      "blinds",
      {0.8, 0.04, 0.6},
      {2.0, kind == 2 ? 0.1 : 0.07, 2.2},
      [kind](PartMaker& make, const Size& size, RandomDraw& draw) {
        const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
                     drawn = draw.uniform(0.3, 1.0),
                     low = kind == 2 ? 0.0 : (1 - drawn) * (z - 0.1);
        roundBox(make, "case", {-x, -y, x, y}, z - 0.05, z, 0.012);
        if (kind == 0) {
          const double tilt = draw.uniform(0.2, 1.3), deep = 0.9 * y;
          const int slats =
              std::clamp(static_cast<int>((z - 0.06 - low) / 0.05), 2, 40);
          for (int i = 0; i < slats; ++i) {
            const double at = low + (z - 0.07 - low) * i / slats;
            sheet(make, "slat", {1, 1, 0.002}, [&](double u, double v) -> P {
              return {0.98 * x * u,
                      deep * v * std::cos(tilt),
                      at + 0.02 + deep * v * std::sin(tilt)};
            });
          }
          make.join(slats, "slats");
          return tube(make,
                      "cord",
                      {{0.9 * x, y - 0.005, z - 0.05}, {0.9 * x, y - 0.005, 0.1 * z}},
                      0.003,
                      4);
        }
        if (kind == 1) {
          tube(make,
               "roll",
               {{-0.98 * x, 0, z - 0.03}, {0.98 * x, 0, z - 0.03}},
               0.9 * y,
               10);
          make.box("cloth", {-0.97 * x, -0.004, 0.97 * x, 0.0}, low + 0.01, z - 0.03);
          make.box("hem", {-0.97 * x, -0.012, 0.97 * x, 0.012}, low, low + 0.03);
          return make.box("bead", {0.98 * x, -0.01, x, 0.0}, 0, z - 0.05);
        }
        if (kind == 2) {
          const int strips = std::clamp(static_cast<int>(2 * x / 0.11), 4, 24);
          const double turn = draw.uniform(0.2, 1.2);
          for (int i = 0; i < strips; ++i) {
            const double at = -x + (i + 0.5) * 2 * x / strips;
            sheet(make, "strip", {1, 1, 0.003}, [&](double u, double v) -> P {
              return {at + 0.05 * u * std::cos(turn),
                      0.9 * y * u * std::sin(turn),
                      (v + 1) / 2 * (z - 0.05)};
            });
          }
          return make.join(strips, "strips");
        }
        sheet(make,
              "cloth",
              {1, 40, 0.005},
              [&](double u, double v) -> P { // folds across
                return {0.97 * x * u,
                        0.9 * y * std::sin(30 * v),
                        low + (v + 1) / 2 * (z - 0.05 - low)};
              });
        make.box("cord", {0.97 * x, -0.01, x, 0}, 0, z - 0.05);
      });
}

enum class Filling { Square, Long, Round, Bolster, Leaning, Stacked };

FurnitureClass
pillowOf(Filling kind)
{
  const bool leans = kind == Filling::Leaning, stack = kind == Filling::Stacked;
  const Size smallest = leans ? Size(0.35, 0.18, 0.3) : Size(0.35, 0.3, 0.1),
             largest =
                 leans ? Size(0.6, 0.32, 0.5) : Size(0.65, 0.6, stack ? 0.45 : 0.22);
  return fitted(
      "pillow",
      smallest,
      largest,
      [kind](PartMaker& make, const Size& size, RandomDraw& draw) {
        const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
                     skew = draw.uniform(-0.12, 0.12);
        switch (kind) {
        case Filling::Round:
          return ellipsoid(make, "pillow", {0, 0, z / 2}, {x, y, z / 2});
        case Filling::Bolster:
          return tube(make,
                      "pillow",
                      {{-x, 0, z / 2},
                       {-0.93 * x, 0, z / 2},
                       {0.93 * x, 0, z / 2},
                       {x, 0, z / 2}},
                      z / 2,
                      12);
        case Filling::Leaning: // its lower edge in front, its upper edge behind
          return pillow(make,
                        "pillow",
                        {{0, 0, z / 2}, {x, 0, skew * z}, {0, -0.6 * y, 0.45 * z}},
                        0.12);
        case Filling::Stacked:
          for (int i = 0; i < 2 + draw.pick(2); ++i)
            pillow(make,
                   "pillow",
                   {{0.05 * x * i, 0, z * (0.2 + 0.33 * i)},
                    {x, skew * x * i, 0},
                    {-skew * y * i, 0.9 * y, 0}},
                   0.4 * z);
          return;
        case Filling::Long:
          return pillow(
              make, "pillow", {{0, 0, z / 2}, {x, 0, 0}, {skew * x, y, 0}}, z);
        default:
          return pillow(
              make, "pillow", {{0, 0, z / 2}, {x, skew * y, 0}, {-skew * x, y, 0}}, z);
        }
      });
}

// Cloth thrown down: humps and folds, thin at its edge.
FurnitureClass
thrown(const char* name, const Size& smallest, const Size& largest, double folds)
{
  return fitted(name,
                smallest,
                largest,
                [folds](PartMaker& make, const Size& size, RandomDraw& draw) {
                  double phase[6];
                  for (auto& p : phase)
                    p = draw.uniform(0, 6.3);
                  sheet(make, "cloth", {16, 16, 0.02}, [&](double u, double v) -> P {
                    const double a = std::atan2(v, u),
                                 r = std::max(std::abs(u), std::abs(v));
                    const double reach = r * (0.8 + 0.12 * std::sin(3 * a + phase[0]) +
                                              0.08 * std::sin(5 * a + phase[1]));
                    const double hump =
                        (1 - r * r) * (0.55 +
                                       0.25 * std::sin(folds * u + phase[2]) *
                                           std::cos(folds * v + phase[3]) +
                                       0.2 * std::sin(1.7 * folds * v + phase[4] + u));
                    return {0.5 * size.x() * reach * std::cos(a),
                            0.5 * size.y() * reach * std::sin(a),
                            size.z() * (0.05 + 0.9 * std::max(0.0, hump) +
                                        0.03 * std::sin(9 * a + phase[5]))};
                  });
                });
}

// Folded and laid down, one on another.
FurnitureClass
folded(const char* name, const Size& smallest, const Size& largest, int most)
{
  return fitted(
      name,
      smallest,
      largest,
      [most](PartMaker& make, const Size& size, RandomDraw& draw) {
        const int count = 1 + draw.pick(most);
        for (int i = 0; i < count; ++i) {
          const double x = size.x() / 2 * draw.uniform(0.85, 1.0),
                       y = size.y() / 2 * draw.uniform(0.85, 1.0),
                       low = i * size.z() / count, high = (i + 1) * size.z() / count;
          roundBox(make, "cloth", {-x, -y, x, y}, low, high, 0.45 * (high - low));
        }
      });
}

// Rolled up.
FurnitureClass
rolled(const char* name, const Size& smallest, const Size& largest)
{
  return fitted(
      name, smallest, largest, [](PartMaker& make, const Size& size, RandomDraw&) {
        const double x = size.x() / 2, r = size.z() / 2;
        Path spiral;
        for (int i = 0; i < 22; ++i)
          spiral.push_back({0,
                            r * (1 - 0.03 * i) * std::cos(0.6 * i),
                            r + r * (1 - 0.03 * i) * std::sin(0.6 * i)});
        sheet(make, "cloth", {2, 21, 0.012}, [&](double u, double v) -> P {
          const auto i = static_cast<std::size_t>(std::lround((v + 1) / 2 * 21));
          return spiral[i] + P(x * u, 0, 0);
        });
      });
}

// On a rail, a hook or a hanger on the wall.
FurnitureClass
hung(const char* name, const Size& smallest, const Size& largest, int kind)
{
  return fitted(
      name,
      smallest,
      largest,
      [kind](PartMaker& make, const Size& size, RandomDraw& draw) {
        const double x = size.x() / 2, y = size.y() / 2, z = size.z(),
                     phase = draw.uniform(0, 6), high = z - 0.02;
        if (kind == 0) { // over a rail, down on both sides
          tube(make,
               "rail",
               {{-x, -y, high}, {-x, 0, high}, {x, 0, high}, {x, -y, high}},
               0.01);
          const double wide = draw.uniform(0.6, 0.85) * x,
                       rear = draw.uniform(0.5, 0.9);
          return sheet(make, "cloth", {10, 12, 0.01}, [&](double u, double v) -> P {
            const double fall = v > 0 ? v * (z - 0.04) : -v * rear * (z - 0.04),
                         side = std::clamp(6 * v, -1.0, 1.0);
            return {wide * u,
                    side * 0.02 + side * fall * 0.04 * (1 + std::sin(8 * u + phase)),
                    z - 0.01 - fall - 0.01 * side * side};
          });
        }
        tube(make,
             "hook",
             {{0, -y, high}, {0, -0.5 * y, high - 0.02}, {0, -0.4 * y, z}},
             0.006,
             5);
        const double shoulder =
            kind == 1 ? 0.15 : 0.9; // gathered at one point, or on a hanger
        sheet(make,
              "cloth",
              {12, 8, kind == 2 ? 0.05 : 0.03},
              [&](double u, double v) -> P {
                const double t = (v + 1) / 2,
                             wide = x * (shoulder + (1 - shoulder) * std::sqrt(t));
                return {wide * u,
                        -0.2 * y + y * 0.6 * (1 - u * u) * (0.4 + 0.6 * t) +
                            0.1 * y * std::sin(9 * u + phase) * t,
                        high - 0.03 - t * (z - 0.08) -
                            (kind == 2 ? 0.1 * u * u * (1 - t) : 0.0)};
              });
        if (kind == 2) // sleeves
          for (const double s : {-1.0, 1.0})
            tube(make,
                 "sleeve",
                 {{s * 0.85 * x, -0.1 * y, high - 0.12},
                  {s * 0.95 * x, 0, 0.6 * z},
                  {s * 0.9 * x, 0.1 * y, 0.4 * z}},
                 0.05,
                 8);
      },
      by_number);
}

} // namespace

std::vector<FurnitureClass>
clothShapes()
{
  const Size heap_low(0.35, 0.3, 0.08), heap_high(0.8, 0.7, 0.28);
  return {
      curtain(Weave::Waves),
      curtain(Weave::Pleats),
      curtain(Weave::Sheer),
      curtain(Weave::Valance),
      blinds(0),
      blinds(1),
      blinds(2),
      blinds(3),
      pillowOf(Filling::Square),
      pillowOf(Filling::Leaning),
      pillowOf(Filling::Long),
      pillowOf(Filling::Round),
      pillowOf(Filling::Bolster),
      pillowOf(Filling::Stacked),
      thrown("blanket", {0.7, 0.6, 0.08}, {1.5, 1.2, 0.3}, 4),
      folded("blanket", {0.4, 0.3, 0.08}, {0.7, 0.55, 0.2}, 2),
      rolled("blanket", {0.5, 0.18, 0.18}, {0.9, 0.3, 0.3}),
      thrown("clothes", heap_low, heap_high, 6),
      thrown("clothes", heap_low, {0.6, 0.5, 0.4}, 9),
      folded("clothes", {0.25, 0.22, 0.06}, {0.4, 0.35, 0.35}, 6),
      hung("clothes", {0.4, 0.15, 0.7}, {0.6, 0.25, 1.2}, 2),
      hung("clothes", {0.25, 0.15, 0.6}, {0.45, 0.3, 1.1}, 1),
      hung("towel", {0.4, 0.1, 0.4}, {0.8, 0.16, 0.8}, 0),
      hung("towel", {0.2, 0.1, 0.4}, {0.35, 0.18, 0.8}, 1),
      folded("towel", {0.25, 0.2, 0.05}, {0.45, 0.35, 0.3}, 5),
      rolled("towel", {0.25, 0.1, 0.1}, {0.4, 0.16, 0.16}),
      thrown("towel", {0.35, 0.3, 0.05}, {0.6, 0.5, 0.15}, 5),
  };
}

} // namespace pcl::indoor
