/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/normal_orientation.h>
#include <pcl/indoor/exports.h>

#include <cstdint>
#include <optional>
#include <string>

namespace pcl {
namespace indoor {

/** \brief What pieces are joined to. */
enum class JoiningScale {
  Parts, ///< parts of chairs and sofas, as a seat, a back and an arm; else whole things
  Objects, ///< whole things
  View     ///< small things in a camera's view, as on a table
};

/** \brief How supervoxels are joined into segments. */
enum class Partition {
  Pieces, ///< to pieces, by the mean bend of whole borders; pieces by joinPieces()
  FelzenszwalbHuttenlocher, ///< on the weights of Eq. (4.3), as the thesis does
  Lccp ///< over all convex edges, as LCCP does ("Proposed + LCCP" of Table 4.1)
};

/** \brief Parameters of Partition::Pieces. */
struct PieceOptions {
  JoiningScale scale = JoiningScale::Objects; ///< what the pieces are joined to
  /** least probability that two pieces are one thing for them to be joined (0 to 1);
   * higher gives smaller segments. None: they are joined where that gives whole things,
   * see bestCut(); for JoiningScale::View from levelOf() on */
  std::optional<float> joining_level;
};

/** \brief Parameters of the partitions by single edges of the graph:
 * Partition::FelzenszwalbHuttenlocher and Partition::Lccp. */
struct EdgeOptions {
  float concavity_tolerance_degrees = 10; ///< of LCCP's criterion (0 to 180)
  float concavity_weight = 0.25f;         ///< a of Eq. (4.3) (0 to 1)
  float graph_scale = 3; ///< k, for Partition::FelzenszwalbHuttenlocher (>= 0)
};

/** \brief Parameters of the thesis's way on points instead of voxels, as Sec. 4.2 has
 * it: removal and recovery on points within a radius, supervoxels of
 * pcl::SupervoxelClustering, and Partition::Lccp by pcl::LCCPSegmentation; points that
 * no round of Algorithm 1 reaches have no segment. Not for Partition::Pieces. */
struct PointOptions {
  /** R of Eq. (4.2), also of normals and curvatures, metres (>= 0); 0 = that of Eq.
   * (2.9) */
  double removal_radius = 0;
  /** least share of all points that a plane holds that RANSAC takes off before all else
   * (0 to 1); 0 = none is */
  double ransac_share = 0;
  /** w_c of Eq. (2.19), in supervoxels and in the graph (0 to 10^6); 0 = no colours, as
   * in Eq. (4.4). Needs colours */
  float color_weight = 0;
  /** of FPFH, Eq. (2.18), in supervoxels and in the graph (0 to 10^6); 0 = none. Else
   * the supervoxels and Partition::Lccp are our own, as PCL's have no such term */
  float fpfh_weight = 0;
};

/** \brief Parameters of the noise-resilient object segmentation (Sec. 4.2). */
struct ObjectSegmentationOptions {
  /** R_voxel, metres (>= 0); 0 = as withSizes() has it. If both sizes are 0, they are
   * raised where points are too sparse, see raisedToResolution() and VoxelVoter */
  double voxel_size = 0;
  double seed_size = 0; ///< R_seed, metres (>= voxel_size); 0 = four voxels
  /** which way estimated normals are turned */
  NormalOrientation orientation = NormalOrientation::Automatic;
  float curvature_threshold = 0.03f; ///< theta_t (0 to 1/3)
  float ratio_threshold = 0.2f;      ///< alpha_t (0 to 1)
  float spatial_weight = 0.2f;       ///< w_s of Eq. (4.4) (0 to 10^6)
  float normal_weight = 0.5f;        ///< w_n of Eq. (4.4) (0 to 10^6)
  Partition partition = Partition::Pieces;
  PieceOptions pieces; ///< for Partition::Pieces
  EdgeOptions edges;   ///< for the others
  /** C: smaller segments are joined to a neighbour, or taken up in the recovery;
   * supervoxels */
  std::uint32_t min_segment_size = 4;
  /** segments of fewer points, or of fewer voxels than a supervoxel has, are too small
   * to be told: together they are the remainder, one segment; for Partition::Pieces */
  std::uint32_t fewest_points = 100;
  std::optional<PointOptions> on_points; ///< for the others; none = on voxels
  unsigned threads = 0; ///< 0 = automatic; the result does not depend on it
};

/** \brief The sizes to work with where points are dense enough: those that are 0 follow
 * from the other, or are 3 and 12 cm, with JoiningScale::View 5 mm and 2 cm. */
PCL_INDOOR_EXPORTS ObjectSegmentationOptions
withSizes(ObjectSegmentationOptions options);

/** \brief Parts of things, as the seat and the back of a chair, instead of whole
 * things: JoiningScale::Parts. */
PCL_INDOOR_EXPORTS ObjectSegmentationOptions
partsOptions();

/** \brief The thesis's own method (Sec. 4.2) with its parameters for laser scans, and
 * no more: planes of 5 % of the points or more are taken off; then on points, its graph
 * segmentation; k = 3, C = 3, R = 5 cm, R_voxel = 3 cm, R_seed = 12 cm. */
PCL_INDOOR_EXPORTS ObjectSegmentationOptions
thesisOptions();

/** \brief The same with its parameters for the Kinect (Sec. 4.3.3): theta_t = 0.02, k =
 * 5, R_seed = 16 cm; R of Eq. (2.9), as points are closer than in laser scans; no
 * planes are taken off. */
PCL_INDOOR_EXPORTS ObjectSegmentationOptions
thesisKinectOptions();

/** \brief Options for a single view of a table with small objects, as from a Kinect at
 * about one metre: voxel and seed size are those at 1 m and grow with the distance.
 */
PCL_INDOOR_EXPORTS ObjectSegmentationOptions
singleViewOptions();

/** \brief Find what is wrong with the options.
 * \return one sentence with parameter, value and unit; empty if nothing is
 */
PCL_INDOOR_EXPORTS std::string
findProblem(const ObjectSegmentationOptions& options);

} // namespace indoor
} // namespace pcl
