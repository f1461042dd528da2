/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cell_sample.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor::tool {
namespace {

constexpr int coarsest = 2; // level
constexpr int bits = 21;    // of a place along an axis
constexpr double half = 1 << (bits - 1);
constexpr std::uint32_t free_place = 0xffffffffu;

} // namespace

CellSample::CellSample(double cell_size, std::size_t limit)
: cell_size_(cell_size)
, limit_(limit)
, points_(pcl::make_shared<PointCloud<PointXYZ>>())
, numbers_(1 << 10, free_place)
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
  std::uint64_t hash = cell * 0x9e3779b97f4a7c15u;
  hash ^= hash >> 32;
  for (std::size_t place = hash & mask;; place = (place + 1) & mask)
    if (numbers_[place] == free_place ||
        cellOf((*points_)[numbers_[place]].getVector3fMap()) == cell)
      return place;
}

std::optional<std::uint32_t>
CellSample::find(const Eigen::Vector3f& point) const
{
  const auto number = numbers_[placeOf(cellOf(point))];
  return number == free_place ? std::nullopt : std::optional(number);
}

bool
CellSample::insert(const Eigen::Vector3f& point)
{
  const auto place = placeOf(cellOf(point));
  if (numbers_[place] != free_place)
    return false;
  numbers_[place] = static_cast<std::uint32_t>(points_->size());
  points_->points.emplace_back(point.x(), point.y(), point.z());
  return true;
}

void
CellSample::rebuild(std::size_t capacity)
{
  numbers_.clear(); // or its memory would be copied
  numbers_.resize(capacity, free_place);
  auto points = std::move(points_->points);
  points_->points.clear();
  points_->points.reserve(points.size());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (insert(points[i].getVector3fMap()))
      indices_[kept++] = indices_[i];
  indices_.resize(kept);
}

void
CellSample::add(const Eigen::Vector3f& point, std::uint64_t index)
{
  if (!insert(point))
    return;
  indices_.push_back(index);
  if (points_->size() > limit_ && level_ < coarsest) {
    ++level_;
    rebuild(numbers_.size());
  }
  else if (3 * points_->size() > 2 * numbers_.size())
    rebuild(2 * numbers_.size());
}

void
CellSample::shrink()
{
  points_->points.shrink_to_fit();
  points_->width = static_cast<std::uint32_t>(points_->size());
  points_->height = 1;
  indices_.shrink_to_fit();
}

} // namespace pcl::indoor::tool
