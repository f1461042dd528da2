/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl::indoor {

/** \brief A unit direction, the same as its opposite, and its share of all weight. */
struct WeightedDirection {
  Eigen::Vector3d direction;
  double weight;
};

/** \brief Put directions into the cells of a cube's three upper faces (about 1 degree).
 * \return the mean direction and the share of each occupied cell, in a fixed order
 */
std::vector<WeightedDirection>
sphereHistogram(const std::vector<Eigen::Vector3d>& normals,
                const std::vector<double>& weights);

/** \brief The modes of a histogram: directions with more weight around them than on
 * both sides of them, strongest first.
 * \param[in] cone radius of the neighbourhood, radians
 * \param[in] min_share least weight within the cone
 * \param[in] min_contrast least ratio of the weight in the cone to the weight that lies
 * in the ring around it (up to twice the radius) on opposite sides; what is on one side
 * only belongs to another mode
 */
std::vector<WeightedDirection>
sphereModes(const std::vector<WeightedDirection>& histogram,
            double cone,
            double min_share,
            double min_contrast);

} // namespace pcl::indoor
