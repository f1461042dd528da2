/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/segmentation_metrics.h>

#include <pcl/exceptions.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_map>

namespace {

using pcl::indoor::Overlap;
using pcl::indoor::SegmentLabels;

using Sizes = std::unordered_map<std::uint32_t, std::size_t>;

void
requireSameSize(const SegmentLabels& a, const SegmentLabels& b)
{
  if (a.size() != b.size())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "The segmentations have " << a.size() << " and " << b.size()
                                                  << " labels.");
}

Sizes
trueSizes(const std::vector<Overlap>& overlaps)
{
  Sizes sizes;
  for (const auto& overlap : overlaps)
    sizes[overlap.truth] += overlap.count;
  return sizes;
}

Sizes
predictedSizes(const std::vector<Overlap>& overlaps)
{
  Sizes sizes;
  for (const auto& overlap : overlaps)
    sizes[overlap.predicted] += overlap.count;
  return sizes;
}

std::size_t
pointCount(const std::vector<Overlap>& overlaps)
{
  std::size_t count = 0;
  for (const auto& overlap : overlaps)
    count += overlap.count;
  return count;
}

double
pairs(std::size_t count)
{
  return 0.5 * static_cast<double>(count) * (static_cast<double>(count) - 1);
}

/** Numbers of point pairs that are in one segment. */
struct PairCounts {
  double both = 0, truth = 0, predicted = 0, all = 0;
};

PairCounts
countPairs(const std::vector<Overlap>& overlaps)
{
  PairCounts counts;
  for (const auto& overlap : overlaps)
    counts.both += pairs(overlap.count);
  for (const auto& entry : trueSizes(overlaps))
    counts.truth += pairs(entry.second);
  for (const auto& entry : predictedSizes(overlaps))
    counts.predicted += pairs(entry.second);
  counts.all = pairs(pointCount(overlaps));
  return counts;
}

/** The predicted segment with most points of each true one; without those predicted 0.
 */
std::map<std::uint32_t, Overlap>
bestPredictions(const std::vector<Overlap>& overlaps, const Sizes& predicted_sizes)
{
  std::map<std::uint32_t, Overlap> best;
  for (const auto& overlap : overlaps) {
    auto& current =
        best.emplace(overlap.truth, Overlap{overlap.truth, 0, 0}).first->second;
    if (overlap.predicted == 0)
      continue;
    const bool smaller =
        overlap.count == current.count && current.predicted != 0 &&
        predicted_sizes.at(overlap.predicted) < predicted_sizes.at(current.predicted);
    if (overlap.count > current.count || smaller)
      current = overlap;
  }
  return best;
}

double
intersectionOverUnion(const Overlap& overlap,
                      const Sizes& truth,
                      const Sizes& predicted)
{
  const auto all = truth.at(overlap.truth) + predicted.at(overlap.predicted);
  return static_cast<double>(overlap.count) / static_cast<double>(all - overlap.count);
}

} // namespace

namespace pcl::indoor {

std::vector<Overlap>
countOverlaps(const SegmentLabels& truth, const SegmentLabels& predicted)
{
  requireSameSize(truth, predicted);
  std::vector<std::uint64_t> keys;
  keys.reserve(truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i)
    if (truth[i] != 0)
      keys.push_back((static_cast<std::uint64_t>(truth[i]) << 32) | predicted[i]);
  std::sort(keys.begin(), keys.end());
  std::vector<Overlap> overlaps;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (i == 0 || keys[i] != keys[i - 1])
      overlaps.push_back({static_cast<std::uint32_t>(keys[i] >> 32),
                          static_cast<std::uint32_t>(keys[i]),
                          0});
    ++overlaps.back().count;
  }
  return overlaps;
}

double
randIndex(const std::vector<Overlap>& overlaps)
{
  const auto counts = countPairs(overlaps);
  if (counts.all == 0)
    return 1;
  const double apart = counts.all - counts.truth - counts.predicted + counts.both;
  return (counts.both + apart) / counts.all;
}

double
adjustedRandIndex(const std::vector<Overlap>& overlaps)
{
  const auto counts = countPairs(overlaps);
  if (counts.all == 0)
    return 1;
  const double expected = counts.truth * counts.predicted / counts.all;
  const double largest = 0.5 * (counts.truth + counts.predicted);
  return largest == expected ? 1 : (counts.both - expected) / (largest - expected);
}

SegmentationErrors
richtsfeldErrors(const std::vector<Overlap>& overlaps)
{
  const auto all = static_cast<double>(pointCount(overlaps));
  if (all == 0)
    return {};
  const auto sizes = predictedSizes(overlaps);
  double right = 0, foreign = 0;
  for (const auto& entry : bestPredictions(overlaps, sizes)) {
    const auto& best = entry.second;
    if (best.predicted == 0)
      continue;
    right += static_cast<double>(best.count);
    foreign += static_cast<double>(sizes.at(best.predicted) - best.count);
  }
  return {1 - right / all, foreign / all};
}

