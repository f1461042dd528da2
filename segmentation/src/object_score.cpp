/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/segmentation_metrics.h>

#include <algorithm>
#include <map>

namespace pcl::indoor {
namespace {

/** \return 1 if there is nothing to have a share of */
double
share(double part, std::size_t all)
{
  return all > 0 ? part / static_cast<double>(all) : 1;
}

} // namespace

ObjectScore&
ObjectScore::operator+=(const ObjectScore& other)
{
  true_count += other.true_count;
  predicted_count += other.predicted_count;
  right_count += other.right_count;
  iou_sum += other.iou_sum;
  whole_count += other.whole_count;
  return *this;
}

double
ObjectScore::panopticQuality() const
{
  const auto count = 0.5 * static_cast<double>(true_count + predicted_count);
  return count > 0 ? iou_sum / count : 1;
}

double
ObjectScore::segmentationQuality() const
{
  return right_count > 0 ? iou_sum / static_cast<double>(right_count) : 0;
}

double
ObjectScore::recognitionQuality() const
{
  return share(2.0 * static_cast<double>(right_count), true_count + predicted_count);
}

double
ObjectScore::recall() const
{
  return share(static_cast<double>(right_count), true_count);
}

double
ObjectScore::precision() const
{
  return share(static_cast<double>(right_count), predicted_count);
}

double
ObjectScore::wholeShare() const
{
  return share(static_cast<double>(whole_count), true_count);
}

ObjectScore
scoreObjects(const SegmentLabels& truth,
             const SegmentLabels& predicted,
             std::size_t min_size,
             const std::vector<std::uint32_t>& counted)
{
  std::map<std::uint32_t, std::size_t> size_of_truth, size_of_predicted, scored;
  for (const auto label : truth)
    ++size_of_truth[label];
  for (const auto label : predicted)
    ++size_of_predicted[label];
  const auto is_void = [&](std::uint32_t label) {
    return label == 0 || size_of_truth.at(label) < min_size ||
           (!counted.empty() &&
            std::find(counted.begin(), counted.end(), label) == counted.end());
  };
  ObjectScore score;
  auto objects = countOverlaps(truth, predicted); // also tells sizes that differ
  objects.erase(
      std::remove_if(objects.begin(),
                     objects.end(),
                     [&](const auto& overlap) { return is_void(overlap.truth); }),
      objects.end());
  for (const auto& overlap : objects)
    if (overlap.predicted != 0)
      scored[overlap.predicted] += overlap.count;
  for (const auto& [label, size] : size_of_truth)
    score.true_count += !is_void(label);
  const auto is_mostly_void = [&](std::uint32_t label) {
    return 2 * scored.at(label) <= size_of_predicted.at(label);
  };
  for (const auto& entry : scored)
    score.predicted_count += !is_mostly_void(entry.first);
  for (const auto& [label, prediction, count] : objects) {
    if (prediction == 0)
      continue;
    const auto size = size_of_truth.at(label);
    const auto iou = static_cast<double>(count) /
                     static_cast<double>(size + scored.at(prediction) - count);
    if (iou > 0.5) {
      ++score.right_count;
      score.iou_sum += iou;
      score.predicted_count += is_mostly_void(prediction);
    }
    score.whole_count +=
        10 * count >= 8 * size && 10 * count >= 7 * size_of_predicted.at(prediction);
  }
  return score;
}

} // namespace pcl::indoor
