/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "voxels/row_sums.h"
#include "voxels/voxel_levels.h"

#include <pcl/indoor/quantile.h>
#include <pcl/ml/voxel_network.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace pcl::indoor {

namespace {

using Rows = std::vector<float>;

constexpr double most_at_once = 40;     // m; what is wider is gone through in tiles
constexpr double tile = 16, around = 4; // m, about what an output depends on
constexpr double low_share =
    0.05; // of the points are below the height that counts as 0

/** \brief Points in voxels. */
struct Voxels {
  std::vector<std::uint64_t> keys; ///< ascending
  std::vector<std::uint32_t> voxel_of_point;
  Rows inputs; ///< voxel_inputs of each
};

Eigen::Vector3d
cellOf(const Eigen::Vector3f& point, double voxel_size)
{
  return (point.cast<double>() / voxel_size).array().floor();
}

float
lowLevel(const std::vector<Eigen::Vector3f>& points)
{
  std::vector<float> heights;
  heights.reserve(points.size());
  for (const auto& point : points)
    heights.push_back(point.z());
  return quantile(heights, low_share);
}

std::vector<std::uint64_t>
keysOf(const std::vector<Eigen::Vector3f>& points, double voxel_size)
{
  Eigen::Vector3d least = cellOf(points.front(), voxel_size);
  for (const auto& point : points)
    least = least.cwiseMin(cellOf(point, voxel_size));
  std::vector<std::uint64_t> keys;
  keys.reserve(points.size());
  for (const auto& point : points) {
    const Eigen::Vector3d place =
        cellOf(point, voxel_size) - least + Eigen::Vector3d::Constant(least_coordinate);
    keys.push_back(voxelKey(static_cast<std::uint64_t>(place.x()),
                            static_cast<std::uint64_t>(place.y()),
                            static_cast<std::uint64_t>(place.z())));
  }
  return keys;
}

Voxels
voxelsOf(const std::vector<Eigen::Vector3f>& points, double voxel_size, double low)
{
  Voxels voxels;
  const auto key_of_point = keysOf(points, voxel_size);
  voxels.keys = key_of_point;
  std::sort(voxels.keys.begin(), voxels.keys.end());
  voxels.keys.erase(std::unique(voxels.keys.begin(), voxels.keys.end()),
                    voxels.keys.end());
  std::vector<Eigen::Vector3d> offsets(voxels.keys.size(), Eigen::Vector3d::Zero());
  std::vector<double> heights(voxels.keys.size(), 0.0);
  std::vector<std::uint32_t> counts(voxels.keys.size(), 0);
  voxels.voxel_of_point.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto voxel = static_cast<std::size_t>(
        std::lower_bound(voxels.keys.begin(), voxels.keys.end(), key_of_point[i]) -
        voxels.keys.begin());
    voxels.voxel_of_point.push_back(static_cast<std::uint32_t>(voxel));
    offsets[voxel] += points[i].cast<double>() / voxel_size -
                      cellOf(points[i], voxel_size) - Eigen::Vector3d::Constant(0.5);
    heights[voxel] += points[i].z() - low;
    ++counts[voxel];
  }
  voxels.inputs.reserve(voxel_inputs * voxels.keys.size());
  for (std::size_t v = 0; v < voxels.keys.size(); ++v) {
    const Eigen::Vector3d offset = offsets[v] / counts[v];
    const double height = std::clamp(heights[v] / counts[v] / 2, -0.5, 2.0);
    for (const double value : {1.0, height, offset.x(), offset.y(), offset.z()})
      voxels.inputs.push_back(static_cast<float>(value));
  }
  return voxels;
}