double
weightedOverlap(const std::vector<Overlap>& overlaps)
{
  if (overlaps.empty())
    return 1;
  const auto truth = trueSizes(overlaps), predicted = predictedSizes(overlaps);
  std::map<std::uint32_t, double> best;
  for (const auto& overlap : overlaps) {
    auto& value = best[overlap.truth];
    if (overlap.predicted != 0)
      value = std::max(value, intersectionOverUnion(overlap, truth, predicted));
  }
  double sum = 0;
  for (const auto& entry : best)
    sum += entry.second * static_cast<double>(truth.at(entry.first));
  return sum / static_cast<double>(pointCount(overlaps));
}

SegmentLabels
mergeFineSegments(const SegmentLabels& fine,
                  const SegmentLabels& coarse,
                  const SegmentLabels& predicted)
{
  const auto by_prediction = countOverlaps(fine, predicted);
  const auto by_object = countOverlaps(fine, coarse);
  // FP and FC of Algorithm 2: what most points of a fine segment have
  const auto majority = [](const std::vector<Overlap>& overlaps) {
    std::map<std::uint32_t, Overlap> most;
    for (const auto& overlap : overlaps) {
      auto& current = most[overlap.truth];
      if (overlap.count > current.count)
        current = overlap;
    }
    return most;
  };
  const auto object_of = majority(by_object);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> merged;
  Sizes merged_label_of;
  for (const auto& entry :
       bestPredictions(by_prediction, predictedSizes(by_prediction))) {
    const auto label = entry.first;
    // Parts that were not found at all do not become one.
    if (entry.second.predicted == 0)
      merged_label_of[label] = label;
    else
      merged_label_of[label] =
          merged
              .emplace(
                  std::make_pair(entry.second.predicted, object_of.at(label).predicted),
                  label)
              .first->second;
  }
  SegmentLabels labels(fine.size(), 0);
  for (std::size_t i = 0; i < fine.size(); ++i)
    if (fine[i] != 0)
      labels[i] = static_cast<std::uint32_t>(merged_label_of.at(fine[i]));
  return labels;
}

SegmentationErrors
multiScaleErrors(const SegmentLabels& fine,
                 const SegmentLabels& coarse,
                 const SegmentLabels& predicted)
{
  return richtsfeldErrors(
      countOverlaps(mergeFineSegments(fine, coarse, predicted), predicted));
}

namespace {

/** Recall and precision of Bormann et al.: the mean of the largest overlaps' shares. */
void
scoreCoverage(const std::vector<Overlap>& overlaps,
              const Sizes& truth,
              Sizes predicted,
              DetectionScore& score)
{
  predicted.erase(0);
  Sizes of_true, of_predicted;
  for (const auto& overlap : overlaps) {
    if (overlap.predicted == 0)
      continue;
    of_true[overlap.truth] = std::max(of_true[overlap.truth], overlap.count);
    of_predicted[overlap.predicted] =
        std::max(of_predicted[overlap.predicted], overlap.count);
  }
  const auto meanShare = [](const Sizes& sizes, Sizes& covered) {
    double sum = 0; // divided at last, so that all of all is exactly 1
    for (const auto& [label, size] : sizes)
      sum += static_cast<double>(covered[label]) / static_cast<double>(size);
    return sizes.empty() ? 0.0 : sum / static_cast<double>(sizes.size());
  };
  score.recall = meanShare(truth, of_true);
  score.precision = meanShare(predicted, of_predicted);
}

} // namespace

DetectionScore
scoreDetections(const std::vector<Overlap>& overlaps)
{
  const auto truth = trueSizes(overlaps);
  auto predicted = predictedSizes(overlaps);
  DetectionScore score;
  score.true_count = truth.size();
  score.predicted_count = predicted.size() - predicted.count(0);
  scoreCoverage(overlaps, truth, predicted, score);
  std::vector<std::pair<double, Overlap>> matches;
  for (const auto& overlap : overlaps)
    if (overlap.predicted != 0)
      matches.emplace_back(intersectionOverUnion(overlap, truth, predicted), overlap);
  std::sort(matches.begin(), matches.end(), [](const auto& a, const auto& b) {
    return std::make_tuple(-a.first, a.second.truth, a.second.predicted) <
           std::make_tuple(-b.first, b.second.truth, b.second.predicted);
  });
  std::map<std::uint32_t, bool> true_taken, predicted_taken;
  double sum = 0;
  for (const auto& match : matches) {
    bool& taken = true_taken[match.second.truth];
    bool& used = predicted_taken[match.second.predicted];
    // An intersection over union above 0.5 has no rival; at 0.5 two may share.
    if (!taken && match.first >= 0.5)
      ++score.right_count;
    if (!taken && !used) {
      taken = used = true;
      sum += match.first;
    }
  }
  if (score.true_count > 0)
    score.mean_iou = sum / static_cast<double>(score.true_count);
  return score;
}

} // namespace pcl::indoor
