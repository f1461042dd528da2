/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/ml/object_classifier.h>
#include <pcl/segmentation/thesis.h>

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl::indoor {

struct ScanCoordinates;

/** \brief How a scan's coordinates are meant. */
struct PCL_INDOOR_EXPORTS CoordinateOptions {
  std::string unit = "auto"; ///< or m, cm, mm, ft, in
  std::string up = "auto";   ///< or an axis such as -y, or three numbers

  /** \brief 1 if it is to be found. */
  double
  metresPerUnit() const;

  /** \brief Of any length; +z if it is to be found.
   * \throws InputError if it is none of these */
  Eigen::Vector3f
  upAxis() const;

  /** \brief What was to be found becomes what was used. */
  void
  settle(const ScanCoordinates& used);
};

/** \brief What is done to the points of a room before its objects are found (Sec.
 * 2.1.5). */
struct RoomPreparation {
  bool removes_outliers = false; ///< see scanOutliers()
  /** how the normals of points are found that have none: voxels, by the segmentation;
   * rrht, see HoughNormalEstimation; multi_scale, see multiScaleNormals() */
  std::string normals = "voxels";
};

/** \brief Tells what objects are: a network, a service, a rule. */
struct ObjectNaming {
  std::vector<std::string> classes; ///< their names; "other" is that of what is unlike
  /** One Classification per object, with a probability per class, or without any where
   * an object cannot be described. Called from several threads at a time; that of an
   * object is not to depend on the others. */
  std::function<std::vector<Classification>(const std::vector<ClassifierObject>&)>
      classify;
};

/** \brief How a building is described; the defaults are those of pcl_indoor_pipeline.
 */
struct SceneOptions {
  CoordinateOptions scan;
  BuildingRoomsOptions rooms;
  ObjectSegmentationOptions objects;
  /** by the thesis's own methods, in place of rooms and objects; none: by ours */
  std::optional<thesis::RoomOptions> thesis_rooms;
  std::optional<thesis::ObjectOptions> thesis_objects;
  double voxel_resolution = 0.0,   ///< edge of a voxel of the objects, metres; 0 =
                                   ///< automatic: 0.03, more where points are sparse
      seed_resolution = 0.0;       ///< distance of supervoxels, metres; 0 = automatic
  std::string partition = "graph"; ///< or lccp: how supervoxels are joined
  std::string preset = "default";  ///< what the options are called, for the record
  RoomPreparation preparation;
  bool ignore_normals = false; ///< estimate normals although the scan has some
  /** File of a classifier, "bundled" = the one that comes with this library, "none" =
   * no classes. */
  std::string model = "bundled";
  /** Where the bundled voxel network votes on what is building and, with the bundled
   * model, on names: "auto" = in rooms whose ceiling was not seen, "all" or "none". */
  std::string network = "auto";
  ObjectNaming naming;     ///< used in place of the model, if it has a function
  int threads = 0;         ///< 0 = automatic; the result does not depend on it
  std::string work_folder; ///< where large scans are divided into their rooms; empty:
                           ///< the system's folder for such files
  /** Is told the stage and how far it is; may be empty. */
  std::function<void(const std::string& stage, std::size_t done, std::size_t all)>
      progress;
};

/** \brief Rooms and objects by the methods of the thesis with their parameters, and no
 * more. */
PCL_INDOOR_EXPORTS SceneOptions
thesisSceneOptions();

} // namespace pcl::indoor
