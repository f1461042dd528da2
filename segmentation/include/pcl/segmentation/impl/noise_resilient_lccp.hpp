/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/segmentation/impl/noise_resilient_lccp_parameters.hpp>
#include <pcl/segmentation/noise_resilient_lccp.h>

#include <pcl/exceptions.h>
#include <pcl/features/unit_normals.h>
#include <pcl/indoor/labelled_outputs.h>
#include <pcl/indoor/middle_point.h>
#include <pcl/indoor/plain_message.h>
#include <pcl/indoor/stray_points.h>
#include <pcl/indoor/usable_point.h>
#include <pcl/segmentation/scan_warnings.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace pcl {

template <typename PointT>
bool
NoiseResilientLCCP<PointT>::initCompute()
{
  const char* where = "[pcl::NoiseResilientLCCP::initCompute]";
  if (!PCLBase<PointT>::initCompute()) {
    PCL_ERROR("%s No input cloud was set.\n", where);
    return false;
  }
  if (this->fake_indices_ && indices_->size() != input_->size())
    return false; // there was no memory for them, as PCL has said
  if (input_->empty() || indices_->empty()) {
    PCL_ERROR("%s The input has no points.\n", where);
    return false;
  }
  for (const auto index : *indices_)
    if (index < 0 || static_cast<std::size_t>(index) >= input_->size()) {
      PCL_ERROR("%s Index %d is outside of the cloud.\n", where, index);
      return false;
    }
  if (normals_ && normals_->size() != input_->size()) {
    PCL_ERROR("%s The input has %zu points, but %zu normals.\n",
              where,
              static_cast<std::size_t>(input_->size()),
              static_cast<std::size_t>(normals_->size()));
    return false;
  }
  if (colors_ && colors_->size() != input_->size()) {
    PCL_ERROR("%s The input has %zu points, but %zu colors.\n",
              where,
              static_cast<std::size_t>(input_->size()),
              static_cast<std::size_t>(colors_->size()));
    return false;
  }
  const bool has_sensor =
      !viewpoint_.empty() || input_->height > 1 || camera_ == Camera::Single;
  const Eigen::Vector3f sensor = sensorOrigin().template cast<float>();
  if (has_sensor && !indoor::isUsable(sensor)) {
    PCL_ERROR("%s The sensor stands at %g %g %g, which is no usable place.\n",
              where,
              static_cast<double>(sensor.x()),
              static_cast<double>(sensor.y()),
              static_cast<double>(sensor.z()));
    return false;
  }
  const auto problem = findProblem();
  if (!problem.empty()) {
    PCL_ERROR("%s %s\n", where, problem.c_str());
    return false;
  }
  return true;
}

template <typename PointT>
std::string
NoiseResilientLCCP<PointT>::findProblem() const
{
  if (on_points_ && partition_ == Partition::Pieces)
    return "On points there are no pieces to join.";
  return indoor::thesis::findProblem(
      indoor::thesis::ObjectOptions{options_, edges_, on_points_});
}

template <typename PointT>
Eigen::Vector3d
NoiseResilientLCCP<PointT>::sensorOrigin() const
{
  return viewpoint_.empty()
             ? Eigen::Vector3d(
                   input_->sensor_origin_.template head<3>().template cast<double>())
             : viewpoint_.front();
}

template <typename PointT>
indoor::CameraView
NoiseResilientLCCP<PointT>::viewOf(const std::vector<Eigen::Vector3f>& points) const
{
  using indoor::Capture;
  if (!input_)
    return {camera_ == Camera::Single ? Capture::TableView : Capture::Scan, false};
  const Eigen::Vector3f sensor = sensorOrigin().template cast<float>();
  if (camera_ == Camera::Single)
    return {Capture::TableView, indoor::areBehind(points, sensor)};
  if (camera_ == Camera::Any || !indoor::isUsable(sensor))
    return {};
  auto view = indoor::cameraView(points, sensor, input_->height > 1);
  const bool for_tables = options_.pieces.scale == indoor::JoiningScale::View;
  if (view.capture == Capture::RoomView && for_tables)
    view.capture = Capture::TableView;
  return view;
}

template <typename PointT>
Eigen::Vector3f
NoiseResilientLCCP<PointT>::colorOf(index_t index) const
{
  const auto read = [](const auto& point) {
    return Eigen::Vector3f(static_cast<float>(point.r),
                           static_cast<float>(point.g),
                           static_cast<float>(point.b));
  };
  if constexpr (traits::has_color<PointT>::value)
    if (!colors_)
      return read((*input_)[index]);
  return read((*colors_)[index]);
}

