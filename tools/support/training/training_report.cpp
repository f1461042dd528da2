/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "training/training_report.h"

#include "pictures/line_plot.h"
#include "text/formatted.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor::tool {
namespace {

/** \brief A curve per network and part, of one value of each epoch. */
template <typename Value>
std::vector<Curve>
curvesOf(const EpochLog& log, bool is_validation, const Value& value)
{
  std::vector<Curve> curves;
  for (std::size_t k = 0; k < log.size(); ++k) {
    Curve curve;
    curve.name = is_validation ? "Validation" : "Training";
    if (log.size() > 1)
      curve.name += " " + std::to_string(k + 1);
    curve.color = lineColor(k);
    curve.is_dashed = is_validation;
    for (const auto& epoch : log[k])
      curve.points.emplace_back(epoch.epoch, value(epoch));
    curves.push_back(curve);
  }
  return curves;
}

/** Names of the columns of logLine(). */
constexpr const char* log_header =
    "network,epoch,training_loss,training_accuracy,validation_loss,"
    "validation_accuracy\n";

} // namespace

std::string
logLine(std::size_t network, const EpochReport& epoch, bool has_validation)
{
  const auto training = formatted("%zu,%d,%.9g,%.9g",
                                  network,
                                  epoch.epoch,
                                  epoch.training_loss,
                                  epoch.training_accuracy);
  if (!has_validation)
    return training + ",,\n";
  return training +
         formatted(",%.9g,%.9g\n", epoch.validation_loss, epoch.validation_accuracy);
}

std::string
logText(const EpochLog& log, bool has_validation)
{
  std::string text = log_header;
  for (std::size_t k = 0; k < log.size(); ++k)
    for (const auto& epoch : log[k])
      text += logLine(k + 1, epoch, has_validation);
  return text;
}

SvgDrawing
curvesPicture(const EpochLog& log, bool has_validation)
{
  std::vector<Curve> losses, accuracies;
  for (const bool is_validation : {false, true}) {
    if (is_validation && !has_validation)
      continue;
    for (auto& curve : curvesOf(log, is_validation, [&](const EpochReport& epoch) {
           return is_validation ? epoch.validation_loss : epoch.training_loss;
         }))
      losses.push_back(std::move(curve));
    for (auto& curve : curvesOf(log, is_validation, [&](const EpochReport& epoch) {
           return 100.0 *
                  (is_validation ? epoch.validation_accuracy : epoch.training_accuracy);
         }))
      accuracies.push_back(std::move(curve));
  }
  double epochs = 1.0;
  double loss = 1e-6;
  for (const auto& curve : losses)
    for (const auto& point : curve.points) {
      epochs = std::max(epochs, point.first);
      loss = std::max(loss, point.second);
    }
  const double x_step = std::max(plotStep(epochs), 1.0), y_step = plotStep(loss);
  const double loss_end = y_step * std::ceil(loss / y_step);
  return stacked(
      {linePlot({"Loss", "Epoch", "Loss", epochs, loss_end, x_step, y_step}, losses),
       linePlot({"Accuracy", "Epoch", "Accuracy, %", epochs, 100.0, x_step, 20.0},
                accuracies)});
}

std::string
scoresText(const ConfusionMatrix& confusion)
{
  std::size_t objects = 0;
  for (std::size_t truth = 0; truth < confusion.class_count; ++truth)
    objects += confusion.objectCount(truth);
  const auto scores = classificationScores(confusion);
  return formatted("%zu objects: total accuracy %.2f %%, mean accuracy %.2f %%, mean "
                   "recall %.2f %%, F1 %.3f\n",
                   objects,
                   100.0 * scores.total_accuracy,
                   100.0 * scores.mean_accuracy,
                   100.0 * scores.mean_recall,
                   scores.f1);
}

} // namespace pcl::indoor::tool
