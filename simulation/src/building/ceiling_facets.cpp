/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "building/ceiling_facets.h"

#include <algorithm>
#include <limits>

namespace pcl::indoor {

namespace {

using Borders = std::vector<HalfPlane>;

double
lowestOf(const std::vector<CeilingPlane>& planes, const Eigen::Vector2d& point)
{
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& plane : planes)
    lowest = std::min(lowest, plane.heightAt(point));
  return lowest;
}

// Where the plane is not above the other.
HalfPlane
notAbove(const CeilingPlane& plane, const CeilingPlane& other)
{
  const Eigen::Vector2d zero = Eigen::Vector2d::Zero();
  return {plane.slope - other.slope, other.heightAt(zero) - plane.heightAt(zero)};
}

void
addFacets(std::vector<CeilingFacet>& facets,
          const std::vector<CeilingPlane>& planes,
          const Borders& region,
          int part)
{
  for (std::size_t k = 0; k < planes.size(); ++k) {
    CeilingFacet facet{planes[k], region, part};
    for (std::size_t j = 0; j < planes.size(); ++j)
      if (j != k)
        facet.borders.push_back(notAbove(planes[k], planes[j]));
    facets.push_back(facet);
  }
}

// All around a convex polygon: beyond edge i, within the edges before it.
std::vector<Borders>
outsideOf(const Polygon& polygon, const Borders& region)
{
  std::vector<Borders> regions;
  Borders within = region;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& a = polygon[i];
    const auto& b = polygon[(i + 1) % polygon.size()];
    regions.push_back(within);
    regions.back().push_back(leftOf(b, a));
    within.push_back(leftOf(a, b));
  }
  return regions;
}

} // namespace

double
CeilingPlan::heightAt(const Eigen::Vector2d& point) const
{
  for (const auto& part : parts)
    if (contains(part.polygon, point))
      return lowestOf(part.planes, point);
  return lowestOf(planes, point);
}

std::vector<CeilingFacet>
ceilingFacets(const CeilingPlan& ceiling)
{
  std::vector<CeilingFacet> facets;
  std::vector<Borders> regions{{}};
  for (std::size_t p = 0; p < ceiling.parts.size(); ++p) {
    const auto& polygon = ceiling.parts[p].polygon;
    Borders inside;
    for (std::size_t i = 0; i < polygon.size(); ++i)
      inside.push_back(leftOf(polygon[i], polygon[(i + 1) % polygon.size()]));
    addFacets(facets, ceiling.parts[p].planes, inside, static_cast<int>(p));
    std::vector<Borders> rest;
    for (const auto& region : regions)
      for (auto& piece : outsideOf(polygon, region))
        rest.push_back(std::move(piece));
    regions = rest;
  }
  for (const auto& region : regions)
    addFacets(facets, ceiling.planes, region, -1);
  return facets;
}

std::pair<double, double>
ceilingRange(const CeilingPlan& ceiling, const Polygon& polygon)
{
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  const auto triangles = triangulate(polygon);
  for (const auto& facet : ceilingFacets(ceiling))
    for (const auto& t : triangles) {
      Polygon piece{polygon[t[0]], polygon[t[1]], polygon[t[2]]};
      for (const auto& border : facet.borders)
        piece = clip(piece, border);
      for (const auto& p : piece) {
        lowest = std::min(lowest, facet.plane.heightAt(p));
        highest = std::max(highest, facet.plane.heightAt(p));
      }
    }
  return {lowest, highest};
}

} // namespace pcl::indoor
