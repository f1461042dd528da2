/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/labelled_objects.h"

#include "files/random_numbers.h"
#include "formats/table/table_words.h" // for readNumber
#include "objects/object_files.h"
#include "text/printable.h"

#include <pcl/indoor/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>

namespace pcl::indoor::tool {
namespace {

/** \brief Put the objects into the parts, in their order. */
template <typename IsTest>
ObjectSplit
splitBy(std::size_t count, const IsTest& is_test)
{
  ObjectSplit split;
  for (std::size_t k = 0; k < count; ++k)
    (is_test(k) ? split.test : split.training).push_back(k);
  return split;
}

/** \brief Names by which a list may mean an object. */
std::vector<std::string>
namesOf(const std::string& path)
{
  const std::filesystem::path whole(path);
  auto without_extension = whole;
  without_extension.replace_extension();
  const auto stem = whole.stem().string();
  std::vector<std::string> names{
      path, without_extension.string(), whole.filename().string(), stem};
  for (auto end = stem.find('_'); end != std::string::npos;
       end = stem.find('_', end + 1))
    names.push_back(stem.substr(0, end));
  return names;
}

} // namespace

void
requireNoProblems(const std::vector<std::string>& problems, const std::string& what)
{
  const auto is_one = [](const std::string& problem) { return !problem.empty(); };
  const auto first = std::find_if(problems.begin(), problems.end(), is_one);
  if (first == problems.end())
    return;
  const auto count = std::count_if(problems.begin(), problems.end(), is_one);
  throw ToolError(*first +
                  (count == 1 ? std::string()
                              : " (the first of " + std::to_string(count) + " " + what +
                                    " of " + std::to_string(problems.size()) + ")"));
}

LabelledObjects
loadLabelledObjects(const std::string& folder,
                    int neighbor_count,
                    unsigned int number_of_threads,
                    StageReport& report)
{
  LabelledObjects objects;
  objects.paths = objectFilesIn(folder);
  for (const auto& path : objects.paths) {
    const auto name = classFolder(path);
    if (name.empty())
      throw ToolError(path + ": lies in no class folder of " + folder);
    if (objects.class_names.empty() || objects.class_names.back() != name)
      objects.class_names.push_back(name); // paths are sorted
    objects.labels.push_back(static_cast<int>(objects.class_names.size()) - 1);
  }
  if (objects.class_names.size() < 2)
    throw ToolError(folder + ": at least two class folders are needed");
  report.start("Loading " + folder);
  const auto count = objects.paths.size();
  objects.clouds.resize(count);
  objects.places.resize(count);
  std::vector<std::string> problems(count);
  std::size_t done = 0;
  std::mutex mutex; // of the report
  parallelFor(static_cast<std::ptrdiff_t>(count),
              static_cast<int>(number_of_threads),
              1,
              [&](std::ptrdiff_t i) {
                const auto k = static_cast<std::size_t>(i);
                try {
                  const auto path = std::filesystem::path(folder) / objects.paths[k];
                  auto object = loadPlacedObject(path.string(), neighbor_count);
                  objects.clouds[k] = std::move(object.cloud);
                  objects.places[k] = object.place;
                } catch (const std::exception& error) {
                  problems[k] = messageOf(error);
                }
                const std::lock_guard<std::mutex> lock(mutex);
                report.update(++done, count);
              });
  requireNoProblems(problems, "unreadable files");
  report.done(std::to_string(count) + " objects of " +
              std::to_string(objects.class_names.size()) + " classes");
  return objects;
}

ObjectSplit
splitAtRandom(const LabelledObjects& objects, double share, std::uint32_t seed)
{
  std::vector<std::vector<std::size_t>> of_class(objects.class_names.size());
  for (std::size_t k = 0; k < objects.labels.size(); ++k)
    of_class[static_cast<std::size_t>(objects.labels[k])].push_back(k);
  std::mt19937 rng(seed);
  std::vector<bool> is_test(objects.labels.size(), true);
  for (std::size_t c = 0; c < of_class.size(); ++c) {
    auto& own = of_class[c];
    if (own.size() < 2)
      throw ToolError(objects.class_names[c] +
                      ": a class needs two objects to be split, it has " +
                      std::to_string(own.size()));
    const auto wanted = std::lround(share * static_cast<double>(own.size()));
    const auto taken =
        std::clamp<std::size_t>(static_cast<std::size_t>(wanted), 1, own.size() - 1);
    drawToFront(own, taken, rng);
    for (std::size_t k = 0; k < taken; ++k)
      is_test[own[k]] = false;
  }
  return splitBy(is_test.size(), [&](std::size_t k) { return is_test[k]; });
}

ObjectSplit
splitByFolders(const LabelledObjects& objects)
{
  const auto split = splitBy(objects.paths.size(), [&](std::size_t k) {
    const auto& path = objects.paths[k];
    const auto below_class = path.substr(path.find('/') + 1);
    const auto part = below_class.substr(0, below_class.find('/'));
    if (part == below_class || (part != "train" && part != "test"))
      throw ToolError(path + ": lies in neither folder train nor test of its class");
    return part == "test";
  });
  if (split.training.empty() || split.test.empty())
    throw ToolError(std::string("there is no object in the folders ") +
                    (split.test.empty() ? "test" : "train"));
  return split;
}

ObjectSplit
splitByList(const LabelledObjects& objects, const std::string& list_path)
{
  std::ifstream stream(list_path);
  if (!stream.is_open() || std::filesystem::is_directory(list_path))
    throw ToolError(list_path + ": no such list of the test part");
  std::set<std::string> listed;
  for (std::string line; std::getline(stream, line);) {
    const auto end = line.find_last_not_of(" \t\r");
    if (end != std::string::npos)
      listed.insert(line.substr(0, end + 1));
  }
  const auto split = splitBy(objects.paths.size(), [&](std::size_t k) {
    const auto names = namesOf(objects.paths[k]);
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
      return listed.count(name) > 0;
    });
  });
  if (split.test.empty())
    throw ToolError(list_path + ": names none of the objects");
  if (split.training.empty())
    throw ToolError(list_path + ": names all objects, none is left to train with");
  return split;
}

