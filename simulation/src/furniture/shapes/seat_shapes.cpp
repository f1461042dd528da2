/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/shapes/seating_kit.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace {

// A log, a tower, a cube, a sack: seats of one body.
FurnitureClass
pouf(const Size& smallest, const Size& largest, double corner, double waist)
{
  return fitted(
      "stool",
      smallest,
      largest,
      [=](PartMaker& make, const Size& size, RandomDraw&) {
        const double x = size.x() / 2, y = size.y() / 2, z = size.z();
        make.loft("pouf",
                  {-x, -y, x, y},
                  {{0.9, 0, corner},
                   {1, 0.15 * z, corner},
                   {waist, 0.5 * z, corner},
                   {1, 0.85 * z, corner},
                   {0.88, 0.97 * z, corner},
                   {0.4, z, corner}},
                  20);
      },
      2);
}

// A bag of beads, sunk where one sits.
void
beanbag(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double dent = draw.uniform(0.2, 0.45);
  std::vector<Path> rings;
  for (int i = 0; i <= 7; ++i) {
    const double t = i / 7.0;
    Path ring;
    for (int k = 0; k < 16; ++k) {
      const double a = 2 * M_PI * k / 16,
                   r = std::sqrt(std::max(0.02, 1 - std::pow(1.7 * t - 0.7, 2)));
      const double front = std::max(0.0, std::sin(a));
      ring.push_back({0.5 * r * size.x() * std::cos(a),
                      0.5 * r * size.y() * std::sin(a) - 0.1 * t * size.y(),
                      size.z() * t * (1 - dent * front * t)});
    }
    rings.push_back(ring);
  }
  skin(make, "sack", rings);
}

void
foldingChair(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2 - 0.012, y = size.y() / 2,
               seat = size.z() * draw.uniform(0.5, 0.55);
  for (const double s : {-x, x}) {
    tube(make,
         "leg",
         {{s, y, 0}, {s, -0.2 * y, 0.62 * size.z()}, {s, -0.9 * y, size.z()}},
         0.012);
    tube(make, "leg", {{s, -y, 0}, {s, 0.75 * y, seat}}, 0.012);
  }
  row(make,
      "slat",
      {{-x, -0.6 * y, seat}, {x, -0.6 * y + 0.05, seat + 0.015}},
      {0, 0.28 * y, 0},
      5);
  row(make,
      "slat",
      {{-x, -0.75 * y, 0.76 * size.z()}, {x, -0.75 * y + 0.015, 0.83 * size.z()}},
      {0, -0.14 * y, 0.11 * size.z()},
      2);
}

void
rockingChair(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const Frame f{size.x() / 2 - 0.03,
                0.55 * size.y() / 2,
                -0.6 * size.y() / 2,
                0.42 * size.z(),
                size.z()};
  legs(make, Legs::Splayed, {f.x, f.y}, f.seat, draw);
  for (const double s : {-f.x, f.x})
    tube(make,
         "rocker",
         arc({s, 0, 1.1 * size.y()},
             {0, 1.12 * size.y(), 0},
             {0, 0, 1.12 * size.y()},
             -2.04,
             -1.1,
             8),
         0.018);
  addSeat(make, Seat::Saddle, f);
  addBack(make, Back::Bars, f);
  addArms(make, Arms::Thin, f);
}

// Leans far back, with a foot rest.
void
recliner(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2,
               seat = draw.uniform(0.4, 0.5) * size.z();
  legs(make, Legs::Skirt, {0.7 * x, 0.5 * y}, 0.5 * seat, draw);
  sheet(make, "body", {6, 14, 0.14}, [&](double u, double v) -> Eigen::Vector3d {
    const double t = v * y;
    const double bend = v < -0.2   ? (-0.2 - v) * 1.2 * (size.z() - seat)
                        : v > 0.45 ? -(v - 0.45) * 0.4 * seat
                                   : 0.03;
    return {0.78 * x * u, t, seat + bend - 0.04 * (1 - u * u)};
  });
  for (const double s : {-1.0, 1.0})
    roundBox(make,
             "armrest",
             {s > 0 ? 0.78 * x : -x, -0.5 * y, s > 0 ? x : -0.78 * x, 0.4 * y},
             0.2 * seat,
             seat + 0.2,
             0.05);
}

void
slatBench(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2;
  legs(make,
       draw.pick(2) == 0 ? Legs::Crossed : Legs::Sled,
       {0.9 * x, y},
       size.z() - 0.03,
       draw);
  row(make,
      "slat",
      {{-x, -y, size.z() - 0.03}, {x, -0.68 * y, size.z()}},
      {0, 0.42 * y, 0},
      5);
}

void
chestBench(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z() - 0.08;
  make.box("body", {-x, -y, x, y - 0.04}, 0, z);
  front(make, size, {2 + draw.pick(2), 1, true, draw.pick(4), 0.03, z - 0.02});
  roundBox(make, "cushion", {-x, -y, x, y}, z, size.z(), 0.035);
}

} // namespace

