/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/vertical_cleanup.h"

#include <pcl/indoor/threads.h>

#include <pcl/exceptions.h>

#include <algorithm>

namespace pcl::indoor {

namespace {

/** \brief Free the short runs between the lowest and the highest run of a column. */
std::size_t
cleanColumn(std::uint8_t* column, int nz, int max_run)
{
  int z = 0;
  while (z < nz && !column[z]) // to the lowest run
    ++z;
  while (z < nz && column[z]) // behind it
    ++z;
  std::size_t freed = 0;
  int candidate = 0; // a short run waits for an occupied voxel above it
  int candidate_end = 0;
  while (z < nz) {
    while (z < nz && !column[z])
      ++z;
    if (z == nz)
      break;
    std::fill(column + candidate, column + candidate_end, std::uint8_t{0});
    freed += candidate_end - candidate;
    candidate = z;
    while (z < nz && column[z])
      ++z;
    candidate_end = z - candidate <= max_run ? z : candidate;
  }
  return freed;
}

} // namespace

std::size_t
cleanUpVertically(VoxelMap<std::uint8_t>& grid, int max_run, int threads)
{
  if (max_run < 0)
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "The longest run must not be negative, not " << max_run << ".");
  if (grid.values.size() != grid.shape.size())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        grid.values.size() << " values do not fill a grid of "
                                           << grid.shape.size() << " voxels.");
  const auto columns =
      static_cast<std::ptrdiff_t>(grid.shape.nx) * grid.shape.ny; // contiguous
  const int nz = grid.shape.nz;
  std::uint8_t* values = grid.values.data();
  std::size_t freed = 0;
  const int thread_count = threadCount(threads);
#pragma omp parallel for schedule(static) num_threads(thread_count) reduction(+ : freed)
  for (std::ptrdiff_t c = 0; c < columns; ++c)
    freed += cleanColumn(values + c * nz, nz, max_run);
  return freed;
}

} // namespace pcl::indoor
