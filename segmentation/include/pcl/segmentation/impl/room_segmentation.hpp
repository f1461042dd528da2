/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/common/point_tests.h> // for isFinite
#include <pcl/console/print.h>
#include <pcl/exceptions.h>
#include <pcl/impl/pcl_base.hpp>
#include <pcl/segmentation/building_frame.h>
#include <pcl/segmentation/room_segmentation.h>

#include <algorithm>
#include <cmath>

namespace pcl {

template <typename PointT>
bool
RoomSegmentation<PointT>::initCompute()
{
  const auto refuse = [](const char* what, double value, const char* unit) {
    PCL_ERROR(
        "[pcl::RoomSegmentation::initCompute] %s, not %g%s.\n", what, value, unit);
    return false;
  };
  if (!PCLBase<PointT>::initCompute()) {
    PCL_ERROR("[pcl::RoomSegmentation::initCompute] No input cloud is set.\n");
    return false;
  }
  if (input_->empty() || indices_->empty()) {
    PCL_ERROR("[pcl::RoomSegmentation::initCompute] The input has no points.\n");
    return false;
  }
  const auto [lowest, highest] =
      std::minmax_element(indices_->begin(), indices_->end());
  if (*lowest < 0 || static_cast<std::size_t>(*highest) >= input_->size()) {
    PCL_ERROR("[pcl::RoomSegmentation::initCompute] The indices leave the cloud of %zu "
              "points.\n",
              static_cast<std::size_t>(input_->size()));
    return false;
  }
  const indoor::RoomMapOptions& map = options_.map;
  if (!(options_.voxel_size > 0 && std::isfinite(options_.voxel_size)))
    return refuse("The voxel size must be positive", options_.voxel_size, " m");
  if (!(map.min_area >= 0))
    return refuse("The smallest room area must not be negative", map.min_area, " m^2");
  if (!(map.min_width >= 0))
    return refuse("The smallest room width must not be negative", map.min_width, " m");
  if (!(map.persistence >= 0 && map.persistence <= 1))
    return refuse("The persistence must lie in 0 ... 1", map.persistence, "");
  if (!(map.merging.open_share >= 0 && map.merging.open_share <= 1))
    return refuse("The open share must lie in 0 ... 1", map.merging.open_share, "");
  if (!(map.open_plan.habitable_area >= 0))
    return refuse("The habitable area must not be negative",
                  map.open_plan.habitable_area,
                  " m^2");
  if (!(up_axis_.allFinite() && up_axis_.squaredNorm() > 0.0f))
    return refuse("The length of the up axis must be positive", up_axis_.norm(), "");
  if (options_.threads < 0)
    return refuse("The number of threads must not be negative", options_.threads, "");
  return true;
}

template <typename PointT>
void
RoomSegmentation<PointT>::segment(std::vector<std::uint32_t>& labels)
{
  labels.clear();
  building_ = indoor::BuildingRooms();
  rooms_.clear();
  openings_.clear();
  if (!initCompute())
    return;

  std::vector<Eigen::Vector3f> points;
  points.reserve(indices_->size());
  for (const auto index : *indices_)
    if (isFinite((*input_)[index]))
      points.push_back((*input_)[index].getVector3fMap());
  if (points.empty()) {
    PCL_ERROR("[pcl::RoomSegmentation::segment] No point is finite.\n");
    this->deinitCompute();
    return;
  }
  bool goes_on = true;
  const auto progress = [&](double share, const char* stage) {
    goes_on = !progress_ || progress_(share, stage);
    return goes_on;
  };
  pose_ = indoor::moveIntoBuildingFrame(points, up_axis_);
  try {
    building_ = indoor::segmentBuilding(points, options_, progress);
  } catch (const BadArgumentException& error) { // such as far too many voxels
    PCL_ERROR("[pcl::RoomSegmentation::segment] %s\n", error.what());
    this->deinitCompute();
    return;
  }
  if (goes_on) {
    rooms_ = building_.rooms;
    openings_ = building_.openings;
    std::vector<Eigen::AlignedBox3f> boxes(rooms_.size());
    labels.assign(input_->size(), 0);
    auto label = building_.point_labels.begin();
    for (const auto index : *indices_)
      if (isFinite((*input_)[index])) {
        labels[index] = *label++;
        if (labels[index] > 0)
          boxes[labels[index] - 1].extend((*input_)[index].getVector3fMap());
      }
    indoor::placeInCloud(pose_, boxes, rooms_, openings_);
  }
  this->deinitCompute();
}

template <typename PointT>
void
RoomSegmentation<PointT>::segment(std::vector<PointIndices>& rooms)
{
  rooms.clear();
  std::vector<std::uint32_t> labels;
  segment(labels);
  rooms.resize(rooms_.size());
  for (auto& room : rooms)
    room.header = input_->header;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] > 0)
      rooms[labels[i] - 1].indices.push_back(static_cast<index_t>(i));
}

} // namespace pcl

#define PCL_INSTANTIATE_RoomSegmentation(T)                                            \
  template class PCL_EXPORTS pcl::RoomSegmentation<T>;
