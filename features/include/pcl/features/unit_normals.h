/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <Eigen/Core>

#include <cmath>
#include <string>
#include <vector>

namespace pcl::indoor {

/** \brief Least share of normals that have length 1 where they are normals. Estimates
 * leave out single points; colours, or zeros in half of them, are far below. */
constexpr double least_unit_share = 0.95;

/** \brief Has a normal length 1, but for what is lost in a few bits or digits? */
inline bool
isUnitNormal(const Eigen::Vector3f& normal)
{
  return std::abs(normal.norm() - 1.0f) <= 0.05f; // false for NaN
}

/** \brief A normal; zero where it is not finite, as PCL has them of one or two points.
 */
inline Eigen::Vector3f
finiteNormal(const Eigen::Vector3f& normal)
{
  return normal.allFinite() ? normal : Eigen::Vector3f(Eigen::Vector3f::Zero());
}

/** \brief Have nearly all length 1? What else is called normals may be zeros or
 * colours. */
PCL_INDOOR_EXPORTS bool
areUnitNormals(const std::vector<Eigen::Vector3f>& normals);

/** \brief Find out why the normals that come with points cannot be theirs: too few have
 * length 1, or they do not stand on the surfaces, as where all are alike, or where the
 * points alone were turned. Surfaces are patches of some points that are flat, from all
 * over the cloud; of those whose normal is along x, y or z each, half must agree.
 * Cost: linear in the points, small.
 * \param[in] points finite
 * \param[in] normals one per point; none is no problem
 * \return one clause with the numbers; empty if there is no problem
 */
PCL_INDOOR_EXPORTS std::string
findNormalsProblem(const std::vector<Eigen::Vector3f>& points,
                   const std::vector<Eigen::Vector3f>& normals);

} // namespace pcl::indoor
