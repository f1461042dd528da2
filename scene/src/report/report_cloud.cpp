/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "report/report_cloud.h"

#include "text/base64.h"

#include <pcl/common/point_tests.h> // for isFinite

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::indoor::tool {
namespace {

constexpr double finest_voxel = 0.03; // metres
constexpr double steps = 65535.0;     // of 16 bits

/** Points that are shown. */
Indices
pointsOf(const Scene& scene, const PointCloud<PointXYZ>& cloud)
{
  Indices indices;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if ((scene.room_of_point[i] > 0 || scene.object_of_point[i] > 0) &&
        isFinite(cloud[i]))
      indices.push_back(static_cast<index_t>(i));
  return indices;
}

/** The first point of each voxel, in the order of the points. */
Indices
onePerVoxel(const Indices& indices,
            const PointCloud<PointXYZ>& cloud,
            const Eigen::Vector3d& lower,
            double size)
{
  std::vector<std::pair<std::uint64_t, index_t>> voxels;
  voxels.reserve(indices.size());
  for (const auto index : indices) {
    std::uint64_t voxel = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double place = (cloud[index].data[axis] - lower[axis]) / size;
      voxel = voxel << 21 | (static_cast<std::uint64_t>(place) & 0x1fffffu);
    }
    voxels.emplace_back(voxel, index);
  }
  std::sort(voxels.begin(), voxels.end());
  const auto end =
      std::unique(voxels.begin(), voxels.end(), [](const auto& a, const auto& b) {
        return a.first == b.first;
      });
  Indices first;
  for (auto voxel = voxels.begin(); voxel != end; ++voxel)
    first.push_back(voxel->second);
  std::sort(first.begin(), first.end());
  return first;
}

struct Thinned {
  Indices indices;
  double spacing; ///< side of a voxel, metres
};

/** Larger voxels until there are few enough points; their number falls with the square
 * of the size, as they lie on surfaces. */
Thinned
thinned(Indices indices,
        const PointCloud<PointXYZ>& cloud,
        const Eigen::Vector3d& lower,
        std::size_t most)
{
  double size = finest_voxel, spacing = size;
  while (indices.size() > most) {
    spacing = size;
    indices = onePerVoxel(indices, cloud, lower, size);
    const double excess =
        static_cast<double>(indices.size()) / static_cast<double>(most);
    size *= std::clamp(1.02 * std::sqrt(excess), 1.05, 4.0);
  }
  return {std::move(indices), spacing};
}

void
append(std::string& bytes, double number)
{
  const auto value = static_cast<std::uint16_t>(number <= steps ? number : 0.0);
  bytes += static_cast<char>(value & 0xffu);
  bytes += static_cast<char>(value >> 8);
}

} // namespace

nlohmann::ordered_json
thinnedCloud(const Scene& scene, const PointCloud<PointXYZ>& upright, std::size_t most)
{
  auto shown = pointsOf(scene, upright);
  Eigen::AlignedBox3d box;
  for (const auto index : shown)
    box.extend(upright[index].getVector3fMap().cast<double>());
  const Eigen::Vector3d shift = scene.frame.origin();
  if (box.isEmpty())
    box.extend(shift);
  const auto [indices, spacing] = thinned(std::move(shown), upright, box.min(), most);
  const Eigen::Vector3d step = box.sizes().cwiseMax(1e-3) / steps;
  std::string bytes;
  for (int axis = 0; axis < 3; ++axis)
    for (const auto index : indices)
      append(bytes,
             std::round((upright[index].data[axis] - box.min()[axis]) / step[axis]));
  for (const auto* labels : {&scene.room_of_point, &scene.object_of_point})
    for (const auto index : indices)
      append(bytes, (*labels)[index]);
  const Eigen::Vector3d lower = box.min() - shift;
  return {{"points", indices.size()},
          {"lower", {lower.x(), lower.y(), lower.z()}},
          {"spacing", spacing},
          {"step", {step.x(), step.y(), step.z()}},
          {"data", base64(bytes)}};
}

} // namespace pcl::indoor::tool
