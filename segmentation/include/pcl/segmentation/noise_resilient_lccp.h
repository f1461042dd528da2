/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/unit_normals.h>
#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/PointIndices.h>
#include <pcl/segmentation/object_segmentation.h>
#include <pcl/segmentation/thesis.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief How pcl::NoiseResilientLCCP joins supervoxels into segments. */
enum class Partition {
  Pieces, ///< to pieces, by the mean bend of whole borders; pieces by what was learned
  FelzenszwalbHuttenlocher, ///< thesis::EdgePartition::FelzenszwalbHuttenlocher
  Lccp                      ///< thesis::EdgePartition::Lccp
};

} // namespace indoor

/** \brief Segments a scanned room into objects, in spite of noise and double surfaces.
 *
 * Points of concave and of noisy regions are taken out first, since patches there would
 * connect what does not belong together; the remaining surface is divided into
 * supervoxels, and these are joined to pieces where they bend little; the points that
 * were taken out are given to the pieces they continue. Pieces that are probably one
 * object are then joined, by a criterion learned from simulated scans.
 *
 * Every finite point of the indices gets a segment, but for those that lie kilometres
 * away from the others. Coordinates may be large (UTM).
 * Cost is nearly linear in the number of points. Results depend neither on the number
 * of threads nor, but for rounding and the names of labels, on the order of the points.
 * \note The method: D. Bobkov et al., "Noise-resistant Unsupervised Object Segmentation
 * in Multi-view Indoor Point Clouds", VISAPP 2017; here Sec. 4.2. Deviations are listed
 * in docs/method/objects.md.
 * \ingroup segmentation
 */
template <typename PointT>
class NoiseResilientLCCP : public PCLBase<PointT> {
public:
  using Ptr = shared_ptr<NoiseResilientLCCP<PointT>>;
  using ConstPtr = shared_ptr<const NoiseResilientLCCP<PointT>>;
  using Partition = indoor::Partition;
  using PointCloudN = PointCloud<Normal>;

  /** \brief Set normals, one per point of the input, that point to the side the surface
   * was seen from. Without them (default, or null) normals are estimated, and turned to
   * the viewpoint, if one is set, to the camera of a single view, or else to the free
   * space between the surfaces. So they are, with a warning, if these cannot be the
   * normals of the points, see indoor::findNormalsProblem().
   */
  void
  setInputNormals(const PointCloudN::ConstPtr& normals);

  /** \brief Get the normals that were set. */
  PointCloudN::ConstPtr
  getInputNormals() const;

  /** \brief Set colours, one per point of the input, for a colour weight in the
   * options. Without them (default, or null) those of the input's points are taken, if
   * its type has any. */
  void
  setInputColors(const PointCloud<RGB>::ConstPtr& colors);

  /** \brief Get the colours that were set. */
  PointCloud<RGB>::ConstPtr
  getInputColors() const;

  /** \brief Set the edge of a voxel, R_voxel.
   * \param[in] resolution metres, not negative. Lower shows smaller objects and needs
   * denser points. 0 (default): a quarter of the seed resolution if that is set, else
   * 0.03, 0.005 with JoiningScale::View, raised until voxels of a sparse surface touch.
   */
  void
  setVoxelResolution(double resolution);

  /** \brief Get the voxel resolution that was set. */
  double
  getVoxelResolution() const;

  /** \brief Set the distance of supervoxels, R_seed.
   * \param[in] resolution metres, at least the voxel resolution; about half of the
   * smallest object. 0 (default): four voxels.
   */
  void
  setSeedResolution(double resolution);

  /** \brief Get the seed resolution that was set. */
  double
  getSeedResolution() const;

  /** \brief Set the curvature above which points may be taken out, theta_t.
   * \param[in] threshold surface variation, 0 to 1/3 (default 0.03; 0.02 for Kinect).
   * Lower takes out more.
   */
  void
  setCurvatureThreshold(float threshold);

