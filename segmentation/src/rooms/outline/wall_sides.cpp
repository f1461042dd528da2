/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/outline/wall_sides.h"

#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/threads.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

namespace pcl {
namespace indoor {
namespace {

/** The rows begin ... end - 1 of the map: what there are points in. */
struct Rows {
  int begin = 0, end = 0;
};

Rows
rowsOf(const std::vector<std::int32_t>& pixel_of, int ny)
{
  Rows rows{std::numeric_limits<int>::max(), 0};
  for (const auto pixel : pixel_of)
    if (pixel >= 0) {
      rows.begin = std::min(rows.begin, pixel / ny);
      rows.end = std::max(rows.end, pixel / ny + 1);
    }
  return rows.end > 0 ? rows : Rows{};
}

/** Points in the order of their pixels, of which only those of some rows are kept. */
class PixelPoints {
public:
  PixelPoints(const std::vector<std::int32_t>& pixel_of,
              const std::vector<std::uint8_t>* chosen,
              const Rows& rows,
              int ny)
  : offset_(static_cast<std::size_t>(rows.begin) * ny)
  , first_(static_cast<std::size_t>(rows.end - rows.begin) * ny + 1, 0)
  {
    const auto counts = [&](std::size_t i) {
      return pixel_of[i] >= 0 && (!chosen || (*chosen)[i]);
    };
    for (std::size_t i = 0; i < pixel_of.size(); ++i)
      if (counts(i))
        ++first_[pixel_of[i] - offset_ + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    index_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < pixel_of.size(); ++i)
      if (counts(i))
        index_[next[pixel_of[i] - offset_]++] = static_cast<std::uint32_t>(i);
  }

  /** The points of a pixel of these rows. */
  const std::uint32_t*
  begin(std::size_t pixel) const
  {
    return index_.data() + first_[pixel - offset_];
  }

  const std::uint32_t*
  end(std::size_t pixel) const
  {
    return index_.data() + first_[pixel - offset_ + 1];
  }

private:
  std::size_t offset_;               // the first pixel
  std::vector<std::uint32_t> first_; // per pixel, and one past the end
  std::vector<std::uint32_t> index_; // into the points
};

/** A vertical plane between the two faces of a wall, or in its only one, seen from
 * above. */
struct WallLine {
  Eigen::Vector2d normal;
  Eigen::Vector2d middle;
  bool has_two_faces;
  double half_thickness;

  double
  side(const Eigen::Vector2d& point) const
  {
    return normal.dot(point - middle);
  }
};

std::optional<WallLine>
fitWall(const std::vector<Eigen::Vector2d>& points, const WallSideOptions& options)
{
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& point : points)
    mean += point;
  mean /= static_cast<double>(points.size());
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (const auto& point : points)
    covariance += (point - mean) * (point - mean).transpose();
  covariance /= static_cast<double>(points.size());
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
  eigen.computeDirect(covariance);
  // Two faces at a distance d have a standard deviation of d / 2 across the wall.
  const double across = std::sqrt(std::max(0.0, eigen.eigenvalues()[0]));
  const double along = std::sqrt(std::max(0.0, eigen.eigenvalues()[1]));
  if (across > 0.5 * options.max_thickness || across > 0.7 * along)
    return std::nullopt;

