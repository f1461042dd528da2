/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_map.h>

#include <cstdint>

namespace pcl::indoor {

/** \brief Labels the rest of a map by the random walker (Sec. 2.1.6.2 of the thesis).
 *
 * An unlabelled pixel gets the label that a walker starting there most probably reaches
 * first; steps go over the sides of pixels and have the weights of Eq. (2.11), at least
 * 1e-10. Equal probabilities (to 1e-9) give the smaller label. Each connected region of
 * unlabelled pixels is solved by itself, exactly, with one factorisation of its
 * Laplacian; a region that touches only one label needs none. Time is about O(m^1.5)
 * for a region of m pixels.
 *
 * \param[in] values I of Eq. (2.11), finite in the mask
 * \param[in] labels 0 or more = seed; -1 = to be labelled
 * \param[in] mask non-zero = pixel of the graph
 * \param[in] beta of Eq. (2.11), in one over the squared unit of the map's values (0 or
 * more): larger: steps of the values separate more
 * \param[in] threads 0 = automatic; the result does not depend on it
 * \return the labels; -1 outside of the mask and where no seed can be reached
 * \throws pcl::BadArgumentException if the maps differ in size, beta is negative or
 * a value in the mask is not finite
 */
PixelMap<int>
mapRandomWalker(const PixelMap<float>& values,
                const PixelMap<int>& labels,
                const PixelMap<std::uint8_t>& mask,
                double beta,
                int threads = 0);

} // namespace pcl::indoor
