/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/object_classes.h"

#include "files/tool_error.h"
#include "scene/category_names.h"

#include <pcl/ml/bundled_model.h>
#include <pcl/ml/model_file.h>
#include <pcl/ml/object_classifier.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace pcl::indoor::tool {
namespace {

constexpr std::size_t fewest_points = 20; // of a surface that can be described

/** \brief The class of what cannot be described. */
ObjectClass
withoutDescription(const std::vector<std::string>& names)
{
  ObjectClass result;
  if (const auto other = otherClass(names); other < names.size())
    result.category = other;
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

/** \brief The weighted geometric mean of a model's probabilities and an object's
 * votes. */
std::vector<float>
withVotes(std::vector<float> probabilities,
          const std::vector<std::string>& names,
          const ObjectVotes& votes,
          std::size_t object)
{
  constexpr float weight = 0.75f, least = 1e-3f; // of the votes; of what is never sure
  float sum = 0;
  for (std::size_t c = 0; c < probabilities.size(); ++c) {
    const auto at = std::find(votes.classes.begin(), votes.classes.end(), names[c]);
    const float vote =
        at == votes.classes.end()
            ? 0.0f
            : votes.of_object[object]
                             [static_cast<std::size_t>(at - votes.classes.begin())];
    auto& probability = probabilities[c];
    probability =
        std::pow(probability + least, 1 - weight) * std::pow(vote + least, weight);
    sum += probability;
  }
  for (auto& probability : probabilities)
    probability /= sum;
  return probabilities;
}

} // namespace

std::string
modelFile(const SceneOptions& options)
{
  return options.naming.classify || options.model == "none" ? ""
         : options.model == "bundled"                       ? bundledModelFile()
                                                            : options.model;
}

std::optional<ObjectNaming>
namingOf(const SceneOptions& options)
{
  if (options.naming.classify)
    return options.naming;
  const auto file = modelFile(options);
  if (file.empty())
    return {};
  const auto model = std::make_shared<const ClassifierModel>(loadModel(file));
  return ObjectNaming{model->classes,
                      [model](const std::vector<ClassifierObject>& objects) {
                        return classifyObjects(objects, *model, 1);
                      }};
}

std::vector<std::string>
classNames(const ObjectNaming& naming)
{
  std::vector<std::string> names = {"none"};
  names.insert(names.end(), naming.classes.begin(), naming.classes.end());
  return names;
}

std::vector<ObjectClass>
classesOf(const std::vector<ObjectSurface>& surfaces,
          const std::vector<ObjectMeasures>& measures,
          const ObjectNaming& naming,
          const ObjectVotes& votes)
{
  const auto undescribed = withoutDescription(classNames(naming));
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
  const auto found = naming.classify(objects);
  if (found.size() != objects.size())
    throw ToolError("the naming of objects gives " + std::to_string(found.size()) +
                    " results for " + std::to_string(objects.size()) + " objects");
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto& own = found[k].probabilities;
    if (own.empty())
      continue;
    if (own.size() != naming.classes.size())
      throw ToolError("the naming of objects gives " + std::to_string(own.size()) +
                      " probabilities for " + std::to_string(naming.classes.size()) +
                      " classes");
    classes[numbers[k]] = likeliest(
        votes.of_object.empty() ? own
                                : withVotes(own, naming.classes, votes, numbers[k]));
  }
  return classes;
}

} // namespace pcl::indoor::tool
