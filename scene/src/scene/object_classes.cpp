/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/object_classes.h"

#include "scene/category_names.h"

#include <pcl/ml/object_classifier.h>

#include <algorithm>
#include <filesystem>
#include <numeric>

namespace pcl::indoor::tool {
namespace {

constexpr std::size_t fewest_points = 20; // of a surface that can be described

/** \brief The class of what cannot be described. */
ObjectClass
withoutDescription(const std::vector<std::string>& names)
{
  const auto other = std::find(names.begin(), names.end(), other_class);
  ObjectClass result;
  if (other != names.end())
    result.category = static_cast<std::uint32_t>(other - names.begin());
  return result;
}

ObjectClass
likeliest(const std::vector<float>& probabilities)
{
  std::vector<std::uint32_t> order(probabilities.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return probabilities[a] > probabilities[b];
  });
  ObjectClass result;
  for (std::size_t k = 0; k < std::min<std::size_t>(order.size(), 3); ++k)
    result.top.emplace_back(order[k] + 1, probabilities[order[k]]);
  result.category = result.top.front().first;
  result.confidence = result.top.front().second;
  return result;
}

} // namespace

std::string
bundledModel()
{
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  const auto folder = program.parent_path().parent_path() / "share" / "pcl_indoor";
  return (folder / "indoor_objects.model").string();
}

std::vector<std::string>
classNames(const ClassifierModel& model)
{
  std::vector<std::string> names = {"none"};
  names.insert(names.end(), model.classes.begin(), model.classes.end());
  return names;
}

std::vector<ObjectClass>
classesOf(const std::vector<ObjectSurface>& surfaces,
          const std::vector<ObjectMeasures>& measures,
          const ClassifierModel& model,
          int threads)
{
  const auto undescribed = withoutDescription(classNames(model));
  std::vector<ObjectClass> classes(surfaces.size());
  std::vector<ClassifierObject> objects;
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    const auto& surface = surfaces[k];
    if (measures[k].structure != 0)
      continue;
    classes[k] = undescribed;
    if (surface.points.size() < fewest_points)
      continue;
    numbers.push_back(k);
    objects.push_back({surface.points, {true, surface.floor_distance}});
  }
  const auto found =
      classifyObjects(objects, model, static_cast<unsigned int>(threads));
  for (std::size_t k = 0; k < found.size(); ++k)
    if (!found[k].probabilities.empty())
      classes[numbers[k]] = likeliest(found[k].probabilities);
  return classes;
}

} // namespace pcl::indoor::tool
