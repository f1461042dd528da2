/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/model/wall_holes.h>

#include "hole_edges.h"
#include "wall_niche.h"

#include <pcl/indoor/flood_fill.h>
#include <pcl/indoor/quantile.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl::indoor {
namespace {

using Mask = PixelMap<std::uint8_t>;

constexpr double least_side = 0.3; // metres: narrower ones are gaps of the scan
constexpr double jump = 0.15;      // metres: between openings side by side
constexpr double border = 0.05;    // metres: a frame, or the band of face beside a hole
constexpr double frame_relief = 0.03; // metres

/** Columns of connected cells: first and last row of each. */
struct Columns {
  int first = 0;
  std::vector<int> low, high;
  std::vector<std::uint8_t>
      hides_low; ///< whether an object stands before what is below
};

/** Leave out what is narrower than three cells. */
Mask
opened(const Mask& mask)
{
  const auto changed = [](const Mask& from, bool grows) {
    Mask to = from;
    for (int x = 0; x < from.nx; ++x)
      for (int y = 0; y < from.ny; ++y)
        for (int u = x - 1; u <= x + 1; ++u)
          for (int v = y - 1; v <= y + 1; ++v)
            if (from.contains(u, v) && (from.at(u, v) != 0) == grows)
              to.at(x, y) = grows;
    return to;
  };
  return changed(changed(mask, false), true);
}

/** Whether an object stands before the wall right below a cell. */
bool
hidesBelow(const WallImage& image, int x, int y)
{
  for (int v = y - 3; v < y; ++v)
    if (image.cells.contains(x, v) && image.cells.at(x, v) == WallCell::Front)
      return true;
  return false;
}

std::vector<Columns>
connectedColumns(const Mask& mask, const WallImage& image)
{
  std::vector<Columns> all;
  std::vector<std::uint8_t> seen(mask.size(), 0);
  std::vector<std::size_t> cells;
  const auto neighbours = [&](std::size_t cell, const auto& visit) {
    const int x = static_cast<int>(cell) / mask.ny;
    const int y = static_cast<int>(cell) % mask.ny;
    for (const auto& [u, v] : {std::pair(x - 1, y),
                               std::pair(x + 1, y),
                               std::pair(x, y - 1),
                               std::pair(x, y + 1)})
      if (mask.contains(u, v))
        visit(mask.index(u, v));
  };
  for (std::size_t start = 0; start < mask.size(); ++start) {
    if (!mask.values[start] || std::exchange(seen[start], 1))
      continue;
    cells.assign(1, start);
    floodFill(cells, neighbours, [&](std::size_t cell, std::size_t) {
      return mask.values[cell] && !std::exchange(seen[cell], 1);
    });
    std::sort(cells.begin(), cells.end()); // column by column
    Columns columns;
    columns.first = static_cast<int>(cells.front()) / mask.ny;
    for (const auto cell : cells) {
      const int x = static_cast<int>(cell) / mask.ny - columns.first;
      const int y = static_cast<int>(cell) % mask.ny;
      if (x == static_cast<int>(columns.low.size())) {
        columns.low.push_back(y);
        columns.high.push_back(y);
      }
      columns.high.back() = y;
    }
    for (std::size_t i = 0; i < columns.low.size(); ++i)
      columns.hides_low.push_back(
          hidesBelow(image, columns.first + static_cast<int>(i), columns.low[i]));
    all.push_back(std::move(columns));
  }
  return all;
}

/** The middle of each value and its two neighbours on each side. */
std::vector<int>
smoothed(const std::vector<int>& values)
{
  std::vector<int> result(values.size());
  const auto n = static_cast<std::ptrdiff_t>(values.size());
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    std::vector<int> near(values.begin() + std::max<std::ptrdiff_t>(0, i - 2),
                          values.begin() + std::min(n, i + 3));
    result[static_cast<std::size_t>(i)] = median(near);
  }
  return result;
}

