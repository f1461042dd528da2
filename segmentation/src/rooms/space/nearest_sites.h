/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_map.h>

#include <cstdint>

namespace pcl::indoor {

/** \brief The nearest site of every pixel: the exact Euclidean feature transform.
 *
 * Two separable passes of lower envelopes (Felzenszwalb and Huttenlocher 2012), linear
 * in the number of pixels.
 */
struct NearestSites {
  PixelMap<std::int32_t> site; ///< pixel index of the nearest site, -1: none
  PixelMap<std::int32_t>
      squared_distance; ///< to it, in pixels squared; INT32_MAX: none
};

/** \brief Find the nearest site of every pixel.
 * \param[in] sites non-zero = site; among equally near ones any may be taken, always
 * the same one for the same map
 */
NearestSites
nearestSites(const PixelMap<std::uint8_t>& sites);

/** \brief The same of the pixels with a label other than 0. */
NearestSites
nearestLabelled(const PixelMap<std::int32_t>& labels);

/** \brief Give every pixel without label (0) the label of the nearest labelled one.
 * \param[in,out] labels 0 = none
 * \param[in] reach greatest distance, in pixels
 */
void
growLabels(PixelMap<std::int32_t>& labels, double reach);

} // namespace pcl::indoor
