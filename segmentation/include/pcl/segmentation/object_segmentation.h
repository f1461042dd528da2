/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/indoor/progress_callback.h>
#include <pcl/indoor/voxel_classes.h>
#include <pcl/segmentation/object_segmentation_options.h>

#include <Eigen/Core>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pcl::indoor {

/** \brief How points were taken. */
enum class Capture {
  Scan,      ///< in any way; which direction is up is known
  TableView, ///< by one camera that looks along z, at about 1 m: objects on a table
  RoomView   ///< by one camera that looks along z, with y down, from farther off
};

/** \brief How a camera's view lies in the frame of its points. */
struct CameraView {
  Capture capture = Capture::Scan;
  /** the camera looks along -z with y up, as in OpenGL, ARKit and the RealSense viewer:
   * halfTurned() gives points as a camera has them that looks along z with y down */
  bool is_turned = false;
};

/** \brief Tell how points were taken and where their camera looks: captureOf(), along z
 * or else along -z.
 * \param[in] is_organized they lie in rows; else only arePixels() tells that a camera
 * took them
 */
PCL_INDOOR_EXPORTS CameraView
cameraView(const std::vector<Eigen::Vector3f>& points,
           const Eigen::Vector3f& camera,
           bool is_organized);

/** \brief Turn by 180 degrees about x. */
inline Eigen::Vector3f
halfTurned(const Eigen::Vector3f& v)
{
  return {v.x(), -v.y(), -v.z()};
}

/** \brief Whether most points have a smaller z than the camera. */
PCL_INDOOR_EXPORTS bool
areBehind(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& camera);

/** \brief Whether a scan is no larger than what stands on a table: 98 % of the points
 * lie within 0.7 m of height, less than a chair's with its back, and within 1.5 m both
 * ways across it; and they are dense enough for smaller voxels than a room's, see
 * raisedToResolution().
 *
 * What is joined to whole furniture in rooms joins such objects to one;
 * singleViewOptions() keep them apart, from whichever sides they were seen.
 * \param[in] points finite, metres, local frame; fewer than 1,000 do not tell
 * \param[in] up unit length
 */
PCL_INDOOR_EXPORTS bool
isTableTop(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& up);

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
  /** one per point, oriented. If empty or not of unit length, normals are estimated. */
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

/** \brief Whether a segment is an object, or what else it is. */
enum class StructureKind : std::uint8_t {
  None = 0, ///< an object
  Floor = 1,
  Wall = 2,
  Ceiling = 3,
  Remainder = 4 ///< all that is too small to be told, as one segment
};

/** \brief Two pieces became one. */
struct PieceJoin {
  /** numbers of the two pieces: the union keeps the first, the second is gone */
  std::uint32_t kept = 0, gone = 0;
  float level = 0; ///< least probability of this and all joins before it
};

struct ObjectSteps; // private

/** \brief Segments and what led to them. */
struct ObjectSegmentation {
  static constexpr std::uint32_t none = 0xffffffffu; ///< no segment, or supervoxel
  ObjectSegmentationOptions options;         ///< that were used, with their sizes
  std::vector<std::uint32_t> piece_of_point; ///< empty if there are no pieces
  VoxelClasses votes; ///< of the points; empty if nobody was asked
  /** joins of pieces, the most probable first; those of at least a level give a
   * segmentation, see segmentsAtLevel() */
  std::vector<PieceJoin> joins;
  /** 0 ... segment_count - 1, or none where thesis::PointOptions leave one without */
  std::vector<std::uint32_t> segment_of_point;
  std::uint32_t segment_count = 0;
  std::vector<StructureKind>
      structure_of_segment; ///< floor, wall, ceiling, remainder, or none
  std::shared_ptr<const ObjectSteps> steps; ///< null if nothing was segmented
};

/** \brief Segment a scanned scene into objects or their parts (Sec. 4.2).
 * Takes out the voxels of concave and noisy regions, joins supervoxels of the others to
 * pieces, gives the voxels that were taken out to the pieces they continue, and joins
 * pieces that are probably one object. Works on voxels throughout, so its cost is
 * nearly linear in the number of points, and small.
 * Floor, ceiling and walls are kept out of the graph, see findRoomStructure(): nothing
 * is joined through them. With JoiningScale::View and for a Capture::TableView there
 * is no such structure.
 * Every point gets a segment, its copies in exactly its place the same.
 * \param[in] progress called before each stage and at the end with 1; may be empty
 * \return without segments and labels if \a progress returned false
 * \throws pcl::BadArgumentException if an option is out of range, sizes differ, or the
 * direction up has not the length 1
 */
