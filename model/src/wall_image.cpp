/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/model/wall_image.h>

#include <pcl/indoor/quantile.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pcl::indoor {
namespace {

constexpr int cells_around = 2;     // cells around one whose points it shows
constexpr double hand = 0.15;       // metres: what stands farther before is an object
constexpr double least_cell = 0.02; // metres: side of a cell of dense scans
// metres, of what is no face: stations are registered to a centimetre, and a median
// over ten points with noise of 1.2 cm is known to 0.5 cm
constexpr double least_relief = 0.02;

/** Points in the order of their cells. */
struct CellPoints {
  std::vector<std::uint32_t> first; ///< per cell, and one past the end
  std::vector<float> depth;
};

/** How far points of a side are apart: from how many lie in squares that have some. */
double
spacingOf(const std::vector<WallPoint>& points)
{
  constexpr double square = 0.1; // metres
  std::vector<std::pair<int, int>> squares;
  for (const auto& point : points)
    if (std::abs(point.before) <= hand)
      squares.emplace_back(static_cast<int>(std::floor(point.along / square)),
                           static_cast<int>(std::floor(point.height / square)));
  if (squares.empty())
    return 0.0;
  std::sort(squares.begin(), squares.end());
  std::vector<std::size_t> counts;
  for (std::size_t i = 0; i < squares.size();) {
    const auto end =
        std::upper_bound(squares.begin(), squares.end(), squares[i]) - squares.begin();
    counts.push_back(static_cast<std::size_t>(end) - i);
    i = static_cast<std::size_t>(end);
  }
  return square / std::sqrt(static_cast<double>(median(counts)));
}

/** Column and row of a point, which may lie outside. */
std::pair<int, int>
placeOf(const WallPoint& point, const WallImage& image)
{
  return {static_cast<int>(std::floor(point.along / image.cell)),
          static_cast<int>(std::floor((point.height - image.floor) / image.cell))};
}

/** The cell of a point; negative outside. */
std::ptrdiff_t
cellOf(const WallPoint& point, const WallImage& image)
{
  const auto [x, y] = placeOf(point, image);
  return image.cells.contains(x, y)
             ? static_cast<std::ptrdiff_t>(image.cells.index(x, y))
             : -1;
}

CellPoints
pointsByCell(const std::vector<WallPoint>& points, const WallImage& image)
{
  CellPoints cells;
  cells.first.assign(image.cells.size() + 1, 0);
  std::vector<std::ptrdiff_t> cell_of(points.size(), -1);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].before <= hand) {
      cell_of[i] = cellOf(points[i], image);
      if (cell_of[i] >= 0)
        ++cells.first[static_cast<std::size_t>(cell_of[i]) + 1];
    }
  std::partial_sum(cells.first.begin(), cells.first.end(), cells.first.begin());
  cells.depth.resize(cells.first.back());
  auto next = cells.first;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (cell_of[i] >= 0)
      cells.depth[next[static_cast<std::size_t>(cell_of[i])]++] = points[i].before;
  return cells;
}

WallCell
kindOf(double depth, double relief)
{
  return depth < -relief  ? WallCell::Recess
         : depth > relief ? WallCell::Proud
                          : WallCell::Face;
}

/** The least depth of what is no face: of uneven walls, and where stations do not fit,
 * three times the middle of what the face itself stands out. */
double
reliefOf(const WallImage& image)
{
  std::vector<float> out;
  for (std::size_t i = 0; i < image.cells.size(); ++i)
    if (image.cells.values[i] != WallCell::Empty && image.depth.values[i] > 0.0f)
      out.push_back(image.depth.values[i]);
  return out.empty() ? least_relief : std::max(least_relief, 3.0 * median(out));
}

/** The median depth of what is seen around a cell. Where the face is seen, what lies
 * farther behind it than a hand is the other side of the wall, seen from there.
 * \param[in] of_face points that a face has around a cell */
