/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/exceptions.h>
#include <pcl/segmentation/segmentation_metrics.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

using namespace pcl::indoor;

namespace {

struct Scene {
  SegmentLabels truth, predicted;
  std::map<std::uint32_t, double> confidences;
};

/** Segments of random sizes in a row, and a prediction that moves their borders. */
Scene
randomInstances(std::mt19937& rng)
{
  Scene scene;
  for (std::uint32_t label = 0; label < 8; ++label)
    scene.truth.insert(scene.truth.end(), 1 + rng() % 12, label % 7);
  scene.predicted = scene.truth;
  for (auto& label : scene.predicted)
    if (rng() % 5 == 0)
      label = static_cast<std::uint32_t>(rng() % 10);
  for (std::uint32_t label = 1; label < 10; ++label)
    if (rng() % 4 != 0)
      scene.confidences[label] = static_cast<double>(rng() % 6);
  return scene;
}

/** A prediction of the oracle, with its points. */
struct Guess {
  double confidence;
  std::size_t scene;
  std::uint32_t label;
};

/** The definitions, point by point: no sums are kept. */
class Oracle {
public:
  Oracle(const std::vector<Scene>& scenes, std::size_t min_size)
  : scenes_(scenes)
  , min_size_(min_size)
  {
    for (std::size_t s = 0; s < scenes.size(); ++s)
      for (const auto label : std::set<std::uint32_t>(scenes[s].predicted.begin(),
                                                      scenes[s].predicted.end())) {
        if (label == 0)
          continue;
        const auto given = scenes[s].confidences.find(label);
        const auto size =
            std::count(scenes[s].predicted.begin(), scenes[s].predicted.end(), label);
        guesses_.push_back({given != scenes[s].confidences.end()
                                ? given->second
                                : static_cast<double>(size),
                            s,
                            label});
      }
  }

  /** Precision and recall of the predictions of at least a confidence. */
  std::pair<double, double>
  at(double least_confidence, double threshold) const
  {
    std::vector<Guess> chosen;
    for (const auto& guess : guesses_)
      if (guess.confidence >= least_confidence)
        chosen.push_back(guess);
    std::stable_sort(chosen.begin(), chosen.end(), [](const auto& a, const auto& b) {
      return a.confidence > b.confidence;
    });
    std::set<std::pair<std::size_t, std::uint32_t>> taken;
    double right = 0, counted = 0;
    for (const auto& guess : chosen) {
      double best = 0;
      std::uint32_t partner = 0;
      for (const auto label : trueLabels(guess.scene)) {
        const double iou = overlap(guess, label);
        if (iou > best && taken.count({guess.scene, label}) == 0) {
          best = iou;
          partner = label;
        }
      }
      const bool is_right = best >= threshold - 1e-12;
      if (is_right) {
        taken.insert({guess.scene, partner});
        ++right;
      }
      if (is_right || voidShare(guess) < 0.5)
        ++counted;
    }
    double all = 0;
    for (std::size_t s = 0; s < scenes_.size(); ++s)
      all += static_cast<double>(trueLabels(s).size());
    return {counted > 0 ? right / counted : 0, right / all};
  }

  /** The area below the largest precision at each recall or above. */
  double
  area(double threshold) const
  {
    std::vector<std::pair<double, double>> curve; // recall, precision
    for (const auto& guess : guesses_) {
      const auto [precision, recall] = at(guess.confidence, threshold);
      curve.emplace_back(recall, precision);
    }
    std::sort(curve.begin(), curve.end());
    double sum = 0, from = 0;
    for (const auto& place : curve) {
      double highest = 0;
      for (const auto& other : curve)
        if (other.first >= place.first)
          highest = std::max(highest, other.second);
      sum += (place.first - from) * highest;
      from = place.first;
    }
    return sum;
  }

private:
  std::set<std::uint32_t>
  trueLabels(std::size_t scene) const
  {
    std::set<std::uint32_t> labels;
    const auto& truth = scenes_[scene].truth;
    for (const auto label : truth)
      if (label != 0 && static_cast<std::size_t>(
                            std::count(truth.begin(), truth.end(), label)) >= min_size_)
        labels.insert(label);
    return labels;
  }

  double
  overlap(const Guess& guess, std::uint32_t label) const
  {
    const auto& scene = scenes_[guess.scene];
    const auto scored = trueLabels(guess.scene);
    double both = 0, either = 0;
    for (std::size_t i = 0; i < scene.truth.size(); ++i) {
      const bool a = scene.truth[i] == label;
      const bool b =
          scene.predicted[i] == guess.label && scored.count(scene.truth[i]) > 0;
      both += a && b;
      either += a || b;
    }
    return both / either;
  }

  double
  voidShare(const Guess& guess) const
  {
    const auto& scene = scenes_[guess.scene];
    const auto scored = trueLabels(guess.scene);
    double outside = 0, all = 0;
    for (std::size_t i = 0; i < scene.truth.size(); ++i)
      if (scene.predicted[i] == guess.label) {
        ++all;
        outside += scored.count(scene.truth[i]) == 0;
      }
    return outside / all;
  }

  const std::vector<Scene>& scenes_;
  std::size_t min_size_;
  std::vector<Guess> guesses_;
};

} // namespace

