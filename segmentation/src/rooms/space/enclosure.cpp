/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/enclosure.h"

#include "rooms/space/line_bundle.h"

#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/threads.h>

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::indoor {

namespace {

constexpr int first_direction_bit = 2;
constexpr int passed_bit = 7; // set between the two passes of a sweep
static_assert(most_enclosure_directions == passed_bit - first_direction_bit);

void
requireSameSize(std::size_t values, const GridShape& shape)
{
  if (values != shape.size())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        values << " values do not fill a grid of " << shape.size()
                               << " voxels.");
}

void
requireValid(const std::vector<Eigen::Vector3d>& directions)
{
  if (directions.size() > most_enclosure_directions)
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "At most " << most_enclosure_directions
                                   << " directions are possible, not "
                                   << directions.size() << ".");
  for (const auto& direction : directions)
    if (!direction.allFinite() || direction.isZero(0.0))
      PCL_THROW_EXCEPTION(BadArgumentException,
                          "A direction must be finite and not 0.");
}

/** \brief Sweep the lines begin ... end - 1 to and fro; state has nz values per line.
 */
void
sweepLines(const LineBundle& lines,
           int begin,
           int end,
           int bit,
           const VoxelMap<std::uint8_t>& occupancy,
           std::vector<std::uint8_t>& state,
           std::vector<std::uint8_t>& bits)
{
  const int nz = occupancy.shape.nz;
  for (const bool forward : {true, false}) {
    state.assign(static_cast<std::size_t>(end - begin) * nz, 0);
    for (int i = 0; i < lines.steps; ++i) {
      const int step = forward ? i : lines.steps - 1 - i;
      const int offset = lines.first + lines.shift[step];
      const int line_begin = std::max(begin, -offset);
      const int line_end = std::min(end, lines.width - offset);
      for (int line = line_begin; line < line_end; ++line) {
        const std::size_t base = lines.column(occupancy.shape, step, line + offset);
        const std::uint8_t* occupied = &occupancy.values[base];
        std::uint8_t* seen = &state[static_cast<std::size_t>(line - begin) * nz];
        std::uint8_t* out = &bits[base];
        if (forward)
          for (int z = 0; z < nz; ++z) {
            out[z] = static_cast<std::uint8_t>(out[z] | seen[z] << passed_bit);
            seen[z] |= occupied[z] != 0;
          }
        else
          for (int z = 0; z < nz; ++z) {
            const int both = out[z] >> passed_bit & seen[z];
            out[z] = static_cast<std::uint8_t>((out[z] & 0x7f) | both << bit);
            seen[z] |= occupied[z] != 0;
          }
      }
    }
  }
}

void
sweep(const LineBundle& lines,
      int bit,
      const VoxelMap<std::uint8_t>& occupancy,
      int threads,
      std::vector<std::uint8_t>& bits)
{
  // Lines do not share voxels, so that bands of lines are independent.
  const int bands = std::min(lines.count, 4 * threads);
  parallelFor(
      bands,
      threads,
      1,
      [] { return std::vector<std::uint8_t>(); },
      [&](std::vector<std::uint8_t>& state, std::ptrdiff_t band) {
        sweepLines(lines,
                   static_cast<int>(lines.count * band / bands),
                   static_cast<int>(lines.count * (band + 1) / bands),
                   bit,
                   occupancy,
                   state,
                   bits);
      });
}

/** \brief The discretised lines along a direction that is not level: at step i of its
 * major axis they have gone shift[k][i] voxels along each of the other two.
 */
struct TiltedLines {
  int axes[3]; // the major one and the others
  std::vector<int> shift[2];

  TiltedLines(const GridShape& shape, const Eigen::Vector3d& direction)
  {
    int major = 0;
    direction.cwiseAbs().maxCoeff(&major);
    axes[0] = major;
    axes[1] = (major + 1) % 3;
    axes[2] = (major + 2) % 3;
    const int extents[] = {shape.nx, shape.ny, shape.nz};
    for (int k = 0; k < 2; ++k) {
      const double slope = direction[axes[k + 1]] / direction[major];
      for (int i = 0; i < extents[major]; ++i)
        shift[k].push_back(static_cast<int>(std::floor(i * slope + 0.5)));
    }
  }
};

