/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "model_header.h"

#include <pcl/exceptions.h>

#include <nlohmann/json.hpp>

#include <limits>

namespace pcl::indoor {

namespace {

using Json = nlohmann::ordered_json;

constexpr int most_nested = 4; // transforms within transforms

const std::vector<std::string> layer_names = {"scale",
                                              "square_root",
                                              "reshape",
                                              "dense",
                                              "convolution",
                                              "batch_norm",
                                              "relu",
                                              "max_pool",
                                              "max_over_positions",
                                              "transform",
                                              "dropout"};
const std::vector<std::string> input_names = {
    "pair_harmonics", "eppf", "eppf_short", "points"};
const std::vector<std::string> precision_names = {"float32", "float16"};

[[noreturn]] void
fail(const std::string& problem)
{
  PCL_THROW_EXCEPTION(IOException, "is a damaged model: its header " << problem);
}

const Json&
part(const Json& json, const char* key)
{
  if (!json.is_object() || !json.contains(key))
    fail(std::string("lacks '") + key + "'");
  return json[key];
}

const Json&
list(const Json& json, const char* key)
{
  const auto& value = part(json, key);
  if (!value.is_array())
    fail(std::string("has a '") + key + "' that is no list");
  return value;
}

/** \brief A whole number of 0 or more; true and 1.5 are none. */
template <typename T>
T
wholeNumber(const Json& value, const char* key)
{
  if (!value.is_number_unsigned() ||
      value.get<std::uint64_t>() > std::uint64_t(std::numeric_limits<T>::max()))
    fail(std::string("has a '") + key + "' that is no whole number in its range");
  return static_cast<T>(value.get<std::uint64_t>());
}

double
number(const Json& json, const char* key)
{
  const auto& value = part(json, key);
  if (!value.is_number())
    fail(std::string("has a '") + key + "' that is no number");
  return value.get<double>();
}

std::string
name(const Json& value, const char* key)
{
  if (!value.is_string())
    fail(std::string("has a '") + key + "' that is no text");
  return value.get<std::string>();
}

/** \brief The number of a name. */
std::size_t
choice(const Json& json, const char* key, const std::vector<std::string>& names)
{
  const auto text = name(part(json, key), key);
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k] == text)
      return k;
  fail(std::string("has a '") + key + "' that is not known");
}

Shape
readShape(const Json& json, const char* key)
{
  Shape shape;
  for (const auto& extent : list(json, key))
    shape.push_back(wholeNumber<int>(extent, key));
  return shape;
}

std::vector<Layer>
readLayers(const Json& json, const char* key, int depth)
{
  if (depth > most_nested)
    fail("has too many layers within layers");
  std::vector<Layer> layers;
  for (const auto& value : list(json, key)) {
    Layer layer;
    layer.kind = static_cast<LayerKind>(choice(value, "kind", layer_names));
    if (value.contains("extents"))
      layer.extents = readShape(value, "extents");
    if (layer.kind == LayerKind::Dropout)
      layer.rate = static_cast<float>(number(value, "rate"));
    if (layer.kind == LayerKind::Transform)
      layer.inner = readLayers(value, "inner", depth + 1);
    layers.push_back(std::move(layer));
  }
  return layers;
}

Json
layersJson(const std::vector<Layer>& layers)
{
  Json list = Json::array();
  for (const auto& layer : layers) {
    Json json;
    json["kind"] = layer_names[static_cast<std::size_t>(layer.kind)];
    if (!layer.extents.empty())
      json["extents"] = layer.extents;
    if (layer.kind == LayerKind::Dropout)
      json["rate"] = layer.rate;
    if (layer.kind == LayerKind::Transform)
      json["inner"] = layersJson(layer.inner);
    list.push_back(std::move(json));
  }
  return list;
}

ClassifierInput
readInput(const Json& json)
{
  ClassifierInput input;
  input.kind = static_cast<ClassifierInputKind>(choice(json, "kind", input_names));
  input.scale = number(json, "scale");
  input.pair_count = wholeNumber<std::uint32_t>(part(json, "pair_count"), "pair_count");
  input.draws = wholeNumber<int>(part(json, "draws"), "draws");
  const auto& context = part(json, "context");
  if (!context.is_boolean())
    fail("has a 'context' that is neither true nor false");
  input.context = context.get<bool>();
  input.point_count = wholeNumber<int>(part(json, "point_count"), "point_count");
  return input;
}

} // namespace

std::string
headerText(const ModelHeader& header)
{
  const auto& input = header.model.input;
  Json json;
  json["classes"] = header.model.classes;
  auto& input_json = json["input"];
  input_json["kind"] = input_names[static_cast<std::size_t>(input.kind)];
  input_json["scale"] = input.scale;
  input_json["pair_count"] = input.pair_count;
  input_json["draws"] = input.draws;
  input_json["context"] = input.context;
  input_json["point_count"] = input.point_count;
  json["networks"] = Json::array();
  for (const auto& network : header.model.networks) {
    Json network_json;
    network_json["input"] = network.input;
    network_json["layers"] = layersJson(network.layers);
    json["networks"].push_back(std::move(network_json));
  }
  json["precision"] = precision_names[header.half_precision ? 1 : 0];
  json["weight_bytes"] = header.weight_bytes;
  try {
    return json.dump();
  } catch (const Json::exception&) {
    PCL_THROW_EXCEPTION(BadArgumentException, "the name of a class is not UTF-8");
  }
}

ModelHeader
readHeader(const std::string& text)
{
  const auto json = Json::parse(text, nullptr, false);
  if (json.is_discarded())
    fail("is not JSON");
  ModelHeader header;
  for (const auto& value : list(json, "classes"))
    header.model.classes.push_back(name(value, "classes"));
  header.model.input = readInput(part(json, "input"));
  for (const auto& value : list(json, "networks"))
    header.model.networks.push_back(
        {readShape(value, "input"), readLayers(value, "layers", 1)});
  header.half_precision = choice(json, "precision", precision_names) == 1;
  header.weight_bytes =
      wholeNumber<std::size_t>(part(json, "weight_bytes"), "weight_bytes");
  return header;
}

} // namespace pcl::indoor
