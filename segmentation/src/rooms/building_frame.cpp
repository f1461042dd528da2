/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/building_frame.h>

#include <pcl/indoor/quantile.h>
#include <pcl/indoor/stray_points.h>

#include <cmath>
#include <vector>

namespace pcl::indoor {
namespace {

/** What is farther than this from the middle of a scan, along an axis, is no part of
 * a building. */
constexpr double near = float_reach;

/** Turned and in metres, but not moved yet; finite in any unit. */
Eigen::Vector3d
turned(const Eigen::Matrix3d& turn,
       double metres_per_unit,
       const Eigen::Vector3f& point)
{
  constexpr double largest = 1e100;
  return (metres_per_unit * (turn * point.cast<double>()))
      .cwiseMax(-largest)
      .cwiseMin(largest);
}

Eigen::Vector3d
medianOf(const std::vector<Eigen::Vector3f>& points,
         const Eigen::Matrix3d& turn,
         double metres_per_unit)
{
  Eigen::Vector3d place;
  std::vector<double> values(points.size());
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < points.size(); ++i)
      values[i] = turned(turn, metres_per_unit, points[i])[axis];
    place[axis] = median(values);
  }
  return place;
}

/** Whole metres near the turned points: a float holds coordinates near the origin only.
 */
Eigen::Vector3d
originNear(const std::vector<Eigen::Vector3f>& points,
           const Eigen::Matrix3d& turn,
           double metres_per_unit)
{
  Eigen::AlignedBox3d box;
  for (const auto& point : points)
    box.extend(turned(turn, metres_per_unit, point));
  if ((box.sizes().array() < near).all())
    return box.min().array().floor();
  const Eigen::Vector3d median = medianOf(points, turn, metres_per_unit);
  box.setEmpty();
  for (const auto& point : points) {
    const Eigen::Vector3d p = turned(turn, metres_per_unit, point);
    if (((p - median).array().abs() < near).all())
      box.extend(p);
  }
  const Eigen::Vector3d origin =
      box.isEmpty() || !(box.sizes().array() < near).all() ? median : box.min();
  return origin.array().floor();
}

} // namespace

Eigen::Matrix3d
turnUpright(const Eigen::Vector3f& up_axis)
{
  const Eigen::Vector3d up = up_axis.cast<double>().normalized();
  int level = 0; // the cloud's axis that is the most level
  up.cwiseAbs().minCoeff(&level);
  const Eigen::Vector3d x =
      (Eigen::Vector3d::Unit(level) - up[level] * up).normalized();
  Eigen::Matrix3d turn;
  turn << x.transpose(), up.cross(x).transpose(), up.transpose();
  return turn;
}

Eigen::Affine3d
BuildingFrame::uprightToFile() const
{
  Eigen::Affine3d to_file = Eigen::Affine3d::Identity();
  to_file.linear() = pose.linear() / metres_per_unit;
  to_file.translation() = offset;
  return to_file;
}

Eigen::Affine3d
BuildingFrame::buildingToFile() const
{
  auto to_file = uprightToFile();
  to_file.translation() += pose.translation() / metres_per_unit;
  return to_file;
}

BuildingFrame
moveIntoBuildingFrame(std::vector<Eigen::Vector3f>& points,
                      const Eigen::Vector3f& up_axis,
                      double metres_per_unit)
{
  constexpr double farthest = 1e9; // metres; far from what a float can hold
  BuildingFrame frame;
  frame.metres_per_unit = metres_per_unit;
  if (points.empty())
    return frame;
  const Eigen::Matrix3d turn = turnUpright(up_axis);
  const Eigen::Vector3d origin = originNear(points, turn, metres_per_unit);
  for (auto& point : points)
    point = (turned(turn, metres_per_unit, point) - origin)
                .cwiseMax(-farthest)
                .cwiseMin(farthest)
                .cast<float>();
  frame.pose.linear() = turn.transpose();
  frame.pose.translation() = turn.transpose() * origin;
  return frame;
}

std::vector<std::size_t>
takeOutFarPoints(std::vector<Eigen::Vector3f>& points)
{
  std::vector<std::size_t> taken;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    // the origin is the lower corner or the middle of what is near
    if ((points[i].array().abs() > static_cast<float>(near)).any())
      taken.push_back(i);
    else
      points[kept++] = points[i];
  points.resize(kept);
  return taken;
}

void
placeInScan(const BuildingFrame& frame,
            const std::vector<Eigen::AlignedBox3f>& boxes,
            std::vector<Room>& rooms,
            std::vector<RoomOpening>& openings)
{
  for (auto& opening : openings)
    opening.position = frame.buildingToScan(opening.position);
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    rooms[i].lower = boxes[i].min().cast<double>();
    rooms[i].upper = boxes[i].max().cast<double>();
    rooms[i].centroid = frame.buildingToScan(rooms[i].centroid);
    for (auto& line : rooms[i].footprint)
      for (auto& corner : line)
        corner = frame.buildingToScan(corner);
  }
}

} // namespace pcl::indoor