/** Rectangles of connected cells, metres. */
std::vector<Eigen::AlignedBox2d>
rectanglesOf(const Columns& columns, const WallImage& image)
{
  std::vector<Eigen::AlignedBox2d> boxes;
  const auto low = smoothed(columns.low), high = smoothed(columns.high);
  // points that are two cells away count for each end
  const int most = std::max(static_cast<int>(jump / image.cell), 5);
  const auto goOn = [&](std::size_t column) {
    const bool is_known = !columns.hides_low[column] && !columns.hides_low[column - 1];
    return (!is_known || std::abs(low[column] - low[column - 1]) <= most) &&
           std::abs(high[column] - high[column - 1]) <= most;
  };
  for (std::size_t begin = 0; begin < low.size();) {
    std::size_t end = begin + 1;
    while (end < low.size() && goOn(end))
      ++end;
    std::vector<int> lows, highs;
    for (std::size_t i = begin; i < end; ++i) {
      if (!columns.hides_low[i])
        lows.push_back(low[i]);
      highs.push_back(high[i]);
    }
    if (2 * lows.size() < end - begin) // most are hidden: as far down as it is seen
      lows.assign(low.begin() + static_cast<std::ptrdiff_t>(begin),
                  low.begin() + static_cast<std::ptrdiff_t>(end));
    const Eigen::Vector2d lower(columns.first + static_cast<double>(begin),
                                median(lows));
    const Eigen::Vector2d upper(columns.first + static_cast<double>(end),
                                median(highs) + 1.0);
    const Eigen::Vector2d floor(0.0, image.floor);
    boxes.emplace_back(floor + image.cell * lower, floor + image.cell * upper);
    begin = end;
  }
  return boxes;
}

/** How far outwards an edge lies, metres; nothing if the places do not say.
 * \param[in] places of the face's points across the edge: metres, outwards from where
 * it is now
 * \param[in] sure how much of each end is on its side for sure, centimetres
 */
std::optional<double>
shiftWithin(const std::vector<double>& places, int sure)
{
  const int bins = 4 * sure;
  std::vector<double> counts(static_cast<std::size_t>(bins), 0.0);
  for (const double place : places) {
    const int bin = static_cast<int>(std::floor(100.0 * place)) + bins / 2;
    if (bin >= 0 && bin < bins)
      counts[static_cast<std::size_t>(bin)] += 1.0;
  }
  double inside = 0.0, outside = 0.0;
  for (int i = 0; i < sure; ++i) {
    inside += counts[static_cast<std::size_t>(i)] / sure;
    outside += counts[static_cast<std::size_t>(bins - 1 - i)] / sure;
  }
  if (outside < 1.0 || outside < 2.0 * inside)
    return std::nullopt;
  const double low = std::max(inside, 0.01 * outside);
  double best = 0.0, likelihood = 0.0; // over that of an edge at the inner end
  int edge = 0;
  for (int i = 0; i < bins; ++i) {
    // the bin is inside instead of outside
    likelihood +=
        counts[static_cast<std::size_t>(i)] * std::log(low / outside) + outside - low;
    if (likelihood > best) {
      best = likelihood;
      edge = i + 1;
    }
  }
  return 0.01 * (edge - bins / 2);
}

/** The same, near by or, if that does not say, as far as cells are uncertain; else 0.
 * \param[in] uncertain metres
 */
double
edgeShift(const std::vector<double>& places, double uncertain)
{
  constexpr int near = 6; // centimetres
  const int far = static_cast<int>(std::ceil(100.0 * uncertain));
  const auto shift = shiftWithin(places, near);
  return shift || far <= near ? shift.value_or(0.0)
                              : shiftWithin(places, far).value_or(0.0);
}

/** Put the edges of a hole where the face begins. */
void
refine(const WallImage& image, const std::vector<WallPoint>& points, FaceHole& hole)
{
  constexpr double near = 0.05; // metres: farther points are of no face
  const double limit = hole.is_proud
                           ? std::min(frame_relief, 0.5 * hole.depth)
                           : -std::min(frame_relief, 0.5 * std::abs(hole.depth));
  const auto is_face = [&](const WallPoint& point) {
    return std::abs(point.before) < near &&
           (hole.is_proud ? point.before < limit
                          : point.before > (hole.depth == 0.0 ? -frame_relief : limit));
  };
  for (int round = 0; round < 2; ++round) {
    const Eigen::AlignedBox2d box = hole.box;
    const Eigen::Vector2d margin = 0.1 * box.sizes();
    // gaps of the scan shall not grow to openings
    const double uncertain =
        box.sizes().minCoeff() < least_side ? 0.0 : 3.0 * image.cell;
    std::array<std::vector<double>, 4> places; // left, right, lower, upper
    for (const auto& point : points) {
      const double u = point.along, v = point.height;
      if (!is_face(point))
        continue;
      if (v > box.min().y() + margin.y() && v < box.max().y() - margin.y()) {
        places[0].push_back(box.min().x() - u);
        places[1].push_back(u - box.max().x());
      }
      if (u > box.min().x() + margin.x() && u < box.max().x() - margin.x()) {
        places[2].push_back(box.min().y() - v);
        places[3].push_back(v - box.max().y());
      }
    }
    hole.box.min() -= Eigen::Vector2d(edgeShift(places[0], uncertain),
                                      edgeShift(places[2], uncertain));
    hole.box.max() += Eigen::Vector2d(edgeShift(places[1], uncertain),
                                      edgeShift(places[3], uncertain));
    hole.box.min().y() = std::max(hole.box.min().y(), image.floor);
  }
}

