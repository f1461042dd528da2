/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/segmentation/object_segmentation.h>

#include <string>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief What was found out about the points of an object segmentation. */
struct ObjectReport {
  std::vector<std::string> warnings; ///< a line each: what is odd, and what mends it
  ObjectSegmentationOptions options; ///< that were used, with their sizes
  CameraView view;                   ///< how the points were taken
  /** The direction up that was used, of unit length; of a camera's view see the scene
   * of NoiseResilientLCCP::getResult(). */
  Eigen::Vector3f up_axis = Eigen::Vector3f::UnitZ();
};

/** \brief Warn if nearly all points, of many, are one segment: right for one thing.
 * \return one line; empty if not
 */
std::string
oneSegmentWarning(const ObjectSegmentation& result);

/** \brief Warn if the largest thing is no larger than what stands on a table, see
 * isTableTop(), but of ten pieces or more: probably it is many small things.
 * \return one line; empty if not, and with JoiningScale::View, which is for such things
 */
std::string
tableTopWarning(const ObjectSegmentation& result);

/** \brief Warn if the largest thing is more than 4 m wide both ways: probably several
 * rooms, or one whose walls were not told from its things.
 * \return one line; empty if not, and with JoiningScale::View
 */
std::string
wideThingWarning(const ObjectSegmentation& result);

/** \brief Warn that some points are so far from the others that they get no segment.
 * \return one line; empty if there are none
 */
std::string
straysWarning(std::size_t strays, std::size_t all);

/** \brief Say that the points are taken as what a camera sees, and how it looks: from y
 * up and z ahead, as engines for games have it, floors would be ceilings.
 * \return one line; empty for a scan
 */
std::string
cameraNote(const CameraView& view);

/** \brief Warn if what a camera looks at is farther off than a depth camera sees.
 * \param[in] input a view; of others nothing is known
 * \return one line; empty if not
 */
std::string
farViewWarning(const ObjectSegmentationInput& input);

} // namespace indoor
} // namespace pcl
