/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/ml/classification_metrics.h>

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numeric>
#include <sstream>

namespace pcl::indoor {

namespace {

double
share(std::size_t part, std::size_t whole)
{
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

} // namespace

std::size_t
ConfusionMatrix::objectCount(std::size_t truth) const
{
  const auto row = counts.begin() + static_cast<std::ptrdiff_t>(truth * class_count);
  return std::accumulate(
      row, row + static_cast<std::ptrdiff_t>(class_count), unknown[truth]);
}

ConfusionMatrix
confusionMatrix(const std::vector<int>& truth,
                const std::vector<int>& predicted,
                std::size_t class_count)
{
  if (truth.size() != predicted.size())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        predicted.size() << " predictions do not fit " << truth.size()
                                         << " objects");
  ConfusionMatrix confusion{class_count, {}, {}};
  confusion.counts.resize(class_count * class_count);
  confusion.unknown.resize(class_count);
  const int last = static_cast<int>(class_count) - 1;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    if (truth[k] < 0 || truth[k] > last || predicted[k] > last)
      PCL_THROW_EXCEPTION(
          BadArgumentException,
          "Class " << (truth[k] < 0 || truth[k] > last ? truth[k] : predicted[k])
                   << " is not in 0 ... " << last);
    const auto row = static_cast<std::size_t>(truth[k]);
    if (predicted[k] < 0)
      ++confusion.unknown[row];
    else
      ++confusion.counts[row * class_count + static_cast<std::size_t>(predicted[k])];
  }
  return confusion;
}

ClassificationScores
classificationScores(const ConfusionMatrix& confusion)
{
  ClassificationScores scores;
  std::size_t right = 0;
  std::size_t objects = 0;
  std::size_t classes = 0;
  for (std::size_t k = 0; k < confusion.class_count; ++k) {
    const std::size_t of_class = confusion.objectCount(k);
    std::size_t predicted = 0;
    for (std::size_t truth = 0; truth < confusion.class_count; ++truth)
      predicted += confusion.at(truth, k);
    ClassScores own;
    own.precision = share(confusion.at(k, k), predicted); // Eq. (2.27)
    own.recall = share(confusion.at(k, k), of_class);     // Eq. (2.28)
    own.f1 =
        share(2 * confusion.at(k, k), predicted + of_class); // Eq. (2.29), 2PR/(P+R)
    scores.classes.push_back(own);
    right += confusion.at(k, k);
    objects += of_class;
    if (of_class == 0)
      continue;
    ++classes;
    scores.mean_accuracy += own.precision;
    scores.mean_recall += own.recall;
    scores.f1 += own.f1;
  }
  scores.total_accuracy = share(right, objects);
  const double divisor = static_cast<double>(std::max<std::size_t>(classes, 1));
  scores.mean_accuracy /= divisor;
  scores.mean_recall /= divisor;
  scores.f1 /= divisor;
  return scores;
}

std::string
confusionText(const ConfusionMatrix& confusion, const std::vector<std::string>& names)
{
  if (names.size() != confusion.class_count)
    PCL_THROW_EXCEPTION(BadArgumentException,
                        names.size() << " names do not fit " << confusion.class_count
                                     << " classes");
  std::size_t width = 5;
  for (const auto& name : names)
    width = std::max(width, name.size());
  std::ostringstream text;
  text << std::left << std::setw(static_cast<int>(width)) << "truth" << std::right
       << "    n";
  for (std::size_t k = 0; k < names.size(); ++k)
    text << std::setw(5) << k + 1;
  text << "    ? (% of the row)\n";
  for (std::size_t truth = 0; truth < names.size(); ++truth) {
    const std::size_t objects = confusion.objectCount(truth);
    const auto percent = [&](std::size_t count) {
      const auto value = std::lround(100.0 * share(count, objects));
      return count == 0 ? std::string(".") : std::to_string(value);
    };
    text << std::left << std::setw(static_cast<int>(width)) << names[truth]
         << std::right << std::setw(5) << objects;
    for (std::size_t k = 0; k < names.size(); ++k)
      text << std::setw(5) << percent(confusion.at(truth, k));
    text << std::setw(5) << percent(confusion.unknown[truth]) << "  " << truth + 1
         << '\n';
  }
  return text.str();
}

Spread
spreadOf(const std::vector<double>& values)
{
  if (values.empty())
    return {};
  const double count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0.0;
  for (const double value : values)
    squares += (value - mean) * (value - mean);
  return {mean, values.size() < 2 ? 0.0 : std::sqrt(squares / (count - 1.0))};
}

} // namespace pcl::indoor
