/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/common/point_tests.h> // for isFinite
#include <pcl/console/print.h>
#include <pcl/exceptions.h>
#include <pcl/impl/pcl_base.hpp>
#include <pcl/segmentation/room_segmentation.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
  if (!initCompute())
    return;

  // A float holds coordinates near the origin only: large ones are moved there.
  Indices usable;
  for (const auto index : *indices_)
    if (isFinite((*input_)[index]))
      usable.push_back(index);
  if (usable.empty()) {
    PCL_ERROR("[pcl::RoomSegmentation::segment] No point is finite.\n");
    this->deinitCompute();
    return;
  }
  const auto position = [&](index_t index) {
    return (*input_)[index].getVector3fMap().template cast<double>().eval();
  };
  Eigen::Vector3f lowest = Eigen::Vector3f::Constant(std::numeric_limits<float>::max());
  Eigen::Vector3f highest = -lowest;
  for (const auto index : usable) {
    lowest = lowest.cwiseMin((*input_)[index].getVector3fMap());
    highest = highest.cwiseMax((*input_)[index].getVector3fMap());
  }
  for (int axis = 0; axis < 3; ++axis) {
    origin_[axis] = std::floor(lowest[axis]);
    if (highest[axis] - lowest[axis] < 4096.0f) // metres
      continue;
    std::vector<float> values; // the median: points astray by kilometres do not move it
    values.reserve(usable.size());
    for (const auto index : usable)
      values.push_back((*input_)[index].data[axis]);
    const auto middle = values.begin() + values.size() / 2;
    std::nth_element(values.begin(), middle, values.end());
    origin_[axis] = std::floor(*middle);
  }
  std::vector<Eigen::Vector3f> points;
  points.reserve(usable.size());
  for (const auto index : usable)
    points.push_back((position(index) - origin_).template cast<float>());

  try {
    building_ = indoor::segmentBuilding(points, options_);
  } catch (const BadArgumentException& error) { // such as far too many voxels
    PCL_ERROR("[pcl::RoomSegmentation::segment] %s\n", error.what());
    this->deinitCompute();
    return;
  }
  for (auto& room : building_.rooms) {
    room.lower += origin_;
    room.upper += origin_;
    room.centroid += origin_;
  }
  labels.assign(input_->size(), 0);
  for (std::size_t i = 0; i < usable.size(); ++i)
    labels[usable[i]] = building_.point_labels[i];
  this->deinitCompute();
}

template <typename PointT>
void
RoomSegmentation<PointT>::segment(std::vector<PointIndices>& rooms)
{
  rooms.clear();
  std::vector<std::uint32_t> labels;
  segment(labels);
  rooms.resize(building_.rooms.size());
  for (auto& room : rooms)
    room.header = input_->header;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] > 0)
      rooms[labels[i] - 1].indices.push_back(static_cast<index_t>(i));
}

} // namespace pcl

#define PCL_INSTANTIATE_RoomSegmentation(T)                                            \
  template class PCL_EXPORTS pcl::RoomSegmentation<T>;
