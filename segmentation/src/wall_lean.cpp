/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/wall_lean.h>

#include "thread_count.h"

#include <pcl/exceptions.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl {
namespace indoor {
namespace {

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
sectionAt(const VoxelGrid<std::uint8_t>& occupancy,
          int floor,
          double slab,
          int top,
          double slope,
          double radius,
          const WallStretch& wall,
          std::vector<SectionVoxel>& section)
{
  section.clear();
  const double thickness = 0.5 * radius; // of half a wall
  const double width = thickness + slope * std::max(0.0, slab - floor);
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
      const double least = (std::abs(across) - thickness) / slope; // depth in reach
      const int end =
          std::min(top, static_cast<int>(std::floor(slab - std::max(0.0, least))));
      const std::uint8_t* column = &occupancy.values[shape.index(x, y, 0)];
      for (int z = floor; z <= end; ++z)
        if (column[z])
          section.push_back(
              {static_cast<float>(across), static_cast<float>(slab - z)});
    }
}

/** The line that most voxels lie on, one voxel wide; an upright one unless another is
 * clearly better. */
class LineVote {
public:
  LineVote(double max_slope, double half_thickness)
  : slopes_(static_cast<int>(std::ceil(max_slope / slope_step)))
  , offsets_(static_cast<int>(std::ceil(half_thickness / offset_step)))
  , votes_((2 * offsets_ + 1) * width())
  {}

  /** \return no line unless voxels fill half of one's \a area, as those of a wall do */
  std::optional<SectionLine>
  best(const std::vector<SectionVoxel>& section, double area)
  {
    std::fill(votes_.begin(), votes_.end(), 0);
    for (const auto& voxel : section)
      if (voxel.depth > 0)
        cast(voxel);
    int most = 0;
    SectionLine line;
    int upright_most = 0;
    SectionLine upright;
    for (int row = 0; row <= 2 * offsets_; ++row) {
      int sum = 0;
      for (int k = 0; k <= 2 * slopes_; ++k) {
        sum += votes_[row * width() + k];
        const double offset = (row - offsets_) * offset_step;
        if (k == slopes_ && sum > upright_most) {
          upright_most = sum;
          upright.offset = offset;
        }
        if (sum > most) {
          most = sum;
          line.lean = (k - slopes_) * slope_step;
          line.offset = offset;
        }
      }
    }
    if (most < 0.5 * area)
      return std::nullopt;
    return upright_most >= upright_share * most ? upright : line;
  }

private:
  static constexpr double slope_step = 0.02; // half a voxel over the height of a storey
  static constexpr double offset_step = 0.5; // voxels
  // Of a wall that moves by a voxel over its height, three quarters are on an upright
  // line of one voxel's width; less than that cannot be told from noise.
  static constexpr double upright_share = 0.9;

  int
  width() const
  {
    return 2 * slopes_ + 2; // one more, for the end of the last interval
  }

  /** Add 1 to the slopes of the lines that pass within half a voxel, per offset. */
  void
  cast(const SectionVoxel& voxel)
  {
    const double scale = 1.0 / (voxel.depth * slope_step);
    for (int row = 0; row <= 2 * offsets_; ++row) {
      const double across = voxel.across - (row - offsets_) * offset_step;
      const int first = static_cast<int>(
          std::ceil(std::clamp((across - 0.5) * scale + slopes_, 0.0, width() - 1.0)));
      const int last = static_cast<int>(std::floor(
          std::clamp((across + 0.5) * scale + slopes_, -1.0, width() - 2.0)));
      if (first > last)
        continue;
      ++votes_[row * width() + first];
      --votes_[row * width() + last + 1];
    }
  }

