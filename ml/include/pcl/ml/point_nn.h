/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief Parameters of pointNNDescriptor(); the defaults are the paper's. */
struct PointNNOptions {
  std::size_t point_count = 1024; ///< of an object with more, at least 16
  int stage_count = 4;            ///< each halves the points, 1 ... 8
  int embedding_size = 72; ///< values of a point at first, a multiple of 6, 6 ... 600
  std::size_t neighbor_count = 90; ///< of a point in each stage, at least 1
  double wavelength_base = 1000.0; ///< alpha: wavelengths spread over this, above 1
  double magnitude = 100.0;        ///< beta: coordinates are multiplied by it, above 0
};

/** \brief The descriptor of a set of points by Point-NN, a network without trained
 * values.
 *
 * R. Zhang et al., Parameter is not all you need: starting from non-parametric networks
 * for 3D point cloud analysis, CVPR 2023. Each point is embedded by sines and cosines
 * of its coordinates. In each of the stages half of the points are kept, the farthest
 * ones from each other; each takes the values of its nearest neighbours, brought to its
 * own and to unit deviation, and its own values again, adds and multiplies sines and
 * cosines of the neighbours' places around it, and keeps the sum of maximum and mean.
 * The same pooling makes one descriptor of all. The deviations are those within the
 * object, not of a batch. A turned object has another descriptor.
 * \param[in] points finite; centred and brought into the unit sphere first; of too many
 * those farthest from each other are taken
 * \return embedding_size * 2^stage_count values of length 1; all NaN if no two points
 * differ
 * \throws pcl::BadArgumentException if an option is out of its range
 */
PCL_INDOOR_EXPORTS std::vector<float>
pointNNDescriptor(const std::vector<Eigen::Vector3f>& points,
                  const PointNNOptions& options = {});

/** \brief Objects of known classes. */
struct PointNNMemory {
  std::vector<std::vector<float>> descriptors; ///< as pointNNDescriptor() gives them
  std::vector<int> labels;                     ///< one each, from 0
};

/** \brief Scores of the classes by similarity to a memory.
 *
 * An object of the memory adds exp(-sharpness * (1 - cosine)) to its class; the scores
 * are brought to a sum of 1. Descriptors that are not finite are left out.
 * \param[in] sharpness gamma, above 0; the larger, the more the nearest alone counts.
 * The paper's authors choose it on the test set; the default is the best of 10, 30, 100
 * ... 10,000 within a memory, each object against the others
 * \return one score per class; empty if the descriptor or all of the memory is not
 * finite
 * \throws pcl::BadArgumentException if lengths differ, or a label is negative or not
 * below class_count
 */
PCL_INDOOR_EXPORTS std::vector<float>
pointNNScores(const std::vector<float>& descriptor,
              const PointNNMemory& memory,
              std::size_t class_count,
              double sharpness = 3000.0);

/** \brief Some of the points, each the farthest from those before it.
 *
 * The first is the farthest from the mean, so that the order of the points does not
 * matter; of equally far ones the first is taken.
 * \return indices, as many as wanted or as there are points
 */
PCL_INDOOR_EXPORTS std::vector<std::uint32_t>
farthestPoints(const std::vector<Eigen::Vector3f>& points, std::size_t wanted);

/** \brief The nearest points of a place, of equally near ones the first.
 * \return sorted indices, as many as wanted or as there are points
 */
PCL_INDOOR_EXPORTS std::vector<std::uint32_t>
nearestPoints(const std::vector<Eigen::Vector3f>& points,
              const Eigen::Vector3f& place,
              std::size_t wanted);

} // namespace pcl::indoor