/** Set what is seen in a hole and around it. */
void
describe(const WallImage& image, FaceHole& hole)
{
  const auto box = [](double left, double low, double right, double high) {
    return Eigen::AlignedBox2d(Eigen::Vector2d(left, low),
                               Eigen::Vector2d(right, high));
  };
  const Eigen::Vector2d a = hole.box.min(), b = hole.box.max();
  const double w = border;
  const double recess = image.share(hole.box, WallCell::Recess);
  hole.seen = hole.is_proud ? image.share(hole.box, WallCell::Proud) : recess;
  hole.hidden = image.share(hole.box, WallCell::Front);
  const auto behind = [&](const Eigen::AlignedBox2d& part) {
    return image.share(part, WallCell::Recess);
  };
  const double height = b.y() - a.y(), width = b.x() - a.x();
  hole.reveal = (height * behind(box(a.x(), a.y(), a.x() + w, b.y())) +
                 height * behind(box(b.x() - w, a.y(), b.x(), b.y())) +
                 width * behind(box(a.x(), b.y() - w, b.x(), b.y()))) /
                (2.0 * height + width);
}

/** The shares of a hole's sides beyond which the face is seen. */
void
findFrame(const WallImage& image, const std::vector<WallPoint>& points, FaceHole& hole)
{
  const double piece = edgePiece(image);
  const double band = std::max(border, 1.5 * image.cell);
  const Eigen::Vector2d sizes = hole.box.sizes();
  std::array<std::vector<std::uint8_t>, 4> seen; // left, right, above, below
  for (std::size_t side = 0; side < 4; ++side)
    seen[side].assign(static_cast<std::size_t>(std::ceil(sizes[side < 2] / piece)), 0);
  const auto mark = [&](std::size_t side, double beyond, double place) {
    auto& pieces = seen[side];
    const auto i = static_cast<std::ptrdiff_t>(std::floor(place / piece));
    if (beyond > 0.0 && beyond <= band && i >= 0 &&
        i < static_cast<std::ptrdiff_t>(pieces.size()))
      pieces[static_cast<std::size_t>(i)] = 1;
  };
  for (const auto& point : points)
    if (std::abs(point.before) <= frame_relief)
      forEachEdge(hole.box, point, mark);
  for (std::size_t side = 0; side < 4; ++side)
    hole.framed[side] = seenShareOf(seen[side]);
}

/** The median depth of what is seen in a hole, metres. */
double
depthOf(const WallImage& image, const FaceHole& hole)
{
  const auto kind = hole.is_proud ? WallCell::Proud : WallCell::Recess;
  std::vector<float> depths;
  for (int x = 0; x < image.cells.nx; ++x)
    for (int y = 0; y < image.cells.ny; ++y)
      if (image.cells.at(x, y) == kind &&
          hole.box.contains(Eigen::Vector2d((x + 0.5) * image.cell,
                                            image.floor + (y + 0.5) * image.cell)))
        depths.push_back(image.depth.at(x, y));
  return depths.empty() ? 0.0 : median(depths);
}

} // namespace

std::vector<FaceHole>
wallHoles(const WallImage& image, const std::vector<WallPoint>& points)
{
  std::vector<FaceHole> holes;
  for (const bool is_proud : {false, true}) {
    Mask mask{image.cells.nx, image.cells.ny, {}};
    for (const auto cell : image.cells.values)
      mask.values.push_back(is_proud
                                ? cell == WallCell::Proud
                                : cell == WallCell::Empty || cell == WallCell::Recess);
    for (const auto& columns : connectedColumns(opened(mask), image))
      for (const auto& box : rectanglesOf(columns, image)) {
        FaceHole hole;
        hole.box = box;
        hole.is_proud = is_proud;
        if (box.sizes().minCoeff() < least_side - 4.0 * image.cell)
          continue;
        hole.depth = depthOf(image, hole);
        refine(image, points, hole);
        if (hole.box.isEmpty() || hole.box.sizes().minCoeff() < least_side)
          continue;
        describe(image, hole);
        findFrame(image, points, hole);
        growToNiche(image, points, hole);
        holes.push_back(hole);
      }
  }
  return holes;
}

} // namespace pcl::indoor
