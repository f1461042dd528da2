/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/exports.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl::indoor {

/** \brief How clusters are chosen from the hierarchy. */
enum class ClusterSelection {
  ExcessOfMass, ///< those of the largest total stability: few, persistent clusters
  Leaf          ///< the leaves of the condensed tree: many, fine clusters
};

/** \brief What hdbscan() looks for. */
struct HDBSCANOptions {
  std::size_t min_cluster_size = 5; ///< points of the smallest cluster (at least 2)
  std::size_t min_samples = 0; ///< the core distance of a point reaches to this many
                               ///< points, itself included; larger = smoother, more
                               ///< noise; 1 = single linkage; 0 = min_cluster_size
  ClusterSelection selection = ClusterSelection::ExcessOfMass;
  double epsilon = 0.0; ///< clusters are not split at distances below this (0 or more,
                        ///< in the unit of the distance; Malzer and Baum, 2020)
  bool allow_single_cluster = false; ///< whether all points may be one cluster
  int threads = 0;                   ///< 0 = automatic; never changes the result
};

/** \brief A node of the condensed tree: a cluster over a range of distances. */
struct CondensedCluster {
  int parent = -1; ///< an earlier one; -1 for the first, which holds all points
  double birth_distance =
      std::numeric_limits<double>::infinity(); ///< at which it splits off its parent
  std::size_t size = 0;                        ///< points at its birth
  double stability = 0.0; ///< sum over its points of (1 / the distance at which they
                          ///< leave it - 1 / birth_distance)
  int label = -1;         ///< its label if it was selected
};

/** \brief Clusters, and the hierarchy that they were chosen from. */
struct HDBSCANResult {
  std::vector<int> labels; ///< of each point: 0, 1, ... by first point; -1 for
                           ///< noise
  std::vector<double> probabilities;  ///< how firmly each point belongs to its cluster,
                                      ///< 0 (noise) to 1
  std::vector<double> outlier_scores; ///< GLOSH, 0 (inlier) to 1
  std::vector<double> stabilities;    ///< of the cluster of each label
  std::vector<CondensedCluster> clusters; ///< the condensed tree, parents first; empty
                                          ///< without points
  std::vector<int> point_cluster;         ///< the last condensed cluster of each point
  std::vector<double> point_distance;     ///< the distance at which it leaves that
};

/** \brief An undirected edge of a graph of points. */
struct HDBSCANEdge {
  std::uint32_t source = 0;
  std::uint32_t target = 0;
  double distance = 0.0; ///< 0 or more; not NaN
};

/** \brief Density-based clustering of points with any distance (HDBSCAN*).
 *
 * Campello, Moulavi and Sander, "Density-based clustering based on hierarchical density
 * estimates", 2013. Two points are mutually reachable at the largest of their distance
 * and their core distances. The hierarchy is that of the components at each distance:
 * merges at exactly equal distances happen at once, in one step of any number of parts,
 * so that neither ties nor the order of the points ever change a result. A distance of
 * 0 counts as half of the smallest positive one of the hierarchy where its reciprocal
 * is needed.
 *
 * Time O(count^2) calls of the distance, many of them spared; memory O(count). Where
 * most pairs are too far apart to matter, the graph version is far cheaper.
 * \param[in] count number of points
 * \param[in] distance callable as double distance(std::size_t i, std::size_t j), called
 * from several threads at once; symmetric, 0 or more, not NaN; infinity is allowed; the
 * triangle inequality is not needed
 * \throws pcl::BadArgumentException if an option or a distance is out of its range
 */
template <typename Distance>
HDBSCANResult
hdbscan(std::size_t count, const Distance& distance, const HDBSCANOptions& options);

/** \brief HDBSCAN* of a graph: pairs without an edge are infinitely far apart. Time O(m
 * log m) for m edges, memory O(m). Equal to the dense version of such distances.
 * \param[in] edges parallel edges and loops are allowed: the shortest counts, loops do
 * not; a point with fewer than min_samples - 1 neighbours has an infinite core distance
 * and becomes noise (pass core distances where that is not meant)
 * \throws pcl::BadArgumentException if an edge leaves the graph, or an option or a
 * distance is out of its range
 */
PCL_INDOOR_EXPORTS HDBSCANResult
hdbscan(std::size_t count,
        const std::vector<HDBSCANEdge>& edges,
        const HDBSCANOptions& options);

/** \brief The same with core distances of the caller; min_samples is not used.
 * \param[in] core_distances one for each point, 0 or more
 */
PCL_INDOOR_EXPORTS HDBSCANResult
hdbscan(std::size_t count,
        const std::vector<HDBSCANEdge>& edges,
        const std::vector<double>& core_distances,
        const HDBSCANOptions& options);

/** \brief The last step: clusters from a spanning forest of mutual reachability.
 * \param[in] forest a minimum spanning tree of each component, in any order
 * \param[in] options min_samples is not used
 * \throws pcl::BadArgumentException if the edges are no forest of the points, or an
 * option or a distance is out of its range
 */
PCL_INDOOR_EXPORTS HDBSCANResult
hdbscanFromSpanningForest(std::size_t count,
                          std::vector<HDBSCANEdge> forest,
                          const HDBSCANOptions& options);

/** \brief A minimum spanning tree of each component of a graph (Kruskal's algorithm).
 * \return ascending by distance
 * \throws pcl::BadArgumentException if an edge leaves the graph or a distance is
 * negative or NaN
 */
PCL_INDOOR_EXPORTS std::vector<HDBSCANEdge>
minimumSpanningForest(std::size_t count, std::vector<HDBSCANEdge> edges);

} // namespace pcl::indoor

#include <pcl/segmentation/impl/hdbscan.hpp>
