/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/segmentation/building_frame.h>
#include <pcl/segmentation/building_rooms.h>
#include <pcl/segmentation/scan_warnings.h>
#include <pcl/segmentation/thesis.h>

#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/PointIndices.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief How pcl::RoomSegmentation tells the rooms of a storey apart. */
enum class RoomMethod {
  CeilingSlab, ///< in a slab below the ceiling, where walls and lintels close the rooms
  PotentialField ///< by the potential field and HDBSCAN: thesis::segmentBuilding()
};

} // namespace indoor

/** \brief Segments the points of a building, or of a part of it, into rooms.
 *
 * Walls, and the lintels over doorways, reach the ceiling, furniture seldom does: in a
 * slab right below the ceiling the rooms lie closed and empty. Neither sensor poses,
 * nor normals, nor walls at right angles are needed.
 *
 * Time and memory are linear in the points and in the voxels of the space they occupy.
 * \note D. Bobkov, Semantic Understanding of 3D Point Clouds of Indoor Environments,
 * Technical University of Munich, 2019, chapter 3; docs/method/rooms.md lists
 * deviations. \ingroup segmentation
 */
template <typename PointT>
class RoomSegmentation : public PCLBase<PointT> {
public:
  using Ptr = shared_ptr<RoomSegmentation<PointT>>;
  using ConstPtr = shared_ptr<const RoomSegmentation<PointT>>;
  using PointCloud = typename PCLBase<PointT>::PointCloud;

  /** \brief Set the side of a voxel, which is also that of a map pixel.
   * Smaller voxels separate rooms by thinner walls. With the automatic size, surfaces
   * of sparse points are closed between neighbouring points.
   * \param[in] voxel_size metres, at least 0.0001, or 0 = automatic: 0.1, up to 0.4
   * where surfaces have holes nevertheless (default 0); getReport() has what was used
   */
  void
  setVoxelSize(double voxel_size)
  {
    options_.voxel_size = voxel_size;
  }

  double
  getVoxelSize() const
  {
    return options_.voxel_size;
  }

  /** \brief Set the area below which a space is no room.
   * \param[in] area m^2, at least 0 (default 0.5)
   */
  void
  setMinRoomArea(double area)
  {
    options_.map.min_area = area;
  }

  double
  getMinRoomArea() const
  {
    return options_.map.min_area;
  }

  /** \brief Set the width below which a space is no room.
   * \param[in] width metres, at least 0 (default 0.5)
   */
  void
  setMinRoomWidth(double width)
  {
    options_.map.min_width = width;
  }

  double
  getMinRoomWidth() const
  {
    return options_.map.min_width;
  }

  /** \brief Set how narrow the passage between two spaces must be to part them.
   * \param[in] persistence width of the passage over the width of the narrower space,
   * 0 ... 1; larger gives more rooms (default 0.5)
   */
  void
  setPersistence(double persistence)
  {
    options_.map.persistence = persistence;
  }

  double
  getPersistence() const
  {
    return options_.map.persistence;
  }

  /** \brief Set how open the border between two spaces must be to join them.
   * \param[in] share area of the opening over that of the border or of the smaller
   * space's widest section, whichever is larger, 0 ... 1; larger gives more rooms
   * (default 0.55)
   */
  void
  setOpenShare(double share)
  {
    options_.map.merging.open_share = share;
  }

  double
  getOpenShare() const
  {
    return options_.map.merging.open_share;
  }

  /** \brief Set the area from which spaces without a door between them may be rooms of
   * their own: see indoor::OpenPlanOptions.
   * \param[in] area m^2, at least 0; infinity joins all open spaces (default 6.5)
   */
  void
  setHabitableArea(double area)
  {
    options_.map.open_plan.habitable_area = area;
  }

  double
  getHabitableArea() const
  {
    return options_.map.open_plan.habitable_area;
  }

  /** \brief Set how rooms are told apart.
   * \param[in] method (default CeilingSlab)
   */
  void
  setMethod(indoor::RoomMethod method)
  {
    method_ = method;
  }

  indoor::RoomMethod
  getMethod() const
  {
    return method_;
  }

  /** \brief Set the weights of the evidence for interior space, Eq. (3.1): w1 (below),
   * w2 (above), w3 (vertical), w4 + w5 (horizontal), and what speaks for the exterior.
   * \param[in] weights 0 to 80 each (defaults: see indoor::EnclosureWeights)
   */
  void
  setEnclosureWeights(const indoor::EnclosureWeights& weights)
  {
    options_.interior.weights = weights;
  }

  const indoor::EnclosureWeights&
  getEnclosureWeights() const
  {
    return options_.interior.weights;
  }

