/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/ml/object_classifier.h>

#include "network_evaluation.h"

#include <pcl/features/eppf_histogram.h>
#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/require_valid.h>
#include <pcl/ml/upright_profile.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace pcl::indoor {

namespace {

constexpr std::size_t most_described_points = 4096; // of an object, by its histogram

EPPFOptions
descriptorOptions(ClassifierInputKind kind)
{
  switch (kind) {
  case ClassifierInputKind::EPPF:
    return thesisEPPFOptions();
  case ClassifierInputKind::EPPFShort:
    return shortEPPFOptions();
  default:
    return pairHarmonicsOptions();
  }
}

/** \brief At most most_described_points of the points, as evenly as they lie. */
std::vector<OrientedPoint>
evenlyChosen(const std::vector<OrientedPoint>& points)
{
  if (points.size() <= most_described_points)
    return points;
  std::vector<OrientedPoint> chosen;
  for (std::size_t k = 0; k < most_described_points; ++k)
    chosen.push_back(points[k * points.size() / most_described_points]);
  return chosen;
}

/** \brief Indices of points, each once before any comes twice. */
std::vector<std::size_t>
drawnPoints(std::size_t point_count, std::size_t wanted, std::uint32_t seed)
{
  std::vector<std::size_t> order(point_count);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::mt19937 random(seed);
  for (std::size_t k = 0; k < std::min(wanted, point_count); ++k) {
    const std::uint64_t rest = point_count - k; // swapped with one of these
    std::swap(order[k], order[k + static_cast<std::size_t>(random() * rest >> 32)]);
  }
  std::vector<std::size_t> drawn(wanted);
  for (std::size_t k = 0; k < wanted; ++k)
    drawn[k] = order[k % point_count];
  return drawn;
}

/** \brief The points in the unit sphere around their mean: all x, all y, all z. */
std::vector<float>
pointInput(const std::vector<OrientedPoint>& points,
           std::size_t wanted,
           std::uint32_t seed)
{
  std::vector<float> values(3 * wanted, std::numeric_limits<float>::quiet_NaN());
  if (points.empty())
    return values;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& point : points)
    sum += point.position.cast<double>();
  const Eigen::Vector3f mean = (sum / static_cast<double>(points.size())).cast<float>();
  float reach = 0.0f;
  for (const auto& point : points)
    reach = std::max(reach, (point.position - mean).norm());
  if (!(reach > 0.0f) || objectExtent(points) == 0.0f)
    return values;
  const auto drawn = drawnPoints(points.size(), wanted, seed);
  for (std::size_t k = 0; k < wanted; ++k) {
    const Eigen::Vector3f position = (points[drawn[k]].position - mean) / reach;
    for (std::size_t axis = 0; axis < 3; ++axis)
      values[axis * wanted + k] = position[static_cast<Eigen::Index>(axis)];
  }
  return values;
}

/** \brief Add the softmax of scores, times a weight. */
void
addProbabilities(const std::vector<float>& scores,
                 double weight,
                 std::vector<double>& probabilities)
{
  const double largest = *std::max_element(scores.begin(), scores.end());
  double sum = 0.0;
  for (const float score : scores)
    sum += std::exp(score - largest);
  for (std::size_t k = 0; k < scores.size(); ++k)
    probabilities[k] += weight * std::exp(scores[k] - largest) / sum;
}

/** \brief The networks' mean probabilities of inputs that are all finite. */
std::vector<std::vector<double>>
meanProbabilities(const ClassifierModel& model, std::vector<std::vector<float>> inputs)
{
  std::vector<std::vector<double>> probabilities(
      inputs.size(), std::vector<double>(model.classes.size(), 0.0));
  const double weight = 1.0 / static_cast<double>(model.networks.size());
  for (const auto& network : model.networks) {
    ObjectValues objects{network.input, inputs};
    for (const auto& layer : network.layers)
      applyLayer(layer, objects);
    for (std::size_t k = 0; k < inputs.size(); ++k)
      addProbabilities(objects.arrays[k], weight, probabilities[k]);
  }
  return probabilities;
}

