/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "random/room_furnisher.h"

#include "furniture/catalogue.h"
#include "plan/turned_rectangle.h"

#include <pcl/simulation/furniture.h>

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace {

constexpr double touch = 1e-4; // metres: what only touches does not collide

Eigen::Vector2d
sidewards(double rotation)
{
  return {std::cos(rotation), std::sin(rotation)};
}

Eigen::Vector2d
forwards(double rotation)
{
  return {-std::sin(rotation), std::cos(rotation)};
}

// The shapes first to last; in lived-in rooms also all that stand for one of them.
// Shapes that are drawn by number only are left out where there is no last one.
std::vector<int>
drawnShapes(const std::string& category, bool lived_in, int first, int last)
{
  const auto& shapes = shapesOf(category);
  const int plain = plainShapes(category), count = static_cast<int>(shapes.size());
  std::vector<int> drawn;
  for (int i = 0; i < (lived_in ? count : plain); ++i) {
    const int like = i < plain ? i : shapes[static_cast<std::size_t>(i)].like;
    const bool asked = i >= first && i <= last && (last < count || like != by_number);
    if (asked || (like >= first && like <= last))
      drawn.push_back(i);
  }
  return drawn;
}

} // namespace

RoomFurnisher::RoomFurnisher(const LayoutRoom& room,
                             const std::vector<LayoutOpening>& openings,
                             int number,
                             double wall_thickness,
                             double ceiling,
                             std::uint32_t seed)
: inner_(room.outline)
, ceiling_(ceiling)
, draw_(seed)
{
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(wall_thickness / 2);
  inner_.min() += half;
  inner_.max() -= half;
  for (const auto& opening : openings) {
    if (opening.rooms[0] != number && opening.rooms[1] != number)
      continue;
    const auto& plan = opening.plan;
    for (int k = 0; k < 4; ++k) {
      const Wall w = wall(k);
      const Eigen::Vector2d from_start = plan.at - w.start;
      if (std::abs(from_start.dot(w.inwards) + wall_thickness / 2) > 1e-6)
        continue;
      const Eigen::Vector2d face = w.start + from_start.dot(w.along) * w.along;
      const bool is_window = plan.kind == OpeningKind::Window;
      if (is_window)
        windows_.push_back(
            {face, w.rotation, plan.width, plan.sill, plan.sill + plan.height});
      // Before a window nothing tall, before a door nothing at all.
      const double depth = is_window ? 0.2 : plan.width + 0.05;
      block(turnedRectangle(
                face + depth / 2 * w.inwards, {plan.width + 0.1, depth}, w.rotation),
            is_window ? plan.sill + 0.02 : 0.0,
            plan.sill + plan.height);
    }
  }
}

RoomFurnisher::Wall
RoomFurnisher::wall(int number) const
{
  const Eigen::Vector2d corners[4] = {inner_.min(),
                                      {inner_.max().x(), inner_.min().y()},
                                      inner_.max(),
                                      {inner_.min().x(), inner_.max().y()}};
  Wall w;
  w.rotation = number * M_PI / 2;
  w.start = corners[number];
  w.length = (corners[(number + 1) % 4] - w.start).norm();
  w.along = sidewards(w.rotation);
  w.inwards = forwards(w.rotation);
  return w;
}

Piece
RoomFurnisher::piece(const std::string& category,
                     const std::optional<Eigen::Vector3d>& size)
{
  Piece result;
  result.category = category;
  const auto shapes = drawnShapes(category, lived_in_, 0, furnitureVariants(category));
  result.variant =
      shapes[static_cast<std::size_t>(draw_.pick(static_cast<int>(shapes.size())))];
  result.seed = mixSeed(static_cast<std::uint32_t>(draw_.pick(1 << 30)), 0);
  result.size = makeFurniture(category, result.seed, size, result.variant).size;
  return result;
}

Piece
RoomFurnisher::shaped(const std::string& category,
                      int first,
                      int last,
                      const std::optional<Eigen::Vector3d>& size)
{
  Piece result = piece(category);
  const auto shapes = drawnShapes(category, lived_in_, first, last);
  result.variant =
      shapes[static_cast<std::size_t>(draw_.pick(static_cast<int>(shapes.size())))];
  result.size = makeFurniture(category, result.seed, size, result.variant).size;
  return result;
}

