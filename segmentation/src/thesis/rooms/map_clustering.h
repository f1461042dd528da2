/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "thesis/rooms/field_connectivity.h"
#include "thesis/rooms/visibility_vectors.h"

#include <pcl/segmentation/dbscan.h>
#include <pcl/segmentation/hdbscan.h>
#include <pcl/segmentation/thesis.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl::indoor {

/** \brief The combined distance of pixels of a field map, Eq. (3.4) of the thesis.
 *
 * The thesis gives no units: each part is brought to [0, 1] before it is weighted, the
 * Euclidean one by its scale, the one of Eq. (3.3) by the largest value of the map; the
 * one of Eq. (3.5) is there already. Nothing of the size N x N is stored.
 */
class MapDistance {
public:
  /** \brief Gather what the distance of two pixels needs.
   * \param[in] map_width nx of the map, pixels
   * \param[in] map_height ny of the map, pixels
   * \param[in] pixels places in the map's values, ascending, each once
   * \param[in] connectivity of that map
   * \param[in] visibility a vector for each of the pixels, or none at all
   * \param[in] options weights and scales
   * \throws pcl::BadArgumentException if a pixel lies outside of the map or out of
   * order, the number of visibility vectors is wrong, or an option is out of its range
   */
  MapDistance(int map_width,
              int map_height,
              const std::vector<std::size_t>& pixels,
              FieldConnectivity connectivity,
              VisibilityVectors visibility,
              const thesis::MapDistanceOptions& options);

  /** \brief The number of pixels. */
  std::size_t
  size() const
  {
    return pixels_.size();
  }

  /** \brief Eq. (3.4) for the i-th and the j-th of the pixels. */
  double
  operator()(std::size_t i, std::size_t j) const
  {
    return reachable(i, j) + visibilityPart(i, j);
  }

  /** \brief The parts that are cheap: the Euclidean one and that of the field. */
  double
  reachable(std::size_t i, std::size_t j) const
  {
    return euclideanPart(pixelsBetween(i, j)) +
           fieldPart(connectivity_.level(pixels_[i], pixels_[j]));
  }

  /** \brief The Euclidean distance, pixels. */
  double
  pixelsBetween(std::size_t i, std::size_t j) const
  {
    const double dx = x_[i] - x_[j], dy = y_[i] - y_[j];
    return std::sqrt(dx * dx + dy * dy);
  }

  /** \brief The weighted part of the visibility. */
  double
  visibilityPart(std::size_t i, std::size_t j) const
  {
    return visibility_.count == 0
               ? 0.0
               : visibility_weight_ * visibilityDistance(visibility_, i, j);
  }

  /** \brief The least that visibilityPart() can be for i and one of the group. */
  double
  leastVisibilityPart(std::size_t i, const VisibilityGroup& group) const
  {
    return visibility_.count == 0
               ? 0.0
               : visibility_weight_ * leastVisibilityDistance(visibility_, i, group);
  }

  /** \brief The weighted part of a Euclidean distance in pixels. */
  double
  euclideanPart(double distance) const
  {
    return euclidean_factor_ * distance;
  }

  /** \brief The weighted part of the field for a level of FieldConnectivity. */
  double
  fieldPart(float level) const
  {
    return field_weight_ * std::max(1.0 - level * field_factor_, 0.0);
  }

  /** \brief The column and row of the i-th pixel. */
  int
  x(std::size_t i) const
  {
    return x_[i];
  }
  int
  y(std::size_t i) const
  {
    return y_[i];
  }

  const std::vector<std::size_t>&
  pixels() const
  {
    return pixels_;
  }
  const FieldConnectivity&
  connectivity() const
  {
    return connectivity_;
  }
  const VisibilityVectors&
  visibility() const
  {
    return visibility_;
  }
  int
  mapWidth() const
  {
    return map_width_;
  }
  int
  mapHeight() const
  {
    return map_height_;
  }

private:
  int map_width_, map_height_;
  std::vector<std::size_t> pixels_;
  std::vector<int> x_, y_;
  FieldConnectivity connectivity_;
  VisibilityVectors visibility_;
  double visibility_weight_, field_weight_;
  double euclidean_factor_ = 0.0; // weight over scale
  double field_factor_ = 0.0;     // 1 over the largest value of the map
};

/** \brief HDBSCAN of the pixels of a map with the combined distance (Sec. 3.2.3).
 *
 * Equals hdbscan(distance.size(), distance, options) in every respect, but evaluates
 * only few distances: the Euclidean part and the ultrametric of the field bound them
 * from below, so that each pixel only looks at those around it. Nearly linear time in
 * the pixels as long as the Euclidean weight is positive; memory O(pixels).
 * \throws pcl::BadArgumentException if an option is out of its range
 */
HDBSCANResult
clusterMap(const MapDistance& distance, const HDBSCANOptions& options);

/** \brief DBSCAN* of the pixels of a map with the combined distance. Equals
 * dbscan(distance.size(), distance, options) at the cost of clusterMap().
 * \throws pcl::BadArgumentException if an option is out of its range
 */
std::vector<int>
dbscanMap(const MapDistance& distance, const DBSCANOptions& options);

/** \brief The step of clusterMap() before the hierarchy: core distances by search
 * around each pixel, \see hdbscan().
 */
std::vector<double>
mapCoreDistances(const MapDistance& distance, std::size_t min_samples, int threads = 0);

/** \brief A minimum spanning tree of the mutual reachability of the pixels of a map. */
std::vector<HDBSCANEdge>
mapSpanningTree(const MapDistance& distance,
                const std::vector<double>& core_distances,
                int threads = 0);

} // namespace pcl::indoor
