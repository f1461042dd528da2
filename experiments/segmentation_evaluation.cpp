/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "command_line/options.h"
#include "files/cloud_file.h"
#include "formats/json_text.h"
#include "formats/table/table_columns.h" // for listedNames
#include "text/words.h"

#include <pcl/segmentation/segmentation_metrics.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;

namespace {

struct Settings {
  std::string truth, predicted; ///< files
  std::string truth_field = "label", predicted_field = "object";
  std::string coarse, coarse_field, ignored, confidence_field, json;
  std::uint32_t min_points = 1;
};

/** Average precision and panoptic quality, both without classes. */
void
addInstanceScores(const SegmentLabels& truth,
                  const SegmentLabels& predicted,
                  std::size_t min_points,
                  const std::map<std::uint32_t, double>& confidences,
                  nlohmann::json& result)
{
  AveragePrecision precision;
  precision.add(truth, predicted, min_points, {}, confidences);
  result["average_precision"] = precision.mean();
  result["average_precision_50"] = precision.at(50);
  result["average_precision_25"] = precision.at(25);
  const auto objects = scoreObjects(truth, predicted, min_points);
  result["panoptic_quality"] = objects.panopticQuality();
  result["segmentation_quality"] = objects.segmentationQuality();
  result["recognition_quality"] = objects.recognitionQuality();
  result["recall_50"] = objects.recall();
  result["precision_50"] = objects.precision();
}

/** The mean of a field over the points of each segment. */
std::map<std::uint32_t, double>
confidencesOf(const CloudFile& file,
              const std::string& field,
              const SegmentLabels& predicted)
{
  std::map<std::uint32_t, double> sums, counts;
  const auto values = readNumbers(file, field);
  for (std::size_t i = 0; i < values.size(); ++i) {
    sums[predicted[i]] += values[i];
    ++counts[predicted[i]];
  }
  for (auto& [label, sum] : sums) {
    sum /= counts.at(label);
    if (!std::isfinite(sum))
      throw ToolError(file.path + ": the field " + field + " of segment " +
                      std::to_string(label) + " is not finite");
  }
  return sums;
}

nlohmann::json
evaluate(const SegmentLabels& truth, const SegmentLabels& predicted)
{
  const auto overlaps = countOverlaps(truth, predicted);
  const auto errors = richtsfeldErrors(overlaps);
  const auto detections = scoreDetections(overlaps);
  std::size_t points = 0, unlabelled = 0;
  for (const auto& overlap : overlaps) {
    points += overlap.count;
    unlabelled += overlap.predicted == 0 ? overlap.count : 0;
  }
  return {{"points", points},
          {"points_without_prediction", unlabelled},
          {"true_segments", detections.true_count},
          {"predicted_segments", detections.predicted_count},
          {"rand_index", randIndex(overlaps)},
          {"adjusted_rand_index", adjustedRandIndex(overlaps)},
          {"oversegmentation", errors.over},
          {"undersegmentation", errors.under},
          {"weighted_overlap", weightedOverlap(overlaps)},
          {"right_segments", detections.right_count},
          {"wrong_segments", detections.true_count - detections.right_count},
          {"mean_iou", detections.mean_iou},
          {"recall", detections.recall},
          {"precision", detections.precision}};
}

SegmentLabels
loadLabels(const CloudFile& file, const std::string& field, std::size_t count)
{
  auto labels = readLabels(file, field);
  if (count != 0 && labels.size() != count)
    throw ToolError(file.path + ": has " + std::to_string(labels.size()) +
                    " points, but the truth has " + std::to_string(count));
  return labels;
}

/** Set the labels that are listed, with commas between them, to 0. */
void
leaveOut(const std::string& list, SegmentLabels& labels)
{
  if (list.empty())
    return;
  std::vector<std::uint32_t> ignored;
  for (const auto& item : listedNames(list)) {
    std::uint32_t label = 0;
    if (!readWord(item, label))
      throw ToolError("-ignore: \"" + item + "\" is no label.");
    ignored.push_back(label);
  }
  std::sort(ignored.begin(), ignored.end());
  for (auto& label : labels)
    if (std::binary_search(ignored.begin(), ignored.end(), label))
      label = 0;
}

void
print(const nlohmann::json& result)
{
  for (const auto& entry : result.items())
    std::printf("%-26s %s\n", entry.key().c_str(), entry.value().dump().c_str());
}

OptionParser
makeParser(Settings& settings)
{
  OptionParser parser("pcl_segmentation_evaluation",
                      "Compare a segmentation with the truth, point by point. Points "
                      "whose true label is 0 are left out.");
  parser.positional("truth.pcd", settings.truth, "PCD or PLY file with the true labels")
      .positional("predicted.pcd",
                  settings.predicted,
                  "PCD or PLY file with the same points in the same order")
      .text("-truth_field",
            settings.truth_field,
            "field of the truth; parts, with coarse labels")
      .text("-predicted_field",
            settings.predicted_field,
            "field of the prediction, 0 = none")
      .text("-coarse_field",
            settings.coarse_field,
            "field with the objects of the parts, for the multi-scale errors")
      .text("-coarse",
            settings.coarse,
            "file that holds the coarse field, if it is not truth.pcd")
      .text("-ignore",
            settings.ignored,
            "labels of the truth to leave out as if they were 0, with commas")
      .number("-min_points",
              settings.min_points,
              "true segments of fewer points are void for average precision and "
              "panoptic quality",
              "",
              Range::atLeast(1))
      .text("-confidence_field",
            settings.confidence_field,
            "field of the prediction by which average precision ranks its segments, as "
            "mean over their points; without it they are ranked by their numbers of "
            "points")
      .text("-json", settings.json, "file to write the result to");
  parser.expert(
      {"-coarse_field", "-coarse", "-ignore", "-min_points", "-confidence_field"});
  return parser;
}

void
addMultiScaleErrors(const Settings& settings,
                    const SegmentLabels& truth,
                    const SegmentLabels& predicted,
                    nlohmann::json& result)
{
  if (settings.coarse_field.empty() && settings.coarse.empty())
    return;
  const auto coarse = loadLabels(
      loadCloud(settings.coarse.empty() ? settings.truth : settings.coarse),
      settings.coarse_field.empty() ? settings.truth_field : settings.coarse_field,
      truth.size());
  const auto errors = multiScaleErrors(truth, coarse, predicted);
  result["multi_scale_oversegmentation"] = errors.over;
  result["multi_scale_undersegmentation"] = errors.under;
}

void
run(const Settings& settings, Progress& progress)
{
  if (!settings.json.empty())
    requireWritable(settings.json);
  progress.start("Loading " + settings.truth);
  auto truth = loadLabels(loadCloud(settings.truth), settings.truth_field, 0);
  leaveOut(settings.ignored, truth);
  progress.done(std::to_string(truth.size()) + " points");
  progress.start("Loading " + settings.predicted);
  const auto file = loadCloud(settings.predicted);
  const auto predicted = loadLabels(file, settings.predicted_field, truth.size());
  progress.done();
  auto result = evaluate(truth, predicted);
  const auto confidences =
      settings.confidence_field.empty()
          ? std::map<std::uint32_t, double>()
          : confidencesOf(file, settings.confidence_field, predicted);
  addInstanceScores(truth, predicted, settings.min_points, confidences, result);
  addMultiScaleErrors(settings, truth, predicted, result);
  print(result);
  if (!settings.json.empty())
    saveText(settings.json, jsonText(result));
}

} // namespace

int
main(int argc, char** argv)
{
  Settings settings;
  return makeParser(settings).run(
      argc, argv, [&](Progress& progress) { run(settings, progress); });
}