  /** \brief Get the curvature threshold. */
  float
  getCurvatureThreshold() const;

  /** \brief Set the ratio of neighbours in front of and behind the tangent plane from
   * which points are taken out, alpha_t.
   * \param[in] threshold 0 to 1 (default 0.2). Lower takes out more.
   */
  void
  setRatioThreshold(float threshold);

  /** \brief Get the ratio threshold. */
  float
  getRatioThreshold() const;

  /** \brief Set how supervoxels are joined (default Partition::Pieces). */
  void
  setPartition(Partition partition);

  /** \brief Get the partition. */
  Partition
  getPartition() const;

  /** \brief Set what pieces are joined to, for Partition::Pieces (default Objects). */
  void
  setJoiningScale(indoor::JoiningScale scale);

  /** \brief Get the joining scale. */
  indoor::JoiningScale
  getJoiningScale() const;

  /** \brief Set the probability of being one object from which pieces are joined, for
   * Partition::Pieces. Until it is set, they are joined where that gives whole objects,
   * see indoor::bestCut().
   * \param[in] level 0 to 1. Higher gives smaller segments; 1 joins none.
   */
  void
  setJoiningLevel(float level);

  /** \brief Get the joining level, if one was set. */
  std::optional<float>
  getJoiningLevel() const;

  /** \brief Set how many points tell a segment, for Partition::Pieces.
   * \param[in] points default 100; segments of fewer, or of fewer voxels than a
   * supervoxel has, are the remainder, one segment
   */
  void
  setFewestPoints(std::uint32_t points);

  /** \brief Get how many points tell a segment. */
  std::uint32_t
  getFewestPoints() const;

  /** \brief Set k of Partition::FelzenszwalbHuttenlocher.
   * \param[in] scale not negative (default 3). Higher gives larger segments.
   */
  void
  setGraphScale(float scale);

  /** \brief Get the graph scale. */
  float
  getGraphScale() const;

  /** \brief Set C, the smallest segment.
   * \param[in] size supervoxels (default 4); 1 for no minimum
   */
  void
  setMinSegmentSize(std::uint32_t size);

  /** \brief Get the min segment size. */
  std::uint32_t
  getMinSegmentSize() const;

  /** \brief Set up to which difference of normals concave edges count as convex, for
   * the two partitions other than Partition::Pieces.
   * \param[in] degrees 0 to 180 (default 10), as in LCCPSegmentation
   */
  void
  setConcavityToleranceThreshold(float degrees);

  /** \brief Get the concavity tolerance threshold. */
  float
  getConcavityToleranceThreshold() const;

  /** \brief Set all parameters at once, also those without a setter of their own; the
   * partition is Partition::Pieces then. Each parameter that was never set is that of
   * indoor::singleViewOptions() for the view of a table, and the default for all else;
   * getReport() tells which were used.
   */
  void
  setOptions(const indoor::ObjectSegmentationOptions& options);

  /** \brief Set all parameters of the thesis's own method, and its partition. */
  void
  setThesisOptions(const indoor::thesis::ObjectOptions& options);

  /** \brief Get the parameters that all partitions share, as they are for anything but
   * the view of a table. */
  const indoor::ObjectSegmentationOptions&
  getOptions() const;

  /** \brief Get what the last segment() found out about the points, and the options
   * that it used; the warnings were printed, too. */
  const indoor::ObjectReport&
  getReport() const;

  /** \brief Set where the sensor stood, in the frame of the cloud. */
  void
  setViewPoint(double x, double y, double z);

  /** \brief Get where the sensor stood; the origin if it was not set. */
  Eigen::Vector3d
  getViewPoint() const;

  /** \brief Set which direction of the cloud points up, of any length; without meaning
   * for the view of a table. If it is not set, floors, ceilings and walls tell it
   * (indoor::findVertical()): +z where the cloud is level within 1 degree or where
   * they do not tell it; in a camera's view of a room its surfaces
   * (indoor::upOfView()). getReport() has what was used. */
  void
  setUpAxis(const Eigen::Vector3f& axis);