/** \brief Sums of the taps' pairs for so many rows. */
template <std::size_t taps>
Rows
summed(const VoxelLayer& layer,
       const std::array<RowPairs, taps>& pairs,
       const Rows& values,
       std::size_t row_count)
{
  Rows sums;
  sums.reserve(row_count * layer.outputs);
  for (std::size_t row = 0; row < row_count; ++row)
    sums.insert(sums.end(), layer.bias.begin(), layer.bias.end());
  for (std::size_t tap = 0; tap < taps; ++tap)
    addRowSums(pairs[tap],
               values,
               layer.inputs,
               layer.weights.data() + tap * layer.inputs * layer.outputs,
               layer.outputs,
               sums);
  return sums;
}

void
rectify(Rows& values)
{
  for (auto& value : values)
    value = std::max(value, 0.0f);
}

template <std::size_t taps>
Rows
rectified(const VoxelLayer& layer,
          const std::array<RowPairs, taps>& pairs,
          const Rows& values,
          std::size_t row_count)
{
  auto sums = summed(layer, pairs, values, row_count);
  rectify(sums);
  return sums;
}

/** \brief Two layers, and what went in added. */
Rows
residual(const VoxelLayer& first,
         const VoxelLayer& second,
         const VoxelLevel& level,
         const Rows& values)
{
  const auto count = level.keys.size();
  auto sums =
      summed(second, level.near, rectified(first, level.near, values, count), count);
  for (std::size_t i = 0; i < sums.size(); ++i)
    sums[i] += values[i];
  rectify(sums);
  return sums;
}

std::array<RowPairs, 8>
fromParents(const std::array<RowPairs, 8>& to_parents)
{
  auto pairs = to_parents;
  for (auto& some : pairs)
    std::swap(some.from, some.to);
  return pairs;
}

/** \brief Rows side by side. */
Rows
beside(const Rows& left, const Rows& right, std::size_t width)
{
  Rows both;
  both.reserve(left.size() + right.size());
  for (std::size_t i = 0; i < left.size(); i += width) {
    both.insert(both.end(), &left[i], &left[i] + width);
    both.insert(both.end(), &right[i], &right[i] + width);
  }
  return both;
}

Rows
scoresOf(const VoxelNetwork& network,
         std::vector<VoxelLevel> levels,
         const Rows& inputs)
{
  auto values = rectified(network.stem, levels[0].near, inputs, levels[0].keys.size());
  std::vector<Rows> kept;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    values = residual(network.first[k], network.second[k], levels[k], values);
    if (k + 1 == levels.size())
      break;
    kept.push_back(std::move(values));
    values = rectified(
        network.down[k], levels[k].to_parent, kept[k], levels[k + 1].keys.size());
  }
  for (std::size_t k = levels.size() - 1; k-- > 0;) {
    const auto count = levels[k].keys.size();
    values = rectified(network.up[k], fromParents(levels[k].to_parent), values, count);
    values = beside(values, kept[k], network.widths[k]);
    kept.pop_back();
    values = rectified(network.joined[k], levels[k].near, values, count);
  }
  std::array<RowPairs, 1> own;
  own[0].from.resize(levels[0].keys.size());
  std::iota(own[0].from.begin(), own[0].from.end(), 0u);
  own[0].to = own[0].from;
  return summed(network.last, own, values, levels[0].keys.size());
}

/** \brief Softmax of the first so many scores of each row. */
std::vector<float>
probabilitiesOf(const Rows& scores, std::size_t width, std::size_t classes)
{
  std::vector<float> probabilities;
  probabilities.reserve(scores.size() / width * classes);
  for (auto row = scores.begin(); row != scores.end();
       row += static_cast<long>(width)) {
    const auto end = row + static_cast<long>(classes);
    const float largest = *std::max_element(row, end);
    float sum = 0;
    for (auto score = row; score != end; ++score) {
      probabilities.push_back(std::exp(*score - largest));
      sum += probabilities.back();
    }
    for (auto p = probabilities.end() - static_cast<long>(classes);
         p != probabilities.end();
         ++p)
      *p /= sum;
  }
  return probabilities;
}