Classification
meanOfDraws(const std::vector<std::vector<double>>& probabilities,
            std::size_t first,
            std::size_t draws)
{
  std::vector<double> sum = probabilities[first];
  for (std::size_t draw = 1; draw < draws; ++draw)
    for (std::size_t k = 0; k < sum.size(); ++k)
      sum[k] += probabilities[first + draw][k];
  Classification result;
  for (const double value : sum)
    result.probabilities.push_back(
        static_cast<float>(value / static_cast<double>(draws)));
  if (!std::isfinite(result.probabilities.front()))
    result.probabilities.clear(); // weights so large that scores overflow
  return result;
}

} // namespace

std::vector<float>
classifierInput(const std::vector<OrientedPoint>& points,
                const ObjectPlace& place,
                const ClassifierInput& input,
                std::uint32_t seed)
{
  if (input.kind == ClassifierInputKind::Points)
    return pointInput(points, static_cast<std::size_t>(input.point_count), seed);
  auto options = descriptorOptions(input.kind);
  options.scale = input.scale;
  options.pair_count = input.pair_count;
  options.seed = seed;
  auto values = eppfHistogram(evenlyChosen(points), options);
  if (input.context) {
    const auto append = [&values](const std::vector<float>& more) {
      values.insert(values.end(), more.begin(), more.end());
    };
    append(contextValues(points, place));
    append(uprightProfile(points, place.is_known ? place.floor_distance : 0.0f));
  }
  return values;
}

std::size_t
inputValueCount(const ClassifierInput& input)
{
  if (input.kind == ClassifierInputKind::Points)
    return 3 * static_cast<std::size_t>(input.point_count);
  return descriptorOptions(input.kind).bins.size() +
         (input.context ? context_value_count + upright_profile_size : 0);
}

int
Classification::best() const
{
  if (probabilities.empty())
    return -1;
  return static_cast<int>(std::max_element(probabilities.begin(), probabilities.end()) -
                          probabilities.begin());
}

std::vector<Classification>
classifyObjects(const std::vector<ClassifierObject>& objects,
                const ClassifierModel& model,
                unsigned int number_of_threads)
{
  requireValid(model);
  const auto draws = static_cast<std::size_t>(model.input.draws);
  std::vector<std::vector<float>> inputs(objects.size() * draws);
  parallelFor(static_cast<std::ptrdiff_t>(inputs.size()),
              static_cast<int>(number_of_threads),
              1,
              [&](std::ptrdiff_t i) {
                const auto k = static_cast<std::size_t>(i);
                const auto& object = objects[k / draws];
                inputs[k] = classifierInput(object.points,
                                            object.place,
                                            model.input,
                                            static_cast<std::uint32_t>(k % draws + 1));
              });
  std::vector<std::size_t> usable; // numbers of inputs
  for (std::size_t k = 0; k < inputs.size(); ++k)
    if (std::isfinite(inputs[k].front()))
      usable.push_back(k);
  std::vector<std::vector<double>> probabilities(inputs.size());
  const std::size_t batches = (usable.size() + inputs_at_once - 1) / inputs_at_once;
  parallelFor(static_cast<std::ptrdiff_t>(batches),
              static_cast<int>(number_of_threads),
              1,
              [&](std::ptrdiff_t i) {
                const auto batch = static_cast<std::size_t>(i);
                const std::size_t first = batch * inputs_at_once;
                const std::size_t last =
                    std::min(first + inputs_at_once, usable.size());
                std::vector<std::vector<float>> own;
                for (std::size_t k = first; k < last; ++k)
                  own.push_back(std::move(inputs[usable[k]]));
                auto results = meanProbabilities(model, std::move(own));
                for (std::size_t k = first; k < last; ++k)
                  probabilities[usable[k]] = std::move(results[k - first]);
              });
  std::vector<Classification> classifications(objects.size());
  for (std::size_t k = 0; k < objects.size(); ++k)
    if (!probabilities[k * draws].empty())
      classifications[k] = meanOfDraws(probabilities, k * draws, draws);
  return classifications;
}

} // namespace pcl::indoor
