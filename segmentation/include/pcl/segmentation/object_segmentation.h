/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/normal_orientation.h>
#include <pcl/indoor/progress_callback.h>
#include <pcl/indoor/voxel_classes.h>
#include <pcl/segmentation/objects/camera_view.h>
#include <pcl/segmentation/objects/object_joining.h>
#include <pcl/segmentation/objects/object_scene.h>
#include <pcl/segmentation/objects/surface_graph.h>

#include <Eigen/Core>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pcl {
namespace indoor {

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
ObjectSegmentationOptions
withSizes(ObjectSegmentationOptions options);

/** \brief Parts of things, as the seat and the back of a chair, instead of whole
 * things: JoiningScale::Parts. */
ObjectSegmentationOptions
partsOptions();

/** \brief The thesis's own method (Sec. 4.2) with its parameters for laser scans, and
 * no more: planes of 5 % of the points or more are taken off; then on points, its graph
 * segmentation; k = 3, C = 3, R = 5 cm, R_voxel = 3 cm, R_seed = 12 cm. */
ObjectSegmentationOptions
thesisOptions();

/** \brief The same with its parameters for the Kinect (Sec. 4.3.3): theta_t = 0.02, k =
 * 5, R_seed = 16 cm; R of Eq. (2.9), as points are closer than in laser scans; no
 * planes are taken off. */
ObjectSegmentationOptions
thesisKinectOptions();

/** \brief Who is asked what the points of a scene are part of, before objects are
 * looked for. With JoiningScale::Objects pieces are joined by these votes, too, and
 * sizes that were raised are then 0.7 of that for voxels, and three voxels for seeds.
 */
struct VoxelVoter {
  ClassifyVoxels classify;   ///< empty: nobody
  bool in_all_rooms = false; ///< also where a ceiling was seen
};

/** \brief What the segmentation works on, points in a local frame. */
struct ObjectSegmentationInput {
  std::vector<Eigen::Vector3f> points; ///< finite, metres
  /** one per point, oriented; else empty, or no areUnitNormals(): they are estimated */
  std::vector<Eigen::Vector3f> normals;
  /** one per point: red, green and blue, 0 to 255; empty if there are none */
  std::vector<Eigen::Vector3f> colors;
  /** one sensor position; empty to orient towards the free space */
  std::vector<Eigen::Vector3f> viewpoint;
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ(); ///< against gravity, unit length
  /** views need the camera's place as viewpoint. Of a table, voxels grow with the
   * distance along z; of a room, the direction up does not count, see upOfView() */
  Capture capture = Capture::Scan;
  VoxelVoter voter; ///< for a Capture::Scan
};

/** \brief Options for a single view of a table with small objects, as from a Kinect at
 * about one metre: voxel and seed size are those at 1 m and grow with the distance.
 */
ObjectSegmentationOptions
singleViewOptions();

/** \brief Segments and what led to them. */
struct ObjectSegmentation {
  ObjectSegmentationOptions options; ///< that were used, with their sizes
  ObjectScene scene; ///< with the points of the input and the voxel size that was used
  std::vector<std::uint8_t> removed; ///< per voxel: non-convex, taken out and recovered
  Supervoxels supervoxels; ///< of the voxels that are in no plane and not removed
  std::vector<SurfaceEdge> edges;            ///< between supervoxels
  std::vector<std::uint32_t> piece_of_point; ///< for Partition::Pieces, else empty
  PieceGraph pieces;                         ///< those of the planes have no voxels
  VoxelClasses votes; ///< of the points; empty if nobody was asked
  /** joins of pieces, the most probable first; those of at least a level give a
   * segmentation, see segmentsAtLevel() */
  std::vector<PieceJoin> joins;
  /** 0 ... segment_count - 1, or Supervoxels::none where PointOptions leave one without
   */
  std::vector<std::uint32_t> segment_of_point;
  std::uint32_t segment_count = 0;
  std::vector<StructureKind>
      structure_of_segment; ///< floor, wall, ceiling, remainder, or none
};

/** \brief Segment a scanned scene into objects or their parts (Sec. 4.2).
 * Takes out the voxels of concave and noisy regions, joins supervoxels of the others to
 * pieces, gives the voxels that were taken out to the pieces they continue, and joins
 * pieces that are probably one thing. Works on voxels throughout, so its cost is
 * nearly linear in the number of points, and small.
 * Floor, ceiling and walls are kept out of the graph, see findRoomStructure(): nothing
 * is joined through them. With JoiningScale::View, for a Capture::TableView and on
 * points there is no such structure.
 * Every point gets a segment, its copies in exactly its place the same.
 * \param[in] progress called before each stage and at the end with 1; may be empty
 * \return without segments and labels if \a progress returned false
 * \throws pcl::BadArgumentException if an option is out of range, sizes differ, or the
 * direction up has not the length 1
 */
ObjectSegmentation
segmentObjects(ObjectSegmentationInput input,
               const ObjectSegmentationOptions& options,
               const ProgressCallback& progress = {});

/** \brief Supervoxels of another segmentation, by names of its own. */
struct NamedSupervoxels {
  std::vector<std::uint32_t> names; ///< ascending
  Supervoxels supervoxels; ///< centroids and normals, in the order of the names
  std::multimap<std::uint32_t, std::uint32_t> adjacency; ///< both ways
};

/** \brief Join given supervoxels to segments, by the partition of the options alone:
 * there are no points to take out, and no pieces are joined by the learned criterion.
 * Edges to names that are not there do not count.
 * \return the segment of each name, from 1
 */
std::map<std::uint32_t, std::uint32_t>
segmentSupervoxels(const NamedSupervoxels& given,
                   const ObjectSegmentationOptions& options);

/** \brief Find what is wrong with the options.
 * \return one sentence with parameter, value and unit; empty if nothing is
 */
std::string
findProblem(const ObjectSegmentationOptions& options);

} // namespace indoor
} // namespace pcl
