/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "text/stage_report.h"

#include <pcl/indoor/exports.h>
#include <pcl/ml/object_context.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Objects with their classes, as read from a folder of folders. */
struct LabelledObjects {
  std::vector<std::string> paths; ///< relative to the folder, sorted
  std::vector<PointCloud<PointNormal>::Ptr> clouds;
  std::vector<ObjectPlace> places; ///< unknown where the files have none
  std::vector<int> labels;         ///< index into class_names
  std::vector<std::string> class_names;
};

/** \brief Complain about the first of some problems, and say how many there are.
 * \param[in] problems one for each that is asked about, empty for those
 * without
 * \param[in] what those with a problem are called, for example "unreadable
 * files"
 * \throws ToolError if there are any
 */
PCL_INDOOR_EXPORTS void
requireNoProblems(const std::vector<std::string>& problems, const std::string& what);

/** \brief Read DIR/CLASS/.../OBJECT.pcd, .ply, .off or .obj; folders within a class
 * folder do not matter.
 * \param[in] number_of_threads 0: as many as the machine has
 * \throws ToolError if a file is unusable, naming the first and their number, or fewer
 * than two classes are found
 */
PCL_INDOOR_EXPORTS LabelledObjects
loadLabelledObjects(const std::string& folder,
                    int neighbor_count,
                    unsigned int number_of_threads,
                    StageReport& report);

/** \brief Which objects to train with and which to test with, as ascending indices. */
struct ObjectSplit {
  std::vector<std::size_t> training;
  std::vector<std::size_t> test;
};

/** \brief A random share of each class, but at least one object of it on both sides.
 * \param[in] share of the training part, between 0 and 1
 * \throws ToolError if a class has only one object
 */
ObjectSplit
splitAtRandom(const LabelledObjects& objects, double share, std::uint32_t seed);

/** \brief By the folders "train" and "test" in each class folder, as in ModelNet.
 * \throws ToolError if an object lies in neither, or one part is empty
 */
ObjectSplit
splitByFolders(const LabelledObjects& objects);

/** \brief By a list of the test part, one name per line.
 *
 * A line names an object by its path, its file's name, either without extension, or by
 * the part of that name before a "_": "scene0011_00" are all objects of that scan.
 * \param[in] list_path of the file with the names; empty lines do not count
 * \throws ToolError if it cannot be read or names no object, or all
 */
ObjectSplit
splitByList(const LabelledObjects& objects, const std::string& list_path);

/** \brief The share X of a split "random:X"; empty for any other.
 * \throws ToolError if it is not between 0 and 1
 */
PCL_INDOOR_EXPORTS std::optional<double>
randomShare(const std::string& split);

/** \brief The split that a text names: "none" trains with all objects, "random:X" with
 * a share, "folders", or the path of a list.
 * \throws ToolError as the splits, and if a class has no object to train with
 */
PCL_INDOOR_EXPORTS ObjectSplit
splitNamed(const LabelledObjects& objects,
           const std::string& split,
           std::uint32_t seed);

/** \brief A random share of each class of a training part, set aside as test part.
 * \param[in] share 0 = none; else as splitAtRandom()
 */
PCL_INDOOR_EXPORTS ObjectSplit
withoutShare(const LabelledObjects& objects,
             const std::vector<std::size_t>& training,
             double share,
             std::uint32_t seed);

} // namespace pcl::indoor::tool
