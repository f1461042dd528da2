/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/model/model_columns.h>

#include "internal/cross.h"
#include "wall_dimensions.h"

#include <pcl/indoor/quantile.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace pcl::indoor {
namespace {

using Places = std::vector<Eigen::Vector2d>;

constexpr double widest_column = 1.0; // metres
constexpr double reach = 0.15;        // metres: outlines lie within 1.5 voxels of sides

Places
placesOf(const std::vector<Eigen::Vector3d>& line)
{
  Places places;
  for (const auto& corner : line)
    places.emplace_back(corner.head<2>());
  return places;
}

Eigen::AlignedBox2d
boxOf(const Places& places)
{
  Eigen::AlignedBox2d box;
  for (const auto& place : places)
    box.extend(place);
  return box;
}

/** The points around a column, away from floor and ceiling; without enough of them its
 * outline. */
Places
placesAround(const Places& outline, const Room& room, const PointsOfRooms& points)
{
  constexpr double from_slabs = 0.3; // metres: what stands around it, beams
  const auto box = boxOf(outline);
  const double radius = 0.5 * box.sizes().maxCoeff() + reach;
  const Eigen::Vector2d side(radius, 0.0);
  const FaceStretch stretch{
      box.center() - side, box.center() + side, 0.0, radius, radius};
  std::vector<WallPoint> near;
  points.beside(stretch, room.label, false, near);
  const double floor = room.footprint.front().front().z();
  Places places;
  for (const auto& point : near)
    if (point.height > floor + from_slabs &&
        point.height < floor + room.height - from_slabs)
      places.emplace_back(stretch.begin + Eigen::Vector2d(point.along, point.before));
  return places.size() < enough_points ? outline : places;
}

/** A shape, and how many points lie on its sides. */
struct Fit {
  Eigen::Vector2d center, size;
  double yaw = 0.0;
  std::size_t on_sides = 0;
};

/** Where most values begin and end: a few are beyond. */
std::pair<double, double>
extentOf(std::vector<double> values)
{
  constexpr double strays = 0.03; // share, at each end
  const auto last = values.size() - 1;
  const auto rank = static_cast<std::size_t>(strays * static_cast<double>(last));
  const double low = valueAtRank(values, rank);
  return {low, valueAtRank(values, last - rank)};
}

/** The rectangle of a direction. */
Fit
rectangleAlong(const Places& places, double yaw)
{
  const Eigen::Rotation2Dd turn(-yaw);
  std::vector<double> u, v;
  for (const auto& place : places) {
    const Eigen::Vector2d turned = turn * place;
    u.push_back(turned.x());
    v.push_back(turned.y());
  }
  const auto [left, right] = extentOf(u);
  const auto [front, back] = extentOf(v);
  const Eigen::Vector2d center(0.5 * (left + right), 0.5 * (front + back));
  Fit fit{turn.inverse() * center, {right - left, back - front}, yaw};
  for (std::size_t i = 0; i < u.size(); ++i)
    fit.on_sides += std::min({std::abs(u[i] - left),
                              std::abs(u[i] - right),
                              std::abs(v[i] - front),
                              std::abs(v[i] - back)}) <= scanner_noise;
  return fit;
}

/** The rectangle on which most points lie. */
Fit
bestRectangle(const Places& places)
{
  Fit best;
  for (int degrees = 0; degrees < 90; ++degrees) {
    const auto fit = rectangleAlong(places, degrees * M_PI / 180.0);
    if (fit.on_sides > best.on_sides || degrees == 0)
      best = fit;
  }
  return best;
}

/** The circle of least squares. */
std::optional<Fit>
circleThrough(const Places& places)
{
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  const Eigen::Vector2d middle = boxOf(places).center();
  for (const auto& place : places) {
    const Eigen::Vector2d from = place - middle;
    const Eigen::Vector3d row(2.0 * from.x(), 2.0 * from.y(), 1.0);
    a += row * row.transpose();
    b += from.squaredNorm() * row;
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(a);
  if (places.size() < enough_points || !solver.isInvertible())
    return std::nullopt;
  const Eigen::Vector3d found = solver.solve(b);
  const double radius = std::sqrt(found.z() + found.head<2>().squaredNorm());
  if (!(radius > 0.0 && radius <= 0.5 * widest_column))
    return std::nullopt;
  return Fit{middle + found.head<2>(), Eigen::Vector2d::Constant(2.0 * radius)};
}

Places
onCircle(const Fit& circle, const Places& places, double band)
{
  Places found;
  for (const auto& place : places)
    if (std::abs((place - circle.center).norm() - 0.5 * circle.size.x()) <= band)
      found.push_back(place);
  return found;
}

/** Refitted to ever nearer places, so that things beside the column drop out. */
std::optional<Fit>
bestCircle(const Places& places)
{
  auto best = circleThrough(places);
  for (const double band : {4.0 * scanner_noise, 2.0 * scanner_noise, scanner_noise})
    if (best)
      best = circleThrough(onCircle(*best, places, band));
  if (best)
    best->on_sides = onCircle(*best, places, scanner_noise).size();
  return best;
}

ModelColumn
columnOf(const Places& outline, const Room& room, const PointsOfRooms& points)
{
  const auto places = placesAround(outline, room, points);
  auto fit = bestRectangle(places);
  ModelColumn column;
  if (const auto circle = bestCircle(places);
      circle && circle->on_sides > fit.on_sides) {
    fit = *circle;
    column.is_round = true;
  }
  if (fit.size.y() > fit.size.x()) {
    std::swap(fit.size.x(), fit.size.y());
    fit.yaw += 0.5 * M_PI;
  }
  column.room = room.label;
  column.storey = room.storey;
  column.center = fit.center;
  column.size = fit.size;
  column.yaw = fit.yaw;
  column.floor = room.footprint.front().front().z();
  column.height = room.height;
  return column;
}

} // namespace

bool
isColumn(const std::vector<Eigen::Vector3d>& line)
{
  const auto outline = placesOf(line);
  double twice_area = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i)
    twice_area += crossOf(outline[i], outline[(i + 1) % outline.size()]);
  if (outline.empty() || twice_area >= 0.0) // outlines of rooms turn to the left
    return false;
  return bestRectangle(outline).size.maxCoeff() <= widest_column;
}

std::vector<ModelColumn>
modelColumns(const std::vector<Room>& rooms, const PointsOfRooms& points)
{
  std::vector<ModelColumn> columns;
  for (const Room& room : rooms)
    for (const auto& line : room.footprint)
      if (isColumn(line))
        columns.push_back(columnOf(placesOf(line), room, points));
  return columns;
}

} // namespace pcl::indoor
