/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/grid_cut.h"

#include "rooms/space/grid_cut_solver.h"

#include <pcl/exceptions.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace pcl::indoor {

namespace {

void
requireValid(const GridShape& shape, std::size_t gains, int smoothness)
{
  if (gains != shape.size())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        gains << " gains do not fill a grid of " << shape.size()
                              << " voxels.");
  const std::size_t padded = 64 * GridBricks(shape).size();
  if (gains >= std::numeric_limits<std::int32_t>::max() ||
      padded > std::numeric_limits<GridBricks::Index>::max())
    PCL_THROW_EXCEPTION(BadArgumentException, gains << " voxels are too many.");
  if (smoothness < 0 || smoothness > grid_cut_max_smoothness)
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "The smoothness must lie in 0 ... " << grid_cut_max_smoothness
                                                            << ", not " << smoothness
                                                            << ".");
}

/** The largest absolute value of gains; what is excluded has none. */
int
greatestGain(const std::int16_t* begin, const std::int16_t* end)
{
  int greatest = 0;
  for (; begin != end; ++begin)
    if (*begin != GRID_CUT_EXCLUDED)
      greatest = std::max(greatest, std::abs(int{*begin}));
  return greatest;
}

template <typename Width>
GridCut
solve(const GridShape& shape, const VoxelGains& gain, int smoothness)
{
  GridCutSolver<Width> solver(shape, gain, smoothness);
  GridCut cut;
  cut.energy = solver.run();
  cut.inside = solver.inside();
  return cut;
}

/** \param[in] greatest no gain is larger */
GridCut
solveInWidth(const GridShape& shape,
             const VoxelGains& gain,
             int greatest,
             int smoothness)
{
  return NarrowNumbers::hold(greatest, smoothness)
             ? solve<NarrowNumbers>(shape, gain, smoothness)
             : solve<WideNumbers>(shape, gain, smoothness);
}

} // namespace

GridCut
cutGrid(const GridShape& shape, const std::vector<std::int16_t>& gain, int smoothness)
{
  requireValid(shape, gain.size(), smoothness);
  const int greatest = greatestGain(gain.data(), gain.data() + gain.size());
  return solveInWidth(shape, VoxelGains(gain), greatest, smoothness);
}

GridCut
cutGrid(const GridShape& shape, const CodedGains& gain, int smoothness)
{
  requireValid(shape, gain.codes.size(), smoothness);
  const auto& gains = gain.gain_of;
  const int greatest = greatestGain(gains.data(), gains.data() + gains.size());
  return solveInWidth(shape, VoxelGains(gain), greatest, smoothness);
}

} // namespace pcl::indoor