bool
RoomFurnisher::isFree(const Polygon& footprint,
                      double low,
                      double high,
                      int under) const
{
  if (high > ceiling_ + touch)
    return false;
  for (const auto& corner : footprint)
    if (((corner - inner_.min()).array() < -touch).any() ||
        ((inner_.max() - corner).array() < -touch).any())
      return false;
  const Polygon smaller = inset(footprint, touch);
  const Eigen::Vector2d middle = (footprint[0] + footprint[2]) / 2;
  const double radius = (footprint[0] - middle).norm();
  return std::none_of(obstacles_.begin(), obstacles_.end(), [&](const Obstacle& o) {
    const Eigen::Vector2d other = (o.footprint[0] + o.footprint[2]) / 2;
    return (o.piece < 0 || o.piece != under) && o.low < high - touch &&
           o.high > low + touch &&
           (other - middle).norm() < radius + (o.footprint[0] - other).norm() &&
           overlap(o.footprint, smaller);
  });
}

void
RoomFurnisher::block(const Polygon& footprint, double low, double high)
{
  obstacles_.push_back({footprint, low, high, -1});
}

int
RoomFurnisher::put(const Piece& piece,
                   const Eigen::Vector2d& at,
                   double rotation,
                   double elevation,
                   int under)
{
  const Polygon footprint = turnedRectangle(at, piece.size.head<2>(), rotation);
  const double high = elevation + piece.size.z();
  if (!isFree(footprint, elevation, high, under))
    return -1;
  const int number = static_cast<int>(pieces_.size());
  obstacles_.push_back({footprint, elevation, high, number});
  pieces_.push_back(piece);
  FurniturePlan plan;
  plan.category = piece.category;
  plan.at = at;
  plan.rotation = rotation;
  plan.elevation = elevation;
  plan.size = piece.size;
  plan.seed = piece.seed;
  plan.variant = piece.variant;
  furniture_.push_back(plan);
  return number;
}

double
RoomFurnisher::placeAlong(const Wall& w, const Piece& piece)
{
  const double half = piece.size.x() / 2;
  const double choice = draw_.uniform();
  if (choice < 0.35) // in a corner
    return draw_.pick(2) == 0 ? half : w.length - half;
  if (choice < 0.65 && !furniture_.empty()) { // right beside another piece
    const int other = draw_.pick(static_cast<int>(furniture_.size()));
    const double at = (furniture_[other].at - w.start).dot(w.along);
    const double apart = half + pieces_[other].size.x() / 2 + draw_.uniform(0.0, 0.03);
    return at + (draw_.pick(2) == 0 ? apart : -apart);
  }
  return draw_.uniform(half, std::max(half, w.length - half));
}

int
RoomFurnisher::tryWalls(const Piece& piece, double elevation, double gap)
{
  constexpr int attempts = 150;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const Wall w = wall(draw_.pick(4));
    const double along = placeAlong(w, piece);
    const double off = piece.size.y() / 2 + gap;
    const int placed =
        put(piece, w.start + along * w.along + off * w.inwards, w.rotation, elevation);
    if (placed >= 0)
      return placed;
  }
  return -1;
}

int
RoomFurnisher::atWall(const Piece& piece, double elevation)
{
  return tryWalls(piece, elevation, chance(0.5) ? 0.0 : between(0.0, 0.04));
}

int
RoomFurnisher::onWall(const Piece& piece, double elevation)
{
  return tryWalls(piece, elevation, 0.0);
}

int
RoomFurnisher::beside(
    int other, const Piece& piece, int side, double gap, double elevation)
{
  if (other < 0)
    return -1;
  const auto& base = furniture_[other];
  const auto& size = pieces_[other].size;
  const double apart = (size.x() + piece.size.x()) / 2 + gap;
  const double back = (piece.size.y() - size.y()) / 2;
  return put(piece,
             base.at + side * apart * sidewards(base.rotation) +
                 back * forwards(base.rotation),
             base.rotation,
             elevation);
}

int
RoomFurnisher::before(
    int other, const Piece& piece, double gap, double sideways, double turn)
{
  if (other < 0)
    return -1;
  const auto& base = furniture_[other];
  const double apart = (pieces_[other].size.y() + piece.size.y()) / 2 + gap;
  return put(piece,
             base.at + apart * forwards(base.rotation) +
                 sideways * sidewards(base.rotation),
             base.rotation + M_PI + turn,
             0.0,
             other);
}

