/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/common/point_tests.h> // for isFinite
#include <pcl/console/print.h>
#include <pcl/exceptions.h>
#include <pcl/impl/pcl_base.hpp>
#include <pcl/indoor/exports.h>
#include <pcl/indoor/labelled_outputs.h>
#include <pcl/indoor/plain_message.h>
#include <pcl/segmentation/building_frame.h>
#include <pcl/segmentation/room_segmentation.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

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
  // PCLBase::initCompute() would list all points where no indices are set
  if (!input_) {
    PCL_ERROR("[pcl::RoomSegmentation::initCompute] No input cloud is set.\n");
    return false;
  }
  if (input_->empty() || (indices_ && indices_->empty())) {
    PCL_ERROR("[pcl::RoomSegmentation::initCompute] The input has no points.\n");
    return false;
  }
  if (indices_) {
    const auto [lowest, highest] =
        std::minmax_element(indices_->begin(), indices_->end());
    if (*lowest < 0 || static_cast<std::size_t>(*highest) >= input_->size()) {
      PCL_ERROR("[pcl::RoomSegmentation::initCompute] The indices leave the cloud of "
                "%zu points.\n",
                static_cast<std::size_t>(input_->size()));
      return false;
    }
  }
  const std::string problem = indoor::thesis::findProblem(
      indoor::thesis::RoomOptions{options_, field_, point_rooms_});
  if (!problem.empty()) {
    PCL_ERROR("[pcl::RoomSegmentation::initCompute] %s\n", problem.c_str());
    return false;
  }
  if (const auto count = stations_.of_point.size();
      count > 0 && count != input_->size()) {
    PCL_ERROR("[pcl::RoomSegmentation::initCompute] There are stations of %zu points "
              "for a cloud of %zu.\n",
              count,
              static_cast<std::size_t>(input_->size()));
    return false;
  }
  if (const auto up = getUpAxis(); !(up.allFinite() && up.squaredNorm() > 0.0f))
    return refuse("The length of the up axis must be positive", up.norm(), "");
  if (const double unit = getMetresPerUnit(); !(unit > 0 && std::isfinite(unit)))
    return refuse("The metres per unit must be positive", unit, " m");
  return true;
}

template <typename PointT>
void
RoomSegmentation<PointT>::warn(const std::string& line)
{
  if (line.empty())
    return;
  report_.warnings.push_back(line);
  PCL_WARN("[pcl::RoomSegmentation::segment] %s\n", line.c_str());
}

template <typename PointT>
void
RoomSegmentation<PointT>::findCoordinates(const std::vector<Eigen::Vector3f>& points)
{
  indoor::ScanCoordinates& used = report_;
  used = coordinates_ ? *coordinates_
                      : indoor::scanCoordinates(points, up_axis_, metres_per_unit_);
  if (!metres_per_unit_)
    warn(indoor::unitNote(used.vertical.room_height, used.metres_per_unit));
  warn(indoor::unitWarning(used.vertical, used.metres_per_unit));
  if (!up_axis_)
    warn(indoor::verticalNote(used.vertical));
}

template <typename PointT>
std::vector<Eigen::Vector3f>
RoomSegmentation<PointT>::pointsOfBuilding(IndicesConstPtr& indices)
{
  const std::size_t count = indices_ ? indices_->size() : input_->size();
  const auto indexOf = [this](std::size_t i) {
    return indices_ ? (*indices_)[i] : static_cast<index_t>(i);
  };
  std::vector<Eigen::Vector3f> points;
  points.reserve(count);
  indices = indices_;
  for (std::size_t i = 0; i < count; ++i)
    if (const auto& point = (*input_)[indexOf(i)]; isFinite(point))
      points.push_back(point.getVector3fMap());
  if (points.empty())
    return points;
  findCoordinates(points);
  const double unit = report_.metres_per_unit;
  frame_ = indoor::moveIntoBuildingFrame(points, report_.up_axis, unit);
  const double farthest =
      frame_.pose.translation().template lpNorm<Eigen::Infinity>() / unit;
  warn(indoor::stepWarning(indoor::floatStep(farthest) * unit, options_.voxel_size));
  const auto far = indoor::takeOutFarPoints(points);
  if (points.size() == count)
    return points;
  const auto used = pcl::make_shared<Indices>();
  used->reserve(points.size());
  auto next = far.begin();
  std::size_t finite = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto index = indexOf(i);
    if (!isFinite((*input_)[index]))
      continue;
    const bool is_far = next != far.end() && *next == finite++;
    (is_far ? report_.outside : *used).push_back(index);
    next += is_far;
  }
  indices = used;
  return points;
}

