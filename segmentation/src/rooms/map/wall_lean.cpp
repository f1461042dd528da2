/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/wall_lean.h"

#include "rooms/dimensions.h"

#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/threads.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl::indoor {
namespace {

const double steepest_slope = std::tan(steepest_lean);

/** Where a wall is looked at, layers. */
struct WallLayers {
  int floor;   ///< above the floor and its noise
  int top;     ///< of the slab
  double slab; ///< its middle
};

/** An occupied voxel in the vertical section across a wall. */
struct SectionVoxel {
  float across; // along the wall's normal, voxels
  float depth;  // below the slab, voxels
};

/** A line in that section: across = offset + lean * depth. */
struct SectionLine {
  double offset = 0.0;
  double lean = 0.0;
  double weight = 0.0; // inverse variance of the lean, if voxels scatter by one
};

/** Middle and normal of the wall around a pixel of the slab, if there is but one. */
std::optional<WallStretch>
wallAround(const PixelMap<std::uint8_t>& blocked,
           const Eigen::Vector2d& center,
           double radius)
{
  const auto from = [&](double at) { return std::max(0, int(std::ceil(at - radius))); };
  const auto to = [&](double at, int n) {
    return std::min(n - 1, static_cast<int>(at + radius));
  };
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  double count = 0.0;
  for (int x = from(center.x()); x <= to(center.x(), blocked.nx); ++x)
    for (int y = from(center.y()); y <= to(center.y(), blocked.ny); ++y) {
      const Eigen::Vector2d offset = Eigen::Vector2d(x, y) - center;
      if (!blocked.at(x, y) || offset.squaredNorm() > radius * radius)
        continue;
      sum += offset;
      squares += offset * offset.transpose();
      count += 1.0;
    }
  if (count < radius) // less than half as long as the window
    return std::nullopt;
  const Eigen::Vector2d mean = sum / count;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
  eigen.computeDirect(squares / count - mean * mean.transpose());
  if (eigen.eigenvalues()[0] > 0.5 * eigen.eigenvalues()[1]) // a corner
    return std::nullopt;
  WallStretch stretch;
  stretch.place = center + mean + Eigen::Vector2d(0.5, 0.5);
  stretch.normal = eigen.eigenvectors().col(0);
  return stretch;
}

/** The occupied voxels between the slab and the floor that may belong to a wall. */
void
sectionAt(const VoxelBits& occupancy,
          const WallLayers& layers,
          double radius,
          const WallStretch& wall,
          std::vector<SectionVoxel>& section)
{
  section.clear();
  const double thickness = 0.5 * radius; // of half a wall
  const double width =
      thickness + steepest_slope * std::max(0.0, layers.slab - layers.floor);
  const Eigen::Vector2d along(-wall.normal.y(), wall.normal.x());
  const Eigen::Vector2d extent =
      width * wall.normal.cwiseAbs() + radius * along.cwiseAbs();
  const GridShape& shape = occupancy.shape;
  const Eigen::Vector2d low = (wall.place - extent).cwiseMax(0.0);
  const Eigen::Vector2d high = wall.place + extent;
  for (int x = static_cast<int>(low.x()); x < std::min<double>(shape.nx, high.x()); ++x)
    for (int y = static_cast<int>(low.y()); y < std::min<double>(shape.ny, high.y());
         ++y) {
      const Eigen::Vector2d offset = Eigen::Vector2d(x + 0.5, y + 0.5) - wall.place;
      const double across = wall.normal.dot(offset);
      if (std::abs(along.dot(offset)) > radius || std::abs(across) > width)
        continue;
      const double least =
          (std::abs(across) - thickness) / steepest_slope; // depth in reach
      const int end = std::min(
          layers.top, static_cast<int>(std::floor(layers.slab - std::max(0.0, least))));
      occupancy.column(x, y).forEachSet(layers.floor, end + 1, [&](int z) {
        section.push_back(
            {static_cast<float>(across), static_cast<float>(layers.slab - z)});
      });
    }
}

/** The lean that gathers the voxels of a section best: sheared upright by it, they make
 * the sharpest profile across the wall (the greatest sum of squares, as both faces of a
 * wall lean alike). Upright unless another lean is clearly better. */
class LeanSearch {
public:
  explicit LeanSearch(double half_thickness)
  : slopes_(static_cast<int>(std::ceil(steepest_slope / slope_step)))
  , profile_(2 * static_cast<int>(std::ceil(half_thickness / bin)))
  {}

  /** \return no line unless voxels fill most of its \a area, as those of a wall do */
  std::optional<SectionLine>
  best(const std::vector<SectionVoxel>& section, double area)
  {
    const double upright = energyAt(section, 0.0);
    SectionLine line = strongest(0.0);
    int filled = most_, at = 0;
    bool is_upright = filled >= full_share * area; // as most walls are
    for (int k = 4; k <= slopes_ && is_upright; k += 4)
      is_upright = energyAt(section, -k * slope_step) < upright &&
                   energyAt(section, k * slope_step) < upright;
    if (is_upright)
      return line;
    double best = upright / upright_share;
    const auto attempt = [&](int k) {
      const double energy = energyAt(section, k * slope_step);
      if (k == 0 || energy <= best)
        return;
      best = energy;
      line = strongest(k * slope_step);
      filled = most_;
      at = k;
    };
    for (int k = -slopes_; k <= slopes_; k += 2)
      attempt(k);
    for (const int k : {at - 1, at + 1})
      attempt(k);
    return filled < full_share * area ? std::nullopt : std::optional<SectionLine>(line);
  }

private:
  static constexpr double slope_step = 0.5 * least_lean;
  static constexpr double bin = 0.5;           // voxels
  static constexpr double upright_share = 0.9; // within this it cannot be told apart
  static constexpr double full_share = 0.7;    // fewer are lintels, posts and furniture