  /** \brief Set the smallest cluster of RoomMethod::PotentialField.
   * \param[in] area m^2, above 0 (default 2)
   */
  void
  setMinClusterArea(double area)
  {
    field_.min_cluster_area = area;
  }

  double
  getMinClusterArea() const
  {
    return field_.min_cluster_area;
  }

  /** \brief Set the neighbourhood of the core distance of RoomMethod::PotentialField.
   * \param[in] area m^2, above 0; larger leaves out more pixels between clusters
   * (default 0.4)
   */
  void
  setSampleArea(double area)
  {
    field_.sample_area = area;
  }

  double
  getSampleArea() const
  {
    return field_.sample_area;
  }

  /** \brief Set the number of threads; the result does not depend on it.
   * \param[in] threads 0 = as many as the machine offers (default 0)
   */
  void
  setNumberOfThreads(unsigned threads = 0)
  {
    options_.threads = static_cast<int>(std::min(threads, 1024u));
  }

  unsigned
  getNumberOfThreads() const
  {
    return static_cast<unsigned>(options_.threads);
  }

  /** \brief Set which direction of the cloud points up, of any length. If it is not
   * set, floors, ceilings and walls tell it (indoor::findVertical()): +z where the
   * cloud is level within 1 degree or where they do not tell it. If the passages
   * between the rooms hang from ceilings then, the rooms are found once more the other
   * way up; see also setEndFinder(). getReport() has what was used.
   */
  void
  setUpAxis(const Eigen::Vector3f& axis)
  {
    up_axis_ = axis;
    coordinates_.reset();
  }

  /** \brief The axis that was set; +z if none was. */
  Eigen::Vector3f
  getUpAxis() const
  {
    return up_axis_.value_or(Eigen::Vector3f::UnitZ());
  }

  /** \brief Set the unit of the cloud. Positions of the results are in it; lengths,
   * areas and volumes of the results and of all parameters are in metres. If it is not
   * set it is the metre, but for clouds whose rooms would be higher than 50 m; see
   * getReport().
   * \param[in] metres greater than 0, for example 0.001 for millimetres
   */
  void
  setMetresPerUnit(double metres)
  {
    metres_per_unit_ = metres;
    coordinates_.reset();
  }

  /** \brief The unit that was set; 1 if none was. */
  double
  getMetresPerUnit() const
  {
    return metres_per_unit_.value_or(1.0);
  }

  /** \brief Give what indoor::scanCoordinates() has found for the same points, up axis
   * and unit, so that segment() need not look for it again: after these were set, which
   * makes it void, and anew for other points. */
  void
  setCoordinates(const indoor::ScanCoordinates& coordinates)
  {
    coordinates_ = coordinates;
  }

  /** \brief Set who is asked which end is up where neither furniture nor passages
   * tell it beyond doubt and no axis is set; after the rooms were found, which are
   * found once more if it is the other one.
   * \param[in] finder (default none)
   */
  void
  setEndFinder(const indoor::EndFinder& finder)
  {
    end_finder_ = finder;
  }

  /** \brief Give where the scanner stood, and as far as it is known from where it
   * measured which point of the input cloud. What no station looked into but through
   * walls, panes or windows is no room then.
   * \param[in] stations in the frame and the unit of the cloud (default none)
   */
  void
  setStations(const indoor::ScanStations& stations)
  {
    stations_ = stations;
  }

  const indoor::ScanStations&
  getStations() const
  {
    return stations_;
  }

  /** \brief Set whom segment() tells how far it is.
   * \param[in] callback given the share of the work, rising from 0 to 1, and the stage
   * that begins; if it returns false, segment() stops, prints nothing and leaves empty
   * outputs (default none). From the call with 0 to that with 1 the input cloud is not
   * read: its points may be elsewhere meanwhile
   */
  void
  setProgressCallback(const indoor::ProgressCallback& callback)
  {
    progress_ = callback;
  }

  /** \brief All parameters that both methods share, also those without a setter. */
  const indoor::BuildingRoomsOptions&
  getOptions() const
  {
    return options_;
  }

  /** \brief Set all of them; the method is RoomMethod::CeilingSlab then. */
  void
  setOptions(const indoor::BuildingRoomsOptions& options)
  {
    setThesisOptions({options, {}});
    method_ = indoor::RoomMethod::CeilingSlab;
  }

  /** \brief Set all parameters of RoomMethod::PotentialField, and this method. */
  void
  setThesisOptions(const indoor::thesis::RoomOptions& options)
  {
    options_ = options.shared;
    field_ = options.field;
    point_rooms_ = options.point_rooms;
    method_ = indoor::RoomMethod::PotentialField;
  }

