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

std::int64_t
gridCutEnergy(const GridShape& shape,
              const std::vector<std::int16_t>& gain,
              int smoothness,
              const std::vector<std::uint8_t>& inside)
{
  requireValid(shape, gain.size(), smoothness);
  if (inside.size() != gain.size())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        inside.size() << " labels do not fill a grid of "
                                      << shape.size() << " voxels.");
  const std::size_t y_step = shape.nz;
  const std::size_t x_step = y_step * shape.ny;
  const auto differ = [&](std::size_t a, std::size_t b) {
    return gain[a] != GRID_CUT_EXCLUDED && gain[b] != GRID_CUT_EXCLUDED &&
           (inside[a] != 0) != (inside[b] != 0);
  };
  std::int64_t unary = 0;
  std::int64_t pairs = 0;
  std::size_t v = 0;
  for (int x = 0; x < shape.nx; ++x)
    for (int y = 0; y < shape.ny; ++y)
      for (int z = 0; z < shape.nz; ++z, ++v) {
        if (gain[v] != GRID_CUT_EXCLUDED && (gain[v] > 0) != (inside[v] != 0))
          unary += std::abs(static_cast<int>(gain[v]));
        pairs += x > 0 && differ(v, v - x_step);
        pairs += y > 0 && differ(v, v - y_step);
        pairs += z > 0 && differ(v, v - 1);
      }
  return unary + pairs * smoothness;
}

} // namespace pcl::indoor
