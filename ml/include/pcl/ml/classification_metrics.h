/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::indoor {

/** \brief How often an object of one class was taken for another, Sec. 2.1.8.2. */
struct PCL_INDOOR_EXPORTS ConfusionMatrix {
  std::size_t class_count = 0;
  std::vector<std::size_t> counts;  ///< row: true class, column: predicted class
  std::vector<std::size_t> unknown; ///< per true class: objects without a prediction

  std::size_t
  at(std::size_t truth, std::size_t predicted) const
  {
    return counts[truth * class_count + predicted];
  }

  /** \brief Objects of a class. */
  std::size_t
  objectCount(std::size_t truth) const;
};

/** \brief Count predictions.
 * \param[in] truth,predicted classes 0 ... class_count - 1, one per object; predicted
 * may be negative for none
 * \throws pcl::BadArgumentException if the lengths differ or a class is out of range
 */
PCL_INDOOR_EXPORTS ConfusionMatrix
confusionMatrix(const std::vector<int>& truth,
                const std::vector<int>& predicted,
                std::size_t class_count);

/** \brief Scores of a class, Eq. (2.27) to (2.29); 0 where nothing was counted. */
struct ClassScores {
  double precision = 0.0;
  double recall = 0.0;
  double f1 = 0.0;
};

/** \brief Scores of a classification, each in 0 ... 1. */
struct ClassificationScores {
  double total_accuracy = 0.0; ///< right predictions / objects
  double mean_accuracy =
      0.0; ///< mean over the classes of their right share of predictions
  double mean_recall = 0.0; ///< mean over the classes of their right share of objects
  double f1 = 0.0;          ///< mean over the classes of F1, Eq. (2.29)
  std::vector<ClassScores> classes;
};

/** \brief Scores of a confusion matrix.
 *
 * Means are over the classes that have objects. The thesis says of its mean accuracy
 * only that it is averaged over the classes; as it differs there from the mean recall,
 * it is read as the mean of Eq. (2.27), the precision.
 */
PCL_INDOOR_EXPORTS ClassificationScores
classificationScores(const ConfusionMatrix& confusion);

/** \brief A confusion matrix as a table of text, in per cent of each row as Table 2.1.
 * \param[in] names one per class
 * \throws pcl::BadArgumentException if there are not as many names as classes
 */
PCL_INDOOR_EXPORTS std::string
confusionText(const ConfusionMatrix& confusion, const std::vector<std::string>& names);

/** \brief Mean and standard deviation of repeated measurements. */
struct Spread {
  double mean = 0.0;
  double deviation = 0.0; ///< of the sample (n - 1); 0 for fewer than two
};

/** \brief Mean and standard deviation of values; zeros for none. */
PCL_INDOOR_EXPORTS Spread
spreadOf(const std::vector<double>& values);

} // namespace pcl::indoor