  /** \brief Get the direction up that was set, of unit length; +z if none was. */
  const Eigen::Vector3f&
  getUpAxis() const;

  /** \brief Set which way estimated normals are turned.
   * \param[in] orientation default: to the viewpoint if there is one, else to the free
   * space; Viewpoint needs setViewPoint() or a single camera
   */
  void
  setNormalOrientation(indoor::NormalOrientation orientation);

  /** \brief Get which way estimated normals are turned. */
  indoor::NormalOrientation
  getNormalOrientation() const;

  /** \brief Use voxels that grow with the distance from a single camera looking along
   * z or -z, as for a table.
   * \param[in] use default: for clouds of which indoor::cameraView() tells that they
   * are views of a table
   */
  void
  setUseSingleCameraTransform(bool use);

  /** \brief Get whether voxels grow with the distance: what was set, or else what the
   * input asks for. */
  bool
  getUseSingleCameraTransform() const;

  /** \brief Set who is asked what the points are part of, as classifyVoxels() tells it:
   * pieces are joined by that, too, with JoiningScale::Objects; not for views.
   * \param[in] voter (default nobody) */
  void
  setVoxelVoter(const indoor::VoxelVoter& voter)
  {
    voter_ = voter;
  }

  /** \brief Set the number of threads; the result does not depend on it.
   * \param[in] threads 0 = as many as the machine offers (default 0) */
  void
  setNumberOfThreads(unsigned threads = 0);

  /** \brief Get the number of threads. */
  unsigned
  getNumberOfThreads() const;

  /** \brief Set whom segment() tells how far it is.
   * \param[in] callback given the share of the work, rising from 0 to 1, and the stage
   * that begins; if it returns false, segment() stops, prints nothing and leaves empty
   * outputs (default none)
   */
  void
  setProgressCallback(const indoor::ProgressCallback& callback);

  /** \brief Segment the cloud.
   * \param[out] labels one per point of the input, 1 to the number of segments in the
   * order of their first points; 0 for points that are not finite or not in the
   * indices; empty after an error
   */
  void
  segment(std::vector<std::uint32_t>& labels);

  /** \brief Segment the cloud.
   * \param[out] output the input's coordinates with labels as above, organised as it is
   */
  void
  segment(PointCloud<PointXYZL>& output);

  /** \brief Segment the cloud.
   * \param[out] segments the points of each segment, as indices into the input cloud;
   * empty after an error
   */
  void
  segment(std::vector<PointIndices>& segments);

  /** \brief Start from supervoxels, as LCCPSegmentation does: segment() without output
   * joins them, relabelCloud() gives the segments. See indoor::segmentSupervoxels().
   * \param[in] supervoxels by label, as SupervoxelClustering::extract() gives them
   * \param[in] adjacency of the labels, as getSupervoxelAdjacency() gives it
   */
  template <typename SupervoxelPtr>
  void
  setInputSupervoxels(const std::map<std::uint32_t, SupervoxelPtr>& supervoxels,
                      const std::multimap<std::uint32_t, std::uint32_t>& adjacency)
  {
    given_ = indoor::NamedSupervoxels();
    given_.adjacency = adjacency;
    for (const auto& [label, supervoxel] : supervoxels) {
      given_.names.push_back(label);
      given_.centroids.push_back(supervoxel->centroid_.getVector3fMap());
      given_.normals.push_back(
          indoor::finiteNormal(supervoxel->normal_.getNormalVector3fMap()));
    }
  }

  /** \brief Join the supervoxels that were set. */
  void
  segment();

  /** \brief Replace labels of supervoxels by those of their segments, from 1; 0 where
   * there is no such supervoxel. */
  void
  relabelCloud(PointCloud<PointXYZL>& labeled_cloud) const;

  /** \brief Get the segment of each supervoxel that was set, from 1. */
  const std::map<std::uint32_t, std::uint32_t>&
  getSupervoxelToSegmentMap() const;