  const Eigen::Vector2d normal = eigen.eigenvectors().col(0);
  std::vector<double> offsets; // from the mean, along the normal
  offsets.reserve(points.size());
  for (const auto& point : points)
    offsets.push_back(normal.dot(point - mean));
  double middle = 0.0;
  double apart = 0.0;
  for (int iteration = 0; iteration < 4; ++iteration) {
    double sum[2] = {0.0, 0.0};
    std::size_t count[2] = {0, 0};
    for (const double t : offsets) {
      sum[t > middle] += t;
      ++count[t > middle];
    }
    if (count[0] == 0 || count[1] == 0)
      break;
    const double faces[2] = {sum[0] / count[0], sum[1] / count[1]};
    middle = 0.5 * (faces[0] + faces[1]);
    apart = faces[1] - faces[0];
  }
  // Splitting the noise of one face puts the two means 2.7 (Gaussian) to 3.5 (uniform)
  // standard deviations within each half apart; those of two faces lie farther apart.
  const double within =
      std::sqrt(std::max(0.0, across * across - 0.25 * apart * apart));
  return WallLine{normal, mean + middle * normal, apart > 4.0 * within, 0.5 * apart};
}

/** A room beside a wall, and how far its free space is. */
struct RoomBeside {
  std::int32_t label = 0; // 0 = none within reach
  double distance = std::numeric_limits<double>::infinity();
};

/** The nearest room on a ray from a wall. */
RoomBeside
roomBeside(const PixelMap<std::int32_t>& free_labels,
           const Eigen::Vector2d& from,
           const Eigen::Vector2d& direction,
           double reach)
{
  for (double t = 0.5; t <= reach; t += 0.5) {
    const Eigen::Vector2d at = from + t * direction;
    const int x = static_cast<int>(std::floor(at.x()));
    const int y = static_cast<int>(std::floor(at.y()));
    if (free_labels.contains(x, y) && free_labels.at(x, y) != 0)
      return {free_labels.at(x, y), t};
  }
  return {};
}

/** The room whose free space is nearest to a point, or else the fallback. */
std::int32_t
nearestRoom(const PixelMap<std::int32_t>& free_labels,
            const Eigen::Vector2d& point,
            double reach,
            std::int32_t fallback)
{
  const int radius = static_cast<int>(std::ceil(reach));
  const int x = static_cast<int>(std::floor(point.x()));
  const int y = static_cast<int>(std::floor(point.y()));
  const auto gap = [](double position, int pixel) { // to the pixel's square
    return std::max({pixel - position, position - (pixel + 1), 0.0});
  };
  double nearest = reach * reach;
  std::size_t best = free_labels.size(); // of equally near pixels the first
  const auto look = [&](int u, int v, double dx) {
    if (!free_labels.contains(u, v) || free_labels.at(u, v) == 0)
      return;
    const double dy = gap(point.y(), v);
    const double squared = dx * dx + dy * dy;
    const std::size_t pixel = free_labels.index(u, v);
    if (squared < nearest ||
        (squared == nearest && best < free_labels.size() && pixel < best)) {
      nearest = squared;
      best = pixel;
    }
  };
  // From the point outwards, as far as something nearer may lie.
  const auto isBeyond = [&](int steps) {
    return steps > radius || (steps > 1 && (steps - 1.0) * (steps - 1.0) > nearest);
  };
  for (int k = 0; !isBeyond(k); ++k)
    for (const int u : {x - k, x + k}) {
      const double dx = gap(point.x(), u);
      for (int l = 0; !isBeyond(l); ++l) {
        look(u, y - l, dx);
        if (l > 0)
          look(u, y + l, dx);
      }
      if (k == 0)
        break;
    }
  return best < free_labels.size() ? free_labels.values[best] : fallback;
}

/** Whether the label of another room than the pixel's lies in its window. */
bool
nearOtherRoom(const PixelMap<std::int32_t>& labels, int x, int y, int radius)
{
  const std::int32_t own = labels.at(x, y);
  for (int u = std::max(0, x - radius); u <= std::min(labels.nx - 1, x + radius); ++u)
    for (int v = std::max(0, y - radius); v <= std::min(labels.ny - 1, y + radius); ++v)
      if (labels.at(u, v) != own && labels.at(u, v) != 0)
        return true;
  return false;
}

} // namespace

void
assignWallSides(const std::vector<Eigen::Vector2f>& points,
                const std::vector<std::uint8_t>& is_wall,
                double pixel_size,
                const PixelMap<std::int32_t>& labels,
                const PixelMap<std::int32_t>& free_labels,
                const WallSideOptions& options,
                std::vector<std::int32_t>& point_labels)
{
  const auto scaled = [&](std::size_t i) {
    return Eigen::Vector2d(points[i].cast<double>() / pixel_size);
  };
  std::vector<std::int32_t> pixel_of(points.size(), -1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d p = scaled(i);
    const int x = static_cast<int>(std::floor(p.x()));
    const int y = static_cast<int>(std::floor(p.y()));
    if (labels.contains(x, y))
      pixel_of[i] = static_cast<std::int32_t>(labels.index(x, y));
  }
  const Rows rows = rowsOf(pixel_of, labels.ny);
  const PixelPoints all(pixel_of, nullptr, rows, labels.ny);
  const PixelPoints wall(pixel_of, &is_wall, rows, labels.ny);
  const int radius =
      std::max(1, static_cast<int>(std::lround(0.5 * options.window / pixel_size)));
  const double reach = options.reach / pixel_size;
  WallSideOptions in_pixels = options;
  in_pixels.max_thickness /= pixel_size;

  const int threads = threadCount(options.threads);
  parallelFor(rows.end - rows.begin, threads, 8, [&](std::ptrdiff_t row) {
    const int x = rows.begin + static_cast<int>(row);
    std::vector<Eigen::Vector2d> window;
    for (int y = 0; y < labels.ny; ++y) {
      const std::size_t pixel = labels.index(x, y);
      if (all.begin(pixel) == all.end(pixel) || !nearOtherRoom(labels, x, y, radius))
        continue;
      window.clear();
      const int last_u = std::min(rows.end - 1, x + radius);
      const int last_v = std::min(labels.ny - 1, y + radius);
      for (int u = std::max(rows.begin, x - radius); u <= last_u; ++u)
        for (int v = std::max(0, y - radius); v <= last_v; ++v) {
          const std::size_t at = labels.index(u, v);
          for (const auto* k = wall.begin(at); k != wall.end(at); ++k)
            window.push_back(scaled(*k));
        }
      if (window.size() < options.min_points)
        continue;
      const auto line = fitWall(window, in_pixels);
      if (!line) { // a corner
        for (const auto* k = all.begin(pixel); k != all.end(pixel); ++k) {
          std::int32_t& label = point_labels[*k];
          label = nearestRoom(free_labels, scaled(*k), reach, label);
        }
        continue;
      }
      const Eigen::Vector2d center(x + 0.5, y + 0.5);
      const Eigen::Vector2d foot = center - line->side(center) * line->normal;
      RoomBeside above = roomBeside(free_labels, foot, line->normal, reach);
      RoomBeside below = roomBeside(free_labels, foot, -line->normal, reach);
      if (above.label == below.label)
        continue;
      // A wall without a room behind it, and one face of a thick wall, have one room.
      const bool nearer_only =
          !line->has_two_faces && std::abs(above.distance - below.distance) > 1.5;
      if (below.label == 0 || (nearer_only && above.distance < below.distance))
        below.label = above.label;
      else if (above.label == 0 || nearer_only)
        above.label = below.label;
      for (const auto* k = all.begin(pixel); k != all.end(pixel); ++k) {
        const std::uint32_t i = *k;
        const double side = line->side(scaled(i));
        if (std::abs(side) > line->half_thickness + 1.0) // another wall's
          point_labels[i] = nearestRoom(free_labels, scaled(i), reach, point_labels[i]);
        else
          point_labels[i] = side > 0 ? above.label : below.label;
      }
    }
  });
}

} // namespace indoor
} // namespace pcl
