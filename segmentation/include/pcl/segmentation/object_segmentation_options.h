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

namespace pcl::indoor {

/** \brief What pieces are joined to. */
enum class JoiningScale {
  Parts,   ///< parts of chairs and sofas, as a seat, a back and an arm; else whole
           ///< objects
  Objects, ///< whole objects
  View     ///< small objects in a camera's view, as on a table
};

/** \brief How pieces are joined. */
struct PieceOptions {
  JoiningScale scale = JoiningScale::Objects; ///< what the pieces are joined to
  /** least probability that two pieces are one object for them to be joined (0 to 1);
   * higher gives smaller segments. None: they are joined where that gives whole
   * objects, see bestCut(); for JoiningScale::View from levelOf() on */
  std::optional<float> joining_level;
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
  PieceOptions pieces;
  /** C: smaller segments are joined to a neighbour, or taken up in the recovery;
   * supervoxels */
  std::uint32_t min_segment_size = 4;
  /** segments of fewer points, or of fewer voxels than a supervoxel has, are too small
   * to be told: together they are the remainder, one segment */
  std::uint32_t fewest_points = 100;
  unsigned threads = 0; ///< 0 = automatic; the result does not depend on it
};

/** \brief The sizes to work with where points are dense enough: those that are 0 follow
 * from the other, or are 3 and 12 cm, with JoiningScale::View 5 mm and 2 cm. */
PCL_INDOOR_EXPORTS ObjectSegmentationOptions
withSizes(ObjectSegmentationOptions options);

/** \brief Parts of objects, as the seat and the back of a chair, instead of whole
 * objects: JoiningScale::Parts. */
PCL_INDOOR_EXPORTS ObjectSegmentationOptions
partsOptions();

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

} // namespace pcl::indoor
