/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "file_bytes.h"
#include "voxels/row_sums.h"
#include "voxels/voxel_levels.h"

#include <pcl/ml/voxel_network.h>

#include <pcl/exceptions.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <iterator>

namespace pcl::indoor {

namespace {

const std::string first_line = "pcl_indoor_voxel_network 1\n";
constexpr std::size_t widest = 1024, most_classes = 1000;

[[noreturn]] void
refuse(const std::string& path, const std::string& problem)
{
  PCL_THROW_EXCEPTION(IOException, path << ": " << problem);
}

std::string
contentOf(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  if (!file)
    refuse(path, "cannot be read");
  return {std::istreambuf_iterator<char>(file), {}};
}

/** \brief Reads layers one after the other: for each output a factor and a bias, both
 * 32-bit floating-point numbers, then weights in 8 bits with a sign. */
class LayerReader {
public:
  LayerReader(const std::string& path, const char* bytes, std::size_t count)
  : path_(path)
  , bytes_(bytes)
  , left_(count)
  {}

  VoxelLayer
  read(std::size_t taps, std::size_t inputs, std::size_t outputs)
  {
    VoxelLayer layer;
    layer.inputs = inputs;
    layer.outputs = (outputs + row_lanes - 1) / row_lanes * row_lanes;
    const auto factors = numbers(outputs);
    layer.bias = numbers(outputs);
    layer.bias.resize(layer.outputs, 0.0f);
    const char* const weights = take(taps * inputs * outputs);
    layer.weights.assign(taps * inputs * layer.outputs, 0.0f);
    for (std::size_t row = 0; row < taps * inputs; ++row)
      for (std::size_t out = 0; out < outputs; ++out)
        layer.weights[row * layer.outputs + out] =
            factors[out] * static_cast<signed char>(weights[row * outputs + out]);
    return layer;
  }

  void
  requireEnd() const
  {
    if (left_ != 0)
      refuse(path_, "has " + std::to_string(left_) + " bytes too many");
  }

private:
  const char*
  take(std::size_t count)
  {
    if (count > left_)
      refuse(path_, "is cut off");
    const char* const taken = bytes_;
    bytes_ += count;
    left_ -= count;
    return taken;
  }

  std::vector<float>
  numbers(std::size_t count)
  {
    const char* const taken = take(4 * count);
    std::vector<float> values(count);
    for (std::size_t i = 0; i < count; ++i) {
      values[i] = floatAt(taken + 4 * i);
      if (!std::isfinite(values[i]))
        refuse(path_, "has a weight that is no number");
    }
    return values;
  }

  const std::string& path_;
  const char* bytes_;
  std::size_t left_;
};

/** \brief Classes, widths and the size of voxels. */
VoxelNetwork
readHeader(const std::string& path, const std::string& line)
{
  VoxelNetwork network;
  try {
    const auto header = nlohmann::json::parse(line);
    header.at("classes").get_to(network.classes);
    for (const auto& width : header.at("widths")) // 1e308 is no whole number
      network.widths.push_back(width.is_number_unsigned() ? width.get<std::size_t>()
                                                          : 0);
    header.at("voxel_size").get_to(network.voxel_size);
  } catch (const nlohmann::json::exception&) {
    refuse(path, "has a header that is none");
  }
  bool fits = network.classes.size() >= building_classes &&
              network.classes.size() <= most_classes && network.voxel_size > 0 &&
              std::isfinite(network.voxel_size) && network.widths.size() >= 2 &&
              network.widths.size() <= most_voxel_levels;
  for (const auto width : network.widths)
    fits = fits && width > 0 && width <= widest && width % row_lanes == 0;
  if (!fits)
    refuse(path, "has a header that fits no network");
  return network;
}

} // namespace

VoxelNetwork
loadVoxelNetwork(const std::string& path)
{
  const auto content = contentOf(path);
  if (content.compare(0, first_line.size(), first_line) != 0)
    refuse(path, "is no voxel network");
  const auto header_end = content.find('\n', first_line.size());
  if (header_end == std::string::npos || content.size() < header_end + 1 + 4)
    refuse(path, "is cut off");
  const std::size_t size = content.size() - 4;
  if (checksum(content.data(), size) != numberAt<std::uint32_t>(content.data() + size))
    refuse(path, "is damaged or cut off");
  auto network = readHeader(
      path, content.substr(first_line.size(), header_end - first_line.size()));
  LayerReader reader(path, content.data() + header_end + 1, size - header_end - 1);
  const auto& widths = network.widths;
  network.stem = reader.read(27, voxel_inputs, widths[0]);
  for (const auto width : widths) {
    network.first.push_back(reader.read(27, width, width));
    network.second.push_back(reader.read(27, width, width));
  }
  for (std::size_t k = 0; k + 1 < widths.size(); ++k) {
    network.down.push_back(reader.read(8, widths[k], widths[k + 1]));
    network.up.push_back(reader.read(8, widths[k + 1], widths[k]));
    network.joined.push_back(reader.read(27, 2 * widths[k], widths[k]));
  }
  network.last = reader.read(1, widths[0], network.classes.size() + 3);
  reader.requireEnd();
  return network;
}

} // namespace pcl::indoor
