/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "text/stage_report.h"

#include <pcl/indoor/exports.h>
#include <pcl/ml/classifier_model.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace pcl::indoor::tool {

/** \brief A file that holds one object. */
struct ObjectFile {
  std::string path;
  std::string
      true_class; ///< the folder in a folder that it lies in; empty if not known
};

/** \brief The clouds of a folder, sorted; FOLDER/CLASS/OBJECT.pcd is of the class
 * CLASS.
 * \throws ToolError if it is no folder or holds none
 */
PCL_INDOOR_EXPORTS std::vector<ObjectFile>
objectsOfFolder(const std::string& folder);

/** \brief The files of a command line's files and folders, of which no file is looked
 * for.
 * \throws ToolError if a folder holds none
 */
PCL_INDOOR_EXPORTS std::vector<ObjectFile>
objectFiles(const std::vector<std::string>& paths);

/** \brief Names of classes and confidences. */
using Classes = std::vector<std::pair<std::string, float>>;

/** \brief What a file's object was taken for. */
struct ClassifiedFile {
  ObjectFile file;
  Classes top; ///< all classes above 0, the likeliest first; none if it cannot be
               ///< described
};

/** \brief Number names in their order.
 * \return the names
 */
std::vector<std::string>
numberNames(std::map<std::string, int>& numbers);

/** \brief By what objects are compared without a model. */
enum class NearestDescriptor { PairHarmonics, PointNN };

/** \brief Settings of reading and describing. */
struct ClassificationSettings {
  NearestDescriptor descriptor = NearestDescriptor::PairHarmonics; ///< without a model
  int neighbor_count = 20;  ///< of normals that have to be estimated
  unsigned int threads = 0; ///< 0: all
};

/** \brief Classify by a trained model. Where an object is in its room is known only if
 * its file has the fields that saveObject() writes.
 * \throws ToolError if a file is unusable
 */
PCL_INDOOR_EXPORTS std::vector<ClassifiedFile>
classifyByModel(const std::vector<ObjectFile>& files,
                const ClassifierModel& model,
                const ClassificationSettings& settings,
                StageReport& report);

/** \brief Classify by known objects.
 *
 * By pair harmonics: the confidence of a class is its share of 1 / distance^2
 * (symmetric Kullback-Leibler) of each class's nearest object. By Point-NN: it is the
 * class's score of pointNNScores(), and the pose of objects matters. A file is not
 * compared with itself, so that a folder can be compared with itself.
 * \param[in] known each with its true class
 * \throws ToolError if a file is unusable or none of a class
 */
PCL_INDOOR_EXPORTS std::vector<ClassifiedFile>
classifyByNearest(const std::vector<ObjectFile>& files,
                  const std::vector<ObjectFile>& known,
                  const ClassificationSettings& settings,
                  StageReport& report);

/** \brief A line per file: file, class, confidence, next likely classes; then, if true
 * classes are known, accuracy and confusion. */
PCL_INDOOR_EXPORTS std::string
classificationText(const std::vector<ClassifiedFile>& files);

/** \brief A list with file, class, confidence and top (up to three) of each file, and
 * its true class where it is known. */
PCL_INDOOR_EXPORTS std::string
classificationJson(const std::vector<ClassifiedFile>& files);

} // namespace pcl::indoor::tool
