/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "thesis/rooms/field_rooms.h"

#include "rooms/map/ceiling_slab.h"
#include "thesis/rooms/map_clustering.h"
#include "thesis/rooms/map_labels.h"
#include "thesis/rooms/map_random_walker.h"
#include "thesis/rooms/potential_field.h"
#include "thesis/rooms/visibility_vectors.h"

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::indoor {
namespace {

void
requireValid(const thesis::FieldRoomsOptions& options)
{
  for (const double value : {options.min_cluster_area, options.sample_area})
    if (!(value > 0.0) || !std::isfinite(value))
      PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                          "Areas of the field map must be positive, not " << value
                                                                          << ".");
  if (!(options.landmark_spacing >= 0.0) || !std::isfinite(options.landmark_spacing))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "The spacing of landmarks must not be negative, but is "
                            << options.landmark_spacing << ".");
  if (!(options.dbscan_distance >= 0.0) || !std::isfinite(options.dbscan_distance))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "The distance of DBSCAN must not be negative, but is "
                            << options.dbscan_distance << ".");
}

/** The interior without what lies above the ceiling: space over a roof has a floor and,
 * where noise sticks out of the ceiling, walls; the rooms would be joined there. */
VoxelMap<std::uint8_t>
belowCeiling(const InteriorSpace& space, const CeilingSlabOptions& slab)
{
  VoxelMap<std::uint8_t> inside = space.inside.bytes();
  const GridShape& shape = inside.shape;
  const auto ceiling = ceilingLayers(space.occupancy, {0, shape.nz}, slab);
  for (int x = 0; x < shape.nx; ++x)
    for (int y = 0; y < shape.ny; ++y)
      for (int z = ceiling.at(x, y) + 1; z < shape.nz; ++z)
        inside.at(x, y, z) = 0;
  return inside;
}

/** What each pixel's highest free voxel sees; nothing if that has no weight. */
VisibilityVectors
visibilityOf(const VoxelMap<std::uint8_t>& occupancy,
             const PixelMap<int>& highest_free,
             const std::vector<std::size_t>& pixels,
             const thesis::FieldRoomsOptions& options)
{
  if (options.distance.visibility_weight == 0.0)
    return {};
  const int spacing = voxelsIn(options.landmark_spacing, occupancy.voxel_size, 1);
  std::vector<Eigen::Vector3i> voxels;
  for (const std::size_t pixel : pixels)
    voxels.emplace_back(static_cast<int>(pixel / highest_free.ny),
                        static_cast<int>(pixel % highest_free.ny),
                        highest_free.values[pixel]);
  const auto landmarks =
      options.landmark_spacing > 0.0 ? spreadLandmarks(highest_free, spacing) : voxels;
  return visibilityVectors(occupancy, voxels, landmarks, options.threads);
}

std::size_t
pixelCount(double area, double pixel_size, std::size_t least)
{
  return std::max(
      least, static_cast<std::size_t>(std::lround(area / pixel_size / pixel_size)));
}

/** The label of each pixel of the distance, by HDBSCAN or DBSCAN*. */
std::vector<int>
clusterPixels(const MapDistance& distance,
              double pixel_size,
              const thesis::FieldRoomsOptions& options)
{
  const std::size_t smallest = pixelCount(options.min_cluster_area, pixel_size, 2);
  const std::size_t samples = pixelCount(options.sample_area, pixel_size, 1);
  if (options.dbscan_distance > 0.0) {
    DBSCANOptions clustering;
    clustering.epsilon = options.dbscan_distance;
    clustering.min_cluster_size = smallest;
    clustering.min_samples = samples;
    clustering.threads = options.threads;
    return dbscanMap(distance, clustering);
  }
  HDBSCANOptions clustering;
  clustering.min_cluster_size = smallest;
  clustering.min_samples = samples;
  clustering.allow_single_cluster = options.allow_single_cluster;
  clustering.threads = options.threads;
  return clusterMap(distance, clustering).labels;
}

/** Clusters of the pixels with a field (Eq. 3.3 to 3.5). */
PixelMap<int>
cluster(const VoxelMap<std::uint8_t>& occupancy,
        const FieldRooms& rooms,
        const thesis::FieldRoomsOptions& options)
{
  const PixelMap<float>& field = rooms.field;
  PixelMap<int> clusters{field.nx, field.ny, std::vector<int>(field.size(), -1)};
  std::vector<std::size_t> pixels;
  for (std::size_t i = 0; i < field.size(); ++i)
    if (field.values[i] > 0 && rooms.highest_free.values[i] >= 0)
      pixels.push_back(i);
  if (pixels.size() < pixelCount(options.min_cluster_area, occupancy.voxel_size, 2))
    return clusters;
  const MapDistance distance(
      field.nx,
      field.ny,
      pixels,
      FieldConnectivity(field, rooms.thresholds),
      visibilityOf(occupancy, rooms.highest_free, pixels, options),
      options.distance);
  const auto labels = clusterPixels(distance, occupancy.voxel_size, options);
  for (std::size_t i = 0; i < pixels.size(); ++i)
    clusters.values[pixels[i]] = labels[i];
  return clusters;
}

/** The remaining pixels: local peaks, then the random walker (Sec. 3.2.3). */
PixelMap<int>
labelTheRest(const FieldRooms& rooms,
             double pixel_size,
             const thesis::FieldRoomsOptions& options)
{
  PixelMap<float> intensity = rooms.field;
  PixelMap<std::uint8_t> mask{intensity.nx, intensity.ny, {}};
  mask.values.resize(mask.size());
  const float highest =
      *std::max_element(intensity.values.begin(), intensity.values.end());
  for (std::size_t i = 0; i < mask.size(); ++i) {
    mask.values[i] = intensity.values[i] > 0;
    intensity.values[i] /= std::max(highest, 1.0f);
  }
  const float lowest_peak = rooms.thresholds.empty() ? 0.0f : rooms.thresholds.front();
  const PixelMap<int> seeds = labelPeaks(
      rooms.clusters,
      rooms.field,
      lowest_peak,
      pixelCount(options.min_cluster_area, pixel_size, 1),
      options.peaks_on_slopes ? PeakPlaces::Anywhere : PeakPlaces::OffSlopes);
  return mapRandomWalker(intensity, seeds, mask, options.beta, options.threads);
}

} // namespace

FieldRooms
segmentFieldMap(const InteriorSpace& space,
                const thesis::FieldRoomsOptions& options,
                const CeilingSlabOptions& slab)
{
  requireValid(options);
  const auto occupancy = space.occupancy.bytes();
  const auto interior =
      options.above_ceiling ? space.inside.bytes() : belowCeiling(space, slab);
  FieldRooms rooms;
  rooms.potential = potentialField(occupancy, options.threads); // Sec. 3.2.2
  rooms.field = fieldMap(rooms.potential, interior);
  rooms.highest_free = highestFreeVoxel(interior);
  rooms.thresholds = histogramPeaks(rooms.field.values, options.peaks);
  rooms.clusters = cluster(occupancy, rooms, options); // Sec. 3.2.3
  rooms.labels = labelTheRest(rooms, occupancy.voxel_size, options);
  return rooms;
}

} // namespace pcl::indoor