template <typename PointT>
indoor::ScanStations
RoomSegmentation<PointT>::stationsOfBuilding(const Indices& indices) const
{
  indoor::ScanStations stations;
  for (const auto& position : stations_.positions)
    stations.positions.push_back(frame_.scanToBuilding(position));
  if (indices.empty())
    stations.of_point = stations_.of_point;
  else if (!stations_.of_point.empty())
    for (const auto index : indices)
      stations.of_point.push_back(stations_.of_point[index]);
  return stations;
}

template <typename PointT>
void
RoomSegmentation<PointT>::describeInput(const Indices& indices)
{
  report_.voxel_size = building_.grid.voxel_size;
  const std::size_t all = building_.point_labels.size() + report_.outside.size();
  for (const std::size_t i : building_.outside)
    report_.outside.push_back(indices.empty() ? static_cast<index_t>(i) : indices[i]);
  std::sort(report_.outside.begin(), report_.outside.end());
  if (!indoor::unitWarning(report_.vertical, report_.metres_per_unit).empty())
    return; // what follows would be no wonder
  warn(indoor::feetWarning(
      building_.rooms, building_.openings, report_.metres_per_unit));
  warn(indoor::endWarning(building_.openings, report_.up_axis));
  warn(indoor::outsideWarning(report_.outside.size(), all));
  for (const std::string& line : indoor::unseenWarnings(building_))
    warn(line);
}

template <typename PointT>
void
RoomSegmentation<PointT>::replaceVerticalNote(const std::string& note)
{
  auto& lines = report_.warnings;
  const auto old = indoor::verticalNote(report_.vertical);
  lines.erase(std::remove(lines.begin(), lines.end(), old), lines.end());
  warn(note);
}

template <typename PointT>
void
RoomSegmentation<PointT>::turnOver(std::vector<Eigen::Vector3f>& points)
{
  const auto over = indoor::moveIntoBuildingFrame(points, -Eigen::Vector3f::UnitZ());
  frame_.pose = frame_.pose * over.pose;
}

template <typename PointT>
void
RoomSegmentation<PointT>::turnIfPassagesStand(std::vector<Eigen::Vector3f>& points,
                                              const FindRooms& find)
{
  const auto pose = frame_.pose;
  turnOver(points);
  auto turned = find();
  if (indoor::endOfPassages(turned.openings) != -1) {
    frame_.pose = pose;
    return;
  }
  replaceVerticalNote(indoor::reversedNote(building_.openings, report_.vertical));
  report_.vertical = report_.vertical.reversed();
  report_.up_axis = -report_.up_axis;
  building_ = std::move(turned);
}

template <typename PointT>
void
RoomSegmentation<PointT>::askEndFinder(std::vector<Eigen::Vector3f>& points,
                                       const FindRooms& find)
{
  const int end = end_finder_(points);
  if (end == 0) {
    if (report_.vertical.is_end_known) // else it was said
      warn(indoor::unclearEndNote(report_.up_axis));
    return;
  }
  auto vertical = end > 0 ? report_.vertical : report_.vertical.reversed();
  vertical.is_end_known = report_.end_is_recognised = true;
  replaceVerticalNote(indoor::verticalNote(vertical));
  report_.vertical = vertical;
  if (end > 0)
    return;
  report_.up_axis = -report_.up_axis;
  turnOver(points);
  building_ = find();
}

