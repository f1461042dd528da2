/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/split/seam_profile.h"

#include <algorithm>
#include <cmath>

namespace {

// What is beside a sheet, slices from its middle.
constexpr std::ptrdiff_t beside_begin = pcl::indoor::SeamProfile::per_voxel;
constexpr std::ptrdiff_t beside_end = 3 * pcl::indoor::SeamProfile::per_voxel;
constexpr double voxels_beside = 2;
constexpr double deviations = 3; // of a count, that are chance
/** a sheet holds this many times the points of the slices beside it */
constexpr double density = 1.8;
/** the slices beside it hold at least this share of each other: the segment goes on, on
 * both sides */
constexpr double balance = 0.5;

std::vector<float>
placesAlong(const std::vector<Eigen::Vector3f>& places,
            const Eigen::Vector2f& direction)
{
  std::vector<float> along;
  along.reserve(places.size());
  for (const auto& place : places)
    along.push_back(direction.dot(place.head<2>()));
  return along;
}

} // namespace

namespace pcl {
namespace indoor {

SeamProfile::SeamProfile(const std::vector<Eigen::Vector3f>& places,
                         const Eigen::Vector2f& direction,
                         double voxel_size)
: direction_(direction)
, along_(placesAlong(places, direction))
, counts_(along_, voxel_size / per_voxel)
{}

double
SeamProfile::excess(std::ptrdiff_t i) const
{
  return sheet(i) - std::max(before(i), behind(i));
}

std::vector<std::ptrdiff_t>
SeamProfile::peaks() const
{
  const auto margin = std::max(
      beside_end, static_cast<std::ptrdiff_t>(std::ceil(min_seam_side / grid().width)));
  std::vector<std::ptrdiff_t> found;
  for (auto i = margin; i + margin < counts_.size(); ++i)
    if (isPeak(i))
      found.push_back(i);
  return found;
}

double
SeamProfile::sheet(std::ptrdiff_t i) const
{
  return counts_.held(i - per_voxel / 2, i + per_voxel / 2);
}

double
SeamProfile::before(std::ptrdiff_t i) const
{
  return counts_.held(i - beside_end, i - beside_begin) / voxels_beside;
}

double
SeamProfile::behind(std::ptrdiff_t i) const
{
  return counts_.held(i + beside_begin, i + beside_end) / voxels_beside;
}

bool
SeamProfile::isPeak(std::ptrdiff_t i) const
{
  const double here = sheet(i);
  const double more = std::max(before(i), behind(i));
  if (here < density * more + deviations * std::sqrt(more) ||
      std::min(before(i), behind(i)) < balance * more)
    return false;
  for (auto other = i - per_voxel; other <= i + per_voxel; ++other)
    if (sheet(other) > here || (sheet(other) == here && other < i))
      return false; // the first of equal ones counts
  return true;
}

} // namespace indoor
} // namespace pcl