TEST(AveragePrecision, AgreesWithTheDefinitionsPointByPoint)
{
  std::mt19937 rng(1);
  for (int trial = 0; trial < 60; ++trial) {
    std::vector<Scene> scenes(1 + trial % 3);
    const std::size_t min_size = trial % 2 == 0 ? 1 : 4;
    AveragePrecision precision, in_parts;
    for (auto& scene : scenes) {
      scene = randomInstances(rng);
      precision.add(scene.truth, scene.predicted, min_size, {}, scene.confidences);
      AveragePrecision part;
      part.add(scene.truth, scene.predicted, min_size, {}, scene.confidences);
      in_parts += part;
    }
    const Oracle oracle(scenes, min_size);
    double sum = 0;
    for (unsigned percent = 50; percent < 100; percent += 5) {
      EXPECT_NEAR(precision.at(percent), oracle.area(percent / 100.0), 1e-12);
      sum += oracle.area(percent / 100.0);
    }
    EXPECT_NEAR(precision.at(25), oracle.area(0.25), 1e-12);
    EXPECT_NEAR(precision.mean(), sum / 10, 1e-12);
    EXPECT_EQ(precision.mean(), in_parts.mean());
  }
}

TEST(AveragePrecision, ByHand)
{
  // Prediction 7 is segment 1 (IoU 3/4), 8 is none, 9 is segment 2 (IoU 1).
  const SegmentLabels truth{1, 1, 1, 1, 2, 2, 3, 3, 3, 0};
  const SegmentLabels predicted{7, 7, 7, 8, 9, 9, 8, 0, 0, 7};
  AveragePrecision by_size, by_confidence;
  by_size.add(truth, predicted); // 7 with 4 points, then 8 and 9 with 2 each
  EXPECT_DOUBLE_EQ(by_size.at(50), 1.0 / 3 * 1 + 1.0 / 3 * 2 / 3);
  EXPECT_DOUBLE_EQ(by_size.at(75), 1.0 / 3 * 1 + 1.0 / 3 * 2 / 3);
  EXPECT_DOUBLE_EQ(by_size.at(80), 1.0 / 3 * 1.0 / 3);
  by_confidence.add(truth, predicted, 1, {}, {{7, 0.9}, {8, 0.1}, {9, 0.5}});
  EXPECT_DOUBLE_EQ(by_confidence.at(50), 2.0 / 3);
  EXPECT_DOUBLE_EQ(by_confidence.mean(), (6 * 2.0 / 3 + 4 * 0.5 / 3) / 10);
}

TEST(AveragePrecision, OnlyWhatIsCountedIsScored)
{
  const SegmentLabels truth{1, 1, 2, 2, 2, 3};
  AveragePrecision some;
  some.add(truth, {5, 5, 6, 6, 6, 8}, 1, {1}); // 6 and 8 lie in void points
  EXPECT_EQ(some.mean(), 1);
  AveragePrecision wrong;
  wrong.add(truth, {5, 5, 6, 6, 6, 8}, 1, {2, 3}, {{6, 1}, {5, 2}, {8, 0}});
  EXPECT_EQ(wrong.mean(), 1);
}

TEST(AveragePrecision, NothingIsFoundWhereNothingIsAndBadInputIsRefused)
{
  AveragePrecision precision;
  EXPECT_EQ(precision.mean(), 1);
  precision.add({0, 0}, {1, 1});
  EXPECT_EQ(precision.mean(), 1); // void alone
  precision.add({1, 1}, {0, 0});
  EXPECT_EQ(precision.mean(), 0);
  EXPECT_THROW(precision.add({1}, {}), pcl::BadArgumentException);
  EXPECT_THROW(
      precision.add({1}, {1}, 1, {}, {{1, std::numeric_limits<double>::quiet_NaN()}}),
      pcl::BadArgumentException);
}

TEST(ObjectScore, FactorsOfPanopticQualityByCountingPoints)
{
  std::mt19937 rng(2);
  for (int trial = 0; trial < 40; ++trial) {
    const auto scene = randomInstances(rng);
    const std::vector<Scene> scenes{scene};
    const auto score = scoreObjects(scene.truth, scene.predicted, 1);
    std::set<std::uint32_t> truths(scene.truth.begin(), scene.truth.end()), guesses;
    truths.erase(0);
    double iou_sum = 0, right = 0;
    std::set<std::uint32_t> matched;
    for (const auto truth : truths)
      for (std::uint32_t guess = 1; guess < 10; ++guess) {
        double both = 0, either = 0;
        for (std::size_t i = 0; i < scene.truth.size(); ++i) {
          const bool a = scene.truth[i] == truth,
                     b = scene.truth[i] != 0 && scene.predicted[i] == guess;
          both += a && b;
          either += a || b;
        }
        if (both > 0.5 * either) {
          ++right;
          iou_sum += both / either;
          matched.insert(guess);
        }
      }
    for (std::uint32_t guess = 1; guess < 10; ++guess) {
      double in_truth = 0, all = 0;
      for (std::size_t i = 0; i < scene.truth.size(); ++i)
        if (scene.predicted[i] == guess) {
          ++all;
          in_truth += scene.truth[i] != 0;
        }
      if (matched.count(guess) > 0 || 2 * in_truth > all)
        guesses.insert(guess);
    }
    const double missed = static_cast<double>(truths.size()) - right,
                 wrong = static_cast<double>(guesses.size()) - right;
    EXPECT_NEAR(
        score.panopticQuality(), iou_sum / (right + 0.5 * missed + 0.5 * wrong), 1e-12);
    EXPECT_NEAR(score.segmentationQuality() * score.recognitionQuality(),
                score.panopticQuality(),
                1e-12);
    EXPECT_NEAR(score.recall(), right / (right + missed), 1e-12);
    EXPECT_NEAR(score.precision(), right / (right + wrong), 1e-12);
  }
  EXPECT_EQ(ObjectScore().recall(), 1);
  EXPECT_EQ(ObjectScore().segmentationQuality(), 0);
}
