/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/segmentation/hdbscan.h>

#include <cstddef>
#include <vector>

namespace pcl::indoor {

/** \brief What dbscan() looks for. */
struct DBSCANOptions {
  double epsilon = 0.0; ///< radius of a neighbourhood, in the unit of the distance
                        ///< (0 or more, finite)
  std::size_t min_samples = 5; ///< a core point has this many points within epsilon,
                               ///< itself included (at least 1)
  std::size_t min_cluster_size = 1; ///< smaller clusters become noise (at least 1)
  int threads = 0;                  ///< 0 = automatic; never changes the result
};

/** \brief Density-based clustering at one density (DBSCAN*), with any distance.
 *
 * The clusters are the connected components of the core points, two of which are linked
 * if they are no farther apart than epsilon: those of Ester et al., "A density-based
 * algorithm for discovering clusters in large spatial databases with noise", 1996,
 * without their border points. A border point (no core point, but within epsilon of
 * one) may touch several clusters and then goes to one by chance of order; here it is
 * noise, as in Campello, Moulavi and Sander, 2013, and the result is unique. It is also
 * the single-linkage hierarchy of hdbscan(), cut at epsilon.
 *
 * Time O(count^2) calls of the distance, memory O(count).
 * \param[in] distance as for hdbscan()
 * \return the cluster of each point: 0, 1, ... by first point; -1 for noise
 * \throws pcl::BadArgumentException if an option or a distance is out of its range
 */
template <typename Distance>
std::vector<int>
dbscan(std::size_t count, const Distance& distance, const DBSCANOptions& options);

/** \brief DBSCAN* of a graph: pairs without an edge are infinitely far apart.
 * Time O(m log m) for m edges, memory O(m).
 * \param[in] edges parallel edges and loops are allowed: the shortest counts, loops do
 * not
 * \throws pcl::BadArgumentException if an edge leaves the graph, or an option or a
 * distance is out of its range
 */
PCL_INDOOR_EXPORTS std::vector<int>
dbscan(std::size_t count,
       const std::vector<HDBSCANEdge>& edges,
       const DBSCANOptions& options);

/** \brief The last step, linear in time: several epsilons need only one forest.
 * \param[in] forest a minimum spanning tree of each component of the mutual
 * reachability, in any order
 * \param[in] core_distances one for each point; those above epsilon are noise
 * \param[in] options min_samples is not used
 * \throws pcl::BadArgumentException if the edges or core distances are not those of so
 * many points, or an option is out of its range
 */
PCL_INDOOR_EXPORTS std::vector<int>
dbscanFromSpanningForest(std::size_t count,
                         const std::vector<HDBSCANEdge>& forest,
                         const std::vector<double>& core_distances,
                         const DBSCANOptions& options);

namespace dbscan_detail {

/** Throws if an option is out of its range. */
PCL_INDOOR_EXPORTS void
requireValid(const DBSCANOptions& options);

} // namespace dbscan_detail

template <typename Distance>
std::vector<int>
dbscan(std::size_t count, const Distance& distance, const DBSCANOptions& options)
{
  dbscan_detail::requireValid(options);
  if (count < options.min_samples)
    return std::vector<int>(count, -1);
  const std::vector<double> core = hdbscan_detail::coreDistances(
      count, distance, options.min_samples, options.threads);
  return dbscanFromSpanningForest(
      count,
      hdbscan_detail::spanningTree(core, distance, options.threads),
      core,
      options);
}

} // namespace pcl::indoor
