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
#include <optional>
#include <vector>

namespace pcl::indoor {
namespace {

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

/** The means of two halves of some values. */
struct TwoMeans {
  double middle = 0.0; ///< between them
  double apart = 0.0;  ///< 0 if all values are in one half
};

/** \param[in] offsets from their mean */
TwoMeans
twoMeans(const std::vector<double>& offsets)
{
  TwoMeans means;
  for (int iteration = 0; iteration < 4; ++iteration) {
    double below = 0.0, above = 0.0; // sums
    std::size_t count = 0;           // above
    for (const double t : offsets) { // without branches
      const bool is_above = t > means.middle;
      below += is_above ? 0.0 : t;
      above += is_above ? t : 0.0;
      count += is_above;
    }
    if (count == 0 || count == offsets.size())
      break;
    below /= static_cast<double>(offsets.size() - count);
    above /= static_cast<double>(count);
    means.apart = above - below;
    if (means.middle == 0.5 * (below + above))
      break;
    means.middle = 0.5 * (below + above);
  }
  return means;
}

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
  const auto [middle, apart] = twoMeans(offsets);
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

/** The points at walls in the window around a pixel, as far as there are rows. */
void
wallPointsAround(const PixelPoints& points,
                 const PixelMap<std::int32_t>& labels,
                 const Eigen::Vector2i& pixel,
                 int radius,
                 std::vector<Eigen::Vector2d>& found)
{
  found.clear();
  const std::size_t first_pixel = labels.index(points.begin_row, 0);
  const int last_u = std::min(points.end_row - 1, pixel.x() + radius);
  const int last_v = std::min(labels.ny - 1, pixel.y() + radius);
  for (int u = std::max(points.begin_row, pixel.x() - radius); u <= last_u; ++u)
    for (int v = std::max(0, pixel.y() - radius); v <= last_v; ++v) {
      const std::size_t at = labels.index(u, v) - first_pixel;
      for (std::uint32_t k = points.first[at]; k < points.walls_end[at]; ++k)
        found.push_back(points.places[k].cast<double>());
    }
}

/** The rooms on the two sides of a wall. */
struct SideRooms {
  std::int32_t above, below; ///< where side() is positive, and where it is not
};

/** \return nothing if the same room, or none, is on both sides near a pixel */
std::optional<SideRooms>
roomsOnSides(const PixelMap<std::int32_t>& free_labels,
             const WallLine& line,
             const Eigen::Vector2i& pixel,
             double reach)
{
  const Eigen::Vector2d center(pixel.x() + 0.5, pixel.y() + 0.5);
  const Eigen::Vector2d foot = center - line.side(center) * line.normal;
  const RoomBeside above = roomBeside(free_labels, foot, line.normal, reach);
  const RoomBeside below = roomBeside(free_labels, foot, -line.normal, reach);
  if (above.label == below.label)
    return std::nullopt;
  // A wall without a room behind it, and one face of a thick wall, have one room.
  const bool nearer_only =
      !line.has_two_faces && std::abs(above.distance - below.distance) > 1.5;
  if (below.label == 0 || (nearer_only && above.distance < below.distance))
    return SideRooms{above.label, above.label};
  if (above.label == 0 || nearer_only)
    return SideRooms{below.label, below.label};
  return SideRooms{above.label, below.label};
}

} // namespace

void
assignWallSides(const PixelPoints& points,
                double pixel_size,
                const PixelMap<std::int32_t>& labels,
                const PixelMap<std::int32_t>& free_labels,
                const WallSideOptions& options,
                int threads,
                std::vector<std::int32_t>& point_labels)
{
  const std::size_t first_pixel = labels.index(points.begin_row, 0);
  const int radius = voxelsIn(0.5 * options.window, pixel_size, 1);
  const double reach = options.reach / pixel_size;
  WallSideOptions in_pixels = options;
  in_pixels.max_thickness /= pixel_size;
  const int count = threadCount(threads);
  parallelFor(points.end_row - points.begin_row, count, 8, [&](std::ptrdiff_t row) {
    const int x = points.begin_row + static_cast<int>(row);
    std::vector<Eigen::Vector2d> window;
    for (int y = 0; y < labels.ny; ++y) {
      const std::size_t pixel = labels.index(x, y) - first_pixel;
      const std::uint32_t begin = points.first[pixel], end = points.first[pixel + 1];
      if (begin == end || !nearOtherRoom(labels, x, y, radius))
        continue;
      wallPointsAround(points, labels, {x, y}, radius, window);
      if (window.size() < options.min_points)
        continue;
      const auto line = fitWall(window, in_pixels);
      const auto rooms =
          line ? roomsOnSides(free_labels, *line, {x, y}, reach) : std::nullopt;
      if (line && !rooms)
        continue;
      for (std::uint32_t k = begin; k < end; ++k) {
        const Eigen::Vector2d place = points.places[k].cast<double>();
        const double side = line ? line->side(place) : 0.0;
        // at a corner, or another wall's
        if (!line || std::abs(side) > line->half_thickness + 1.0)
          point_labels[k] = nearestRoom(free_labels, place, reach, point_labels[k]);
        else
          point_labels[k] = side > 0 ? rooms->above : rooms->below;
      }
    }
  });
}

} // namespace pcl::indoor
