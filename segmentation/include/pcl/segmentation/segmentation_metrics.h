/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/exports.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace pcl::indoor {

/** \brief Labels of a segmentation, one per point; 0 = no segment. */
using SegmentLabels = std::vector<std::uint32_t>;

/** \brief How many points have a pair of labels in two segmentations. */
struct Overlap {
  std::uint32_t truth = 0;
  std::uint32_t predicted = 0;
  std::size_t count = 0;
};

/** \brief Count the points of each pair of labels.
 * Points whose true label is 0 are left out, as in all metrics here; those whose
 * predicted label is 0 are counted.
 * \return pairs that occur, in ascending order of (truth, predicted)
 * \throws pcl::BadArgumentException if the numbers of labels differ
 */
PCL_INDOOR_EXPORTS std::vector<Overlap>
countOverlaps(const SegmentLabels& truth, const SegmentLabels& predicted);

/** \brief Share of the pairs of points on which two segmentations agree (Rand index,
 * Sec. 2.1.8.1). Here, points predicted 0 count as one segment.
 * \return 0 to 1; 1 for less than two points
 */
PCL_INDOOR_EXPORTS double
randIndex(const std::vector<Overlap>& overlaps);

/** \brief Rand index corrected for chance (Hubert and Arabie, 1985).
 * \return 1 if equal, about 0 for random labels; 1 if both are trivial in the same way
 */
PCL_INDOOR_EXPORTS double
adjustedRandIndex(const std::vector<Overlap>& overlaps);

/** \brief Over- and undersegmentation of Richtsfeld et al. (Eq. (2.23), (2.24)). */
struct SegmentationErrors {
  double over = 0;  ///< share of points outside of their segment's best prediction
  double under = 0; ///< foreign points in best predictions, per point; may exceed 1
};

/** \brief Compare each true segment with the predicted segment that holds most of it.
 * With M_i points in the true segment, P_i in its predicted one and PT_i in both, the
 * errors are those of Eq. (4.5) and (4.6). Points predicted 0 are never right. Of equal
 * overlaps the smaller predicted segment is taken, then the smaller label.
 * \return zeros if no point has a true label
 */
PCL_INDOOR_EXPORTS SegmentationErrors
richtsfeldErrors(const std::vector<Overlap>& overlaps);

/** \brief Mean over points of the best intersection over union of their true segment
 * (Eq. (2.25), (2.26), which is printed without the number of points).
 * \return 0 to 1; 1 if no point has a true label
 */
PCL_INDOOR_EXPORTS double
weightedOverlap(const std::vector<Overlap>& overlaps);

/** \brief Merge fine true segments to the scale of the prediction (Algorithm 2).
 * Fine segments become one if most of their points have the same prediction, and they
 * belong to the same coarse segment.
 * \param[in] fine labels of parts; 0 is left out
 * \param[in] coarse labels of objects; a part belongs to that of most of its points
 * \return one label per point: the smallest fine label of the merged segment, or 0
 * \throws pcl::BadArgumentException if the numbers of labels differ
 */
PCL_INDOOR_EXPORTS SegmentLabels
mergeFineSegments(const SegmentLabels& fine,
                  const SegmentLabels& coarse,
                  const SegmentLabels& predicted);

/** \brief Multi-scale over- and undersegmentation (Sec. 4.3.1.2, Eq. (4.5), (4.6)). */
PCL_INDOOR_EXPORTS SegmentationErrors
multiScaleErrors(const SegmentLabels& fine,
                 const SegmentLabels& coarse,
                 const SegmentLabels& predicted);

/** \brief How well objects were found as wholes, over one or several scenes. */
struct PCL_INDOOR_EXPORTS ObjectScore {
  std::size_t true_count = 0;      ///< true segments that are large enough
  std::size_t predicted_count = 0; ///< predicted segments that are not void
  std::size_t right_count = 0;     ///< pairs with intersection over union above 0.5
  double iou_sum = 0;              ///< of these pairs
  /** true segments of which a prediction covers 80 % or more, and that are 70 % or more
   * of it, void points included */
  std::size_t whole_count = 0;
  ObjectScore&
  operator+=(const ObjectScore& other);

  /** \brief Panoptic quality without classes (Kirillov et al., CVPR 2019): iou_sum over
   * the mean of true and predicted counts; 0 to 1, 1 if there is nothing. */
  double
  panopticQuality() const;

  /** \brief Segmentation quality, the first factor of panoptic quality: mean
   * intersection over union of the right pairs; 0 if there are none. */
  double
  segmentationQuality() const;

  /** \brief Recognition quality, its second factor: right pairs over the mean of true
   * and predicted counts (the F1 score); 1 if there is nothing. */
  double
  recognitionQuality() const;

  /** \brief Share of the true segments that are right, and of the predicted ones; 1 if
   * there are none. */
  double
  recall() const;
  double
  precision() const;

  /** \brief Share of true segments that were found whole; 1 if there is none. */
  double
  wholeShare() const;
};

/** \brief Compare true objects with predicted segments. Void points, whose true label
 * is 0 or that of a segment of fewer than min_size points, count neither for nor
 * against a prediction; a prediction of which half or more is void is not counted
 * unless it is right.
 * \param[in] counted labels of the true objects to score; others
 * are void; empty: all
 * \throws pcl::BadArgumentException if the numbers of labels
 * differ
 */
PCL_INDOOR_EXPORTS ObjectScore
scoreObjects(const SegmentLabels& truth,
             const SegmentLabels& predicted,
             std::size_t min_size = 100,
             const std::vector<std::uint32_t>& counted = {});

/** \brief How well whole segments, for example rooms, were found. */
struct DetectionScore {
  std::size_t true_count = 0;
  std::size_t predicted_count = 0;
  std::size_t right_count = 0; ///< true segments with intersection over union >= 0.5
  double mean_iou = 0; ///< over the true segments, each prediction used once at most
  /** Mean over the true segments of the share that the prediction covering most of it
   * covers (Bormann et al., Room Segmentation: Survey, Implementation, and Analysis,
   * ICRA 2016). */
  double recall = 0;
  /** Mean over the predicted segments of the share that lies in one true segment. */
  double precision = 0;
};

/** \brief Match true and predicted segments one to one, best overlap first. */
PCL_INDOOR_EXPORTS DetectionScore
scoreDetections(const std::vector<Overlap>& overlaps);

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
class PCL_INDOOR_EXPORTS AveragePrecision {
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

} // namespace pcl::indoor
