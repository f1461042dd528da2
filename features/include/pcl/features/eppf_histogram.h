/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/eppf_options.h>
#include <pcl/features/oriented_point.h>
#include <pcl/indoor/exports.h>

#include <vector>

namespace pcl::indoor {

/** \brief The enhanced point pair feature (EPPF) histogram of an object, Sec. 5.2.
 *
 * The bin of a pair is ((i1 * N_f2 + i2) * N_f3 + i3) * N_f4 + i4. Where options.bins
 * has harmonics, they follow after the pairs and are half of the sum, see
 * surfaceHarmonics(). Time is linear in pairs and points. The same options give the
 * same bits for any number of threads.
 * \param[in] points finite points with normals of unit length, near the origin
 * \param[in] options see EPPFOptions
 * \return options.bins.size() values that add up to 1; all NaN if fewer than two points
 * differ in position
 * \throws pcl::BadArgumentException if an option is out of its range
 */
PCL_INDOOR_EXPORTS std::vector<float>
eppfHistogram(const std::vector<OrientedPoint>& points, const EPPFOptions& options);

} // namespace pcl::indoor
