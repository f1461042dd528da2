/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/graph/segment_members.h"
#include "objects/structure/object_scene.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

using PointBox = Eigen::AlignedBox3f;

/** Groups of points, with the boxes around them. */
struct PointGroups {
  std::vector<SegmentMembers> members;
  std::vector<PointBox> boxes;

  explicit PointGroups(std::size_t count)
  : members(count)
  , boxes(count)
  {}

  void
  add(std::uint32_t group, std::uint32_t index, const Eigen::Vector3f& point)
  {
    members[group].push_back(index);
    boxes[group].extend(point);
  }
};

/** The points of each plane, and those of each other segment. */
struct PlanesAndObjects {
  PointGroups planes, objects;
};

/** \param[in] segment_of_point numbered from 0. REQUIRES: points. */
inline PlanesAndObjects
groupPoints(const ObjectScene& scene,
            const std::vector<std::uint32_t>& segment_of_point)
{
  PlanesAndObjects groups{PointGroups(scene.planes.size()),
                          PointGroups(1 + *std::max_element(segment_of_point.begin(),
                                                            segment_of_point.end()))};
  for (std::uint32_t i = 0; i < scene.points.size(); ++i) {
    const auto plane = scene.planeOfPoint(i);
    if (plane == 0)
      groups.objects.add(segment_of_point[i], i, scene.points[i]);
    else
      groups.planes.add(plane - 1, i, scene.points[i]);
  }
  return groups;
}

inline PointBox
widened(const PointBox& box, double by)
{
  const Eigen::Vector3f margin = Eigen::Vector3f::Constant(static_cast<float>(by));
  return PointBox(box.min() - margin, box.max() + margin);
}

} // namespace pcl::indoor