  /** Sum of squares of the profile, smoothed to one voxel. */
  double
  energyAt(const std::vector<SectionVoxel>& section, double lean)
  {
    std::fill(profile_.begin(), profile_.end(), 0);
    const auto count = static_cast<int>(profile_.size());
    const float scale = static_cast<float>(1.0 / bin);
    const float slope = static_cast<float>(lean);
    for (const auto& voxel : section) {
      const float place = (voxel.across - slope * voxel.depth) * scale + 0.5f * count;
      const int at = static_cast<int>(place);
      if (place >= 0.0f && at < count)
        ++profile_[at];
    }
    double sum = 0.0;
    most_ = 0;
    for (int i = 0; i + 1 < count; ++i) {
      const int both = profile_[i] + profile_[i + 1];
      sum += static_cast<double>(both) * both;
      if (both > most_) {
        most_ = both;
        most_at_ = i;
      }
    }
    return sum;
  }

  /** The line of the profile's peak. */
  SectionLine
  strongest(double lean) const
  {
    SectionLine line;
    line.lean = lean;
    line.offset = (most_at_ + 1 - 0.5 * static_cast<double>(profile_.size())) * bin;
    return line;
  }

  int slopes_;               // on each side of 0
  std::vector<int> profile_; // per bin across the wall, its middle in the middle
  int most_ = 0;             // voxels of the peak
  int most_at_ = 0;          // its first bin
};

/** The line through the voxels near one. */
void
refine(const std::vector<SectionVoxel>& section, SectionLine& line)
{
  for (int turn = 0; turn < 3; ++turn) {
    double count = 0, sum_d = 0, sum_r = 0, sum_dd = 0, sum_dr = 0;
    for (const auto& voxel : section) {
      const double d = voxel.depth;
      const double r = voxel.across - line.offset - line.lean * d;
      if (std::abs(r) > 1.0)
        continue;
      count += 1.0;
      sum_d += d;
      sum_r += r;
      sum_dd += d * d;
      sum_dr += d * r;
    }
    line.weight = count > 0 ? sum_dd - sum_d * sum_d / count : 0.0;
    if (!(line.weight > 0))
      return;
    const double change = (sum_dr - sum_d * sum_r / count) / line.weight;
    line.lean += change;
    line.offset += (sum_r - change * sum_d) / count;
  }
}

/** The middles of the blocked pixels of each tile of the map, tile by tile. */
std::vector<Eigen::Vector2d>
spreadOver(const PixelMap<std::uint8_t>& blocked, int tile)
{
  std::vector<Eigen::Vector2d> places;
  for (int x = 0; x < blocked.nx; x += tile)
    for (int y = 0; y < blocked.ny; y += tile) {
      Eigen::Vector2d sum = Eigen::Vector2d::Zero();
      int count = 0;
      for (int u = x; u < std::min(blocked.nx, x + tile); ++u)
        for (int v = y; v < std::min(blocked.ny, y + tile); ++v)
          if (blocked.at(u, v)) {
            sum += Eigen::Vector2d(u, v);
            ++count;
          }
      if (count > 0)
        places.push_back(sum / count);
    }
  return places;
}

} // namespace

std::vector<WallStretch>
wallStretches(const VoxelBits& occupancy, const RoomMap& map, int threads)
{
  const PixelMap<std::uint8_t>& blocked = map.blocked;
  const SlabLayers& slab = map.slab;
  const double whole_map = 2.0 * (blocked.nx + blocked.ny); // nothing lies farther
  const double radius =
      std::min(whole_map, std::max(2.0, 0.5 * surroundings / occupancy.voxel_size));
  const auto places = spreadOver(blocked, static_cast<int>(radius));
  std::vector<WallStretch> found(places.size());
  struct State {
    LeanSearch search;
    std::vector<SectionVoxel> section;
  };
  parallelFor(
      static_cast<std::ptrdiff_t>(places.size()),
      threadCount(threads),
      16,
      [&] {
        return State{LeanSearch(0.5 * radius), {}};
      },
      [&](State& state, std::ptrdiff_t i) {
        auto wall = wallAround(blocked, places[i], radius);
        if (!wall)
          return;
        const int top = map.ceiling.at(static_cast<int>(places[i].x() + 0.5),
                                       static_cast<int>(places[i].y() + 0.5));
        const WallLayers layers = {map.range.begin + 2,
                                   top - slab.first,
                                   top - 0.5 * (slab.first + slab.last)};
        sectionAt(occupancy, layers, radius, *wall, state.section);
        auto line = state.search.best(
            state.section, 2.0 * radius * std::max(0.0, layers.slab - layers.floor));
        if (!line)
          return;
        const bool is_upright = line->lean == 0.0;
        refine(state.section, *line);
        if (std::abs(line->lean) > steepest_slope)
          return;
        wall->lean = is_upright ? 0.0 : line->lean;
        wall->weight = line->weight;
        found[i] = *wall;
      });
  found.erase(std::remove_if(found.begin(),
                             found.end(),
                             [](const auto& wall) { return !(wall.weight > 0); }),
              found.end());
  return found;
}

} // namespace pcl::indoor