float
medianDepth(std::vector<float>& depths, double of_face)
{
  const auto behind = std::partition(depths.begin(), depths.end(), [&](float depth) {
    return depth >= static_cast<float>(-hand);
  });
  const bool is_face = static_cast<double>(behind - depths.begin()) > 0.5 * of_face;
  const auto end = is_face ? behind : depths.end();
  const auto middle = depths.begin() + (end - depths.begin()) / 2;
  std::nth_element(depths.begin(), middle, end);
  return *middle;
}

/** Set what each cell shows: the median of the points around it. */
void
showDepths(const CellPoints& points, double of_face, WallImage& image)
{
  std::vector<float> near;
  for (int x = 0; x < image.cells.nx; ++x)
    for (int y = 0; y < image.cells.ny; ++y) {
      near.clear();
      const int low = std::max(0, y - cells_around);
      const int high = std::min(image.cells.ny - 1, y + cells_around);
      for (int u = std::max(0, x - cells_around);
           u <= std::min(image.cells.nx - 1, x + cells_around);
           ++u)
        near.insert(near.end(),
                    points.depth.begin() + points.first[image.cells.index(u, low)],
                    points.depth.begin() +
                        points.first[image.cells.index(u, high) + 1]);
      if (near.empty())
        continue;
      image.depth.at(x, y) = medianDepth(near, of_face);
      image.cells.at(x, y) = WallCell::Face;
    }
  const double relief = reliefOf(image);
  for (std::size_t i = 0; i < image.cells.size(); ++i)
    if (image.cells.values[i] == WallCell::Face)
      image.cells.values[i] = kindOf(image.depth.values[i], relief);
}

/** Mark empty cells with objects before them. */
void
showObjects(const std::vector<WallPoint>& points, WallImage& image)
{
  for (const auto& point : points) {
    if (point.before <= hand)
      continue;
    const auto [x, y] = placeOf(point, image);
    for (int u = x - cells_around; u <= x + cells_around; ++u)
      for (int v = y - cells_around; v <= y + cells_around; ++v)
        if (image.cells.contains(u, v) && image.cells.at(u, v) == WallCell::Empty)
          image.cells.at(u, v) = WallCell::Front;
  }
}

} // namespace

double
WallImage::share(const Eigen::AlignedBox2d& box, WallCell kind) const
{
  const auto bound = [&](double place) {
    return static_cast<int>(std::lround(place / cell));
  };
  const int from_y = bound(box.min().y() - floor);
  const int to_y = bound(box.max().y() - floor);
  std::size_t all = 0, found = 0;
  for (int x = bound(box.min().x()); x < bound(box.max().x()); ++x)
    for (int y = from_y; y < to_y; ++y) {
      ++all;
      found += cells.contains(x, y) && cells.at(x, y) == kind;
    }
  return all > 0 ? static_cast<double>(found) / static_cast<double>(all) : 0.0;
}

WallImage
wallImage(const std::vector<WallPoint>& points,
          double length,
          double floor,
          double height)
{
  constexpr double cells_per_spacing = 0.6; // nine points around each cell
  const double spacing = spacingOf(points);
  WallImage image;
  image.cell = std::max(least_cell, cells_per_spacing * spacing);
  image.floor = floor;
  image.cells.nx = static_cast<int>(std::ceil(length / image.cell));
  image.cells.ny = static_cast<int>(std::ceil(height / image.cell));
  image.cells.values.assign(image.cells.size(), WallCell::Empty);
  image.depth.nx = image.cells.nx;
  image.depth.ny = image.cells.ny;
  image.depth.values.assign(image.depth.size(), 0.0f);
  const double around = (2 * cells_around + 1) * image.cell; // metres
  const double of_face = spacing > 0.0 ? std::pow(around / spacing, 2) : 0.0;
  showDepths(pointsByCell(points, image), of_face, image);
  showObjects(points, image);
  return image;
}

} // namespace pcl::indoor
