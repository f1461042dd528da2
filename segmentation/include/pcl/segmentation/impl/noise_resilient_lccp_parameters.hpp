/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

// The setters and getters of pcl::NoiseResilientLCCP.

#include <pcl/segmentation/noise_resilient_lccp.h>

#include <pcl/indoor/usable_point.h>

namespace pcl {

template <typename PointT>
template <typename Change>
void
NoiseResilientLCCP<PointT>::set(const Change& change)
{
  change(options_);
  change(table_options_);
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::setInputNormals(const PointCloudN::ConstPtr& normals)
{
  normals_ = normals;
}

template <typename PointT>
typename NoiseResilientLCCP<PointT>::PointCloudN::ConstPtr
NoiseResilientLCCP<PointT>::getInputNormals() const
{
  return normals_;
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::setInputColors(const PointCloud<RGB>::ConstPtr& colors)
{
  colors_ = colors;
}

template <typename PointT>
PointCloud<RGB>::ConstPtr
NoiseResilientLCCP<PointT>::getInputColors() const
{
  return colors_;
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::setVoxelResolution(double value)
{
  set([value](auto& options) { options.voxel_size = value; });
}

template <typename PointT>
double
NoiseResilientLCCP<PointT>::getVoxelResolution() const
{
  return options_.voxel_size;
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::setSeedResolution(double value)
{
  set([value](auto& options) { options.seed_size = value; });
}

template <typename PointT>
double
NoiseResilientLCCP<PointT>::getSeedResolution() const
{
  return options_.seed_size;
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::setCurvatureThreshold(float value)
{
  set([value](auto& options) { options.curvature_threshold = value; });
}

template <typename PointT>
float
NoiseResilientLCCP<PointT>::getCurvatureThreshold() const
{
  return options_.curvature_threshold;
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::setRatioThreshold(float value)
{
  set([value](auto& options) { options.ratio_threshold = value; });
}

template <typename PointT>
float
NoiseResilientLCCP<PointT>::getRatioThreshold() const
{
  return options_.ratio_threshold;
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::setPartition(Partition partition)
{
  partition_ = partition;
  edges_.partition = partition == Partition::Lccp
                         ? indoor::thesis::EdgePartition::Lccp
                         : indoor::thesis::EdgePartition::FelzenszwalbHuttenlocher;
}

template <typename PointT>
typename NoiseResilientLCCP<PointT>::Partition
NoiseResilientLCCP<PointT>::getPartition() const
{
  return partition_;
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::setJoiningScale(indoor::JoiningScale value)
{
  set([value](auto& options) { options.pieces.scale = value; });
}

template <typename PointT>
indoor::JoiningScale
NoiseResilientLCCP<PointT>::getJoiningScale() const
{
  return options_.pieces.scale;
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::setJoiningLevel(float value)
{
  set([value](auto& options) { options.pieces.joining_level = value; });
}

template <typename PointT>
std::optional<float>
NoiseResilientLCCP<PointT>::getJoiningLevel() const
{
  return options_.pieces.joining_level;
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::setFewestPoints(std::uint32_t value)
{
  set([value](auto& options) { options.fewest_points = value; });
}

template <typename PointT>
std::uint32_t
NoiseResilientLCCP<PointT>::getFewestPoints() const
{
  return options_.fewest_points;
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::setGraphScale(float value)
{
  edges_.graph_scale = value;
}

template <typename PointT>
float
NoiseResilientLCCP<PointT>::getGraphScale() const
{
  return edges_.graph_scale;
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::setMinSegmentSize(std::uint32_t value)
{
  set([value](auto& options) { options.min_segment_size = value; });
}

template <typename PointT>
std::uint32_t
NoiseResilientLCCP<PointT>::getMinSegmentSize() const
{
  return options_.min_segment_size;
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::setConcavityToleranceThreshold(float value)
{
  edges_.concavity_tolerance_degrees = value;
}

template <typename PointT>
float
NoiseResilientLCCP<PointT>::getConcavityToleranceThreshold() const
{
  return edges_.concavity_tolerance_degrees;
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::setOptions(const indoor::ObjectSegmentationOptions& options)
{
  set([&options](auto& all) { all = options; });
  partition_ = Partition::Pieces;
  edges_ = {};
  on_points_.reset();
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::setThesisOptions(
    const indoor::thesis::ObjectOptions& options)
{
  setOptions(options.shared);
  edges_ = options.edges;
  on_points_ = options.on_points;
  partition_ = edges_.partition == indoor::thesis::EdgePartition::Lccp
                   ? Partition::Lccp
                   : Partition::FelzenszwalbHuttenlocher;
}

template <typename PointT>
const indoor::ObjectSegmentationOptions&
NoiseResilientLCCP<PointT>::getOptions() const
{
  return options_;
}

template <typename PointT>
const indoor::ObjectReport&
NoiseResilientLCCP<PointT>::getReport() const
{
  return report_;
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::setViewPoint(double x, double y, double z)
{
  viewpoint_.assign(1, Eigen::Vector3d(x, y, z));
}

template <typename PointT>
Eigen::Vector3d
NoiseResilientLCCP<PointT>::getViewPoint() const
{
  return viewpoint_.empty() ? Eigen::Vector3d(0, 0, 0) : viewpoint_.front();
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::setUpAxis(const Eigen::Vector3f& axis)
{
  up_ = axis.normalized();
  up_chosen_ = true;
}

template <typename PointT>
const Eigen::Vector3f&
NoiseResilientLCCP<PointT>::getUpAxis() const
{
  return up_;
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::setNormalOrientation(indoor::NormalOrientation orientation)
{
  set([orientation](auto& options) { options.orientation = orientation; });
}

template <typename PointT>
indoor::NormalOrientation
NoiseResilientLCCP<PointT>::getNormalOrientation() const
{
  return options_.orientation;
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::setUseSingleCameraTransform(bool use)
{
  camera_ = use ? Camera::Single : Camera::Any;
}

template <typename PointT>
bool
NoiseResilientLCCP<PointT>::getUseSingleCameraTransform() const
{
  std::vector<Eigen::Vector3f> points;
  if (input_ && camera_ == Camera::Automatic)
    for (const auto& point : *input_)
      if (indoor::isUsablePoint(point))
        points.push_back(point.getVector3fMap());
  return viewOf(points).capture == indoor::Capture::TableView;
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::setNumberOfThreads(unsigned threads)
{
  set([threads](auto& options) { options.threads = threads; });
}

template <typename PointT>
unsigned
NoiseResilientLCCP<PointT>::getNumberOfThreads() const
{
  return options_.threads;
}

template <typename PointT>
void
NoiseResilientLCCP<PointT>::setProgressCallback(
    const indoor::ProgressCallback& callback)
{
  progress_ = callback;
}

} // namespace pcl
