/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "retrieval/retrieval_report.h"

#include "formats/json_text.h"
#include "pictures/line_plot.h"
#include "text/formatted.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace pcl::indoor::tool {
namespace {

nlohmann::json
spreadJson(const Spread& spread)
{
  return {{"mean", spread.mean}, {"deviation", spread.deviation}};
}

nlohmann::json
resultJson(const RetrievalResult& result, double noise_percent, double hidden_percent)
{
  const std::size_t n = result.confusion.class_count;
  auto rows = nlohmann::json::array();
  for (std::size_t truth = 0; truth < n; ++truth) {
    auto row = nlohmann::json::array();
    for (std::size_t predicted = 0; predicted < n; ++predicted)
      row.push_back(result.confusion.at(truth, predicted));
    rows.push_back(row);
  }
  return {{"descriptor", result.descriptor},
          {"distance", distanceName(result.distance)},
          {"bins", result.bin_count},
          {"repeats", result.repeat_count},
          {"noise_percent", noise_percent},
          {"hidden_percent", hidden_percent},
          {"total_accuracy", spreadJson(result.total_accuracy)},
          {"mean_accuracy", spreadJson(result.mean_accuracy)},
          {"mean_recall", spreadJson(result.mean_recall)},
          {"f1", spreadJson(result.f1)},
          {"milliseconds_per_object", spreadJson(result.milliseconds)},
          {"seconds_all_distances", result.distance_seconds},
          {"confusion", rows},
          {"without_prediction", result.confusion.unknown}};
}

} // namespace

std::string
resultTable(const std::vector<RetrievalResult>& results)
{
  std::string text = "descriptor          distance  bins  total acc. %  mean acc. %  "
                     "mean recall %         F1   ms/object\n";
  for (const auto& result : results)
    text +=
        formatted("%-20s%-8s%6zu  %5.2f (%4.2f)  %5.2f (%4.2f)  %5.2f (%4.2f)  %.3f "
                  "(%.3f)  %8.3f\n",
                  result.descriptor.c_str(),
                  distanceName(result.distance).c_str(),
                  result.bin_count,
                  100 * result.total_accuracy.mean,
                  100 * result.total_accuracy.deviation,
                  100 * result.mean_accuracy.mean,
                  100 * result.mean_accuracy.deviation,
                  100 * result.mean_recall.mean,
                  100 * result.mean_recall.deviation,
                  result.f1.mean,
                  result.f1.deviation,
                  result.milliseconds.mean);
  return text;
}

std::string
resultJson(const std::vector<RetrievalLevel>& levels,
           const LabelledObjects& objects,
           const ExperimentSettings& settings)
{
  nlohmann::json document = {{"objects", objects.clouds.size()},
                             {"classes", objects.class_names},
                             {"seed", settings.seed},
                             {"clean_gallery", settings.clean_gallery}};
  document["results"] = nlohmann::json::array();
  for (const auto& level : levels)
    for (const auto& result : level.results)
      document["results"].push_back(
          resultJson(result, level.noise_percent, settings.disturbance.hidden_percent));
  return jsonText(document);
}

SvgDrawing
noisePicture(const std::vector<RetrievalLevel>& levels)
{
  PlotAxes axes{"Total accuracy under noise",
                "Noise, % of the object's extent",
                "Total accuracy, %"};
  axes.x_end = 1e-9;
  for (const auto& level : levels)
    axes.x_end = std::max(axes.x_end, level.noise_percent);
  axes.x_step = plotStep(axes.x_end);
  axes.y_end = 100.0;
  axes.y_step = 20.0;
  const auto& first = levels.front().results;
  std::vector<Curve> curves;
  for (std::size_t k = 0; k < first.size(); ++k) {
    if (first[k].distance != first.front().distance)
      continue;
    Curve curve{first[k].descriptor, {}, lineColor(curves.size())};
    for (const auto& level : levels)
      curve.points.emplace_back(level.noise_percent,
                                100.0 * level.results[k].total_accuracy.mean);
    curves.push_back(curve);
  }
  return linePlot(axes, curves);
}

SvgDrawing
barPicture(const std::vector<RetrievalResult>& results)
{
  constexpr double length = 360.0, row_height = 26.0, top = 40.0, bar = 16.0;
  std::vector<RetrievalResult> shown;
  std::copy_if(results.begin(),
               results.end(),
               std::back_inserter(shown),
               [&](const auto& r) { return r.distance == results.front().distance; });
  double left = 60.0;
  for (const auto& result : shown)
    left = std::max(left, 20.0 + SvgDrawing::textWidth(result.descriptor));
  const double bottom = top + row_height * static_cast<double>(shown.size());
  SvgDrawing drawing(left + length + 130.0, bottom + 30.0);
  drawing.text(
      {left, 18.0}, "F1, mean and deviation", {Anchor::Start, 15.0, 0.0, true});
  for (int tenths = 0; tenths <= 10; tenths += 2) {
    const double x = left + length * tenths / 10.0;
    drawing.line({{x, top}, {x, bottom}}, light_grey);
    drawing.text(
        {x, bottom + 12.0}, formatted("%.1f", tenths / 10.0), {Anchor::Middle});
  }
  double y = top + 0.5 * row_height;
  for (const auto& result : shown) {
    const auto& f1 = result.f1;
    const double low = left + length * (f1.mean - f1.deviation);
    const double high = left + length * (f1.mean + f1.deviation);
    drawing.text({left - 8.0, y}, result.descriptor, {Anchor::End});
    drawing.rectangle({left, y - 0.5 * bar}, {length * f1.mean, bar}, lineColor(0));
    drawing.line({{low, y - 4.0}, {low, y + 4.0}}, ink);
    drawing.line({{low, y}, {high, y}}, ink);
    drawing.line({{high, y - 4.0}, {high, y + 4.0}}, ink);
    drawing.text({left + length + 12.0, y},
                 formatted("%.3f ± %.3f", f1.mean, f1.deviation));
    y += row_height;
  }
  return drawing;
}

} // namespace pcl::indoor::tool