VoxelClasses
classifyAtOnce(const std::vector<Eigen::Vector3f>& points,
               const VoxelNetwork& network,
               double low)
{
  VoxelClasses classes;
  classes.class_count = network.classes.size();
  auto voxels = voxelsOf(points, network.voxel_size, low);
  auto levels = voxelLevels(std::move(voxels.keys), network.widths.size());
  const auto scores = scoresOf(network, std::move(levels), voxels.inputs);
  classes.probabilities =
      probabilitiesOf(scores, network.last.outputs, classes.class_count);
  for (auto row = scores.data(); row != scores.data() + scores.size();
       row += network.last.outputs)
    classes.to_middle.emplace_back(row + classes.class_count);
  classes.voxel_of_point = std::move(voxels.voxel_of_point);
  return classes;
}

using Tile = std::array<int, 3>;
using Tiles = std::map<Tile, std::vector<std::uint32_t>>;

/** \brief The points of each cube. */
Tiles
tilesOf(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& corner)
{
  Tiles tiles;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3i place =
        ((points[i] - corner).cast<double>() / tile).cast<int>();
    tiles[{place.x(), place.y(), place.z()}].push_back(i);
  }
  return tiles;
}

/** \brief The points of a tile, and after them those around it. */
std::vector<Eigen::Vector3f>
withSurroundings(const Tiles::value_type& own,
                 const Tiles& tiles,
                 const std::vector<Eigen::Vector3f>& points,
                 const Eigen::Vector3f& corner)
{
  const auto& place = own.first;
  const Eigen::Array3d least = Eigen::Array3d(place[0], place[1], place[2]) * tile;
  std::vector<Eigen::Vector3f> local;
  for (const auto i : own.second)
    local.push_back(points[i]);
  for (int n = 0; n < 27; ++n) {
    const auto other = tiles.find(
        {place[0] + n % 3 - 1, place[1] + n / 3 % 3 - 1, place[2] + n / 9 - 1});
    if (other == tiles.end() || other->first == place)
      continue;
    for (const auto i : other->second) {
      const Eigen::Array3d point = (points[i] - corner).cast<double>();
      if ((point >= least - around).all() && (point <= least + tile + around).all())
        local.push_back(points[i]);
    }
  }
  return local;
}

/** \brief One tile after the other: memory does not follow the points. */
VoxelClasses
classifyInTiles(const std::vector<Eigen::Vector3f>& points,
                const VoxelNetwork& network,
                const Eigen::Vector3f& corner,
                double low)
{
  VoxelClasses all;
  all.class_count = network.classes.size();
  all.voxel_of_point.resize(points.size());
  const auto tiles = tilesOf(points, corner);
  for (const auto& own : tiles) {
    const auto classes =
        classifyAtOnce(withSurroundings(own, tiles, points, corner), network, low);
    for (std::size_t k = 0; k < own.second.size(); ++k) {
      all.voxel_of_point[own.second[k]] =
          static_cast<std::uint32_t>(all.probabilities.size() / all.class_count);
      all.to_middle.push_back(classes.to_middle[classes.voxel_of_point[k]]);
      all.probabilities.insert(
          all.probabilities.end(), classes.of(k), classes.of(k) + all.class_count);
    }
  }
  return all;
}

} // namespace

VoxelClasses
classifyVoxels(const std::vector<Eigen::Vector3f>& points, const VoxelNetwork& network)
{
  if (points.empty()) {
    VoxelClasses none;
    none.class_count = network.classes.size();
    return none;
  }
  Eigen::Vector3f least = points.front(), most = points.front();
  for (const auto& point : points) {
    least = least.cwiseMin(point);
    most = most.cwiseMax(point);
  }
  const double low = lowLevel(points);
  return (most - least).maxCoeff() <= most_at_once
             ? classifyAtOnce(points, network, low)
             : classifyInTiles(points, network, least, low);
}

} // namespace pcl::indoor
