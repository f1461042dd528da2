/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "training_checkpoint.h"

#include <pcl/exceptions.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>

namespace pcl::indoor {

namespace {

constexpr std::uint64_t format = 0x31544e49524f4f44; // of this machine's byte order

/** \brief FNV-1a over words of 8 bytes. */
class Hash {
public:
  void
  add(const void* data, std::size_t size)
  {
    const auto* bytes = static_cast<const char*>(data);
    for (std::size_t k = 0; k < size; k += sizeof(std::uint64_t)) {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes + k, std::min(sizeof(word), size - k));
      value = (value ^ word) * 1099511628211U;
      value ^= value >> 32;
    }
  }

  std::uint64_t value = 14695981039346656037U;
};

/** \brief Visits the parts of what is hashed, written or read: one order for all. */
using Visit = std::function<void(void* data, std::size_t size)>;

template <typename Value>
void
visitValue(const Visit& visit, Value& value)
{
  visit(&value, sizeof(value));
}

void
visitValues(const Visit& visit, std::vector<float>& values)
{
  visit(values.data(), values.size() * sizeof(float));
}

void
visitWeights(const Visit& visit, std::vector<Layer>& layers)
{
  for (auto& layer : layers) {
    for (auto& tensor : layer.weights)
      visitValues(visit, tensor.values);
    visitWeights(visit, layer.inner);
  }
}

void
visitState(const Visit& visit, TrainingState& state)
{
  for (auto& epoch : state.epochs) {
    visitValue(visit, epoch.epoch);
    visitValue(visit, epoch.training_loss);
    visitValue(visit, epoch.training_accuracy);
    visitValue(visit, epoch.validation_loss);
    visitValue(visit, epoch.validation_accuracy);
  }
  visitValue(visit, state.best_epoch);
  visitValue(visit, state.step_count);
  visitWeights(visit, state.network.layers);
  visitWeights(visit, state.best.layers);
  for (auto& values : state.moments)
    visitValues(visit, values);
}

template <typename Value>
void
add(Hash& hash, Value value)
{
  hash.add(&value, sizeof(value));
}

void
add(Hash& hash, const Shape& shape)
{
  add(hash, shape.size());
  for (const int extent : shape)
    add(hash, extent);
}

void
add(Hash& hash, const std::vector<float>& values)
{
  add(hash, values.size());
  hash.add(values.data(), values.size() * sizeof(float));
}

void
add(Hash& hash, const std::vector<Layer>& layers)
{
  add(hash, layers.size());
  for (const auto& layer : layers) {
    add(hash, static_cast<int>(layer.kind));
    add(hash, layer.extents);
    add(hash, layer.rate);
    for (const auto& weights : layer.weights)
      add(hash, weights.values);
    add(hash, layer.inner);
  }
}

void
add(Hash& hash, const TrainingSet& set)
{
  add(hash, set.inputs.size());
  for (std::size_t object = 0; object < set.inputs.size(); ++object) {
    add(hash, set.labels[object]);
    add(hash, set.inputs[object].size());
    for (const auto& draw : set.inputs[object])
      add(hash, draw);
  }
}

[[noreturn]] void
refuse(const std::string& file, const std::string& reason)
{
  PCL_THROW_EXCEPTION(IOException, "Checkpoint " << file << " " << reason);
}

std::string
besideIt(const std::string& file)
{
  return file + ".part";
}

} // namespace

TrainingIdentity
trainingIdentity(const Network& network,
                 const TrainingSet& training,
                 const TrainingSet& validation,
                 const TrainingOptions& options)
{
  Hash of_network;
  add(of_network, network.input);
  add(of_network, network.layers);
  Hash of_options;
  add(of_options, options.epoch_count);
  add(of_options, options.batch_size);
  add(of_options, options.learning_rate);
  add(of_options, options.weight_decay);
  add(of_options, options.label_smoothing);
  add(of_options, options.class_balance);
  add(of_options, options.seed);
  Hash of_sets;
  add(of_sets, training);
  add(of_sets, validation);
  return {of_network.value, of_options.value, of_sets.value};
}

void
requireWritable(const std::string& file)
{
  const auto part = besideIt(file);
  if (std::filesystem::is_directory(file) || !std::ofstream(part, std::ios::binary))
    refuse(file, "cannot be written");
  std::remove(part.c_str());
}

void
writeCheckpoint(const std::string& file,
                const TrainingIdentity& identity,
                const TrainingState& state)
{
  const auto part = besideIt(file);
  std::ofstream stream(part, std::ios::binary | std::ios::trunc);
  Hash hash;
  const Visit write = [&](void* data, std::size_t size) {
    hash.add(data, size);
    stream.write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
  };
  std::uint64_t header[] = {
      format, identity.network, identity.options, identity.sets, state.epochs.size()};
  visitValue(write, header);
  visitState(write, const_cast<TrainingState&>(state)); // writing changes nothing
  std::uint64_t end = hash.value;
  visitValue(write, end);
  stream.close();
  if (!stream || std::rename(part.c_str(), file.c_str()) != 0) {
    std::remove(part.c_str());
    refuse(file, "cannot be written");
  }
}

bool
readCheckpoint(const std::string& file,
               const TrainingIdentity& identity,
               TrainingState& state)
{
  std::ifstream stream(file, std::ios::binary);
  if (!stream && !std::filesystem::exists(file))
    return false;
  if (!stream)
    refuse(file, "cannot be read");
  Hash hash;
  const Visit read = [&](void* data, std::size_t size) {
    if (!stream.read(static_cast<char*>(data), static_cast<std::streamsize>(size)))
      refuse(file, "is damaged: it ends too early");
    hash.add(data, size);
  };
  std::uint64_t header[5] = {};
  visitValue(read, header);
  if (header[0] != format)
    refuse(file, "is no checkpoint of a training");
  if (header[1] != identity.network)
    refuse(file, "is of another network or of other first weights");
  if (header[2] != identity.options)
    refuse(file, "is of a training with other options");
  if (header[3] != identity.sets)
    refuse(file, "is of a training with other objects");
  if (header[4] > (1U << 24))
    refuse(file, "is damaged: it has too many epochs");
  state.epochs.resize(header[4]);
  visitState(read, state);
  const auto expected = hash.value;
  std::uint64_t end = 0;
  visitValue(read, end);
  if (end != expected)
    refuse(file, "is damaged: its values have changed");
  return true;
}

} // namespace pcl::indoor
