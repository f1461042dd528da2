/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cell_sample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pcl::indoor::tool {
namespace {

constexpr int coarsest = 2; // level
constexpr int bits = 21;    // of a place along an axis
constexpr double half = 1 << (bits - 1);
constexpr std::uint32_t free_place = 0xffffffffu;

std::uint64_t
hashOf(std::uint64_t cell)
{
  const std::uint64_t hash = cell * 0x9e3779b97f4a7c15u;
  return hash ^ hash >> 32;
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
, numbers_(placesFor(0), free_place)
{}

std::uint64_t
CellSample::cellOf(const Eigen::Vector3f& point) const
{
  std::uint64_t cell = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double place =
        std::floor(static_cast<double>(point[axis]) / cell_size_) + half;
    const auto whole =
        static_cast<std::uint64_t>(std::clamp(place, 0.0, 2.0 * half - 1.0));
    cell = cell << bits | whole >> level_;
  }
  return cell;
}

std::size_t
CellSample::placeOf(std::uint64_t cell) const
{
  const std::size_t mask = numbers_.size() - 1;
  for (std::size_t place = hashOf(cell) & mask;; place = (place + 1) & mask)
    if (numbers_[place] == free_place ||
        cellOf((*points_)[numbers_[place]].getVector3fMap()) == cell)
      return place;
}

std::optional<std::uint32_t>
CellSample::find(const Eigen::Vector3f& point)
{
  if (numbers_.empty())
    makeTable(placesFor(points_->size()));
  const auto number = numbers_[placeOf(cellOf(point))];
  return number == free_place ? std::nullopt : std::optional(number);
}

void
CellSample::makeTable(std::size_t places)
{
  std::vector<std::uint32_t>().swap(numbers_); // before there is another one
  numbers_.assign(places, free_place);
  const std::size_t mask = places - 1;
  // The table is larger than the caches: what comes next is fetched ahead.
  constexpr std::size_t ahead = 16;
  std::array<std::size_t, ahead> next{};
  const auto look = [&](std::size_t i) {
    if (i >= points_->size())
      return;
    next[i % ahead] = hashOf(cellOf((*points_)[i].getVector3fMap())) & mask;
    __builtin_prefetch(&numbers_[next[i % ahead]]);
  };
  for (std::size_t i = 0; i < ahead; ++i)
    look(i);
  for (std::size_t i = 0; i < points_->size(); ++i) {
    auto place = next[i % ahead];
    look(i + ahead);
    while (numbers_[place] != free_place)
      place = (place + 1) & mask;
    numbers_[place] = static_cast<std::uint32_t>(i);
  }
}

void
CellSample::thinOut()
{
  ++level_;
  numbers_.assign(numbers_.size(), free_place);
  AscendingNumbers::Reader index(indices_);
  AscendingNumbers indices;
  std::size_t kept = 0;
  for (const auto& point : *points_) {
    index.next();
    const auto place = placeOf(cellOf(point.getVector3fMap()));
    if (numbers_[place] != free_place)
      continue;
    numbers_[place] = static_cast<std::uint32_t>(kept);
    (*points_)[kept++] = point;
    indices.add(index.number());
  }
  points_->points.resize(kept);
  indices_ = std::move(indices);
}

void
CellSample::add(const Eigen::Vector3f& point, std::uint64_t index)
{
  if (numbers_.empty())
    makeTable(placesFor(points_->size()));
  const auto place = placeOf(cellOf(point));
  if (numbers_[place] != free_place)
    return;
  numbers_[place] = static_cast<std::uint32_t>(points_->size());
  points_->points.emplace_back(point.x(), point.y(), point.z());
  indices_.add(index);
  if (points_->size() > limit_ && level_ < coarsest)
    thinOut();
  else if (placesFor(points_->size()) > numbers_.size())
    makeTable(2 * numbers_.size());
}

void
CellSample::shrink()
{
  std::vector<std::uint32_t>().swap(numbers_);
  points_->points.shrink_to_fit();
  points_->width = static_cast<std::uint32_t>(points_->size());
  points_->height = 1;
  indices_.shrink();
}

} // namespace pcl::indoor::tool