  /** \brief Get the points that the last segment() took out and recovered. */
  Indices
  getRemovedIndices() const;

  /** \brief Get the points of floor, ceiling and walls that the last segment() kept out
   * of the graph. Those that an object encloses have its label, see yieldEnclosed(). */
  Indices
  getStructureIndices() const;

  /** \brief Get what each point of the last segment() is of.
   * \return one per point of the input, a StructureKind: 0 an object, or no segment, 1
   * floor, 2 wall, 3 ceiling, 4 remainder; all points of a segment are alike */
  std::vector<std::uint32_t>
  getStructure() const;

  /** \brief Get the segments of the last segment() that joining up to another level
   * would give, before objects are parted at seams.
   * \param[in] level 0.3 to 1; higher gives smaller segments
   * \return one per point of the input, from 1; 0 for points without a segment; empty
   * unless the partition is Partition::Pieces */
  std::vector<std::uint32_t>
  getSegmentsAtLevel(float level) const;

  /** \brief Get the order in which the last segment() would join pieces, with the
   * least probability of each join and all before it: a tree whose leaves are pieces.
   */
  const std::vector<indoor::PieceJoin>&
  getHierarchy() const;

  /** \brief Get the supervoxel of each point of the last segment(), from 1; 0 for
   * points without (taken out, of floor, ceiling or walls, not finite or not in the
   * indices). */
  std::vector<std::uint32_t>
  getSupervoxelLabels() const;

  /** \brief Get the pairs of touching supervoxels of the last segment(), both ways, as
   * SupervoxelClustering gives them. */
  std::multimap<std::uint32_t, std::uint32_t>
  getSupervoxelAdjacency() const;

  /** \brief Get the result of the last segment(), of the points that have segments. */
  const indoor::ObjectSegmentation&
  getResult() const;

protected:
  using PCLBase<PointT>::indices_;
  using PCLBase<PointT>::input_;

private:
  bool
  initCompute();

  /** \brief Change the options for all captures. */
  template <typename Change>
  void
  set(const Change& change);

  /** \brief What is wrong with the parameters; empty if nothing is. */
  std::string
  findProblem() const;

  /** \brief Print a line and keep it in the report, unless it is empty. */
  void
  warn(const std::string& line);

  /** \brief Where the sensor was set to be, or the input says that it was. */
  Eigen::Vector3d
  sensorOrigin() const;

  /** \brief How the input was taken: as was set, or as its points show. */
  indoor::CameraView
  viewOf(const std::vector<Eigen::Vector3f>& points) const;

  indoor::ObjectSegmentationInput
  localInput();

  /** \brief The colour of a point of the input: red, green and blue. */
  Eigen::Vector3f
  colorOf(index_t index) const;

  PointCloudN::ConstPtr normals_;
  PointCloud<RGB>::ConstPtr colors_;
  indoor::ObjectSegmentationOptions options_;
  /** for the view of a table: what was set is set in both */
  indoor::ObjectSegmentationOptions table_options_ = indoor::singleViewOptions();
  Partition partition_ = Partition::Pieces;
  indoor::thesis::EdgeOptions edges_; // for the other partitions
  std::optional<indoor::thesis::PointOptions> on_points_;
  Eigen::Vector3f up_ = Eigen::Vector3f::UnitZ();
  bool up_chosen_ = false;
  indoor::VoxelVoter voter_;
  indoor::ProgressCallback progress_;
  indoor::NamedSupervoxels given_;
  std::map<std::uint32_t, std::uint32_t> segment_of_supervoxel_;
  std::vector<Eigen::Vector3d> viewpoint_; // none or one
  enum class Camera { Automatic, Single, Any } camera_ = Camera::Automatic;
  Indices finite_; // the points that were segmented
  std::size_t input_size_ = 0;
  indoor::ObjectSegmentation result_;
  indoor::ObjectReport report_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/noise_resilient_lccp.hpp>
#endif
