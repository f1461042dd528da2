/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "seam_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

// What is beside a sheet, slices from its middle.
constexpr std::ptrdiff_t beside_begin = pcl::indoor::SeamProfile::per_voxel;
constexpr std::ptrdiff_t beside_end = 3 * pcl::indoor::SeamProfile::per_voxel;
constexpr double voxels_beside = 2;
constexpr double deviations = 3; // of a count, that are chance

} // namespace

namespace pcl {
namespace indoor {

SeamProfile::SeamProfile(const std::vector<Eigen::Vector3f>& places,
                         const Eigen::Vector2f& direction,
                         const ObjectSeamOptions& options)
: options_(options)
, direction_(direction)
{
  float low = std::numeric_limits<float>::infinity(), high = -low;
  along_.reserve(places.size());
  for (const auto& place : places) {
    along_.push_back(direction.dot(place.head<2>()));
    low = std::min(low, along_.back());
    high = std::max(high, along_.back());
  }
  low_ = low;
  sums_.assign(sliceAt(high) + 2, 0);
  for (const auto place : along_)
    ++sums_[sliceAt(place) + 1];
  for (std::size_t i = 1; i < sums_.size(); ++i)
    sums_[i] += sums_[i - 1];
}

double
SeamProfile::excess(std::ptrdiff_t i) const
{
  return sheet(i) - std::max(before(i), behind(i));
}

std::vector<std::ptrdiff_t>
SeamProfile::peaks() const
{
  const auto margin = std::max(
      beside_end, static_cast<std::ptrdiff_t>(std::ceil(options_.min_side / width())));
  std::vector<std::ptrdiff_t> found;
  for (auto i = margin; i + margin < size(); ++i)
    if (isPeak(i))
      found.push_back(i);
  return found;
}

double
SeamProfile::held(std::ptrdiff_t begin, std::ptrdiff_t end) const
{
  begin = std::max<std::ptrdiff_t>(begin, 0);
  end = std::min(end, size());
  return begin < end ? static_cast<double>(sums_[end] - sums_[begin]) : 0;
}

double
SeamProfile::sheet(std::ptrdiff_t i) const
{
  return held(i - per_voxel / 2, i + per_voxel / 2);
}

double
SeamProfile::before(std::ptrdiff_t i) const
{
  return held(i - beside_end, i - beside_begin) / voxels_beside;
}

double
SeamProfile::behind(std::ptrdiff_t i) const
{
  return held(i + beside_begin, i + beside_end) / voxels_beside;
}

bool
SeamProfile::isPeak(std::ptrdiff_t i) const
{
  const double here = sheet(i);
  const double more = std::max(before(i), behind(i));
  if (here < options_.density * more + deviations * std::sqrt(more) ||
      std::min(before(i), behind(i)) < options_.balance * more)
    return false;
  for (auto other = i - per_voxel; other <= i + per_voxel; ++other)
    if (sheet(other) > here || (sheet(other) == here && other < i))
      return false; // the first of equal ones counts
  return true;
}

} // namespace indoor
} // namespace pcl
