/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/vertical_cleanup.h"

#include <pcl/indoor/threads.h>

#include <pcl/exceptions.h>

#include <cstddef>

namespace pcl::indoor {

namespace {

/** \brief Free the runs of one voxel between the lowest and the highest run of a
 * column. */
void
cleanColumn(std::uint8_t* column, int nz)
{
  int z = 0;
  while (z < nz && !column[z]) // to the lowest run
    ++z;
  while (z < nz && column[z]) // behind it
    ++z;
  int candidate = -1; // waits for an occupied voxel above it
  while (z < nz) {
    while (z < nz && !column[z])
      ++z;
    if (z == nz)
      break;
    if (candidate >= 0)
      column[candidate] = 0;
    const int begin = z;
    while (z < nz && column[z])
      ++z;
    candidate = z - begin == 1 ? begin : -1;
  }
}

} // namespace

void
cleanUpVertically(VoxelMap<std::uint8_t>& grid, int threads)
{
  if (grid.values.size() != grid.shape.size())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        grid.values.size() << " values do not fill a grid of "
                                           << grid.shape.size() << " voxels.");
  const auto columns =
      static_cast<std::ptrdiff_t>(grid.shape.nx) * grid.shape.ny; // contiguous
  const int nz = grid.shape.nz;
  std::uint8_t* values = grid.values.data();
  const int thread_count = threadCount(threads);
#pragma omp parallel for schedule(static) num_threads(thread_count)
  for (std::ptrdiff_t c = 0; c < columns; ++c)
    cleanColumn(values + c * nz, nz);
}

} // namespace pcl::indoor