/** \brief Go along all lines to and fro; each voxel lies on one of them. */
void
sweep(const TiltedLines& lines,
      int bit,
      const VoxelMap<std::uint8_t>& occupancy,
      int threads,
      std::vector<std::uint8_t>& bits)
{
  const GridShape& shape = occupancy.shape;
  const int extents[] = {shape.nx, shape.ny, shape.nz};
  const auto steps = static_cast<int>(lines.shift[0].size());
  int first[2], count[2]; // of the lines' numbers along the other axes
  for (int k = 0; k < 2; ++k) {
    const int last = lines.shift[k].back();
    first[k] = -std::max(last, 0);
    count[k] = extents[lines.axes[k + 1]] - first[k] - std::min(last, 0);
  }
  parallelFor(
      count[0],
      threads,
      1,
      [] { return std::vector<std::size_t>(); },
      [&](std::vector<std::size_t>& line, std::ptrdiff_t a) {
        for (int b = 0; b < count[1]; ++b) {
          line.clear();
          for (int i = 0; i < steps; ++i) {
            int place[3];
            place[lines.axes[0]] = i;
            place[lines.axes[1]] = first[0] + static_cast<int>(a) + lines.shift[0][i];
            place[lines.axes[2]] = first[1] + b + lines.shift[1][i];
            if (shape.contains(place[0], place[1], place[2]))
              line.push_back(shape.index(place[0], place[1], place[2]));
          }
          const auto occupied = [&](std::size_t v) { return occupancy.values[v] != 0; };
          const auto begin = std::find_if(line.begin(), line.end(), occupied);
          const auto end = std::find_if(line.rbegin(), line.rend(), occupied).base();
          for (auto v = begin; v < end; ++v)
            bits[*v] = static_cast<std::uint8_t>(bits[*v] | 1 << bit);
        }
      });
}

/** \brief The vertical bits, and 0 for occupied voxels. */
void
finishColumn(const std::uint8_t* occupied, int nz, std::uint8_t* bits)
{
  int below = 0;
  for (int z = 0; z < nz; ++z) {
    bits[z] = static_cast<std::uint8_t>(bits[z] | below);
    below |= occupied[z] ? ENCLOSED_BELOW : 0;
  }
  int above = 0;
  for (int z = nz - 1; z >= 0; --z) {
    bits[z] =
        occupied[z] ? std::uint8_t{0} : static_cast<std::uint8_t>(bits[z] | above);
    above |= occupied[z] ? ENCLOSED_ABOVE : 0;
  }
}

} // namespace

VoxelMap<std::uint8_t>
enclosure(const VoxelMap<std::uint8_t>& occupancy,
          const std::vector<Eigen::Vector3d>& directions,
          int threads)
{
  const GridShape& shape = occupancy.shape;
  requireSameSize(occupancy.values.size(), shape);
  requireValid(directions);
  const int thread_count = threadCount(threads);
  VoxelMap<std::uint8_t> bits;
  bits.shape = shape;
  bits.origin = occupancy.origin;
  bits.voxel_size = occupancy.voxel_size;
  bits.values.assign(shape.size(), 0);
  if (bits.values.empty())
    return bits;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const int bit = first_direction_bit + static_cast<int>(i);
    if (directions[i].z() == 0.0)
      sweep(LineBundle(shape, directions[i].head<2>()),
            bit,
            occupancy,
            thread_count,
            bits.values);
    else
      sweep(
          TiltedLines(shape, directions[i]), bit, occupancy, thread_count, bits.values);
  }
  const auto columns = static_cast<std::ptrdiff_t>(shape.nx) * shape.ny;
#pragma omp parallel for schedule(static) num_threads(thread_count)
  for (std::ptrdiff_t c = 0; c < columns; ++c)
    finishColumn(&occupancy.values[c * shape.nz], shape.nz, &bits.values[c * shape.nz]);
  return bits;
}

double
enclosureEvidence(std::uint8_t bits,
                  int direction_count,
                  const EnclosureWeights& weights)
{
  const bool below = bits & ENCLOSED_BELOW;
  const bool above = bits & ENCLOSED_ABOVE;
  double evidence = (below ? weights.below : 0.0) + (above ? weights.above : 0.0) +
                    (below && above ? weights.vertical : 0.0);
  for (int i = 0; i < direction_count; ++i)
    if (bits & ENCLOSED_ALONG_DIRECTION << i)
      evidence += weights.horizontal / direction_count;
  return evidence;
}

CodedGains
interiorGain(const VoxelMap<std::uint8_t>& occupancy,
             VoxelMap<std::uint8_t> bits,
             int direction_count,
             const EnclosureWeights& weights)
{
  constexpr std::uint8_t occupied = 1 << passed_bit; // no way to be enclosed
  requireSameSize(occupancy.values.size(), occupancy.shape);
  requireSameSize(bits.values.size(), occupancy.shape);
  CodedGains gains;
  gains.gain_of.fill(GRID_CUT_EXCLUDED);
  for (std::uint8_t value = 0; value < occupied; ++value) {
    const double gain =
        (enclosureEvidence(value, direction_count, weights) - weights.exterior) /
        gain_unit;
    if (!(std::abs(gain) < grid_cut_max_gain))
      PCL_THROW_EXCEPTION(BadArgumentException,
                          "A gain of " << gain << " units leaves the range.");
    gains.gain_of[value] = static_cast<std::int16_t>(std::lround(gain));
  }
  gains.codes = std::move(bits.values);
  for (std::size_t v = 0; v < gains.codes.size(); ++v)
    if (occupancy.values[v] != 0)
      gains.codes[v] = occupied;
  return gains;
}

} // namespace pcl::indoor
