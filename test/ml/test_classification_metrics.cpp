/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/exceptions.h>
#include <pcl/ml/classification_metrics.h>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::indoor {
namespace {

TEST(ClassificationScores, EqualACountByHand)
{
  // Class 0: 4 objects, 3 right, 1 taken for 1. Class 1: 2 objects, 1 right, 1 taken
  // for 0. Class 2: 2 objects, 1 taken for 0, 1 without a prediction.
  const auto confusion =
      confusionMatrix({0, 0, 0, 0, 1, 1, 2, 2}, {0, 0, 0, 1, 1, 0, 0, -1}, 3);
  EXPECT_EQ(confusion.at(0, 0), 3u);
  EXPECT_EQ(confusion.at(0, 1), 1u);
  EXPECT_EQ(confusion.at(2, 0), 1u);
  EXPECT_EQ(confusion.unknown[2], 1u);
  EXPECT_EQ(confusion.objectCount(2), 2u);
  const auto scores = classificationScores(confusion);
  EXPECT_DOUBLE_EQ(scores.total_accuracy, 4.0 / 8.0);
  EXPECT_DOUBLE_EQ(scores.classes[0].precision, 3.0 / 5.0);
  EXPECT_DOUBLE_EQ(scores.classes[0].recall, 3.0 / 4.0);
  EXPECT_DOUBLE_EQ(scores.classes[0].f1, 2 * 0.6 * 0.75 / (0.6 + 0.75));
  EXPECT_DOUBLE_EQ(scores.classes[2].precision, 0.0);
  EXPECT_DOUBLE_EQ(scores.classes[2].f1, 0.0);
  EXPECT_DOUBLE_EQ(scores.mean_accuracy, (0.6 + 0.5 + 0.0) / 3);
  EXPECT_DOUBLE_EQ(scores.mean_recall, (0.75 + 0.5 + 0.0) / 3);
  EXPECT_DOUBLE_EQ(scores.f1, (2.0 / 3.0 + 0.5 + 0.0) / 3);
}

TEST(ClassificationScores, PerfectAndWorst)
{
  const auto perfect = classificationScores(confusionMatrix({0, 1, 1}, {0, 1, 1}, 2));
  EXPECT_EQ(perfect.total_accuracy, 1.0);
  EXPECT_EQ(perfect.f1, 1.0);
  const auto worst = classificationScores(confusionMatrix({0, 1, 1}, {1, 0, 0}, 2));
  EXPECT_EQ(worst.total_accuracy, 0.0);
  EXPECT_EQ(worst.f1, 0.0);
}

TEST(ClassificationScores, ClassesWithoutObjectsAreLeftOutOfMeans)
{
  const auto scores = classificationScores(confusionMatrix({0, 0}, {0, 0}, 5));
  EXPECT_EQ(scores.mean_recall, 1.0);
  EXPECT_EQ(scores.classes.size(), 5u);
  EXPECT_EQ(classificationScores(confusionMatrix({}, {}, 3)).total_accuracy, 0.0);
}

TEST(ConfusionMatrix, RefusesWhatDoesNotFit)
{
  EXPECT_THROW(confusionMatrix({0}, {}, 1), BadArgumentException);
  EXPECT_THROW(confusionMatrix({1}, {0}, 1), BadArgumentException);
  EXPECT_THROW(confusionMatrix({0}, {1}, 1), BadArgumentException);
  EXPECT_THROW(confusionMatrix({-1}, {0}, 1), BadArgumentException);
  EXPECT_THROW(confusionText(confusionMatrix({0}, {0}, 1), {}), BadArgumentException);
}

TEST(ConfusionMatrix, TextHasARowPerClassInPerCent)
{
  const auto text = confusionText(confusionMatrix({0, 0, 0, 0, 1}, {0, 0, 0, 1, -1}, 2),
                                  {"Bed", "Lamp"});
  EXPECT_EQ(text,
            "truth    n    1    2    ? (% of the row)\n"
            "Bed      4   75   25    .  1\n"
            "Lamp     1    .    .  100  2\n");
}

TEST(SpreadOf, IsThatOfASample)
{
  const auto spread = spreadOf({1.0, 2.0, 3.0, 4.0});
  EXPECT_DOUBLE_EQ(spread.mean, 2.5);
  EXPECT_DOUBLE_EQ(spread.deviation, std::sqrt(5.0 / 3.0));
  EXPECT_EQ(spreadOf({7.0}).deviation, 0.0);
  EXPECT_EQ(spreadOf({}).mean, 0.0);
}

} // namespace
} // namespace pcl::indoor
