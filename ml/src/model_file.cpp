/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/ml/model_file.h>

#include "file_bytes.h"
#include "model_header.h"

#include <pcl/exceptions.h>
#include <pcl/indoor/plain_message.h>
#include <pcl/indoor/require_valid.h>

#include <Eigen/Core> // for Eigen::half

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace pcl::indoor {

namespace {

const std::string format_name = "pcl_indoor_model ";
const std::string first_line = format_name + "1\n";
constexpr std::size_t longest_header = std::size_t(1) << 24;
constexpr std::size_t checksum_size = 4;

/** \brief Throw a text of one line; names in it may have line feeds. */
[[noreturn]] void
refuse(std::string problem)
{
  std::replace_if(
      problem.begin(),
      problem.end(),
      [](char letter) { return static_cast<unsigned char>(letter) < ' '; },
      ' ');
  PCL_THROW_EXCEPTION(IOException, problem);
}

/** \brief Append an unsigned number, the lowest byte first. */
template <typename T>
void
append(std::string& bytes, T number)
{
  for (std::size_t k = 0; k < sizeof(T); ++k)
    bytes.push_back(static_cast<char>(number >> (8 * k) & 0xff));
}

/** \brief Whether a layer's weights may be stored in 16 bits. Scale and BatchNorm may
 * divide by tiny deviations. */
bool
isHalved(const Layer& layer, bool half_precision)
{
  return half_precision &&
         (layer.kind == LayerKind::Dense || layer.kind == LayerKind::Convolution);
}

/** \brief Call with each layer and its input's shape, inner layers after their
 * Transform. */
template <typename Layers, typename Visit>
void
forEachLayer(Layers& layers, Shape shape, const Visit& visit)
{
  for (auto& layer : layers) {
    visit(layer, shape);
    forEachLayer(layer.inner, shape, visit);
    shape = outputShape(layer, shape);
  }
}

std::size_t
weightBytes(const ClassifierModel& model, bool half_precision)
{
  std::size_t bytes = 0;
  for (const auto& network : model.networks)
    forEachLayer(
        network.layers, network.input, [&](const Layer& layer, const Shape& shape) {
          for (const auto& weights : weightShapes(layer, shape))
            bytes += valueCount(weights) * (isHalved(layer, half_precision) ? 2 : 4);
        });
  return bytes;
}

void
appendWeights(std::string& bytes, const Layer& layer, bool half_precision)
{
  const bool is_halved = isHalved(layer, half_precision);
  for (const auto& weights : layer.weights)
    for (const float value : weights.values) {
      if (!is_halved) {
        std::uint32_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        append(bytes, bits);
        continue;
      }
      const auto half = Eigen::half_impl::float_to_half_rtne(value);
      if (!std::isfinite(Eigen::half_impl::half_to_float(half)))
        PCL_THROW_EXCEPTION(BadArgumentException,
                            "A weight of " << value << " is too large for 16 bits");
      append(bytes, static_cast<std::uint16_t>(half.x));
    }
}

/** \brief Make and fill a layer's weights. \return the byte behind them */
const char*
readWeights(const char* bytes, Layer& layer, const Shape& shape, bool half_precision)
{
  const bool is_halved = isHalved(layer, half_precision);
  for (const auto& weight_shape : weightShapes(layer, shape)) {
    Tensor weights{weight_shape, std::vector<float>(valueCount(weight_shape))};
    for (float& value : weights.values)
      if (is_halved) {
        value = Eigen::half_impl::half_to_float(
            Eigen::half_impl::raw_uint16_to_half(numberAt<std::uint16_t>(bytes)));
        bytes += 2;
      }
      else {
        value = floatAt(bytes);
        bytes += 4;
      }
    layer.weights.push_back(std::move(weights));
  }
  return bytes;
}

/** \brief The end of the second line, behind its line feed. */
std::size_t
headerEnd(const std::string& bytes)
{
  if (bytes.compare(0, format_name.size(), format_name) != 0)
    refuse("is no model of pcl_indoor");
  if (bytes.compare(0, first_line.size(), first_line) != 0) {
    const auto end = bytes.find('\n');
    if (end == std::string::npos || end > format_name.size() + 9)
      refuse("is a damaged model: its first line is not complete");
    refuse(
        "is a model of format " +
        std::to_string(std::strtoul(bytes.c_str() + format_name.size(), nullptr, 10)) +
        ", of which only 1 can be read");
  }
  const auto end = bytes.find('\n', first_line.size());
  if (end == std::string::npos || end > longest_header)
    refuse("is a damaged model: its header has no end");
  return end + 1;
}

} // namespace

std::string
modelBytes(const ClassifierModel& model, bool half_precision)
{
  requireValid(model);
  const std::size_t weight_bytes = weightBytes(model, half_precision);
  std::string bytes =
      first_line + headerText({model, half_precision, weight_bytes}) + "\n";
  const std::size_t header_size = bytes.size();
  bytes.reserve(header_size + weight_bytes + 2 * checksum_size);
  for (const auto& network : model.networks)
    forEachLayer(network.layers, network.input, [&](const Layer& layer, const Shape&) {
      appendWeights(bytes, layer, half_precision);
    });
  const auto weight_checksum = checksum(bytes.data() + header_size, weight_bytes);
  append(bytes, checksum(bytes.data(), header_size));
  append(bytes, weight_checksum);
  return bytes;
}

ClassifierModel
modelFromBytes(const std::string& bytes)
{
  const std::size_t header_size = headerEnd(bytes);
  auto header =
      readHeader(bytes.substr(first_line.size(), header_size - 1 - first_line.size()));
  const std::size_t rest = bytes.size() - header_size;
  if (header.weight_bytes > rest || rest - header.weight_bytes != 2 * checksum_size)
    refuse("is a damaged model: " + std::to_string(rest) +
           " bytes follow its header, not " + std::to_string(header.weight_bytes) +
           " and two checksums");
  const char* const weights = bytes.data() + header_size;
  const char* const checksums = weights + header.weight_bytes;
  if (checksum(bytes.data(), header_size) != numberAt<std::uint32_t>(checksums))
    refuse("is a damaged model: the checksum of its header does not fit");
  if (checksum(weights, header.weight_bytes) !=
      numberAt<std::uint32_t>(checksums + checksum_size))
    refuse("is a damaged model: the checksum of its weights does not fit");
  auto& model = header.model;
  auto problem = findProblem(model, false);
  if (problem.empty() &&
      weightBytes(model, header.half_precision) != header.weight_bytes)
    problem = "its layers need " +
              std::to_string(weightBytes(model, header.half_precision)) +
              " bytes of weights, not " + std::to_string(header.weight_bytes);
  if (problem.empty()) {
    const char* place = weights;
    for (auto& network : model.networks)
      forEachLayer(
          network.layers, network.input, [&](Layer& layer, const Shape& shape) {
            place = readWeights(place, layer, shape, header.half_precision);
          });
    problem = findProblem(model);
  }
  if (!problem.empty())
    refuse("is a model that does not fit itself: " + problem);
  return std::move(model);
}

ClassifierModel
loadModel(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    refuse(path + ": no such file");
  std::ifstream stream(path, std::ios::binary);
  std::string bytes(first_line.size(), '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  try {
    if (bytes.compare(0, format_name.size(), format_name) == 0) // a scan can be large
      bytes.append(std::istreambuf_iterator<char>(stream), {});
    if (stream.bad())
      refuse("cannot be read");
    return modelFromBytes(bytes);
  } catch (const IOException& problem) {
    refuse(path + ": " + plainMessage(problem));
  }
}

} // namespace pcl::indoor
