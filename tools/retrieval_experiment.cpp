/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "retrieval_experiment.h"

#include "object_files.h"

#include <pcl/ml/retrieval.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
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
    if (!clean)
      disturb(cloud, settings.disturbance, settings.neighbor_count, object_seed);
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
  Histograms histograms;
  std::size_t bin_count = 1;
  for (const auto& object : objects) {
    histograms.push_back(descriptor.describe(object, seed));
    bin_count = std::max(bin_count, histograms.back().size());
  }
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

/** \brief Scores of every repeat of one descriptor with one distance. */
struct Series {
  std::vector<double> total_accuracy, mean_accuracy, mean_recall, f1;
  double distance_seconds = 0.0;
  ConfusionMatrix confusion;
};

} // namespace

LabelledObjects
loadLabelledObjects(const std::string& folder, int neighbor_count, Progress& progress)
{
  const auto paths = findClouds(folder);
  progress.start("Loading " + folder);
  LabelledObjects objects;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    progress.update(k, paths.size());
    const auto parent = std::filesystem::path(paths[k]).parent_path().string();
    if (parent.empty())
      throw ToolError(paths[k] + ": lies in no class folder of " + folder);
    if (objects.class_names.empty() || objects.class_names.back() != parent)
      objects.class_names.push_back(parent); // paths are sorted
    const auto path = std::filesystem::path(folder) / paths[k];
    objects.clouds.push_back(loadObject(path.string(), neighbor_count));
    objects.labels.push_back(static_cast<int>(objects.class_names.size()) - 1);
  }
  if (objects.class_names.size() < 2)
    throw ToolError(folder + ": at least two class folders are needed");
  progress.done(std::to_string(paths.size()) + " objects of " +
                std::to_string(objects.class_names.size()) + " classes");
  return objects;
}

std::vector<RetrievalResult>
runRetrieval(const LabelledObjects& objects,
             const std::vector<RetrievalDescriptor>& descriptors,
             const ExperimentSettings& settings,
             Progress& progress)
{
  const bool is_disturbed = settings.disturbance.noise_percent > 0.0 ||
                            settings.disturbance.hidden_percent > 0.0;
  const auto clean = disturbedObjects(objects, settings, true, 0);
  std::vector<std::vector<Series>> series(descriptors.size());
  std::vector<std::vector<double>> milliseconds(descriptors.size());
  std::vector<std::size_t> bin_counts(descriptors.size());
  progress.start("Describing and retrieving");
  const auto repeats = static_cast<std::uint32_t>(settings.repeat_count);
  for (std::uint32_t repeat = 0; repeat < repeats; ++repeat) {
    const auto disturbed = is_disturbed
                               ? disturbedObjects(objects, settings, false, repeat)
                               : std::vector<RetrievalObject>();
    const auto& queries = is_disturbed ? disturbed : clean;
    for (std::size_t d = 0; d < descriptors.size(); ++d) {
      progress.update(repeat * descriptors.size() + d, repeats * descriptors.size());
      if (repeat > 0 && !is_disturbed && !descriptors[d].is_random)
        continue;
      const auto begin = std::chrono::steady_clock::now();
      auto histograms = describeAll(queries, descriptors[d], settings.seed + repeat);
      milliseconds[d].push_back(1000.0 * secondsSince(begin) /
                                static_cast<double>(queries.size()));
      bin_counts[d] = histograms.front().size();
      normalize(histograms);
      Histograms gallery;
      if (settings.clean_gallery) {
        gallery = describeAll(clean, descriptors[d], settings.seed + repeat);
        normalize(gallery);
      }
      series[d].resize(settings.distances.size());
      for (std::size_t k = 0; k < settings.distances.size(); ++k) {
        const auto start = std::chrono::steady_clock::now();
        const auto table =
            histogramDistances(histograms,
                               settings.clean_gallery ? gallery : histograms,
                               settings.distances[k],
                               settings.number_of_threads);
        auto& own = series[d][k];
        own.distance_seconds = secondsSince(start);
        const auto confusion = confusionMatrix(objects.labels,
                                               leaveOneOutLabels(table, objects.labels),
                                               objects.class_names.size());
        const auto scores = classificationScores(confusion);
        own.total_accuracy.push_back(scores.total_accuracy);
        own.mean_accuracy.push_back(scores.mean_accuracy);
        own.mean_recall.push_back(scores.mean_recall);
        own.f1.push_back(scores.f1);
        if (repeat == 0)
          own.confusion = confusion;
      }
    }
  }
  std::vector<RetrievalResult> results;
  for (std::size_t d = 0; d < descriptors.size(); ++d)
    for (std::size_t k = 0; k < settings.distances.size(); ++k) {
      const auto& own = series[d][k];
      results.push_back({descriptors[d].name,
                         settings.distances[k],
                         bin_counts[d],
                         own.f1.size(),
                         spreadOf(own.total_accuracy),
                         spreadOf(own.mean_accuracy),
                         spreadOf(own.mean_recall),
                         spreadOf(own.f1),
                         spreadOf(milliseconds[d]),
                         own.distance_seconds,
                         own.confusion});
    }
  progress.done(std::to_string(repeats) + " repeats");
  return results;
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
