/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/structure/floor_search.h"

#include "objects/structure/plane_raster.h"

#include <pcl/indoor/quantile.h>

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <utility>

namespace {

using pcl::indoor::StructurePlane;
using pcl::indoor::SurfaceVoxels;

constexpr double min_floor = 0.5; // m^2

double
middleHeight(const SurfaceVoxels& voxels,
             const StructurePlane& plane,
             const Eigen::Vector3f& up)
{
  std::vector<double> heights;
  for (const auto v : plane.voxels)
    heights.push_back(up.dot(voxels.centroids[v]));
  return pcl::indoor::median(heights);
}

/** \brief Finds the floors among planes, see floorsAmong(). */
class FloorSearch {
public:
  FloorSearch(const std::vector<StructurePlane>& planes,
              const SurfaceVoxels& voxels,
              double voxel_size,
              const Eigen::Vector3f& up)
  : planes_(planes)
  , voxels_(voxels)
  , voxel_size_(voxel_size)
  {
    constexpr double level = 0.95; // cosine of 18 degrees: small regions
    for (std::size_t p = 0; p < planes.size(); ++p)
      if (planes[p].normal.dot(up.cast<double>()) > level)
        rising_.push_back({middleHeight(voxels, planes[p], up), p});
    std::sort(rising_.begin(), rising_.end());
  }

  /** Whether each plane is a floor. */
  std::vector<std::uint8_t>
  floors()
  {
    std::vector<std::uint8_t> is_floor(planes_.size(), 0);
    const auto ground = std::find_if(rising_.begin(), rising_.end(), [&](auto& each) {
      return isLarge(each.second) && isLowest(each.second);
    });
    std::vector<std::size_t> open;
    for (auto each = rising_.begin(); ground != rising_.end() && each <= ground; ++each)
      if (each == ground || !isLarge(each->second)) {
        is_floor[each->second] = 1;
        open.push_back(each->second);
      }
    goOn(std::move(open), is_floor);
    return is_floor;
  }

private:
  bool
  isLarge(std::size_t p) const
  {
    return pcl::indoor::areaOfPlane(planes_[p], voxel_size_) >= min_floor;
  }

  bool
  isLowest(std::size_t p) const
  {
    return pcl::indoor::freeShareOfPlane(
               voxels_, planes_[p], pcl::indoor::other_layer, voxel_size_) >=
           pcl::indoor::min_free;
  }

  void
  goOn(std::vector<std::size_t> open, std::vector<std::uint8_t>& is_floor) const
  {
    constexpr std::size_t contacts = 30; // pairs of voxels along an edge of 0.3 m
    constexpr std::uint32_t none = 0xffffffffu;
    std::vector<std::uint32_t> plane_of_voxel(voxels_.size(), none);
    for (const auto& [height, p] : rising_)
      if (isLarge(p))
        for (const auto v : planes_[p].voxels)
          plane_of_voxel[v] = static_cast<std::uint32_t>(p);
    std::vector<std::uint8_t> is_decided = is_floor;
    while (!open.empty()) {
      const auto p = open.back();
      open.pop_back();
      std::unordered_map<std::uint32_t, std::size_t> shared;
      for (const auto v : planes_[p].voxels)
        for (const auto other : voxels_.neighbors.of(v)) {
          const auto q = plane_of_voxel[other];
          if (q == none || is_decided[q] || ++shared[q] < contacts)
            continue;
          is_decided[q] = 1;
          is_floor[q] = isLowest(q);
          if (is_floor[q])
            open.push_back(q);
        }
    }
  }

  const std::vector<StructurePlane>& planes_;
  const SurfaceVoxels& voxels_;
  double voxel_size_;
  std::vector<std::pair<double, std::size_t>> rising_; // heights of level planes
};

} // namespace

namespace pcl::indoor {

double
areaOfPlane(const StructurePlane& plane, double voxel_size)
{
  return static_cast<double>(plane.voxels.size()) * voxel_size * voxel_size;
}

double
freeShareOfPlane(const SurfaceVoxels& voxels,
                 const StructurePlane& plane,
                 double margin,
                 double voxel_size)
{
  PlaneRaster raster(voxels, plane, near_surface_voxels * voxel_size);
  raster.look(voxels, std::max(margin, near_surface_voxels * voxel_size));
  return raster.freeShare();
}

std::vector<std::uint8_t>
floorsAmong(const std::vector<StructurePlane>& planes,
            const SurfaceVoxels& voxels,
            double voxel_size,
            const Eigen::Vector3f& up)
{
  return FloorSearch(planes, voxels, voxel_size, up).floors();
}

} // namespace pcl::indoor