  /** \brief Find the rooms.
   * \param[out] labels room of each point of the input cloud, in its order: 1 ... n; 0
   * for points in no room, not finite, or not in the indices; empty after an error
   */
  void
  segment(std::vector<std::uint32_t>& labels);

  /** \brief Find the rooms.
   * \param[out] rooms the points of each room, as indices into the input cloud; empty
   * after an error
   */
  void
  segment(std::vector<PointIndices>& rooms);

  /** \brief Find the rooms.
   * \param[out] output the input's coordinates with the rooms as labels, organised as
   * it is; empty after an error
   */
  void
  segment(pcl::PointCloud<PointXYZL>& output);

  /** \brief The voxel size, up axis and unit that the last run used, which points it
   * left out, and its warnings, which were printed, too: a tilted cloud, an unlikely
   * unit, coordinates too coarse for the voxels, many points left out. */
  const indoor::ScanReport&
  getReport() const
  {
    return report_;
  }

  /** \brief The rooms of the last run, by label, in the frame of the input cloud. */
  const std::vector<indoor::Room>&
  getRooms() const
  {
    return rooms_;
  }

  /** \brief Where one can pass from room to room, in the frame of the input cloud. */
  const std::vector<indoor::RoomOpening>&
  getOpenings() const
  {
    return openings_;
  }

  /** \brief The rooms of the last run with their maps, in the building's frame: z up,
   * the origin near the points. */
  const indoor::BuildingRooms&
  getBuilding() const
  {
    return building_;
  }

  /** \brief Hand over what getBuilding() gives, which is empty then: of large buildings
   * there is no memory for two. */
  indoor::BuildingRooms
  takeBuilding()
  {
    return std::exchange(building_, {});
  }

  /** \brief How the building's frame lies in that of the cloud. */
  const indoor::BuildingFrame&
  getBuildingFrame() const
  {
    return frame_;
  }

protected:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;

  /** \brief Check input and parameters; shadows the base's, which accepts anything. */
  bool
  initCompute();

private:
  /** \brief Note and print what is wrong; empty lines are nothing. */
  void
  warn(const std::string& line);

  /** \brief Find up axis and unit, if they are not set. */
  void
  findCoordinates(const std::vector<Eigen::Vector3f>& points);

  /** \brief The usable points in the building's frame; what is amiss is said.
   * \param[out] indices of these points in the cloud; null if it has no others
   */
  std::vector<Eigen::Vector3f>
  pointsOfBuilding(IndicesConstPtr& indices);

  /** \brief The stations in the building's frame.
   * \param[in] indices of the points; none: those of the cloud */
  indoor::ScanStations
  stationsOfBuilding(const Indices& indices) const;

  using FindRooms = std::function<indoor::BuildingRooms()>; ///< of the points

  /** \brief Take the scan the other way up if passages hang from ceilings now and stand
   * on floors then, or if the end finder says so; not if the up axis is set.
   * \param[in,out] points in the building's frame, which is turned
   */
  void
  turnIfUpsideDown(std::vector<Eigen::Vector3f>& points, const FindRooms& find);

  /** \brief Turn the building's frame the other way up. */
  void
  turnOver(std::vector<Eigen::Vector3f>& points);

  void
  turnIfPassagesStand(std::vector<Eigen::Vector3f>& points, const FindRooms& find);

  /** \brief Ask the end finder, and turn the scan if it says so. */
  void
  askEndFinder(std::vector<Eigen::Vector3f>& points, const FindRooms& find);

  /** \brief The note in place of that on the vertical as it was found. */
  void
  replaceVerticalNote(const std::string& note);

  /** \brief Report what was shown of the points; no indices: those of the cloud. */
  void
  describeInput(const Indices& indices);

  indoor::BuildingRoomsOptions options_;
  indoor::RoomMethod method_ = indoor::RoomMethod::CeilingSlab;
  indoor::thesis::FieldRoomsOptions field_; // of RoomMethod::PotentialField
  indoor::thesis::PointRooms point_rooms_ = indoor::thesis::PointRooms::WallSides;
  std::optional<Eigen::Vector3f> up_axis_;
  std::optional<double> metres_per_unit_;
  std::optional<indoor::ScanCoordinates> coordinates_; ///< found before
  indoor::ScanStations stations_;
  indoor::ProgressCallback progress_;
  indoor::EndFinder end_finder_;
  indoor::ScanReport report_;
  indoor::BuildingRooms building_;
  std::vector<indoor::Room> rooms_;
  std::vector<indoor::RoomOpening> openings_;
  indoor::BuildingFrame frame_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/room_segmentation.hpp>
#endif
