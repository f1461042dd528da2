/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/json_text.h"
#include "objects/file_classification.h"
#include "text/formatted.h"

#include <pcl/ml/classification_metrics.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pcl::indoor::tool {
namespace {

constexpr std::size_t top_count = 3;

using Json = nlohmann::ordered_json;

std::string
percent(double share)
{
  return formatted("%.1f %%", 100.0 * share);
}

/** \brief Columns as wide as their widest text. */
std::string
tableText(const std::vector<std::vector<std::string>>& rows)
{
  std::vector<std::size_t> widths;
  for (const auto& row : rows)
    for (std::size_t k = 0; k < row.size(); ++k) {
      widths.resize(std::max(widths.size(), k + 1));
      widths[k] = std::max(widths[k], row[k].size());
    }
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k)
      text +=
          row[k] +
          (k + 1 < row.size() ? std::string(widths[k] - row[k].size() + 2, ' ') : "\n");
  }
  return text;
}

/** \brief Accuracy and confusion of the files whose class is known. */
std::string
scoreText(const std::vector<ClassifiedFile>& files)
{
  std::map<std::string, int> numbers;
  for (const auto& file : files)
    if (!file.file.true_class.empty()) {
      numbers.emplace(file.file.true_class, 0);
      if (!file.top.empty())
        numbers.emplace(file.top.front().first, 0);
    }
  if (numbers.empty())
    return "";
  const auto names = numberNames(numbers);
  std::vector<int> truth;
  std::vector<int> predicted;
  for (const auto& file : files)
    if (!file.file.true_class.empty()) {
      truth.push_back(numbers[file.file.true_class]);
      predicted.push_back(file.top.empty() ? -1 : numbers[file.top.front().first]);
    }
  const auto confusion = confusionMatrix(truth, predicted, names.size());
  const auto scores = classificationScores(confusion);
  return "\n" + std::to_string(truth.size()) +
         " objects of known class: " + percent(scores.total_accuracy) +
         " right, mean over the classes " + percent(scores.mean_recall) + "\n\n" +
         confusionText(confusion, names);
}

} // namespace

std::string
classificationText(const std::vector<ClassifiedFile>& files)
{
  std::vector<std::vector<std::string>> rows = {
      {"file", "class", "confidence", "next likely"}};
  for (const auto& file : files) {
    if (file.top.empty()) {
      rows.push_back({file.file.path, "-", "-", ""});
      continue;
    }
    std::string next;
    for (std::size_t k = 1; k < std::min(top_count, file.top.size()); ++k)
      next +=
          (k == 1 ? "" : ", ") + file.top[k].first + " " + percent(file.top[k].second);
    rows.push_back({file.file.path,
                    file.top.front().first,
                    percent(file.top.front().second),
                    next});
  }
  return tableText(rows) + scoreText(files);
}

std::string
classificationJson(const std::vector<ClassifiedFile>& files)
{
  Json list = Json::array();
  for (const auto& file : files) {
    Json json;
    json["file"] = file.file.path;
    json["class"] = file.top.empty() ? Json() : Json(file.top.front().first);
    json["confidence"] = file.top.empty() ? 0.0 : rounded(file.top.front().second);
    json["top"] = Json::array();
    for (std::size_t k = 0; k < std::min(top_count, file.top.size()); ++k)
      json["top"].push_back(
          {{"class", file.top[k].first}, {"confidence", rounded(file.top[k].second)}});
    if (!file.file.true_class.empty())
      json["true_class"] = file.file.true_class;
    list.push_back(std::move(json));
  }
  return jsonText(list);
}

} // namespace pcl::indoor::tool
