/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/room_objects.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace pcl {
namespace indoor {

/** \brief The thesis's own methods, without what was added since, beside those of
 * pcl::indoor: results are of the same types. docs/method/thesis.md lists what the
 * thesis leaves open. */
namespace thesis {

/** \brief How supervoxels are joined over the edges of their graph. */
enum class EdgePartition {
  FelzenszwalbHuttenlocher, ///< on the weights of Eq. (4.3)
  Lccp ///< over all convex edges, as LCCP does ("Proposed + LCCP" of Table 4.1)
};

/** \brief Parameters of the graph of supervoxels. */
struct EdgeOptions {
  EdgePartition partition = EdgePartition::FelzenszwalbHuttenlocher;
  float concavity_tolerance_degrees = 10; ///< of LCCP's criterion (0 to 180)
  float concavity_weight = 0.25f;         ///< a of Eq. (4.3) (0 to 1)
  float graph_scale = 3; ///< k, for EdgePartition::FelzenszwalbHuttenlocher (>= 0)
};

/** \brief Parameters of the way on points instead of voxels, as Sec. 4.2 has it:
 * removal and recovery on points within a radius, supervoxels of
 * pcl::SupervoxelClustering, and EdgePartition::Lccp by pcl::LCCPSegmentation; points
 * that no round of Algorithm 1 reaches have no segment. */
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
   * supervoxels and EdgePartition::Lccp are our own, as PCL's have no such term */
  float fpfh_weight = 0;
};

/** \brief Parameters of the thesis's object segmentation (Sec. 4.2). */
struct ObjectOptions {
  /** of the steps that both ways have. Of its pieces JoiningScale::View alone counts,
   * on voxels; fewest_points in segmentRoomObjects() */
  ObjectSegmentationOptions shared;
  EdgeOptions edges;
  /** none = on voxels, from which pcl::indoor::segmentObjects() takes out structure */
  std::optional<PointOptions> on_points;
};

/** \brief Segment a scanned scene into objects as pcl::indoor::segmentObjects() does,
 * but by the graph of supervoxels alone: there are no pieces and no remainder. */
ObjectSegmentation
segmentObjects(ObjectSegmentationInput input,
               const ObjectOptions& options,
               const ProgressCallback& progress = {});

/** \brief Join given supervoxels by their graph alone, see
 * pcl::indoor::segmentSupervoxels(). */
std::map<std::uint32_t, std::uint32_t>
segmentSupervoxels(const NamedSupervoxels& given, const ObjectOptions& options);

/** \brief Segment the points of one room, see pcl::indoor::segmentRoomObjects(). */
RoomObjects
segmentRoomObjects(RoomPoints room,
                   const ObjectOptions& options,
                   const VoxelVoter& voter = {});

/** \brief Find what is wrong with the options.
 * \return one sentence with parameter, value and unit; empty if nothing is
 */
std::string
findProblem(const ObjectOptions& options);

} // namespace thesis

/** \brief The thesis's own method (Sec. 4.2) with its parameters for laser scans, and
 * no more: planes of 5 % of the points or more are taken off; then on points, its graph
 * segmentation; k = 3, C = 3, R = 5 cm, R_voxel = 3 cm, R_seed = 12 cm. */
thesis::ObjectOptions
thesisOptions();

/** \brief The same with its parameters for the Kinect (Sec. 4.3.3): theta_t = 0.02, k =
 * 5, R_seed = 16 cm; R of Eq. (2.9), as points are closer than in laser scans; no
 * planes are taken off. */
thesis::ObjectOptions
thesisKinectOptions();

} // namespace indoor
} // namespace pcl
