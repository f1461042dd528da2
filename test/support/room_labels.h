/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "support/labelled_cloud.h"
#include "support/synthetic_scenes.h"

#include <pcl/segmentation/room_segmentation.h>

#include <pcl/point_types.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace pcl::indoor {
namespace test {

inline Labels
segmented(const Cloud::ConstPtr& cloud)
{
  pcl::RoomSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setInputCloud(cloud);
  Labels labels;
  segmentation.segment(labels);
  return labels;
}

inline std::size_t
roomCount(const Labels& labels)
{
  std::set<std::uint32_t> rooms(labels.begin(), labels.end());
  rooms.erase(0);
  return rooms.size();
}

/** Whether a point lies farther than 10 cm from all doorways: in a doorway itself both
 * rooms see it. */
inline bool
awayFrom(const std::vector<Opening>& doors, const Eigen::Vector3f& point)
{
  for (const auto& door : doors)
    if (door.exteriorDistance(point) <= 0.1f)
      return false;
  return true;
}

/** Points that do not have the label that most points of their room have, and points of
 * two rooms that share one. */
inline std::size_t
wrongPoints(const LabelledPoints& scene,
            const Labels& labels,
            const std::vector<Opening>& doors)
{
  std::map<std::uint32_t, std::map<std::uint32_t, std::size_t>> counts;
  std::size_t total = 0;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (awayFrom(doors, scene.points[i])) {
      ++counts[scene.objects[i]][labels[i]];
      ++total;
    }
  std::set<std::uint32_t> taken{0};
  std::size_t right = 0;
  for (const auto& room : counts) {
    const auto most = std::max_element(
        room.second.begin(), room.second.end(), [](const auto& a, const auto& b) {
          return a.second < b.second;
        });
    if (taken.insert(most->first).second)
      right += most->second;
  }
  return total - right;
}

} // namespace test
} // namespace pcl::indoor
