/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/exceptions.h>
#include <pcl/segmentation/segmentation_metrics.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace pcl::indoor;

namespace {

SegmentLabels
randomLabels(std::size_t count, unsigned highest, std::mt19937& rng)
{
  SegmentLabels labels;
  for (std::size_t i = 0; i < count; ++i)
    labels.push_back(static_cast<std::uint32_t>(rng() % (highest + 1)));
  return labels;
}

} // namespace

TEST(SegmentationMetrics, MultiScaleErrorsOfTheWorkedExample)
{
  // Fig. 4.7: ten points in seven fine segments. Eq. (4.8) tells that the fourth, of
  // one point, has the prediction of the first three: the merged segments have 5, 1, 2
  // and 2 points and the predicted ones 6, 2 and 2.
  const SegmentLabels fine{1, 1, 2, 2, 3, 4, 5, 5, 6, 7};
  const SegmentLabels coarse{1, 1, 1, 1, 1, 4, 5, 5, 5, 5};
  const SegmentLabels predicted{11, 11, 11, 11, 11, 11, 13, 13, 14, 14};
  EXPECT_EQ(mergeFineSegments(fine, coarse, predicted),
            (SegmentLabels{1, 1, 1, 1, 1, 4, 5, 5, 6, 6}));
  const auto errors = multiScaleErrors(fine, coarse, predicted);
  EXPECT_DOUBLE_EQ(errors.over, 0);
  EXPECT_DOUBLE_EQ(errors.under, 0.6);
}

TEST(SegmentationMetrics, RandIndexAgreesWithCountingAllPairs)
{
  std::mt19937 rng(1);
  for (int trial = 0; trial < 30; ++trial) {
    const auto truth = randomLabels(40, 4, rng), predicted = randomLabels(40, 5, rng);
    double agree = 0, all = 0;
    for (std::size_t i = 0; i < truth.size(); ++i)
      for (std::size_t j = i + 1; j < truth.size(); ++j) {
        if (truth[i] == 0 || truth[j] == 0)
          continue;
        agree += (truth[i] == truth[j]) == (predicted[i] == predicted[j]);
        ++all;
      }
    EXPECT_NEAR(randIndex(countOverlaps(truth, predicted)), agree / all, 1e-12);
  }
}

TEST(SegmentationMetrics, AdjustedRandIndexHasItsFixedPoints)
{
  std::mt19937 rng(2);
  const auto truth = randomLabels(5000, 6, rng);
  auto names = truth;
  for (auto& name : names)
    name = 100 - name;
  EXPECT_DOUBLE_EQ(adjustedRandIndex(countOverlaps(truth, names)), 1);
  const auto random = randomLabels(5000, 6, rng);
  // The standard deviation is about 1 / number of points.
  EXPECT_NEAR(adjustedRandIndex(countOverlaps(truth, random)), 0, 0.01);
  // By hand: of 10 pairs 3 are joined in the truth, 4 in the prediction, 1 in both.
  const double expected = 3.0 * 4 / 10, largest = (3.0 + 4) / 2;
  EXPECT_NEAR(adjustedRandIndex(countOverlaps({1, 1, 1, 2, 3}, {1, 1, 2, 2, 2})),
              (1 - expected) / (largest - expected),
              1e-12);
}

TEST(SegmentationMetrics, ErrorsOfSplitAndOfMergedSegments)
{
  const auto split = richtsfeldErrors(countOverlaps({1, 1, 1, 1}, {1, 1, 1, 2}));
  EXPECT_DOUBLE_EQ(split.over, 0.25);
  EXPECT_DOUBLE_EQ(split.under, 0);
  const auto merged = richtsfeldErrors(countOverlaps({1, 1, 1, 2}, {5, 5, 5, 5}));
  EXPECT_DOUBLE_EQ(merged.over, 0);
  EXPECT_DOUBLE_EQ(merged.under, (1 + 3) / 4.0);
}

TEST(SegmentationMetrics, PointsWithoutTruthAreLeftOutAndWithoutPredictionAreWrong)
{
  const auto errors =
      richtsfeldErrors(countOverlaps({0, 0, 0, 1, 1, 2}, {4, 4, 4, 4, 0, 0}));
  EXPECT_NEAR(errors.over, 2.0 / 3, 1e-12);
  EXPECT_DOUBLE_EQ(errors.under, 0);
}

TEST(SegmentationMetrics, WeightedOverlapByHand)
{
  // Segment 1: 3 of 4 points, union 4; segment 2: 2 of 2, union 3 with the stray point.
  EXPECT_DOUBLE_EQ(
      weightedOverlap(countOverlaps({1, 1, 1, 1, 2, 2}, {1, 1, 1, 2, 2, 2})),
      (4 * 0.75 + 2 * (2.0 / 3)) / 6);
}

TEST(SegmentationMetrics, DetectionsByHand)
{
  const SegmentLabels truth{1, 1, 1, 1, 2, 2, 3, 3, 0};
  const SegmentLabels predicted{1, 1, 1, 2, 2, 2, 2, 0, 9};
  const auto score = scoreDetections(countOverlaps(truth, predicted));
  EXPECT_EQ(score.true_count, 3u);
  EXPECT_EQ(score.predicted_count, 2u);
  EXPECT_EQ(score.right_count, 2u); // 3/4, 2/4
  EXPECT_DOUBLE_EQ(score.mean_iou, (0.75 + 0.5 + 0) / 3);
  EXPECT_DOUBLE_EQ(score.recall, (0.75 + 1 + 0.5) / 3);
  EXPECT_DOUBLE_EQ(score.precision, (1 + 0.5) / 2);
}

