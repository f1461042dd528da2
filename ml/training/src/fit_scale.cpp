/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/exceptions.h>
#include <pcl/ml/network_training.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::indoor {

namespace {

/** \brief Calls visit(k, value) for the values of all draws as they reach the layer.
 * \return the number of draws
 */
template <typename Visit>
double
visitValues(const TrainingSet& set, bool has_root, Visit&& visit)
{
  double count = 0.0;
  for (const auto& draws : set.inputs)
    for (const auto& draw : draws) {
      for (std::size_t k = 0; k < draw.size(); ++k)
        visit(k, has_root ? std::sqrt(std::max(draw[k], 0.0f)) : draw[k]);
      ++count;
    }
  return count;
}

void
requireDraws(const TrainingSet& set, std::size_t value_count)
{
  bool is_empty = true;
  for (const auto& draws : set.inputs)
    for (const auto& draw : draws) {
      is_empty = false;
      if (draw.size() != value_count)
        PCL_THROW_EXCEPTION(BadArgumentException,
                            "A draw has " << draw.size() << " values, not the "
                                          << value_count << " of the network");
    }
  if (is_empty)
    PCL_THROW_EXCEPTION(BadArgumentException, "A scale needs at least 1 draw to fit");
}

} // namespace

void
fitScale(Network& network, const TrainingSet& set)
{
  // only what has no weights may come before it
  const auto is_plain = [](const Layer& layer) {
    return layer.kind == LayerKind::SquareRoot || layer.kind == LayerKind::Reshape;
  };
  const auto scale =
      std::find_if_not(network.layers.begin(), network.layers.end(), is_plain);
  if (scale == network.layers.end() || scale->kind != LayerKind::Scale)
    return;
  const std::vector<Layer> before(network.layers.begin(), scale);
  const bool has_root =
      std::any_of(before.begin(), before.end(), [](const Layer& layer) {
        return layer.kind == LayerKind::SquareRoot;
      });
  const auto count = valueCount(network.input);
  requireDraws(set, count);
  std::vector<double> means(count, 0.0);
  std::vector<double> squares(count, 0.0);
  const double draw_count = visitValues(
      set, has_root, [&](std::size_t k, float value) { means[k] += value; });
  for (double& mean : means)
    mean /= draw_count;
  visitValues(set, has_root, [&](std::size_t k, float value) {
    squares[k] += (value - means[k]) * (value - means[k]);
  });
  std::vector<double> deviations(count);
  std::transform(squares.begin(), squares.end(), deviations.begin(), [=](double sum) {
    return std::sqrt(sum / draw_count);
  });
  const double mean_deviation = std::max(
      std::accumulate(deviations.begin(), deviations.end(), 0.0) / count, 1e-6);
  // before a convolution all bins share one scale
  const auto next = scale + 1;
  const bool one_scale =
      next != network.layers.end() && next->kind == LayerKind::Convolution;
  scale->weights.assign(
      2, {outputShape(before, network.input), std::vector<float>(count)});
  for (std::size_t k = 0; k < count; ++k) {
    const double deviation =
        one_scale ? mean_deviation : deviations[k] + mean_deviation;
    scale->weights[0].values[k] = static_cast<float>(1.0 / deviation);
    scale->weights[1].values[k] = static_cast<float>(-means[k] / deviation);
  }
}

} // namespace pcl::indoor
