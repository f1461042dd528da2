/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/file_classification.h"

#include "files/cloud_file.h"
#include "objects/object_files.h"

#include <pcl/indoor/parallel_for.h>
#include <pcl/ml/histogram_distance.h>
#include <pcl/ml/object_classifier.h>
#include <pcl/ml/point_nn.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numeric>

namespace pcl::indoor::tool {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t files_at_once = 64; // whose points are in memory together

ClassifierObject
readObject(const std::string& path, int neighbor_count, bool wants_place)
{
  const auto object = loadPlacedObject(path, neighbor_count);
  return {classifierPoints(*object.cloud), wants_place ? object.place : ObjectPlace()};
}

/** \brief Call with the objects of some files after the other. */
template <typename Visit>
void
forEachBatch(const std::vector<ObjectFile>& files,
             const ClassificationSettings& settings,
             bool wants_place,
             StageReport& report,
             const Visit& visit)
{
  for (std::size_t first = 0; first < files.size(); first += files_at_once) {
    std::vector<ClassifierObject> objects;
    for (std::size_t k = first; k < std::min(first + files_at_once, files.size());
         ++k) {
      report.update(k, files.size());
      objects.push_back(
          readObject(files[k].path, settings.neighbor_count, wants_place));
    }
    visit(first, objects);
  }
}

Classes
sorted(Classes classes)
{
  std::stable_sort(classes.begin(), classes.end(), [](const auto& a, const auto& b) {
    return a.second > b.second;
  });
  while (!classes.empty() && !(classes.back().second > 0.0f))
    classes.pop_back();
  return classes;
}

/** \brief What objects are compared by. */
std::vector<float>
described(const ClassifierObject& object, NearestDescriptor descriptor)
{
  if (descriptor == NearestDescriptor::PairHarmonics)
    return classifierInput(object.points, object.place, ClassifierInput(), 1);
  std::vector<Eigen::Vector3f> points;
  for (const auto& point : object.points)
    points.push_back(point.position);
  return pointNNDescriptor(points);
}

/** \brief What files are compared by, and their real paths: an object finds itself. */
struct DescribedFiles {
  Histograms histograms;
  std::vector<fs::path> paths;
};

DescribedFiles
describe(const std::vector<ObjectFile>& files,
         const std::string& what,
         const ClassificationSettings& settings,
         StageReport& report)
{
  Histograms histograms(files.size());
  std::vector<fs::path> paths;
  for (const auto& file : files)
    paths.push_back(fs::weakly_canonical(file.path));
  report.start("Describing " + std::to_string(files.size()) + " " + what);
  forEachBatch(
      files, settings, false, report, [&](std::size_t first, const auto& objects) {
        parallelFor(static_cast<std::ptrdiff_t>(objects.size()),
                    static_cast<int>(settings.threads),
                    1,
                    [&](std::ptrdiff_t i) {
                      const auto k = static_cast<std::size_t>(i);
                      histograms[first + k] =
                          described(objects[k], settings.descriptor);
                    });
      });
  report.done();
  return {std::move(histograms), std::move(paths)};
}

/** \brief Shares of 1 / distance^2; of distances of 0 alone if there are any. */
Classes
shares(const std::map<std::string, float>& distances)
{
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [name, distance] : distances)
    least = std::min<double>(least, distance);
  if (!std::isfinite(least))
    return {};
  Classes classes;
  double sum = 0.0;
  const auto share = [least](double distance) {
    return distance > least ? least * least / (distance * distance) : 1.0;
  };
  for (const auto& [name, distance] : distances)
    sum += share(distance);
  for (const auto& [name, distance] : distances)
    classes.emplace_back(name, static_cast<float>(share(distance) / sum));
  return sorted(classes);
}