TEST(SegmentationMetrics, AllOfAllIsExactlyOne)
{
  SegmentLabels labels;
  for (std::uint32_t i = 0; i < 18201; ++i)
    labels.push_back(i + 1);
  const auto score = scoreDetections(countOverlaps(labels, labels));
  EXPECT_EQ(score.recall, 1);
  EXPECT_EQ(score.precision, 1);
}

TEST(SegmentationMetrics, EmptyIsPerfectAndSizesMustAgree)
{
  const auto overlaps = countOverlaps({}, {});
  EXPECT_EQ(randIndex(overlaps), 1);
  EXPECT_EQ(adjustedRandIndex(overlaps), 1);
  EXPECT_EQ(richtsfeldErrors(overlaps).over, 0);
  EXPECT_EQ(weightedOverlap(overlaps), 1);
  EXPECT_EQ(scoreDetections(overlaps).mean_iou, 0);
  EXPECT_THROW(countOverlaps({1}, {}), pcl::BadArgumentException);
  EXPECT_THROW(mergeFineSegments({1}, {}, {1}), pcl::BadArgumentException);
}

TEST(SegmentationMetrics, CoarseEqualToFineGivesTheSingleScaleErrors)
{
  std::mt19937 rng(3);
  for (int trial = 0; trial < 20; ++trial) {
    const auto truth = randomLabels(60, 5, rng), predicted = randomLabels(60, 7, rng);
    const auto single = richtsfeldErrors(countOverlaps(truth, predicted));
    const auto multi = multiScaleErrors(truth, truth, predicted);
    EXPECT_DOUBLE_EQ(single.over, multi.over);
    EXPECT_DOUBLE_EQ(single.under, multi.under);
  }
}

TEST(SegmentationMetrics, ObjectsAgreeWithTheirDefinition)
{
  std::mt19937 rng(21);
  std::size_t right = 0, whole = 0;
  for (unsigned trial = 0; trial < 200; ++trial) {
    const auto truth = randomLabels(40, 4, rng);
    auto predicted = truth; // with some wrong labels
    for (auto& label : predicted)
      if (rng() % (2 + trial % 6) == 0)
        label = static_cast<std::uint32_t>(rng() % 6);
    const std::size_t min_size = trial % 3 * 5;
    const std::vector<std::uint32_t> counted =
        trial % 2 ? std::vector<std::uint32_t>{1, 3, 9} : std::vector<std::uint32_t>{};
    const auto count = [&](auto holds) {
      std::size_t sum = 0;
      for (std::size_t i = 0; i < truth.size(); ++i)
        sum += holds(truth[i], predicted[i]);
      return static_cast<double>(sum);
    };
    const auto is_object = [&](std::uint32_t label) {
      return label != 0 &&
             count([&](auto t, auto) { return t == label; }) >= min_size &&
             (counted.empty() || label == 1 || label == 3);
    };
    ObjectScore expected;
    for (std::uint32_t t = 1; t <= 4; ++t)
      expected.true_count += is_object(t) && std::count(truth.begin(), truth.end(), t);
    for (std::uint32_t p = 1; p <= 5; ++p) {
      const double size = count([&](auto, auto q) { return q == p; });
      const double of_objects =
          count([&](auto t, auto q) { return q == p && is_object(t); });
      bool counts = 2 * of_objects > size;
      for (std::uint32_t t = 1; t <= 4; ++t) {
        const double both = count([&](auto u, auto q) { return u == t && q == p; });
        const double of_truth = count([&](auto u, auto) { return u == t; });
        if (!is_object(t) || both == 0)
          continue;
        const double iou = both / (of_truth + of_objects - both);
        if (iou > 0.5) {
          counts = true;
          ++expected.right_count;
          expected.iou_sum += iou;
        }
        expected.whole_count += both >= 0.8 * of_truth && both >= 0.7 * size;
      }
      expected.predicted_count += counts;
    }
    const auto score = scoreObjects(truth, predicted, min_size, counted);
    EXPECT_EQ(score.true_count, expected.true_count);
    EXPECT_EQ(score.predicted_count, expected.predicted_count);
    EXPECT_EQ(score.right_count, expected.right_count);
    EXPECT_NEAR(score.iou_sum, expected.iou_sum, 1e-9);
    EXPECT_EQ(score.whole_count, expected.whole_count);
    right += score.right_count;
    whole += score.whole_count;
  }
  EXPECT_GT(right, 100u);
  EXPECT_GT(whole, 50u);
}

TEST(SegmentationMetrics, ObjectsOfSeveralScenesAddUp)
{
  const SegmentLabels truth{1, 1, 1, 1, 2, 2, 0, 0};
  auto score = scoreObjects(truth, truth, 1);
  EXPECT_DOUBLE_EQ(score.panopticQuality(), 1);
  EXPECT_DOUBLE_EQ(score.wholeShare(), 1);
  score += scoreObjects(truth, {5, 5, 5, 6, 7, 8, 9, 9}, 1);
  EXPECT_EQ(score.true_count, 4u);
  EXPECT_EQ(score.predicted_count, 2u + 4u) << "nothing of 9 is of an object";
  EXPECT_EQ(score.right_count, 3u);
  EXPECT_DOUBLE_EQ(score.panopticQuality(), 2.75 / 5);
  EXPECT_DOUBLE_EQ(score.wholeShare(), 0.5);
  EXPECT_EQ(scoreObjects(truth, truth, 3).true_count, 1u);
  EXPECT_DOUBLE_EQ(ObjectScore().panopticQuality(), 1);
  EXPECT_DOUBLE_EQ(ObjectScore().wholeShare(), 1);
  EXPECT_THROW(scoreObjects({1, 2}, {1}), pcl::BadArgumentException);
}
