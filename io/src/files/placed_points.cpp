/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/placed_points.h"

#include "text/printable.h" // for shortText

#include <pcl/common/point_tests.h> // for isFinite
#include <pcl/features/unit_normals.h>
#include <pcl/indoor/distinct_points.h>

#include <algorithm>
#include <numeric>

namespace pcl::indoor::tool {
namespace {

using Places = std::vector<Eigen::Vector3d>;

PCLPointCloud2
without(const PCLPointCloud2& cloud, const Places& left_out)
{
  auto result = cloud;
  result.data.clear();
  const CloudPlaces places(cloud);
  for (std::size_t i = 0; i < places.size(); ++i)
    if (!isOneOf(places.at(i), left_out)) {
      const auto begin =
          cloud.data.begin() + static_cast<std::ptrdiff_t>(i * cloud.point_step);
      result.data.insert(result.data.end(), begin, begin + cloud.point_step);
    }
  result.width = static_cast<std::uint32_t>(result.data.size() / cloud.point_step);
  result.height = 1;
  result.row_step = result.point_step * result.width;
  return result;
}

/** The finite points, and which of all they are. */
struct FinitePoints {
  std::vector<Eigen::Vector3f> positions;
  std::vector<std::size_t> indices;
};

FinitePoints
finiteOf(const PointCloud<PointXYZ>& points)
{
  FinitePoints finite;
  finite.positions.reserve(points.size());
  finite.indices.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (isFinite(points[i])) {
      finite.positions.emplace_back(points[i].getVector3fMap());
      finite.indices.push_back(i);
    }
  return finite;
}

/** The first point of each place that has very many more than nearly all others. Where
 * coordinates are rounded, or a scan was merged with itself, many places have several;
 * what lies near a scanner has tens of times as many as the rest. */
std::vector<std::uint32_t>
crowded(const DistinctPoints& places)
{
  constexpr std::uint32_t times_others = 100;
  constexpr double others = 0.99; // of the places
  std::vector<std::uint32_t> counts(places.first.size(), 0), firsts;
  for (const auto place : places.place)
    ++counts[place];
  if (counts.empty() || *std::max_element(counts.begin(), counts.end()) < times_others)
    return firsts;
  auto sorted = counts;
  const auto high = sorted.begin() + static_cast<std::ptrdiff_t>(
                                         others * static_cast<double>(sorted.size()));
  std::nth_element(sorted.begin(), high, sorted.end());
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] / times_others >= *high)
      firsts.push_back(places.first[i]);
  return firsts;
}

} // namespace

PlacedPoints
placedPoints(const PCLPointCloud2& cloud, bool in_rows)
{
  PlacedPoints placed;
  auto& left_out = placed.left_out;
  if (in_rows && countAt(cloud, Eigen::Vector3d::Zero()) > 0)
    left_out.emplace_back(Eigen::Vector3d::Zero());
  for (;;) {
    placed.origin =
        coordinateOrigin(left_out.empty() ? cloud : without(cloud, left_out));
    placed.points =
        pointsAround(cloud, placed.origin.middle, placed.finite_count, placed.left_out);
    const auto finite = finiteOf(*placed.points);
    placed.copy_count = 0;
    if (!mayHaveCopies(finite.positions))
      return placed;
    const auto places = distinctPoints(finite.positions);
    placed.copy_count = places.copies();
    const auto more = crowded(places);
    if (more.empty())
      return placed;
    for (const auto first : more)
      left_out.push_back(CloudPlaces(cloud).at(finite.indices[first]));
  }
}

std::size_t
countAt(const PCLPointCloud2& cloud, const Eigen::Vector3d& place)
{
  const CloudPlaces places(cloud);
  std::size_t count = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
    count += places.at(i) == place;
  return count;
}

std::vector<std::string>
leftOutNotes(const std::vector<Eigen::Vector3d>& places,
             const std::vector<std::uint64_t>& counts,
             std::uint64_t all)
{
  constexpr std::size_t most = 3;
  const auto note = [all](std::uint64_t count, const std::string& where) {
    return std::to_string(count) + " of " + std::to_string(all) + " points lie at " +
           where + ", as if nothing had been measured: they are left out";
  };
  const auto single = places.size() > most ? most - 1 : places.size();
  std::vector<std::string> notes;
  for (std::size_t k = 0; k < single; ++k)
    notes.push_back(note(counts[k],
                         shortText(places[k].x(), 10) + " " +
                             shortText(places[k].y(), 10) + " " +
                             shortText(places[k].z(), 10)));
  const auto rest = counts.begin() + static_cast<std::ptrdiff_t>(single);
  if (single < places.size())
    notes.push_back(note(std::accumulate(rest, counts.end(), std::uint64_t{0}),
                         std::to_string(places.size() - single) + " more places"));
  return notes;
}

std::string
copiesNote(std::uint64_t copies, std::uint64_t all)
{
  constexpr std::uint64_t many = 100;      // below, nobody would miss them
  if (copies < many || 100 * copies < all) // as DistinctPoints::hasCopies()
    return {};
  return std::to_string(copies) + " of " + std::to_string(all) +
         " points lie exactly at the place of another: each place counts once";
}

std::string
normalsNote(const PCLPointCloud2& cloud, const PointCloud<PointXYZ>& points)
{
  const auto normals = readNormals(cloud);
  const auto finite = finiteOf(points);
  std::vector<Eigen::Vector3f> own;
  own.reserve(finite.indices.size());
  for (const auto i : finite.indices)
    own.emplace_back((*normals)[i].getNormalVector3fMap());
  const auto problem = findNormalsProblem(finite.positions, own);
  return problem.empty() ? problem
                         : "the normals are not used, they are estimated: " + problem;
}

} // namespace pcl::indoor::tool