/** \brief Classes of each object by its nearest known object of each class. */
std::vector<Classes>
classesByDistance(const DescribedFiles& queries,
                  const DescribedFiles& gallery,
                  const std::vector<ObjectFile>& known,
                  unsigned int threads)
{
  const auto table = histogramDistances(queries.histograms,
                                        gallery.histograms,
                                        HistogramDistance::SymmetricKullbackLeibler,
                                        threads);
  std::vector<Classes> results;
  for (std::size_t row = 0; row < queries.paths.size(); ++row) {
    std::map<std::string, float> nearest; // of each class
    for (std::size_t column = 0; column < known.size(); ++column) {
      const float distance = std::max(table.at(row, column), 0.0f); // rounding
      if (!std::isfinite(distance) || gallery.paths[column] == queries.paths[row])
        continue;
      const auto place = nearest.emplace(known[column].true_class, distance).first;
      place->second = std::min(place->second, distance);
    }
    results.push_back(shares(nearest));
  }
  return results;
}

/** \brief Classes of each object by its similarity to all known objects. */
std::vector<Classes>
classesByMemory(const DescribedFiles& queries,
                const DescribedFiles& gallery,
                const std::vector<ObjectFile>& known)
{
  std::map<std::string, int> labels;
  for (const auto& file : known)
    labels.emplace(file.true_class, 0);
  const auto names = numberNames(labels);
  std::vector<Classes> results;
  for (std::size_t row = 0; row < queries.paths.size(); ++row) {
    PointNNMemory memory;
    for (std::size_t column = 0; column < known.size(); ++column)
      if (gallery.paths[column] != queries.paths[row]) {
        memory.descriptors.push_back(gallery.histograms[column]);
        memory.labels.push_back(labels[known[column].true_class]);
      }
    const auto scores = pointNNScores(queries.histograms[row], memory, names.size());
    Classes classes;
    for (std::size_t k = 0; k < scores.size(); ++k)
      classes.emplace_back(names[k], scores[k]);
    results.push_back(sorted(std::move(classes)));
  }
  return results;
}

} // namespace

std::vector<std::string>
numberNames(std::map<std::string, int>& numbers)
{
  std::vector<std::string> names;
  for (auto& [name, number] : numbers) {
    number = static_cast<int>(names.size());
    names.push_back(name);
  }
  return names;
}

std::vector<ObjectFile>
objectsOfFolder(const std::string& folder)
{
  std::vector<ObjectFile> files;
  for (const auto& name : objectFilesIn(folder))
    files.push_back({(fs::path(folder) / name).string(), classFolder(name)});
  return files;
}

std::vector<ObjectFile>
objectFiles(const std::vector<std::string>& paths)
{
  std::vector<ObjectFile> files;
  for (const auto& path : paths) {
    std::error_code error;
    if (!fs::is_directory(path, error)) {
      files.push_back({path, ""});
      continue;
    }
    const auto found = objectsOfFolder(path);
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

std::vector<ClassifiedFile>
classifyByModel(const std::vector<ObjectFile>& files,
                const ClassifierModel& model,
                const ClassificationSettings& settings,
                StageReport& report)
{
  std::vector<ClassifiedFile> results;
  report.start("Classifying " + std::to_string(files.size()) + " objects");
  const bool wants_place = model.input.context;
  forEachBatch(files,
               settings,
               wants_place,
               report,
               [&](std::size_t first, const auto& objects) {
                 const auto found = classifyObjects(objects, model, settings.threads);
                 for (std::size_t k = 0; k < found.size(); ++k) {
                   Classes classes;
                   for (std::size_t c = 0; c < found[k].probabilities.size(); ++c)
                     classes.emplace_back(model.classes[c], found[k].probabilities[c]);
                   results.push_back({files[first + k], sorted(classes)});
                 }
               });
  report.done();
  return results;
}

std::vector<ClassifiedFile>
classifyByNearest(const std::vector<ObjectFile>& files,
                  const std::vector<ObjectFile>& known,
                  const ClassificationSettings& settings,
                  StageReport& report)
{
  for (const auto& file : known)
    if (file.true_class.empty())
      throw ToolError(file.path + ": lies in no folder that names its class");
  const auto gallery = describe(known, "known objects", settings, report);
  const auto queries = describe(files, "objects", settings, report);
  const auto classes =
      settings.descriptor == NearestDescriptor::PointNN
          ? classesByMemory(queries, gallery, known)
          : classesByDistance(queries, gallery, known, settings.threads);
  std::vector<ClassifiedFile> results;
  for (std::size_t k = 0; k < files.size(); ++k)
    results.push_back({files[k], classes[k]});
  return results;
}

} // namespace pcl::indoor::tool