std::vector<FurnitureClass>
seatShapes()
{
  const Size low(0.42, 0.44, 0.78), high(0.52, 0.54, 0.95), wide(0.52, 0.5, 0.76),
      wider(0.62, 0.6, 0.9);
  const Size bar_low(0.36, 0.36, 0.85), bar_high(0.46, 0.46, 1.1),
      disc_low(0.3, 0.3, 0.42), disc_high(0.42, 0.42, 0.75);
  const Size task_low(0.58, 0.58, 0.9), task_high(0.7, 0.7, 1.2),
      easy_low(0.65, 0.7, 0.75), easy_high(0.95, 0.95, 1.05);
  const Size bench_low(0.9, 0.32, 0.42), bench_high(1.6, 0.45, 0.5);
  const auto range = [](const char* name, const Size& smallest, const Size& largest) {
    return
        [=](const Seating& style) { return seating(name, smallest, largest, style); };
  };
  const auto chair = range("chair", low, high);
  const auto wideChair = range("chair", wide, wider);
  const auto task = range("office_chair", task_low, task_high);
  const auto easy = range("armchair", easy_low, easy_high);
  const auto stool = range("stool", disc_low, disc_high);
  const auto barStool = range("stool", bar_low, bar_high);
  return {
      chair({Legs::Tapered, Seat::Saddle, Back::Ladder}),
      chair({Legs::Splayed, Seat::Saddle, Back::Bars}),
      chair({Legs::Straight, Seat::Padded, Back::Padded}),
      chair({Legs::Tapered, Seat::Cushion, Back::Board}),
      chair({Legs::Hairpin, Seat::Board, Back::Curved}),
      wideChair({Legs::Tapered, Seat::Padded, Back::Curved, Arms::Thin}),
      wideChair({Legs::Splayed, Seat::Board, Back::Slats, Arms::Loop}),
      wideChair({Legs::Sled, Seat::Padded, Back::Mesh, Arms::Thin}),
      wideChair({Legs::Straight, Seat::Cushion, Back::Tufted}),
      chair({Legs::Panels, Seat::Board, Back::Board}),
      chair({Legs::Star, Seat::Padded, Back::Curved}),
      wideChair({Legs::Pedestal, Seat::Cushion, Back::Round}),
      shell("chair", wide, wider, Legs::Hairpin),
      shell("chair", wide, wider, Legs::Splayed),
      fitted("chair", {0.42, 0.46, 0.76}, {0.5, 0.6, 0.9}, foldingChair),
      fitted("chair", {0.52, 0.7, 0.9}, {0.65, 0.95, 1.1}, rockingChair),
      task({Legs::Castors, Seat::Padded, Back::Mesh, Arms::None, 0.46}),
      task({Legs::Castors, Seat::Padded, Back::Mesh, Arms::Thin, 0.46}),
      task({Legs::Castors, Seat::Thick, Back::Tufted, Arms::Loop, 0.45}),
      task({Legs::Castors, Seat::Padded, Back::Padded, Arms::None, 0.5}),
      task({Legs::Castors, Seat::Saddle, Back::Board, Arms::None, 0.5}),
      task({Legs::Star, Seat::Cushion, Back::Curved, Arms::Loop, 0.48}),
      shell("office_chair", task_low, {0.68, 0.68, 1.0}, Legs::Castors),
      easy({Legs::Skirt, Seat::Thick, Back::Tufted, Arms::Thick, 0.5}),
      easy({Legs::Tapered, Seat::Thick, Back::Padded, Arms::Rounded, 0.5}),
      seating("armchair",
              easy_low,
              {0.9, 0.95, 1.2},
              {Legs::Tapered, Seat::Thick, Back::Tufted, Arms::Wings, 0.42}),
      easy({Legs::Splayed, Seat::Cushion, Back::Slats, Arms::Thin, 0.48}),
      easy({Legs::Pedestal, Seat::Thick, Back::Round, Arms::None, 0.5}),
      easy({Legs::Sled, Seat::Cushion, Back::Padded, Arms::Thin, 0.48}),
      easy({Legs::Plinth, Seat::Thick, Back::Round, Arms::None, 0.52}),
      fitted("armchair", {0.75, 1.2, 0.85}, {0.95, 1.65, 1.1}, recliner),
      fitted("armchair", {0.75, 0.8, 0.6}, {1.0, 1.1, 0.85}, beanbag),
      stool({Legs::Tapered, Seat::Round, Back::None}),
      stool({Legs::Crossed, Seat::Board, Back::None}),
      stool({Legs::Castors, Seat::Round, Back::None}),
      stool({Legs::Hairpin, Seat::Saddle, Back::None}),
      barStool({Legs::Splayed, Seat::Padded, Back::Curved, Arms::None, 0.72}),
      barStool({Legs::Pedestal, Seat::Padded, Back::Board, Arms::None, 0.74}),
      barStool({Legs::Sled, Seat::Board, Back::Slats, Arms::None, 0.72}),
      pouf({0.38, 0.38, 0.36}, {0.6, 0.6, 0.48}, 0.3, 1.0),
      pouf({0.32, 0.32, 0.42}, {0.42, 0.42, 0.5}, 1.0, 0.7),
      seating(
          "bench", bench_low, bench_high, {Legs::Tapered, Seat::Cushion, Back::None}),
      seating("bench",
              {0.9, 0.45, 0.8},
              {1.5, 0.6, 0.95},
              {Legs::Tapered, Seat::Board, Back::Bars, Arms::Thin, 0.5}),
      fitted("bench", bench_low, bench_high, slatBench),
      fitted("bench", bench_low, bench_high, chestBench),
  };
}

} // namespace pcl::indoor
