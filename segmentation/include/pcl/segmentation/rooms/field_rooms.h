/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_map.h>
#include <pcl/segmentation/hdbscan.h>
#include <pcl/segmentation/rooms/field_connectivity.h>
#include <pcl/segmentation/rooms/interior_space.h>
#include <pcl/segmentation/rooms/map_clustering.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief How a field map is divided into rooms (Sec. 3.2.3). */
struct FieldRoomsOptions {
  MapDistanceOptions distance;   ///< weights of Eq. (3.4)
  HistogramPeakOptions peaks;    ///< thresholds of Eq. (3.3)
  double dbscan_distance = 0.0;  ///< 0 = HDBSCAN finds the clusters; else DBSCAN*, with
                                 ///< this distance of Eq. (3.4) (>= 0)
  double min_cluster_area = 2.0; ///< smallest cluster, m^2 (> 0)
  double sample_area = 0.4;      ///< neighbourhood of its core distance, m^2 (> 0)
  double landmark_spacing = 1.0; ///< between the landmarks of visibility, metres (>=
                                 ///< 0); 0 = every pixel is one, in time O(pixels^2)
  bool allow_single_cluster = false; ///< whether HDBSCAN may find one room only
  bool above_ceiling = false;   ///< whether interior space above the ceiling takes part
  bool peaks_on_slopes = false; ///< whether a peak that a cluster left out is a room
                                ///< although it lies on that one's slope
  double beta = 100.0;          ///< of the random walker, Eq. (2.11), for a field in
                                ///< [0, 1] (>= 0)
  int threads = 0;              ///< 0 = automatic
};

/** \brief The rooms of a storey on its field map, and each step on the way to them. */
struct FieldRooms {
  VoxelMap<std::uint32_t> potential; ///< anisotropic potential field, voxels squared
  PixelMap<float> field;             ///< its highest interior value per column
  PixelMap<int> highest_free;        ///< layer of the highest interior voxel, -1 = none
  std::vector<float> thresholds;     ///< peaks of the field's histogram
  PixelMap<int> clusters;            ///< of HDBSCAN or DBSCAN*: 0 ... n - 1; -1 = none
  PixelMap<int> labels; ///< after peaks and random walker; -1 = no interior
};

/** \brief Divide a storey into rooms as the thesis does: potential field, field map,
 * visibility, HDBSCAN of the combined distance, local peaks, random walker.
 * \param[in] space of this storey alone
 * \throws pcl::BadArgumentException if an option is out of its range
 */
FieldRooms
segmentFieldMap(const InteriorSpace& space, const FieldRoomsOptions& options = {});

} // namespace indoor
} // namespace pcl
