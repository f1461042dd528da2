/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/common/point_tests.h> // for isFinite
#include <pcl/console/print.h>
#include <pcl/features/hough_normals.h>
#include <pcl/indoor/exports.h>
#include <pcl/indoor/first_in_place.h>
#include <pcl/indoor/index_check.h>
#include <pcl/indoor/neighbor_distance.h>
#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/threads.h>
#include <pcl/indoor/usable_point.h>
#include <pcl/search/kdtree.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace pcl {

template <typename PointInT, typename PointOutT>
HoughNormalEstimation<PointInT, PointOutT>::HoughNormalEstimation(unsigned threads)
: threads_(threads)
{
  feature_name_ = "HoughNormalEstimation";
}

template <typename PointInT, typename PointOutT>
void
HoughNormalEstimation<PointInT, PointOutT>::getViewPoint(float& x,
                                                         float& y,
                                                         float& z) const
{
  const Eigen::Vector3f place =
      use_sensor_origin_ && input_
          ? Eigen::Vector3f(input_->sensor_origin_.template head<3>())
          : viewpoint_;
  x = place.x();
  y = place.y();
  z = place.z();
}

template <typename PointInT, typename PointOutT>
bool
HoughNormalEstimation<PointInT, PointOutT>::initCompute()
{
  std::string problem = indoor::findProblem(options_);
  if (problem.empty() && input_ && indices_ && !this->fake_indices_)
    problem = indoor::findIndexProblem(*indices_, input_->size());
  if (!(search_radius_ >= 0) || !std::isfinite(search_radius_))
    problem = "The radius must not be negative, not " + std::to_string(search_radius_) +
              " m.";
  if (k_ != 0 && k_ < 3)
    problem = "A plane takes at least 3 neighbours, not " + std::to_string(k_) + ".";
  if (!problem.empty()) {
    PCL_ERROR("[pcl::HoughNormalEstimation::initCompute] %s\n", problem.c_str());
    return false;
  }
  const auto& searched = surface_ ? surface_ : input_;
  for (std::size_t i = 0; searched && i < searched->size(); ++i)
    if (isFinite((*searched)[i]) && !indoor::isUsablePoint((*searched)[i])) {
      PCL_ERROR("[pcl::HoughNormalEstimation::initCompute] Point %zu is more than %g m "
                "from the origin, too far for the search of neighbours.\n",
                i,
                static_cast<double>(indoor::largest_coordinate));
      return false;
    }
  automatic_radius_ = search_radius_ == 0 && k_ == 0 && searched;
  if (automatic_radius_)
    search_radius_ = 2 * indoor::neighborhoodRadius(*searched, threads_);
  if (automatic_radius_ && !(search_radius_ > 0))
    search_radius_ = 1e-30; // no two different points, or too near for their squared
                            // distances to be told from 0: no neighbourhood
  // Feature would search a cloud in rows as the image of a camera, which a scan in rows
  // need not be: neighbours are missed, and some searches have no end.
  if (!this->tree_)
    this->setSearchMethod(pcl::make_shared<search::KdTree<PointInT>>(false));
  return Feature<PointInT, PointOutT>::initCompute() || (deinitCompute(), false);
}

template <typename PointInT, typename PointOutT>
bool
HoughNormalEstimation<PointInT, PointOutT>::deinitCompute()
{
  if (automatic_radius_)
    search_radius_ = 0;
  automatic_radius_ = false;
  return Feature<PointInT, PointOutT>::deinitCompute();
}

template <typename PointInT, typename PointOutT>
void
HoughNormalEstimation<PointInT, PointOutT>::computeFeature(PointCloudOut& output)
{
  const indoor::HoughNormalEstimator shared(options_);
  // Points in one place have one normal, which is found once: where there are thousands
  // of them, each finds all others as neighbours.
  const auto first = indoor::firstInPlace(*input_, *indices_);
  const auto count = static_cast<std::ptrdiff_t>(indices_->size());
  struct State {
    indoor::HoughNormalEstimator estimator;
    Indices neighbors;
    std::vector<float> squared_distances;
    std::vector<Eigen::Vector3f> offsets;
    bool dense;
  };
  output.is_dense = true;
  indoor::parallelFor(
      count,
      static_cast<int>(threads_),
      256,
      [&shared] {
        return State{shared, {}, {}, {}, true};
      },
      [&](State& state, std::ptrdiff_t i) {
        auto& [estimator, neighbors, squared_distances, offsets, dense] = state;
        if (first[i] != i)
          return;
        const auto index = (*indices_)[i];
        const PointInT& point = (*input_)[index];
        offsets.clear();
        if (indoor::isUsablePoint(point)) {
          this->searchForNeighbors(
              index, search_parameter_, neighbors, squared_distances);
          // Double differences: nothing is lost in large coordinates.
          const Eigen::Vector3d origin = point.getVector3fMap().template cast<double>();
          for (const auto neighbor : neighbors)
            offsets.push_back(
                ((*surface_)[neighbor].getVector3fMap().template cast<double>() -
                 origin)
                    .template cast<float>());
        }
        const auto found = estimator.estimate(offsets);
        output[i].getNormalVector3fMap() = found.normal;
        output[i].curvature = found.curvature;
        dense = dense && std::isfinite(found.normal.x());
      },
      [&output](const State& state) { output.is_dense &= state.dense; });
  for (std::ptrdiff_t i = 0; i < count; ++i)
    output[i] = output[first[i]];
  orient(output);
}

template <typename PointInT, typename PointOutT>
void
HoughNormalEstimation<PointInT, PointOutT>::orient(PointCloudOut& output) const
{
  using indoor::NormalOrientation;
  Eigen::Vector3f viewpoint;
  getViewPoint(viewpoint.x(), viewpoint.y(), viewpoint.z());
  std::vector<std::size_t> oriented;
  std::vector<Eigen::Vector3f> positions, normals; // relative to the viewpoint
  for (std::size_t i = 0; i < output.size(); ++i) {
    if (!output[i].getNormalVector3fMap().allFinite())
      continue;
    oriented.push_back(i);
    normals.push_back(output[i].getNormalVector3fMap());
    positions.push_back(
        ((*input_)[(*indices_)[i]].getVector3fMap().template cast<double>() -
         viewpoint.template cast<double>())
            .template cast<float>());
  }
  const bool alone = orientation_ == NormalOrientation::Viewpoint ||
                     orientation_ == NormalOrientation::Automatic;
  indoor::FreeSpaceOptions free_space;
  free_space.threads = threads_;
  indoor::orientNormals(orientation_,
                        positions,
                        alone ? indoor::Adjacency()
                              : indoor::nearestNeighbors(positions, 8, threads_),
                        {Eigen::Vector3f::Zero()},
                        free_space,
                        normals);
  for (std::size_t i = 0; i < oriented.size(); ++i)
    output[oriented[i]].getNormalVector3fMap() = normals[i];
}

} // namespace pcl

#define PCL_INSTANTIATE_HoughNormalEstimation(T, OutT)                                 \
  template class PCL_INDOOR_EXPORTS pcl::HoughNormalEstimation<T, OutT>;
