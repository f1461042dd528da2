/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "retrieval/retrieval_experiment.h"

#include "retrieval/isolated_description.h"

#include <pcl/ml/retrieval.h>

#include <algorithm>
#include <chrono>
#include <limits>

namespace pcl::indoor::tool {
namespace {

double
secondsSince(std::chrono::steady_clock::time_point begin)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
      .count();
}

std::vector<RetrievalObject>
disturbedObjects(const LabelledObjects& objects,
                 const ExperimentSettings& settings,
                 bool clean,
                 std::uint32_t repeat)
{
  std::vector<RetrievalObject> result;
  for (std::size_t k = 0; k < objects.clouds.size(); ++k) {
    auto cloud = *objects.clouds[k];
    const auto object_seed = static_cast<std::uint32_t>(
        (settings.seed + repeat) * 1000003u + static_cast<std::uint32_t>(k));
    auto disturbance = settings.disturbance;
    if (clean)
      disturbance.noise_percent = disturbance.hidden_percent = 0.0;
    disturb(cloud, disturbance, settings.neighbor_count, object_seed);
    result.push_back(makeRetrievalObject(cloud, settings.neighbor_count));
  }
  return result;
}

/** \brief Histograms of all objects; objects without one get NaN. */
Histograms
describeAll(const std::vector<RetrievalObject>& objects,
            const RetrievalDescriptor& descriptor,
            std::uint32_t seed)
{
  const auto describe = [&](std::size_t k) {
    return descriptor.describe(objects[k], seed);
  };
  Histograms histograms;
  if (descriptor.may_abort)
    histograms = describeIsolated(objects.size(), describe);
  else
    for (std::size_t k = 0; k < objects.size(); ++k)
      histograms.push_back(describe(k));
  std::size_t bin_count = 1;
  for (const auto& histogram : histograms)
    bin_count = std::max(bin_count, histogram.size());
  for (auto& histogram : histograms)
    histogram.resize(bin_count, std::numeric_limits<float>::quiet_NaN());
  return histograms;
}

/** \brief Bring the sum of each histogram to 1, as the distances expect. */
void
normalize(Histograms& histograms)
{
  for (auto& histogram : histograms) {
    double sum = 0.0;
    for (const float bin : histogram)
      sum += bin;
    if (sum > 0.0)
      for (float& bin : histogram)
        bin = static_cast<float>(bin / sum);
  }
}

/** \brief What all repeats of one descriptor gave with one distance. */
struct Series {
  std::vector<double> total_accuracy, mean_accuracy, mean_recall, f1;
  double distance_seconds = 0.0;
  ConfusionMatrix confusion; // of the first repeat
};

/** \brief What all repeats of one descriptor gave. */
struct DescriptorSeries {
  std::vector<double> milliseconds;
  std::size_t bin_count = 0;
  std::vector<Series> of_distance;
};

/** \brief Retrieve each query in the gallery and add the scores to the series. */
void
retrieve(const Histograms& queries,
         const Histograms& gallery,
         const LabelledObjects& objects,
         const ExperimentSettings& settings,
         std::vector<Series>& series)
{
  series.resize(settings.distances.size());
  for (std::size_t k = 0; k < settings.distances.size(); ++k) {
    auto& own = series[k];
    const auto begin = std::chrono::steady_clock::now();
    const auto table = histogramDistances(
        queries, gallery, settings.distances[k], settings.number_of_threads);
    own.distance_seconds = secondsSince(begin);
    auto confusion = confusionMatrix(objects.labels,
                                     leaveOneOutLabels(table, objects.labels),
                                     objects.class_names.size());
    const auto scores = classificationScores(confusion);
    own.total_accuracy.push_back(scores.total_accuracy);
    own.mean_accuracy.push_back(scores.mean_accuracy);
    own.mean_recall.push_back(scores.mean_recall);
    own.f1.push_back(scores.f1);
    if (own.f1.size() == 1)
      own.confusion = std::move(confusion);
  }
}

/** \brief Describe and retrieve once. */
void
runRepeat(const std::vector<RetrievalObject>& queries,
          const std::vector<RetrievalObject>& clean,
          const RetrievalDescriptor& descriptor,
          std::uint32_t seed,
          const LabelledObjects& objects,
          const ExperimentSettings& settings,
          DescriptorSeries& series)
{
  const auto begin = std::chrono::steady_clock::now();
  auto histograms = describeAll(queries, descriptor, seed);
  series.milliseconds.push_back(1000.0 * secondsSince(begin) /
                                static_cast<double>(queries.size()));
  series.bin_count = histograms.front().size();
  normalize(histograms);
  if (settings.clean_gallery) {
    auto gallery = describeAll(clean, descriptor, seed);
    normalize(gallery);
    retrieve(histograms, gallery, objects, settings, series.of_distance);
  }
  else
    retrieve(histograms, histograms, objects, settings, series.of_distance);
}

std::vector<RetrievalResult>
summarize(const std::vector<DescriptorSeries>& series,
          const std::vector<RetrievalDescriptor>& descriptors,
          const ExperimentSettings& settings)
{
  std::vector<RetrievalResult> results;
  for (std::size_t d = 0; d < descriptors.size(); ++d)
    for (std::size_t k = 0; k < settings.distances.size(); ++k) {
      const auto& own = series[d].of_distance[k];
      results.push_back({descriptors[d].name,
                         settings.distances[k],
                         series[d].bin_count,
                         own.f1.size(),
                         spreadOf(own.total_accuracy),
                         spreadOf(own.mean_accuracy),
                         spreadOf(own.mean_recall),
                         spreadOf(own.f1),
                         spreadOf(series[d].milliseconds),
                         own.distance_seconds,
                         own.confusion});
    }
  return results;
}

} // namespace

std::vector<RetrievalResult>
runRetrieval(const LabelledObjects& objects,
             const std::vector<RetrievalDescriptor>& descriptors,
             const ExperimentSettings& settings,
             Progress& progress)
{
  const bool is_disturbed = settings.disturbance.noise_percent > 0.0 ||
                            settings.disturbance.hidden_percent > 0.0 ||
                            settings.disturbance.before_camera;
  const auto clean = disturbedObjects(objects, settings, true, 0);
  std::vector<DescriptorSeries> series(descriptors.size());
  progress.start("Describing and retrieving");
  const auto repeats = static_cast<std::uint32_t>(settings.repeat_count);
  for (std::uint32_t repeat = 0; repeat < repeats; ++repeat) {
    const auto disturbed = is_disturbed
                               ? disturbedObjects(objects, settings, false, repeat)
                               : std::vector<RetrievalObject>();
    for (std::size_t d = 0; d < descriptors.size(); ++d) {
      progress.update(repeat * descriptors.size() + d, repeats * descriptors.size());
      if (repeat == 0 || is_disturbed || descriptors[d].is_random)
        runRepeat(is_disturbed ? disturbed : clean,
                  clean,
                  descriptors[d],
                  settings.seed + repeat,
                  objects,
                  settings,
                  series[d]);
    }
  }
  progress.done(std::to_string(repeats) + " repeats");
  return summarize(series, descriptors, settings);
}

std::string
distanceName(HistogramDistance distance)
{
  switch (distance) {
  case HistogramDistance::SymmetricKullbackLeibler:
    return "kl";
  case HistogramDistance::L1:
    return "l1";
  case HistogramDistance::L2:
    return "l2";
  case HistogramDistance::ChiSquared:
    return "chi2";
  }
  return "";
}

} // namespace pcl::indoor::tool
