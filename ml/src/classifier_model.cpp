/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/ml/classifier_model.h>
#include <pcl/ml/object_classifier.h> // for inputValueCount

#include <cmath>
#include <set>
#include <sstream>

namespace pcl::indoor {

namespace {

std::string
findProblem(const ClassifierInput& input)
{
  std::ostringstream problem;
  const bool is_points = input.kind == ClassifierInputKind::Points;
  if (!(input.scale >= 0.0) || !std::isfinite(input.scale))
    problem << "the scale must be at least 0 m, not " << input.scale;
  else if (input.pair_count < 1)
    problem << "at least 1 pair of points must be drawn";
  else if (input.draws < 1 || input.draws > most_draws)
    problem << "objects must be described 1 to " << most_draws << " times, not "
            << input.draws;
  else if (input.point_count < 1 || input.point_count > most_points)
    problem << "1 to " << most_points << " points must be drawn, not "
            << input.point_count;
  else if (is_points && input.context)
    problem << "size and place cannot follow after points";
  return problem.str();
}

std::string
wrongNames(const std::vector<std::string>& classes)
{
  if (classes.size() < 2)
    return "a model needs at least 2 classes, not " + std::to_string(classes.size());
  std::set<std::string> names;
  for (const auto& name : classes) {
    if (name.empty())
      return "a class has no name";
    if (!names.insert(name).second)
      return "two classes are called '" + name + "'";
  }
  return "";
}

} // namespace

std::string
findProblem(const ClassifierModel& model, bool wants_weights)
{
  auto problem = wrongNames(model.classes);
  if (problem.empty())
    problem = findProblem(model.input);
  if (!problem.empty())
    return problem;
  if (model.networks.empty())
    return "a model needs at least one network";
  const std::size_t value_count = inputValueCount(model.input);
  for (const auto& network : model.networks) {
    problem = findProblem(network, wants_weights);
    if (!problem.empty())
      return problem;
    if (valueCount(network.input) != value_count)
      return "a network takes " + std::to_string(valueCount(network.input)) +
             " values, but an object has " + std::to_string(value_count);
    const auto score_count = valueCount(outputShape(network.layers, network.input));
    if (score_count != model.classes.size())
      return "a network gives " + std::to_string(score_count) + " scores for " +
             std::to_string(model.classes.size()) + " classes";
  }
  return "";
}

} // namespace pcl::indoor
