/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "arguments.h"
#include "bindings.h"
#include "listener.h"
#include "object_input.h"

#include <pcl/ml/bundled_model.h>
#include <pcl/ml/model_file.h>
#include <pcl/ml/object_classifier.h>

#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace pcl::indoor::python {
namespace {

/** An object, and how far its lowest point is above the floor, if that is known. */
using PlacedInput = std::pair<ObjectInput, std::optional<float>>;

struct ClassSettings {
  std::string model = "bundled";
  int neighbor_count = 20;
  unsigned threads = 0;

  explicit ClassSettings(const Arguments& arguments)
  {
    tool::OptionParser parser("classify", "");
    parser.text("-model", model, "file of a classifier, or bundled")
        .number("-normal_neighbors",
                neighbor_count,
                "neighbours of a normal",
                "points",
                tool::Range::atLeast(3))
        .number("-threads", threads, "threads; 0: all of the machine");
    arguments.readBy(std::move(parser));
  }
};

ClassifierObject
classifierObject(const PlacedInput& input,
                 const ClassSettings& settings,
                 bool wants_place)
{
  const auto object = objectOf(input.first, settings.neighbor_count);
  auto place = object.place;
  if (input.second)
    place = {true, *input.second};
  return {tool::classifierPoints(*object.cloud), wants_place ? place : ObjectPlace()};
}

/** Probabilities of each object, none where it cannot be described. */
std::vector<std::vector<float>>
classified(const std::vector<PlacedInput>& inputs,
           const ClassifierModel& model,
           const ClassSettings& settings)
{
  std::vector<ClassifierObject> objects;
  for (const auto& input : inputs)
    objects.push_back(classifierObject(input, settings, model.input.context));
  std::vector<std::vector<float>> probabilities;
  for (auto& found : classifyObjects(objects, model, settings.threads))
    probabilities.push_back(std::move(found.probabilities));
  return probabilities;
}

/** Names of the classes, and of each object their probabilities. */
py::tuple
classify(const std::vector<PlacedInput>& inputs, const std::vector<std::string>& words)
{
  const ClassSettings settings{Arguments(words)};
  ClassifierModel model;
  auto probabilities = withoutLock([&] {
    model =
        loadModel(settings.model == "bundled" ? bundledModelFile() : settings.model);
    return classified(inputs, model, settings);
  });
  return py::make_tuple(model.classes, std::move(probabilities));
}

} // namespace

void
bindClasses(py::module_& module)
{
  module.def("classify", &classify);
}

} // namespace pcl::indoor::python