  int slopes_, offsets_; // on each side of 0
  std::vector<int> votes_;
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
wallStretches(const VoxelGrid<std::uint8_t>& occupancy,
              const VerticalRange& storey,
              const PixelMap<int>& ceiling,
              const SlabLayers& slab,
              const PixelMap<std::uint8_t>& blocked,
              const WallLeanOptions& options)
{
  if (!(options.max_lean > 0.0) || !(options.max_lean < 0.5 * M_PI) ||
      !(options.window > 0.0))
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "The lean of walls, " << options.max_lean
                                              << " rad, or the window, "
                                              << options.window
                                              << " m, is out of range.");
  const double radius = std::max(2.0, 0.5 * options.window / occupancy.voxel_size);
  const double slope = std::tan(options.max_lean);
  const auto places = spreadOver(blocked, static_cast<int>(radius));
  std::vector<WallStretch> found(places.size());
#pragma omp parallel num_threads(threadCount(options.threads))
  {
    LineVote vote(slope, 0.5 * radius);
    std::vector<SectionVoxel> section;
#pragma omp for schedule(dynamic, 16)
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(places.size()); ++i) {
      auto wall = wallAround(blocked, places[i], radius);
      if (!wall)
        continue;
      const int top = ceiling.at(static_cast<int>(places[i].x() + 0.5),
                                 static_cast<int>(places[i].y() + 0.5));
      const double middle = top - 0.5 * (slab.first + slab.last);
      sectionAt(occupancy,
                storey.begin + 2, // above the floor and its noise
                middle,
                top - slab.first,
                slope,
                radius,
                *wall,
                section);
      auto line =
          vote.best(section, 2.0 * radius * std::max(0.0, middle - storey.begin - 2));
      if (!line)
        continue;
      const bool is_upright = line->lean == 0.0;
      refine(section, *line);
      if (std::abs(line->lean) > slope)
        continue;
      wall->lean = is_upright ? 0.0 : line->lean;
      wall->weight = line->weight;
      found[i] = *wall;
    }
  }
  found.erase(std::remove_if(found.begin(),
                             found.end(),
                             [](const auto& wall) { return !(wall.weight > 0); }),
              found.end());
  return found;
}

PixelMap<Eigen::Vector2f>
leanMap(const std::vector<WallStretch>& stretches, int nx, int ny, double pixel_size)
{
  PixelMap<Eigen::Vector2f> lean{nx, ny, {}};
  if (std::all_of(stretches.begin(), stretches.end(), [](const auto& wall) {
        return wall.lean == 0.0;
      }))
    return lean;
  struct Equations { // of the shift: a symmetric matrix and the right side
    float xx = 1.0f, xy = 0.0f, yy = 1.0f, x = 0.0f, y = 0.0f;
  };
  // A voxel of scatter and a lean of up to 1 to start from weigh 1 each: far from walls
  // nothing is known to lean.
  std::vector<Equations> equations(lean.size());
  const double sigma = 0.5 / pixel_size;
  const int radius = static_cast<int>(std::ceil(3.0 * sigma));
  for (const auto& wall : stretches) {
    const int x0 = static_cast<int>(wall.place.x());
    const int y0 = static_cast<int>(wall.place.y());
    for (int x = std::max(0, x0 - radius); x <= std::min(nx - 1, x0 + radius); ++x)
      for (int y = std::max(0, y0 - radius); y <= std::min(ny - 1, y0 + radius); ++y) {
        const double squared =
            (Eigen::Vector2d(x + 0.5, y + 0.5) - wall.place).squaredNorm();
        const double weight =
            wall.weight * std::exp(-0.5 * squared / (sigma * sigma));
        Equations& sums = equations[lean.index(x, y)];
        const Eigen::Vector2d& n = wall.normal;
        sums.xx += static_cast<float>(weight * n.x() * n.x());
        sums.xy += static_cast<float>(weight * n.x() * n.y());
        sums.yy += static_cast<float>(weight * n.y() * n.y());
        sums.x += static_cast<float>(weight * n.x() * wall.lean);
        sums.y += static_cast<float>(weight * n.y() * wall.lean);
      }
  }
  lean.values.reserve(lean.size());
  for (const auto& sums : equations) {
    Eigen::Matrix2d matrix;
    matrix << sums.xx, sums.xy, sums.xy, sums.yy;
    const Eigen::Vector2d shift = matrix.ldlt().solve(Eigen::Vector2d(sums.x, sums.y));
    lean.values.push_back(shift.cast<float>());
  }
  return lean;
}

Eigen::Vector2d
straightened(const PixelMap<Eigen::Vector2f>& lean,
             const PixelMap<float>& slab,
             const Eigen::Vector3d& place)
{
  Eigen::Vector2d upright = place.head<2>();
  for (int turn = 0; turn < 3; ++turn) { // the lean is that of the place above
    const int x = static_cast<int>(std::floor(upright.x()));
    const int y = static_cast<int>(std::floor(upright.y()));
    if (!lean.contains(x, y))
      return upright;
    const double depth = slab.at(x, y) - place.z();
    upright = place.head<2>() - depth * lean.at(x, y).cast<double>();
  }
  return upright;
}

} // namespace indoor
} // namespace pcl
