/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/segmentation/segmentation_metrics.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief Average precision of predicted segments, without classes, over one or several
 * scenes.
 *
 * The predictions of all scenes are taken by falling confidence. Each is right if a
 * true segment that no prediction before it took overlaps it by at least the threshold
 * (intersection over union); it takes the one that it overlaps best. After each
 * confidence there is a recall and a precision of all predictions so far; average
 * precision is the area below the largest precision at each recall or above.
 *
 * Points whose true label is 0, and those of true segments that are too small, are
 * void: they are in no intersection and in no union. A prediction of which half or more
 * is void counts only where it is right. Time O(points log points) per scene.
 */
class AveragePrecision {
public:
  /** \brief Add a scene.
   * \param[in] truth, predicted labels, one per point each
   * \param[in] min_size true segments of fewer points are void
   * \param[in] counted labels of the true segments to score, others are void; none:
   * all
   * \param[in] confidences of predicted segments, by label; segments that are not
   * named have the number of their points, so that larger ones come first
   * \throws pcl::BadArgumentException if the numbers of labels differ or a confidence
   * is not finite
   */
  void
  add(const SegmentLabels& truth,
      const SegmentLabels& predicted,
      std::size_t min_size = 1,
      const std::vector<std::uint32_t>& counted = {},
      const std::map<std::uint32_t, double>& confidences = {});

  /** \brief Add the scenes of another one. */
  AveragePrecision&
  operator+=(const AveragePrecision& other);

  /** \brief Get the average precision at one threshold.
   * \param[in] percent least intersection over union (1 to 100): 50 for AP50
   * \return 0 to 1; 1 if there is neither truth nor prediction, 0 if either is missing
   */
  double
  at(unsigned percent) const;

  /** \brief Get the mean over the thresholds 50, 55 ... 95 %: AP. */
  double
  mean() const;

private:
  struct Match {
    std::size_t truth; ///< number of the true segment, over all scenes
    std::size_t intersection, union_size;
  };
  struct Prediction {
    double confidence;
    bool mostly_void;
    std::vector<Match> matches; ///< the best first
  };
  std::size_t true_count_ = 0;
  std::vector<Prediction> predictions_;
};

} // namespace indoor
} // namespace pcl
