/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "voxels/voxel_levels.h"

#include <cstddef>
#include <vector>

namespace pcl::indoor {

/** \brief Outputs of rows are computed so many at a time. */
constexpr std::size_t row_lanes = 16;

/** \brief Add to row `to` of the sums the product of row `from` and a matrix, for all
 * pairs.
 *
 * Each sum is made in the order of the inputs, multiplied and added one after the
 * other: on all processors the same.
 * \param[in] values rows of inputs values
 * \param[in] matrix inputs x outputs, row by row; outputs a multiple of row_lanes
 * \param[in,out] sums rows of outputs values
 */
void
addRowSums(const RowPairs& pairs,
           const std::vector<float>& values,
           std::size_t inputs,
           const float* matrix,
           std::size_t outputs,
           std::vector<float>& sums);

} // namespace pcl::indoor
