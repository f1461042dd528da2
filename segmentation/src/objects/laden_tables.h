/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/object_steps.h"

namespace pcl::indoor {

/** \brief Make what stands on a table segments of their own where it came out as one
 * object with the table. No step of the thesis.
 *
 * What is joined to whole furniture joins such objects to one. Where points are dense
 * enough for voxels of half the size, what lies on the top of a table, see ladenTop(),
 * is segmented by singleViewOptions(). If that gives four small objects or more, which
 * reach at most 0.28 m from their middles, they become segments; all else stays with
 * the table. So does everything if they are less than half of what lies above the top,
 * or larger objects more than a fifth.
 * \param[in] options that were used, with their sizes
 * \param[in,out] result with names of segments; new ones follow those that were there
 */
void
clearLadenTables(const ObjectSegmentationOptions& options,
                 DetailedSegmentation& result);

} // namespace pcl::indoor
