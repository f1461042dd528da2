/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/ml/histogram_distance.h>

#include <vector>

namespace pcl::indoor {

constexpr int no_label = -1; ///< of an object that nothing was found for

/** \brief The label of the nearest histogram of the gallery, for each query.
 *
 * Of equally near ones the first. no_label if no distance is finite.
 * \param[in] distances a row per query, a column per histogram of the gallery
 * \param[in] gallery_labels one per column
 * \throws pcl::BadArgumentException if there are not as many labels as columns
 */
PCL_INDOOR_EXPORTS std::vector<int>
nearestLabels(const DistanceTable& distances, const std::vector<int>& gallery_labels);

/** \brief Leave-one-out retrieval, Sec. 5.3.2: the nearest other object's label.
 *
 * As nearestLabels(), but no object is compared with the one of the same number: row k
 * and column k are of the same object, whether or not their histograms are the same.
 * \throws pcl::BadArgumentException if the table is not square, or not as many labels
 */
PCL_INDOOR_EXPORTS std::vector<int>
leaveOneOutLabels(const DistanceTable& distances, const std::vector<int>& labels);

} // namespace pcl::indoor
