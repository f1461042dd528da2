/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/building_frame.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl {
namespace indoor {
namespace {

/** The turn from the cloud's frame into one with z up; of zeros and ones, and thus
 * exact, where an axis of the cloud points up. */
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

/** Whole metres near the turned points: a float holds coordinates near the origin only.
 */
Eigen::Vector3d
originNear(const std::vector<Eigen::Vector3f>& points, const Eigen::Matrix3d& turn)
{
  Eigen::AlignedBox3d box;
  for (const auto& point : points)
    box.extend(turn * point.cast<double>());
  Eigen::Vector3d origin = box.min().array().floor();
  for (int axis = 0; axis < 3; ++axis) {
    if (box.max()[axis] - box.min()[axis] < 4096.0) // metres
      continue;
    std::vector<double> values; // the median: points astray by kilometres leave it
    values.reserve(points.size());
    for (const auto& point : points)
      values.push_back(turn.row(axis).dot(point.cast<double>()));
    const auto middle = values.begin() + values.size() / 2;
    std::nth_element(values.begin(), middle, values.end());
    origin[axis] = std::floor(*middle);
  }
  return origin;
}

} // namespace

Eigen::Isometry3d
moveIntoBuildingFrame(std::vector<Eigen::Vector3f>& points,
                      const Eigen::Vector3f& up_axis)
{
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  if (points.empty())
    return pose;
  const Eigen::Matrix3d turn = turnUpright(up_axis);
  const Eigen::Vector3d origin = originNear(points, turn);
  for (auto& point : points)
    point = (turn * point.cast<double>() - origin).cast<float>();
  pose.linear() = turn.transpose();
  pose.translation() = turn.transpose() * origin;
  return pose;
}

void
placeInCloud(const Eigen::Isometry3d& pose,
             const std::vector<Eigen::AlignedBox3f>& boxes,
             std::vector<Room>& rooms,
             std::vector<RoomOpening>& openings)
{
  for (auto& opening : openings)
    opening.position = pose * opening.position;
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    rooms[i].lower = boxes[i].min().cast<double>();
    rooms[i].upper = boxes[i].max().cast<double>();
    rooms[i].centroid = pose * rooms[i].centroid;
    for (auto& line : rooms[i].footprint)
      for (auto& corner : line)
        corner = pose * corner;
  }
}

} // namespace indoor
} // namespace pcl