PCL_INDOOR_EXPORTS ObjectSegmentation
segmentObjects(ObjectSegmentationInput input,
               const ObjectSegmentationOptions& options,
               const ProgressCallback& progress = {});

/** \brief Which points were taken out and recovered: one flag per point. */
PCL_INDOOR_EXPORTS std::vector<std::uint8_t>
removedPoints(const ObjectSegmentation& segmentation);

/** \brief Which points are in the planes of floor, ceiling and walls: one flag per
 * point. */
PCL_INDOOR_EXPORTS std::vector<std::uint8_t>
structurePoints(const ObjectSegmentation& segmentation);

/** \brief The supervoxel of each point, or ObjectSegmentation::none of points in planes
 * and of those that were taken out. */
PCL_INDOOR_EXPORTS std::vector<std::uint32_t>
supervoxelsOfPoints(const ObjectSegmentation& segmentation);

/** \brief The pairs of supervoxels that touch, the smaller number first. */
PCL_INDOOR_EXPORTS std::vector<std::pair<std::uint32_t, std::uint32_t>>
touchingSupervoxels(const ObjectSegmentation& segmentation);

/** \brief The segment of each piece when all joins of at least a level are made: the
 * number of one of its pieces. */
PCL_INDOOR_EXPORTS std::vector<std::uint32_t>
segmentsAtLevel(const ObjectSegmentation& segmentation, float level);

/** \brief Supervoxels of another segmentation, by names of its own. */
struct NamedSupervoxels {
  std::vector<std::uint32_t> names;                      ///< ascending
  std::vector<Eigen::Vector3f> centroids;                ///< in the order of the names
  std::vector<Eigen::Vector3f> normals;                  ///< unit length or zero
  std::multimap<std::uint32_t, std::uint32_t> adjacency; ///< both ways
};

/** \brief Join given supervoxels to what segmentObjects() would have for pieces: there
 * are no points to take out, and no pieces are joined by the learned criterion.
 * Edges to names that are not there do not count.
 * \return the segment of each name, from 1
 */
PCL_INDOOR_EXPORTS std::map<std::uint32_t, std::uint32_t>
segmentSupervoxels(const NamedSupervoxels& given,
                   const ObjectSegmentationOptions& options);

/** \brief What was found out about the points of an object segmentation. */
struct ObjectReport {
  std::vector<std::string> warnings; ///< a line each: what is odd, and what mends it
  ObjectSegmentationOptions options; ///< that were used, with their sizes
  CameraView view;                   ///< how the points were taken
  /** The direction up that was used, of unit length; not of a camera's view. */
  Eigen::Vector3f up_axis = Eigen::Vector3f::UnitZ();
};

/** \brief Warn if nearly all points, of many, are one segment: right for one object.
 * \return one line; empty if not
 */
PCL_INDOOR_EXPORTS std::string
oneSegmentWarning(const ObjectSegmentation& result);

/** \brief Warn if the largest object is no larger than what stands on a table, see
 * isTableTop(), but of ten pieces or more: probably it is many small objects.
 * \return one line; empty if not, for a Capture::TableView, and with
 * JoiningScale::View, which is for such objects
 */
PCL_INDOOR_EXPORTS std::string
tableTopWarning(const ObjectSegmentation& result);

/** \brief Warn if the largest object is more than 4 m wide both ways: probably several
 * rooms, or one whose walls were not told from its objects.
 * \return one line; empty if not, for a Capture::TableView, and with
 * JoiningScale::View
 */
PCL_INDOOR_EXPORTS std::string
wideObjectWarning(const ObjectSegmentation& result);

/** \brief Warn that some points are so far from the others that they get no segment.
 * \return one line; empty if there are none
 */
PCL_INDOOR_EXPORTS std::string
straysWarning(std::size_t strays, std::size_t all);

/** \brief Say that the points are taken as what a camera sees, and how it looks: from y
 * up and z ahead, as engines for games have it, floors would be ceilings.
 * \return one line; empty for a scan
 */
PCL_INDOOR_EXPORTS std::string
cameraNote(const CameraView& view);

/** \brief Warn if what a camera looks at is farther off than a depth camera sees.
 * \param[in] input a view; of others nothing is known
 * \return one line; empty if not
 */
PCL_INDOOR_EXPORTS std::string
farViewWarning(const ObjectSegmentationInput& input);

} // namespace pcl::indoor