std::optional<double>
randomShare(const std::string& split)
{
  const std::string lead = "random:";
  if (split.rfind(lead, 0) != 0)
    return std::nullopt;
  double share = 0.0;
  if (!readNumber(std::string_view(split).substr(lead.size()), share) ||
      !(share > 0.0 && share < 1.0))
    throw ToolError("-split: '" + split +
                    "' has no share of the training part between 0 and 1, as "
                    "random:0.8 has");
  return share;
}

ObjectSplit
splitNamed(const LabelledObjects& objects, const std::string& split, std::uint32_t seed)
{
  ObjectSplit parts;
  if (split == "none")
    parts = splitBy(objects.labels.size(), [](std::size_t) { return false; });
  else if (split == "folders")
    parts = splitByFolders(objects);
  else if (const auto share = randomShare(split))
    parts = splitAtRandom(objects, *share, seed);
  else
    parts = splitByList(objects, split);
  std::vector<bool> is_trained(objects.class_names.size(), false);
  for (const auto k : parts.training)
    is_trained[static_cast<std::size_t>(objects.labels[k])] = true;
  const auto without = std::find(is_trained.begin(), is_trained.end(), false);
  if (without != is_trained.end())
    throw ToolError(
        objects.class_names[static_cast<std::size_t>(without - is_trained.begin())] +
        ": the split leaves no object of this class to train with");
  return parts;
}

ObjectSplit
withoutShare(const LabelledObjects& objects,
             const std::vector<std::size_t>& training,
             double share,
             std::uint32_t seed)
{
  if (share == 0.0)
    return {training, {}};
  LabelledObjects part;
  part.class_names = objects.class_names;
  for (const auto k : training)
    part.labels.push_back(objects.labels[k]);
  auto split = splitAtRandom(part, 1.0 - share, seed);
  for (auto* const indices : {&split.training, &split.test})
    for (auto& index : *indices)
      index = training[index];
  return split;
}

} // namespace pcl::indoor::tool
