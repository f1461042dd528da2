/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/rooms/wall_sides.h>

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

/** Points in the order of their pixels. */
struct PixelPoints {
  std::vector<std::uint32_t> first; // per pixel, and one past the end
  std::vector<std::uint32_t> index; // into the points

  PixelPoints(const std::vector<std::int32_t>& pixel_of,
              const std::vector<std::uint8_t>* chosen,
              std::size_t pixel_count)
  : first(pixel_count + 1, 0)
  {
    const auto counts = [&](std::size_t i) {
      return pixel_of[i] >= 0 && (!chosen || (*chosen)[i]);
    };
    for (std::size_t i = 0; i < pixel_of.size(); ++i)
      if (counts(i))
        ++first[pixel_of[i] + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    index.resize(first.back());
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (std::size_t i = 0; i < pixel_of.size(); ++i)
      if (counts(i))
        index[next[pixel_of[i]]++] = static_cast<std::uint32_t>(i);
  }
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
  const PixelPoints all(pixel_of, nullptr, labels.size());
  const PixelPoints wall(pixel_of, &is_wall, labels.size());
  const int radius =
      std::max(1, static_cast<int>(std::lround(0.5 * options.window / pixel_size)));
  const double reach = options.reach / pixel_size;
  WallSideOptions in_pixels = options;
  in_pixels.max_thickness /= pixel_size;

  const int threads = threadCount(options.threads);
  parallelFor(labels.nx, threads, 8, [&](std::ptrdiff_t column) {
    const int x = static_cast<int>(column);
    std::vector<Eigen::Vector2d> window;
    for (int y = 0; y < labels.ny; ++y) {
      const std::size_t pixel = labels.index(x, y);
      if (all.first[pixel] == all.first[pixel + 1] ||
          !nearOtherRoom(labels, x, y, radius))
        continue;
      window.clear();
      for (int u = std::max(0, x - radius); u <= std::min(labels.nx - 1, x + radius);
           ++u)
        for (int v = std::max(0, y - radius); v <= std::min(labels.ny - 1, y + radius);
             ++v)
          for (std::uint32_t k = wall.first[labels.index(u, v)];
               k < wall.first[labels.index(u, v) + 1];
               ++k)
            window.push_back(scaled(wall.index[k]));
      if (window.size() < options.min_points)
        continue;
      const auto line = fitWall(window, in_pixels);
      if (!line) { // a corner
        for (std::uint32_t k = all.first[pixel]; k < all.first[pixel + 1]; ++k) {
          std::int32_t& label = point_labels[all.index[k]];
          label = nearestRoom(free_labels, scaled(all.index[k]), reach, label);
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
      for (std::uint32_t k = all.first[pixel]; k < all.first[pixel + 1]; ++k) {
        const std::uint32_t i = all.index[k];
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