template <typename PointT>
indoor::ObjectSegmentationInput
NoiseResilientLCCP<PointT>::localInput()
{
  const bool has_colors = colors_ || traits::has_color<PointT>::value;
  indoor::ObjectSegmentationInput local;
  for (const auto index : *indices_)
    if (indoor::isUsablePoint((*input_)[index]))
      finite_.push_back(index);
  for (const auto index : finite_)
    local.points.push_back((*input_)[index].getVector3fMap());
  const auto strays = indoor::strayPoints(local.points);
  warn(indoor::straysWarning(strays.size(), local.points.size()));
  indoor::takeOut(strays, local.points);
  indoor::takeOut(strays, finite_);
  report_.view = viewOf(local.points);
  const auto in_frame = [turned = report_.view.is_turned](const Eigen::Vector3f& v) {
    return turned ? indoor::halfTurned(v) : v;
  };
  for (std::size_t i = 0; i < finite_.size(); ++i) {
    const auto index = finite_[i];
    local.points[i] = in_frame(local.points[i]);
    if (normals_)
      local.normals.push_back(in_frame((*normals_)[index].getNormalVector3fMap()));
    if (has_colors && on_points_ && on_points_->color_weight > 0)
      local.colors.push_back(colorOf(index));
  }
  const auto problem = indoor::findNormalsProblem(local.points, local.normals);
  if (!problem.empty()) {
    PCL_WARN(
        "[pcl::NoiseResilientLCCP::segment] The normals are not used but estimated: "
        "%s.\n",
        problem.c_str());
    local.normals.clear();
  }
  const Eigen::Vector3d origin = indoor::moveToMiddle(local.points);
  Eigen::Vector3d sensor = sensorOrigin();
  if (report_.view.is_turned)
    sensor.tail<2>() *= -1;
  local.capture = report_.view.capture;
  report_.up_axis = up_;
  if (!up_chosen_ && local.capture == indoor::Capture::Scan) {
    const auto vertical = indoor::findVertical(local.points);
    report_.up_axis = vertical.upAxis();
    warn(indoor::verticalNote(vertical));
  }
  local.up = in_frame(report_.up_axis);
  if (local.capture != indoor::Capture::Scan || !viewpoint_.empty())
    local.viewpoint.assign(1, (sensor - origin).template cast<float>());
  if (local.capture == indoor::Capture::RoomView && up_chosen_)
    local.capture = indoor::Capture::Scan; // but for the viewpoint
  local.voter = voter_;
  return local;
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::warn(const std::string& line)
{
  if (line.empty())
    return;
  report_.warnings.push_back(line);
  PCL_WARN("[pcl::NoiseResilientLCCP::segment] %s\n", line.c_str());
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::segment(std::vector<std::uint32_t>& labels)
{
  labels.clear();
  finite_.clear();
  result_ = indoor::ObjectSegmentation();
  report_ = indoor::ObjectReport();
  input_size_ = 0;
  if (!initCompute())
    return;
  auto input = localInput();
  const bool is_table = input.capture == indoor::Capture::TableView;
  const auto& options = is_table ? table_options_ : options_;
  if (camera_ == Camera::Automatic)
    warn(indoor::cameraNote(report_.view));
  warn(indoor::farViewWarning(input));
  bool goes_on = true;
  const auto progress = [&](double share, const char* stage) {
    goes_on = !progress_ || progress_(share, stage);
    return goes_on;
  };
  try {
    if (finite_.empty())
      PCL_THROW_EXCEPTION(BadArgumentException, "No point is finite.");
    if (partition_ == Partition::Pieces)
      result_ = indoor::segmentObjects(std::move(input), options, progress);
    else
      result_ = indoor::thesis::segmentObjects(
          std::move(input), {options, edges_, on_points_}, progress);
  } catch (const PCLException& error) { // voxels too small for the extent of the cloud
    PCL_ERROR("[pcl::NoiseResilientLCCP::segment] %s\n",
              indoor::plainMessage(error).c_str());
    goes_on = false;
  }
  if (!goes_on) {
    finite_.clear();
    this->deinitCompute();
    return;
  }
  report_.options = result_.options;
  const auto as_one = indoor::oneSegmentWarning(result_);
  warn(as_one.empty() ? indoor::tableTopWarning(result_) : as_one);
  if (as_one.empty())
    warn(indoor::wideObjectWarning(result_));
  input_size_ = input_->size();
  labels.assign(input_size_, 0);
  std::vector<std::uint32_t> name_of_segment(result_.segment_count, 0);
  std::vector<std::uint32_t> segment_of_point(input_size_,
                                              indoor::ObjectSegmentation::none);
  for (std::size_t i = 0; i < finite_.size(); ++i)
    segment_of_point[finite_[i]] = result_.segment_of_point[i];
  std::uint32_t names = 0;
  for (std::size_t i = 0; i < input_size_; ++i) {
    if (segment_of_point[i] == indoor::ObjectSegmentation::none)
      continue;
    auto& name = name_of_segment[segment_of_point[i]];
    if (name == 0)
      name = ++names;
    labels[i] = name;
  }
  this->deinitCompute();
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::segment(PointCloud<PointXYZL>& output)
{
  std::vector<std::uint32_t> labels;
  segment(labels);
  indoor::labelCloud(input_, labels, output);
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::segment(std::vector<PointIndices>& segments)
{
  std::vector<std::uint32_t> labels;
  segment(labels);
  segments = indoor::indicesOfLabels(input_, labels, result_.segment_count);
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::segment()
{
  segment_of_supervoxel_.clear();
  const auto problem =
      given_.names.empty() ? "No supervoxels were set." : findProblem();
  if (!problem.empty())
    PCL_ERROR("[pcl::NoiseResilientLCCP::segment] %s\n", problem.c_str());
  else if (partition_ == Partition::Pieces)
    segment_of_supervoxel_ = indoor::segmentSupervoxels(given_, options_);
  else
    segment_of_supervoxel_ =
        indoor::thesis::segmentSupervoxels(given_, {options_, edges_, on_points_});
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::relabelCloud(PointCloud<PointXYZL>& labeled_cloud) const
{
  for (auto& point : labeled_cloud) {
    const auto segment = segment_of_supervoxel_.find(point.label);
    point.label = segment == segment_of_supervoxel_.end() ? 0 : segment->second;
  }
}

template <typename PointT>
const std::map<std::uint32_t, std::uint32_t>&
NoiseResilientLCCP<PointT>::getSupervoxelToSegmentMap() const
{
  return segment_of_supervoxel_;
}

template <typename PointT>
Indices
NoiseResilientLCCP<PointT>::getRemovedIndices() const
{
  const auto is_removed = indoor::removedPoints(result_);
  Indices removed;
  for (std::size_t i = 0; i < finite_.size(); ++i)
    if (is_removed[i])
      removed.push_back(finite_[i]);
  return removed;
}

template <typename PointT>
Indices
NoiseResilientLCCP<PointT>::getStructureIndices() const
{
  const auto is_structure = indoor::structurePoints(result_);
  Indices structure;
  for (std::size_t i = 0; i < finite_.size(); ++i)
    if (is_structure[i])
      structure.push_back(finite_[i]);
  return structure;
}

template <typename PointT>
std::vector<std::uint32_t>
NoiseResilientLCCP<PointT>::getStructure() const
{
  std::vector<std::uint32_t> structure(input_size_, 0);
  for (std::size_t i = 0; i < finite_.size(); ++i)
    if (result_.segment_of_point[i] != indoor::ObjectSegmentation::none)
      structure[finite_[i]] = static_cast<std::uint32_t>(
          result_.structure_of_segment[result_.segment_of_point[i]]);
  return structure;
}

template <typename PointT>
std::vector<std::uint32_t>
NoiseResilientLCCP<PointT>::getSegmentsAtLevel(float level) const
{
  if (result_.piece_of_point.empty())
    return {};
  const auto segments = indoor::segmentsAtLevel(result_, level);
  std::vector<std::uint32_t> labels(input_size_, 0);
  for (std::size_t i = 0; i < finite_.size(); ++i)
    labels[finite_[i]] = segments[result_.piece_of_point[i]] + 1;
  return labels;
}

template <typename PointT>
const std::vector<indoor::PieceJoin>&
NoiseResilientLCCP<PointT>::getHierarchy() const
{
  return result_.joins;
}

template <typename PointT>
std::vector<std::uint32_t>
NoiseResilientLCCP<PointT>::getSupervoxelLabels() const
{
  const auto supervoxels = indoor::supervoxelsOfPoints(result_);
  std::vector<std::uint32_t> labels(input_size_, 0);
  for (std::size_t i = 0; i < finite_.size(); ++i)
    if (supervoxels[i] != indoor::ObjectSegmentation::none)
      labels[finite_[i]] = supervoxels[i] + 1;
  return labels;
}

template <typename PointT>
std::multimap<std::uint32_t, std::uint32_t>
NoiseResilientLCCP<PointT>::getSupervoxelAdjacency() const
{
  std::multimap<std::uint32_t, std::uint32_t> adjacency;
  for (const auto& [one, other] : indoor::touchingSupervoxels(result_)) {
    adjacency.emplace(one + 1, other + 1);
    adjacency.emplace(other + 1, one + 1);
  }
  return adjacency;
}

template <typename PointT>
const indoor::ObjectSegmentation&
NoiseResilientLCCP<PointT>::getResult() const
{
  return result_;
}

} // namespace pcl

#define PCL_INSTANTIATE_NoiseResilientLCCP(T)                                          \
  template class PCL_INDOOR_EXPORTS pcl::NoiseResilientLCCP<T>;
