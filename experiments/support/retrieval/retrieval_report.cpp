/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "retrieval/retrieval_report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

namespace pcl::indoor::tool {
namespace {

const Color black{0, 0, 0};
const Color grey{200, 200, 200};

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

std::string
formatted(const char* format, double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

/** \brief A straight line, a few pixels thick. */
void
drawLine(Picture& picture, double x0, double y0, double x1, double y1, Color color)
{
  const int steps =
      1 + static_cast<int>(std::max(std::abs(x1 - x0), std::abs(y1 - y0)));
  for (int k = 0; k <= steps; ++k) {
    const double part = static_cast<double>(k) / steps;
    picture.fillRectangle(static_cast<int>(std::lround(x0 + part * (x1 - x0))) - 1,
                          static_cast<int>(std::lround(y0 + part * (y1 - y0))) - 1,
                          2,
                          2,
                          color);
  }
}

} // namespace

std::string
resultTable(const std::vector<RetrievalResult>& results)
{
  std::string text = "descriptor          distance  bins  total acc. %  mean acc. %  "
                     "mean recall %         F1   ms/object\n";
  for (const auto& result : results) {
    char line[200];
    std::snprintf(line,
                  sizeof(line),
                  "%-20s%-8s%6zu  %5.2f (%4.2f)  %5.2f (%4.2f)  %5.2f (%4.2f)  %.3f "
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
    text += line;
  }
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
  return document.dump(1) + "\n";
}

Picture
noisePicture(const std::vector<RetrievalLevel>& levels)
{
  constexpr int width = 520, height = 400, left = 50, top = 20;
  Picture picture(width + 210, height + 60);
  double largest = 1e-9;
  for (const auto& level : levels)
    largest = std::max(largest, level.noise_percent);
  const auto x = [&](double noise) { return left + (width - left) * noise / largest; };
  const auto y = [&](double share) { return top + (height - top) * (1.0 - share); };
  for (int percent = 0; percent <= 100; percent += 10) {
    drawLine(picture, left, y(percent / 100.0), width, y(percent / 100.0), grey);
    picture.drawText(
        10, static_cast<int>(y(percent / 100.0)) - 3, std::to_string(percent), black);
  }
  for (const auto& level : levels)
    picture.drawText(static_cast<int>(x(level.noise_percent)) - 3,
                     height + 10,
                     formatted("%g", level.noise_percent),
                     black);
  picture.drawText(left, height + 30, "noise, % of the object's extent", black);
  picture.drawText(left, 4, "total accuracy, %", black);
  const auto& first = levels.front().results;
  int line = 0;
  for (std::size_t k = 0; k < first.size(); ++k) {
    if (first[k].distance != first.front().distance)
      continue;
    const Color color = labelColor(static_cast<std::uint32_t>(++line));
    for (std::size_t level = 0; level + 1 < levels.size(); ++level)
      drawLine(picture,
               x(levels[level].noise_percent),
               y(levels[level].results[k].total_accuracy.mean),
               x(levels[level + 1].noise_percent),
               y(levels[level + 1].results[k].total_accuracy.mean),
               color);
    picture.fillRectangle(width + 20, top + 20 * line, 20, 8, color);
    picture.drawText(width + 46, top + 20 * line, first[k].descriptor, black);
  }
  return picture;
}

Picture
barPicture(const std::vector<RetrievalResult>& results)
{
  std::vector<RetrievalResult> shown;
  std::copy_if(results.begin(),
               results.end(),
               std::back_inserter(shown),
               [&](const auto& r) { return r.distance == results.front().distance; });
  constexpr int length = 400, row_height = 24;
  int left = 60;
  for (const auto& result : shown)
    left = std::max(left, Picture::textWidth(result.descriptor) + 20);
  Picture picture(left + length + 120,
                  40 + row_height * static_cast<int>(shown.size()));
  picture.drawText(left, 8, "F1", black);
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const int y = 26 + row_height * static_cast<int>(k);
    const auto& f1 = shown[k].f1;
    picture.drawText(8, y + 5, shown[k].descriptor, black);
    picture.fillRectangle(
        left, y, static_cast<int>(length * f1.mean), 16, labelColor(3));
    const int low = left + static_cast<int>(length * (f1.mean - f1.deviation));
    const int high = left + static_cast<int>(length * (f1.mean + f1.deviation));
    picture.fillRectangle(low, y + 7, std::max(high - low, 1), 2, black);
    picture.drawText(left + length + 10,
                     y + 5,
                     formatted("%.3f", f1.mean) + " +-" +
                         formatted("%.3f", f1.deviation),
                     black);
  }
  return picture;
}

} // namespace pcl::indoor::tool
