/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/segmentation/building_rooms.h>
#include <pcl/segmentation/room_objects.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pcl::indoor {

/** \brief The thesis's own methods, without what was added since, beside those of
 * pcl::indoor: results are of the same types. docs/method/thesis.md lists what the
 * thesis leaves open. */
namespace thesis {

/** \brief Weights and scales of the distance between pixels. */
struct MapDistanceOptions {
  double visibility_weight = 0.05; ///< w_vis (0 or more)
  double euclidean_weight = 0.7;   ///< w_eucl (0 or more)
  double field_weight = 0.25;      ///< w_PF (0 or more)
  double euclidean_scale = 0.0;    ///< the distance that counts as 1, pixels; 0 = the
                                   ///< largest distance between two of the pixels
};

/** \brief How peaks of a histogram are found. */
struct HistogramPeakOptions {
  int bins = 64;            ///< number of bins from 0 to the largest value (at least 1)
  int smoothing = 1;        ///< half-width of the moving average, bins (at least 0)
  double prominence = 0.01; ///< smallest fall on both sides of a peak before a higher
                            ///< one, as a fraction of the fullest bin (0 or more)
};

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

/** \brief How points at walls get their room. */
enum class PointRooms {
  WallSides, ///< by the side of the wall that they are on
  Vote       ///< by most of the ten nearest free voxels, Sec. 3.2.3
};

/** \brief Parameters of the thesis's way from points to rooms (Sec. 3.2). */
struct RoomOptions {
  /** of the steps that both ways have. Of its map, which shows walls and openings
   * alone, persistence, min_width, min_area, open_plan and merging.open_share mean
   * nothing */
  BuildingRoomsOptions shared;
  FieldRoomsOptions field;
  PointRooms point_rooms = PointRooms::WallSides;
};

/** \brief Find the rooms of a building as pcl::indoor::segmentBuilding() does, but by
 * the potential field and HDBSCAN (Sec. 3.2.2 and 3.2.3). */
PCL_INDOOR_EXPORTS BuildingRooms
segmentBuilding(const std::vector<Eigen::Vector3f>& points,
                RoomOptions options,
                const ProgressCallback& progress = {},
                const ScanStations& stations = {});

/** \brief What is wrong with the options: one sentence with the value and the range.
 * \return empty if all are in range
 */
PCL_INDOOR_EXPORTS std::string
findProblem(const RoomOptions& options);

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
PCL_INDOOR_EXPORTS ObjectSegmentation
segmentObjects(ObjectSegmentationInput input,
               const ObjectOptions& options,
               const ProgressCallback& progress = {});

/** \brief Join given supervoxels by their graph alone, see
 * pcl::indoor::segmentSupervoxels(). */
PCL_INDOOR_EXPORTS std::map<std::uint32_t, std::uint32_t>
segmentSupervoxels(const NamedSupervoxels& given, const ObjectOptions& options);

/** \brief Segment the points of one room, see pcl::indoor::segmentRoomObjects(). */
PCL_INDOOR_EXPORTS RoomObjects
segmentRoomObjects(RoomPoints room,
                   const ObjectOptions& options,
                   const VoxelVoter& voter = {});

/** \brief Find what is wrong with the options.
 * \return one sentence with parameter, value and unit; empty if nothing is
 */
PCL_INDOOR_EXPORTS std::string
findProblem(const ObjectOptions& options);

} // namespace thesis

/** \brief The thesis's own way from points to rooms (Sec. 3.2) and no more: voxels of
 * 20 cm along the axes, two dominant directions in space, the potential field, each
 * pixel a landmark of visibility, and the vote of ten neighbours. Of the weights of Eq.
 * (3.1) it changed w1 (shared.interior.weights.below) to 0.5 where floors are hidden,
 * and w2 (shared.interior.weights.above) to 1.5 where ceilings are not.
 * docs/method/thesis.md lists what the thesis leaves open.
 */
PCL_INDOOR_EXPORTS thesis::RoomOptions
thesisRoomOptions();

/** \brief The thesis's own method (Sec. 4.2) with its parameters for laser scans, and
 * no more: planes of 5 % of the points or more are taken off; then on points, its graph
 * segmentation; k = 3, C = 3, R = 5 cm, R_voxel = 3 cm, R_seed = 12 cm. */
PCL_INDOOR_EXPORTS thesis::ObjectOptions
thesisOptions();

/** \brief The same with its parameters for the Kinect (Sec. 4.3.3): theta_t = 0.02, k =
 * 5, R_seed = 16 cm; R of Eq. (2.9), as points are closer than in laser scans; no
 * planes are taken off. */
PCL_INDOOR_EXPORTS thesis::ObjectOptions
thesisKinectOptions();

} // namespace pcl::indoor
