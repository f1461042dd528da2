/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/normal_orientation.h>
#include <pcl/segmentation/graph_segmentation.h>
#include <pcl/segmentation/point_recovery.h>
#include <pcl/segmentation/surface_graph.h>

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief How supervoxels are joined into segments. */
enum class Partition {
  Graph, ///< by the mean bend of whole borders, see clusterByBorders()
  FelzenszwalbHuttenlocher, ///< on the weights of Eq. (4.3), as the thesis does
  Lccp ///< over all convex edges, as LCCP does ("Proposed + LCCP" of Table 4.1)
};

/** \brief Parameters of the noise-resilient object segmentation (Sec. 4.2). */
struct ObjectSegmentationOptions {
  double voxel_size = 0.03; ///< R_voxel, metres (> 0)
  double seed_size = 0.12;  ///< R_seed, metres (>= voxel_size)
  /** raise both sizes in proportion where points are too sparse for the voxel size, see
   * raisedToResolution(); never for a single camera */
  bool adapt_to_resolution = true;
  /** keep floor, ceiling and walls out of the graph, see findRoomStructure(): nothing
   * is joined through them; never for a single camera */
  bool separate_structure = true;
  /** part flat things from the horizontal surface that they lie on, see
   * partFlatThings(); never for a single camera */
  bool separate_things = true;
  /** part segments at empty gaps narrower than voxels, see partAtGaps(); never for a
   * single camera */
  bool separate_gaps = true;
  /** part bodies that stand against each other, see partAtSeams(); never for a single
   * camera */
  bool separate_seams = true;
  /** take straight bars out of what they run through, see partAtBars(); never for a
   * single camera */
  bool separate_bars = true;
  /** against gravity, unit length; for flat things, gaps, seams, bars and all that is
   * joined
   */
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  unsigned normal_rings = 1; ///< reach of normals and curvature, voxels (>= 1)
  /** which way estimated normals are turned */
  NormalOrientation orientation = NormalOrientation::Automatic;
  float curvature_threshold = 0.03f; ///< theta_t (0 to 1/3)
  float ratio_threshold = 0.2f;      ///< alpha_t (0 to 1)
  /** neighbours nearer to the tangent plane count for neither half-space; voxels (>= 0)
   */
  float plane_tolerance = 0.3f;
  float spatial_weight = 0.2f;               ///< w_s of Eq. (4.4) (>= 0)
  float normal_weight = 0.5f;                ///< w_n of Eq. (4.4) (>= 0)
  float concavity_weight = 0.25f;            ///< a of Eq. (4.3) (0 to 1)
  float concavity_tolerance_degrees = 10.0f; ///< of LCCP's criterion (0 to 180)
  bool use_sanity_check = false;             ///< of LCCP
  bool use_smoothness_check = false;         ///< of LCCP
  float smoothness_threshold = 0.1f;         ///< of LCCP, voxels (>= 0)
  Partition partition = Partition::Graph;
  float bend_threshold_degrees = 23; ///< for Partition::Graph (-180 to 180)
  BendOptions bend;                  ///< for Partition::Graph
  /** join segments whose hulls leave little air between them for their contact, see
   * ConvexUnionOptions::air_per_contact; for Partition::Graph (>= 0, 0 = never) */
  double max_union_air = 5;
  /** join the touching pieces of upright frames, see joinFrames() */
  bool join_frames = true;
  /** join the boards of racks, see joinRacks() */
  bool join_racks = true;
  /** join legs, end boards and backs to what they carry or end, see joinUprights() */
  bool join_uprights = true;
  /** join the pieces of a front that a shadow cuts in two, see joinAcrossShadows();
   * never for a single camera */
  bool join_shadowed = true;
  /** join the open leaves of doors with their frames, see joinDoorLeaves(); never for a
   * single camera */
  bool join_doors = true;
  float graph_scale = 3; ///< k, for Partition::FelzenszwalbHuttenlocher (>= 0)
  /** C: smaller segments are joined to a neighbour, or taken up in the recovery;
   * supervoxels */
  std::uint32_t min_segment_size = 4;
  unsigned common_neighbors = 0; ///< k of extended convexity, for Partition::Lccp
  unsigned lccp_min_segment = 3; ///< n_filter, for Partition::Lccp
  RecoveryOptions recovery;
  unsigned threads = 0; ///< 0 = automatic; the result does not depend on it
};

/** \brief Fewer and larger segments, for laser scans of rooms full of things, whose
 * surfaces undulate with the noise and the registration: flat things stay with what
 * they lie on, and C = 6. There is less oversegmentation, and more undersegmentation.
 */
ObjectSegmentationOptions
laserScanOptions();

/** \brief The thesis's own choice: its graph segmentation with C = 3, and no more.
 */
ObjectSegmentationOptions
thesisOptions();

/** \brief What the segmentation works on, points in a local frame. */
struct ObjectSegmentationInput {
  std::vector<Eigen::Vector3f> points; ///< finite, metres
  /** one per point, oriented; empty to estimate and orient them */
  std::vector<Eigen::Vector3f> normals;
  /** one sensor position; empty to orient towards the free space */
  std::vector<Eigen::Vector3f> viewpoint;
  /** one camera at the viewpoint: voxels grow with the distance along z */
  bool single_camera = false;
};

/** \brief Options for a single view of a table with small objects, as from a Kinect at
 * about one metre: voxel and seed size are those at 1 m and grow with the distance.
 */
ObjectSegmentationOptions
singleViewOptions();

/** \brief Segments and what led to them. */
struct ObjectSegmentation {
  double voxel_size = 0; ///< that was used, metres
  SurfaceVoxels voxels;
  /** per voxel: number of the floor's, ceiling's or wall's plane, from 1; 0 = none */
  std::vector<std::uint32_t> plane_of_voxel;
  std::vector<std::uint8_t> removed; ///< per voxel: non-convex, taken out and recovered
  Supervoxels supervoxels; ///< of the voxels that are in no plane and not removed
  std::vector<SurfaceEdge> edges;              ///< between supervoxels
  std::vector<std::uint32_t> segment_of_point; ///< 0 ... segment_count - 1
  std::uint32_t segment_count = 0;
};

/** \brief Segment a scanned scene into objects or their parts (Sec. 4.2).
 * Takes out the voxels of concave and noisy regions, joins supervoxels of the others,
 * and gives the voxels that were taken out to the segments they continue. Works on
 * voxels throughout, so its cost is linear in the number of points and small.
 * Every point gets a segment.
 * \throws pcl::BadArgumentException if an option is out of range or sizes differ
 */
ObjectSegmentation
segmentObjects(const ObjectSegmentationInput& input,
               const ObjectSegmentationOptions& options);

/** \brief Find what is wrong with the options.
 * \return one sentence with parameter, value and unit; empty if nothing is
 */
std::string
findInvalidOption(const ObjectSegmentationOptions& options);

} // namespace indoor
} // namespace pcl