void
RoomFurnisher::around(int table, const std::string& chair, int most)
{
  if (table < 0)
    return;
  const Piece model = piece(chair); // the chairs of a table are alike
  const auto base = furniture_[table];
  const Eigen::Vector3d size = pieces_[table].size;
  const double pitch = model.size.x() + between(0.05, 0.2);
  for (int k = 0, placed = 0; k < 4 && placed < most; ++k) {
    const double facing = base.rotation + k * M_PI / 2;
    const double width = k % 2 == 0 ? size.x() : size.y();
    const double depth = k % 2 == 0 ? size.y() : size.x();
    const int seats = std::max(1, static_cast<int>((width - 0.1) / pitch));
    for (int i = 0; i < seats && placed < most; ++i) {
      const bool out = chance(0.25);
      const double gap = out ? between(0.05, 0.4) : between(-0.3, -0.02);
      const double turn = (out ? 0.6 : 0.12) * between(-1.0, 1.0);
      const double along = (i - 0.5 * (seats - 1)) * pitch;
      const Eigen::Vector2d at =
          base.at + ((depth + model.size.y()) / 2 + gap) * forwards(facing) +
          along * sidewards(facing);
      placed += put(model, at, facing + M_PI + turn, 0.0, table) >= 0 ? 1 : 0;
    }
  }
}

int
RoomFurnisher::onTop(int other, const Piece& piece, double turn, bool at_rear)
{
  if (other < 0)
    return -1;
  if (lived_in_)
    return restOn(other, piece, {turn, false, at_rear});
  const auto base = furniture_[other];
  const Eigen::Vector3d size = pieces_[other].size;
  const Eigen::Vector2d room = (size - piece.size).head<2>() / 2;
  if (room.minCoeff() < 0)
    return -1;
  for (int attempt = 0; attempt < 6; ++attempt) {
    const double y = at_rear ? -room.y() : between(-1.0, 1.0) * room.y();
    const Eigen::Vector2d p(between(-1.0, 1.0) * room.x(), y);
    const int placed = put(piece,
                           base.at + p.x() * sidewards(base.rotation) +
                               p.y() * forwards(base.rotation),
                           base.rotation + turn,
                           *base.elevation + size.z());
    if (placed >= 0)
      return placed;
  }
  return -1;
}

int
RoomFurnisher::anywhere(const Piece& piece)
{
  for (int attempt = 0; attempt < 30; ++attempt) {
    const double y = between(inner_.min().y(), inner_.max().y());
    const Eigen::Vector2d at(between(inner_.min().x(), inner_.max().x()), y);
    const int placed = put(piece, at, between(-M_PI, M_PI), 0.0);
    if (placed >= 0)
      return placed;
  }
  return -1;
}

int
RoomFurnisher::inTheMiddle(const Piece& piece, double share, double elevation)
{
  for (int attempt = 0; attempt < 20; ++attempt) {
    const double y = between(-share, share);
    const Eigen::Vector2d off(between(-share, share), y);
    const double skew = chance(0.2) ? between(-0.15, 0.15) : 0.0;
    const int placed = put(piece,
                           inner_.center() + off.cwiseProduct(inner_.sizes()) / 2,
                           pick(4) * M_PI / 2 + skew,
                           elevation);
    if (placed >= 0)
      return placed;
  }
  return -1;
}

int
RoomFurnisher::fromCeiling(const Piece& piece, int over)
{
  const double elevation = ceiling_ - piece.size.z();
  if (over >= 0)
    return put(piece, furniture_[over].at, furniture_[over].rotation, elevation);
  return inTheMiddle(piece, 0.4, elevation);
}

void
RoomFurnisher::radiatorsBelowWindows()
{
  for (const auto& window : windows_) {
    if (!chance(0.6))
      continue;
    Piece p = piece("radiator");
    p.size.x() = std::min(p.size.x(), window.width);
    p.size.z() = std::min(p.size.z(), window.sill - 0.05);
    if (p.size.z() > 0.3)
      put(p,
          window.at + p.size.y() / 2 * forwards(window.rotation),
          window.rotation,
          0.0);
  }
}

} // namespace pcl::indoor
