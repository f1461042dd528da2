/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cell_sample.h"

#include <pcl/common/point_tests.h> // for isFinite

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pcl::indoor::tool {
namespace {

constexpr int coarsest = 2;                          // level
constexpr int bits = 21;                             // of a place along an axis
constexpr std::int64_t first_cell = 1 << (bits - 1); // of the one at zero
constexpr double half = first_cell;

/** Every bit of the cell moves all of the hash: cells of one wall share most bits. */
std::uint64_t
hashOf(std::uint64_t cell)
{
  std::uint64_t hash = (cell ^ cell >> 32) * 0x9e3779b97f4a7c15u;
  hash = (hash ^ hash >> 32) * 0x9e3779b97f4a7c15u;
  return hash ^ hash >> 32;
}

/** Of what is in a place of the table, which is not 0. */
std::uint8_t
tagOf(std::uint64_t hash)
{
  return static_cast<std::uint8_t>(hash >> 56 | 1);
}

/** Of a table of which at most two thirds are filled. */
std::size_t
placesFor(std::size_t points)
{
  std::size_t places = 1 << 10;
  while (3 * points > 2 * places)
    places *= 2;
  return places;
}

} // namespace

CellSample::CellSample(double cell_size, std::size_t limit)
: cell_size_(cell_size)
, limit_(limit)
, points_(pcl::make_shared<PointCloud<PointXYZ>>())
{}

std::uint64_t
CellSample::cellOf(const Eigen::Vector3f& point) const
{
  std::uint64_t cell = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double place =
        std::clamp(static_cast<double>(point[axis]) / cell_size_, -half, half - 1.0);
    const auto toward_zero = static_cast<std::int64_t>(place);
    const std::int64_t below = // as std::floor(), which is a call of the library
        toward_zero - (static_cast<double>(toward_zero) > place);
    cell = cell << bits | static_cast<std::uint64_t>(below + first_cell) >> level_;
  }
  return cell;
}

template <typename IsSame>
std::size_t
CellSample::placeOf(std::uint64_t hash, const IsSame& is_same) const
{
  const std::size_t mask = numbers_.size() - 1;
  const std::uint8_t tag = tagOf(hash);
  for (std::size_t place = hash & mask;; place = (place + 1) & mask)
    if (tags_[place] == 0 || (tags_[place] == tag && is_same(numbers_[place])))
      return place;
}

/** Visit the places in the table of finite points, from a first one on until
 * visit(i, place, tag) is false: places where their cells are, or free ones where they
 * belong. The table and the points are larger than the caches: what comes next is
 * fetched ahead.
 * \return the point after the last one visited
 */
template <typename Visit>
std::size_t
CellSample::forEachPlace(const PointCloud<PointXYZ>& points,
                         std::size_t begin,
                         const Visit& visit) const
{
  constexpr std::size_t to_place = 16, to_point = 8; // points ahead
  struct Ahead {
    std::uint64_t cell = 0, hash = 0;
  };
  std::array<Ahead, to_place> ahead;
  const auto exists = [&](std::size_t i) {
    return i < points.size() && isFinite(points[i]);
  };
  const auto fetchPlace = [&](std::size_t i) {
    if (!exists(i))
      return;
    Ahead& next = ahead[i % to_place];
    next.cell = cellOf(points[i].getVector3fMap());
    next.hash = hashOf(next.cell);
    const std::size_t place = next.hash & (numbers_.size() - 1);
    __builtin_prefetch(&tags_[place]);
    __builtin_prefetch(&numbers_[place]);
  };
  const auto fetchPoint = [&](std::size_t i) {
    if (!exists(i))
      return;
    const auto isSame = [](std::uint32_t /*number*/) { return true; }; // by its tag
    const std::size_t place = placeOf(ahead[i % to_place].hash, isSame);
    if (tags_[place] != 0)
      __builtin_prefetch(points_->data() + numbers_[place]);
  };
  for (std::size_t i = begin; i < begin + to_place; ++i)
    fetchPlace(i);
  for (std::size_t i = begin; i < begin + to_point; ++i)
    fetchPoint(i);
  for (std::size_t i = begin; i < points.size(); ++i) {
    const Ahead now = ahead[i % to_place];
    fetchPlace(i + to_place);
    fetchPoint(i + to_point);
    if (!exists(i))
      continue;
    const auto isSame = [&](std::uint32_t number) {
      return cellOf((*points_)[number].getVector3fMap()) == now.cell;
    };
    const std::size_t place = placeOf(now.hash, isSame);
    if (!visit(i, place, tagOf(now.hash)))
      return i + 1;
  }
  return points.size();
}

std::vector<std::uint32_t>
CellSample::find(const PointCloud<PointXYZ>& points)
{
  if (tags_.empty())
    makeTable(placesFor(points_->size()));
  std::vector<std::uint32_t> found(points.size(), absent);
  forEachPlace(points, 0, [&](std::size_t i, std::size_t place, std::uint8_t /*tag*/) {
    if (tags_[place] != 0)
      found[i] = numbers_[place];
    return true;
  });
  return found;
}

void
CellSample::makeTable(std::size_t places)
{
  dropTable(); // before there is another one
  tags_.assign(places, 0);
  numbers_.resize(places);
  forEachPlace(*points_, 0, [&](std::size_t i, std::size_t place, std::uint8_t tag) {
    tags_[place] = tag;
    numbers_[place] = static_cast<std::uint32_t>(i);
    return true;
  });
}

void
CellSample::dropTable()
{
  std::vector<std::uint8_t>().swap(tags_);
  std::vector<std::uint32_t>().swap(numbers_);
}

void
CellSample::thinOut()
{
  ++level_;
  tags_.assign(tags_.size(), 0);
  AscendingNumbers::Reader index(indices_);
  AscendingNumbers indices;
  std::size_t kept = 0;
  forEachPlace(*points_, 0, [&](std::size_t i, std::size_t place, std::uint8_t tag) {
    index.next();
    if (tags_[place] != 0)
      return true;
    tags_[place] = tag;
    numbers_[place] = static_cast<std::uint32_t>(kept);
    (*points_)[kept++] = (*points_)[i];
    indices.add(index.number());
    return true;
  });
  points_->points.resize(kept);
  indices_ = std::move(indices);
}

void
CellSample::add(const PointCloud<PointXYZ>& points, std::uint64_t first)
{
  if (tags_.empty())
    makeTable(placesFor(points_->size()));
  const auto addOne = [&](std::size_t i, std::size_t place, std::uint8_t tag) {
    if (tags_[place] != 0)
      return true;
    tags_[place] = tag;
    numbers_[place] = static_cast<std::uint32_t>(points_->size());
    points_->points.push_back(points[i]);
    indices_.add(first + i);
    return !isTooMany() && placesFor(points_->size()) <= numbers_.size();
  };
  for (std::size_t begin = 0; begin < points.size();) {
    begin = forEachPlace(points, begin, addOne);
    if (isTooMany())
      thinOut();
    else if (placesFor(points_->size()) > numbers_.size())
      makeTable(2 * numbers_.size());
  }
}

bool
CellSample::isTooMany() const
{
  return points_->size() > limit_ && level_ < coarsest;
}

void
CellSample::shrink()
{
  dropTable();
  points_->points.shrink_to_fit();
  points_->width = static_cast<std::uint32_t>(points_->size());
  points_->height = 1;
  indices_.shrink();
}

} // namespace pcl::indoor::tool
