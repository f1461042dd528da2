/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "random/room_furnisher.h"

#include "plan/turned_rectangle.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace {

constexpr int attempts = 15; // for a place on a piece

Eigen::Vector2d
turned(const Eigen::Vector2d& p, double rotation)
{
  return Eigen::Rotation2Dd(rotation) * p;
}

} // namespace

const RestingPlaces&
RoomFurnisher::placesOn(int number)
{
  const auto n = static_cast<std::size_t>(number);
  places_.resize(std::max(places_.size(), pieces_.size()));
  if (!places_[n]) {
    const auto& p = pieces_[n];
    places_[n] = std::make_shared<RestingPlaces>(
        makeFurniture(p.category, p.seed, p.size, p.variant));
  }
  return *places_[n];
}

int
RoomFurnisher::restOn(int other, const Piece& piece, const Resting& how)
{
  if (other < 0)
    return -1;
  const auto base = furniture_[other];
  const auto corners = turnedRectangle({0, 0}, piece.size.head<2>(), how.turn);
  const Eigen::Vector2d half = pieces_[other].size.head<2>() / 2,
                        own = corners[2].cwiseAbs().cwiseMax(corners[3].cwiseAbs());
  if ((own.array() > half.array() + 0.02).any())
    return -1;
  const Eigen::Vector2d room = (half - own).cwiseMax(0.0);
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const double y = how.at_rear ? between(-1.0, -0.8) : between(-1.0, 1.0);
    Eigen::Vector2d at(between(-1.0, 1.0) * room.x(), y * room.y());
    if (how.touching >= 0 && attempt < attempts / 2) {
      const auto& beside = furniture_[how.touching];
      const double apart =
          (pieces_[how.touching].size.x() + piece.size.x()) / 2 + between(0.0, 0.008);
      at = turned(beside.at - base.at, -base.rotation) +
           turned({(chance(0.5) ? 1 : -1) * apart, 0}, beside.rotation - base.rotation);
    }
    const double turn = how.touching >= 0
                            ? furniture_[how.touching].rotation - base.rotation
                            : how.turn;
    const auto levels = placesOn(other).levels(
        turnedRectangle(at, piece.size.head<2>(), turn), piece.size.z(), how.give);
    if (levels.empty())
      continue;
    const double level =
        how.inside
            ? levels[static_cast<std::size_t>(pick(static_cast<int>(levels.size())))]
            : levels.back();
    const int placed = put(piece,
                           base.at + turned(at, base.rotation),
                           base.rotation + turn,
                           *base.elevation + level,
                           other);
    if (placed >= 0)
      return placed;
  }
  return -1;
}

int
RoomFurnisher::under(int other, const Piece& piece)
{
  const auto base = furniture_[other];
  const Eigen::Vector2d room = (pieces_[other].size - piece.size).head<2>() / 2;
  for (int attempt = 0; attempt < attempts && room.minCoeff() > 0; ++attempt) {
    const double y = between(-1.0, 1.0) * room.y();
    const Eigen::Vector2d at(between(-1.0, 1.0) * room.x(), y);
    if (!placesOn(other).isFreeBelow(turnedRectangle(at, piece.size.head<2>(), 0.0),
                                     piece.size.z()))
      continue;
    const int placed =
        put(piece, base.at + turned(at, base.rotation), base.rotation, 0.0, other);
    if (placed >= 0)
      return placed;
  }
  return -1;
}

void
RoomFurnisher::layOver(int other, Piece cloth, const Eigen::Vector2d& at, double hem)
{
  constexpr double over = 0.06; // metres that folds rise over what they lie on
  const auto& base = furniture_[other];
  cloth.size.z() = *base.elevation + pieces_[other].size.z() + over - hem;
  Eigen::Vector2d place = base.at + turned(at, base.rotation);
  Eigen::AlignedBox2d outer, room = inner_;
  for (const auto& corner :
       turnedRectangle({0, 0}, cloth.size.head<2>(), base.rotation))
    outer.extend(corner);
  room.min() -= outer.min(); // where its middle may be
  room.max() -= outer.max();
  if (room.isEmpty() || cloth.size.z() < 0.05)
    return;
  place = place.cwiseMax(room.min()).cwiseMin(room.max());
  FurniturePlan plan;
  plan.category = cloth.category;
  plan.at = place;
  plan.rotation = base.rotation;
  plan.elevation = hem;
  plan.size = cloth.size;
  plan.seed = cloth.seed;
  plan.variant = cloth.variant;
  plan.draped = true;
  furniture_.push_back(plan);
  pieces_.push_back(cloth);
}

} // namespace pcl::indoor
