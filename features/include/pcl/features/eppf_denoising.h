/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/oriented_point.h>
#include <pcl/indoor/exports.h>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief The noise of an object's points. */
struct PointNoise {
  float evidence = 0.0f;  ///< how sure it is that there is noise: 0 none, 1 certain
  float deviation = 0.0f; ///< of the noise on a coordinate, metres; 0 without evidence
};

/** \brief Measure the noise of an object from the points themselves.
 *
 * A surface without noise almost always has flat places; with noise nearly as large as
 * the distance of points none is flat. So the evidence is how flat the second flattest
 * of 32 neighbourhoods of 16 points is; if it is not flat, the thirteenth of 128. The
 * deviation is the residual of local planes, in a window that is widened until it is
 * wider than the noise. Noise below about half of the distance of points counts as
 * none.
 * \param[in] points near the origin
 * \param[in] order a space-filling order of the points, see spaceFillingOrder()
 * \param[in] extent of the object, metres
 * \param[in] number_of_threads 0 meaning all; the result does not depend on it
 * \return nothing for fewer than 256 points, whose neighbourhoods are not local. Time:
 * linear, of at most 4096 points evenly along the order
 */
PCL_INDOOR_EXPORTS PointNoise
measureNoise(const std::vector<OrientedPoint>& points,
             const std::vector<std::uint32_t>& order,
             float extent,
             unsigned int number_of_threads = 1);

/** \brief An object whose noise was lowered. */
struct DenoisedObject {
  std::vector<OrientedPoint> points; ///< along the order, at most 4096
  std::vector<float> weights; ///< of each point, how flat its surface is: 0 ... 1
  float extent = 0.0f;        ///< metres, without what noise adds to it
};

/** \brief Move points to planes through their neighbours, and tell how far the planes
 * can be trusted.
 *
 * The neighbours are weighted by a Gaussian 1.2 deviations of the noise wide. Normals
 * stay. How far points move grows from 0 with the evidence of noise, so that there is
 * no jump between an object without noise and one with little. Time: with the square of
 * the points, of which there are at most 4096; no result depends on the number of
 * threads.
 */
PCL_INDOOR_EXPORTS DenoisedObject
denoised(const std::vector<OrientedPoint>& points,
         const std::vector<std::uint32_t>& order,
         float extent,
         const PointNoise& noise,
         unsigned int number_of_threads);

} // namespace pcl::indoor