template <typename PointT>
void
RoomSegmentation<PointT>::turnIfUpsideDown(std::vector<Eigen::Vector3f>& points,
                                           const FindRooms& find)
{
  const auto& vertical = report_.vertical;
  if (up_axis_ || !indoor::unitWarning(vertical, report_.metres_per_unit).empty())
    return;
  if (indoor::endOfPassages(building_.openings) == 1) {
    turnIfPassagesStand(points, find);
    return;
  }
  const bool is_clear =
      vertical.is_end_known &&
      (vertical.is_furnished || indoor::allPassagesStand(building_.openings));
  if (end_finder_ && vertical.is_found && !is_clear)
    askEndFinder(points, find);
}

template <typename PointT>
void
RoomSegmentation<PointT>::segment(std::vector<std::uint32_t>& labels)
{
  labels.clear();
  report_ = indoor::ScanReport();
  frame_ = indoor::BuildingFrame();
  building_ = indoor::BuildingRooms();
  rooms_.clear();
  openings_.clear();
  if (!initCompute())
    return;

  IndicesConstPtr indices; // of the points; null if they are those of the cloud
  auto points = pointsOfBuilding(indices);
  if (points.empty() && report_.outside.empty()) {
    PCL_ERROR("[pcl::RoomSegmentation::segment] No point is finite.\n");
    this->deinitCompute();
    return;
  }
  bool goes_on = true;
  double done = 0.0;
  const auto tell = [&](double share, const char* stage) {
    done = std::max(done, share); // rooms may be found twice
    goes_on = !progress_ || progress_(done, stage);
    return goes_on;
  };
  const auto progress = [&](double share, const char* stage) {
    return share == 1.0 || tell(share, stage); // the end is told below
  };
  const auto find = [&] {
    const auto stations = stationsOfBuilding(indices ? *indices : Indices());
    if (method_ == indoor::RoomMethod::CeilingSlab)
      return indoor::segmentBuilding(points, options_, progress, stations);
    return indoor::thesis::segmentBuilding(
        points, {options_, field_, point_rooms_}, progress, stations);
  };
  try {
    building_ = find();
    if (goes_on)
      turnIfUpsideDown(points, find);
  } catch (const BadArgumentException& error) { // such as far too many voxels
    PCL_ERROR("[pcl::RoomSegmentation::segment] %s\n",
              indoor::plainMessage(error).c_str());
    this->deinitCompute();
    return;
  }
  std::vector<Eigen::Vector3f>().swap(points); // they may be many
  if (!goes_on || !tell(1.0, "done"))
    building_ = indoor::BuildingRooms();
  if (goes_on) {
    const Indices all;
    describeInput(indices ? *indices : all);
    rooms_ = building_.rooms;
    openings_ = building_.openings;
    std::vector<Eigen::AlignedBox3f> boxes(rooms_.size());
    labels.assign(input_->size(), 0);
    for (std::size_t i = 0; i < building_.point_labels.size(); ++i) {
      const auto index = indices ? (*indices)[i] : static_cast<index_t>(i);
      labels[index] = building_.point_labels[i];
      if (labels[index] > 0)
        boxes[labels[index] - 1].extend((*input_)[index].getVector3fMap());
    }
    indoor::placeInScan(frame_, boxes, rooms_, openings_);
  }
  this->deinitCompute();
}

template <typename PointT>
void
RoomSegmentation<PointT>::segment(std::vector<PointIndices>& rooms)
{
  std::vector<std::uint32_t> labels;
  segment(labels);
  rooms = indoor::indicesOfLabels(input_, labels, rooms_.size());
}

template <typename PointT>
void
RoomSegmentation<PointT>::segment(pcl::PointCloud<PointXYZL>& output)
{
  std::vector<std::uint32_t> labels;
  segment(labels);
  indoor::labelCloud(input_, labels, output);
}

} // namespace pcl

#define PCL_INSTANTIATE_RoomSegmentation(T)                                            \
  template class PCL_INDOOR_EXPORTS pcl::RoomSegmentation<T>;
