/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "training_data.h"

#include <algorithm>
#include <random>
#include <utility>

namespace pcl::indoor {

TrainingData
trainingData(const TrainingSet& set, const at::Device& device)
{
  TrainingData data;
  data.first_row.push_back(0);
  for (const auto& draws : set.inputs)
    data.first_row.push_back(data.first_row.back() +
                             static_cast<std::int64_t>(draws.size()));
  const auto row_count = data.first_row.back();
  const auto value_count =
      row_count == 0 ? 0 : static_cast<std::int64_t>(set.inputs[0][0].size());
  data.inputs = at::empty({row_count, value_count}, at::kFloat);
  data.labels = at::empty({row_count}, at::kLong);
  auto* value = data.inputs.data_ptr<float>();
  auto* label = data.labels.data_ptr<std::int64_t>();
  for (std::size_t object = 0; object < set.inputs.size(); ++object)
    for (const auto& draw : set.inputs[object]) {
      value = std::copy(draw.begin(), draw.end(), value);
      *label++ = set.labels[object];
    }
  data.inputs = data.inputs.to(device);
  data.labels = data.labels.to(device);
  return data;
}

std::vector<std::int64_t>
drawnRows(const TrainingData& data, std::uint32_t seed, int epoch)
{
  std::seed_seq seeds{seed, static_cast<std::uint32_t>(epoch)};
  std::mt19937 random(seeds);
  std::vector<std::int64_t> rows;
  for (std::size_t object = 0; object + 1 < data.first_row.size(); ++object) {
    const auto draw_count = data.first_row[object + 1] - data.first_row[object];
    rows.push_back(data.first_row[object] +
                   static_cast<std::int64_t>(random()) % draw_count);
  }
  for (std::size_t k = rows.size(); k > 1; --k)
    std::swap(rows[k - 1], rows[random() % k]);
  return rows;
}

std::vector<std::int64_t>
batchBounds(std::int64_t object_count, std::int64_t batch_size)
{
  std::vector<std::int64_t> bounds{0};
  while (bounds.back() + batch_size < object_count)
    bounds.push_back(bounds.back() + batch_size);
  if (bounds.size() > 1 && batch_size > 1 && object_count - bounds.back() == 1)
    bounds.pop_back();
  bounds.push_back(object_count);
  return bounds;
}

} // namespace pcl::indoor
