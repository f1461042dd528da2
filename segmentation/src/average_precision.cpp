/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/segmentation_metrics.h>

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

void
AveragePrecision::add(const SegmentLabels& truth,
                      const SegmentLabels& predicted,
                      std::size_t min_size,
                      const std::vector<std::uint32_t>& counted,
                      const std::map<std::uint32_t, double>& confidences)
{
  const auto overlaps = countOverlaps(truth, predicted); // also tells sizes that differ
  std::map<std::uint32_t, std::size_t> true_sizes, sizes, counted_sizes, number_of;
  for (const auto label : truth)
    ++true_sizes[label];
  for (const auto label : predicted)
    ++sizes[label];
  for (const auto& [label, size] : true_sizes)
    if (label != 0 && size >= min_size &&
        (counted.empty() ||
         std::find(counted.begin(), counted.end(), label) != counted.end()))
      number_of.emplace(label, true_count_++);
  for (const auto& overlap : overlaps)
    if (number_of.count(overlap.truth) > 0)
      counted_sizes[overlap.predicted] += overlap.count;

  std::map<std::uint32_t, Prediction> found;
  for (const auto& [label, size] : sizes) {
    if (label == 0)
      continue;
    const auto given = confidences.find(label);
    const double confidence =
        given == confidences.end() ? static_cast<double>(size) : given->second;
    if (!std::isfinite(confidence))
      PCL_THROW_EXCEPTION(BadArgumentException,
                          "Segment " << label << " has the confidence " << confidence
                                     << ".");
    found[label] = {confidence, 2 * counted_sizes[label] <= size, {}};
  }
  for (const auto& [label, prediction, count] : overlaps) {
    const auto number = number_of.find(label);
    if (prediction == 0 || number == number_of.end())
      continue;
    const auto all = true_sizes.at(label) + counted_sizes.at(prediction) - count;
    found.at(prediction).matches.push_back({number->second, count, all});
  }
  for (auto& [label, prediction] : found) {
    std::stable_sort(prediction.matches.begin(),
                     prediction.matches.end(),
                     [](const Match& a, const Match& b) {
                       return a.intersection * b.union_size >
                              b.intersection * a.union_size;
                     });
    predictions_.push_back(std::move(prediction));
  }
}

AveragePrecision&
AveragePrecision::operator+=(const AveragePrecision& other)
{
  predictions_.reserve(predictions_.size() + other.predictions_.size());
  for (auto prediction : other.predictions_) {
    for (auto& match : prediction.matches)
      match.truth += true_count_;
    predictions_.push_back(std::move(prediction));
  }
  true_count_ += other.true_count_;
  return *this;
}

double
AveragePrecision::at(unsigned percent) const
{
  auto ranked = predictions_;
  std::stable_sort(
      ranked.begin(), ranked.end(), [](const Prediction& a, const Prediction& b) {
        return a.confidence > b.confidence;
      });
  std::vector<std::uint8_t> taken(true_count_, 0);
  std::size_t right = 0, judged = 0;
  struct Place {
    double recall, precision;
  };
  std::vector<Place> curve;
  for (std::size_t i = 0; i < ranked.size(); ++i) {
    const auto& matches = ranked[i].matches;
    const auto match = std::find_if(matches.begin(), matches.end(), [&](const auto& m) {
      return !taken[m.truth] && 100 * m.intersection >= percent * m.union_size;
    });
    if (match != matches.end()) {
      taken[match->truth] = 1;
      ++right;
    }
    judged += match != matches.end() || !ranked[i].mostly_void;
    const bool last_of_confidence =
        i + 1 == ranked.size() || ranked[i + 1].confidence < ranked[i].confidence;
    if (last_of_confidence && judged > 0 && true_count_ > 0)
      curve.push_back({static_cast<double>(right) / static_cast<double>(true_count_),
                       static_cast<double>(right) / static_cast<double>(judged)});
  }
  if (true_count_ == 0)
    return judged == 0 ? 1 : 0;
  double area = 0, best = 0;
  for (std::size_t i = curve.size(); i-- > 0;) {
    best = std::max(best, curve[i].precision);
    area += best * (curve[i].recall - (i > 0 ? curve[i - 1].recall : 0));
  }
  return area;
}

double
AveragePrecision::mean() const
{
  double sum = 0;
  for (unsigned percent = 50; percent < 100; percent += 5)
    sum += at(percent);
  return sum / 10;
}

} // namespace pcl::indoor
