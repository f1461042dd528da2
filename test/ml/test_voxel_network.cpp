/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "support/folder_test.h"
#include "voxels/row_sums.h"
#include "voxels/voxel_levels.h"

#include <pcl/exceptions.h>
#include <pcl/ml/voxel_network.h>

#include <boost/crc.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

using namespace pcl::indoor;

namespace {

constexpr std::size_t classes = 4;
const std::vector<std::size_t> widths = {16, 32, 16};

class Random {
public:
  float
  number(float least, float most)
  {
    return std::uniform_real_distribution<float>(least, most)(engine_);
  }

  std::vector<float>
  numbers(std::size_t count)
  {
    std::vector<float> values(count);
    for (auto& value : values)
      value = number(-0.3f, 0.3f);
    return values;
  }

  VoxelLayer
  layer(std::size_t taps, std::size_t inputs, std::size_t outputs)
  {
    return {inputs, outputs, numbers(taps * inputs * outputs), numbers(outputs)};
  }

private:
  std::mt19937 engine_{7};
};

VoxelNetwork
randomNetwork()
{
  Random random;
  VoxelNetwork network;
  network.classes = {"floor", "wall", "ceiling", "chair"};
  network.widths = widths;
  network.voxel_size = 0.1;
  network.stem = random.layer(27, 5, widths[0]);
  for (const auto width : widths) {
    network.first.push_back(random.layer(27, width, width));
    network.second.push_back(random.layer(27, width, width));
  }
  for (std::size_t k = 0; k + 1 < widths.size(); ++k) {
    network.down.push_back(random.layer(8, widths[k], widths[k + 1]));
    network.up.push_back(random.layer(8, widths[k + 1], widths[k]));
    network.joined.push_back(random.layer(27, 2 * widths[k], widths[k]));
  }
  network.last = random.layer(1, widths[0], row_lanes);
  return network;
}

/** A floor, two walls and a box. */
std::vector<Eigen::Vector3f>
room()
{
  Random random;
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 1500; ++i) {
    const float a = random.number(0, 1.6f), b = random.number(0, 1.3f);
    points.emplace_back(a, b, 0.01f);
    points.emplace_back(a, 0.03f, b);
    points.emplace_back(0.02f, a, b);
    points.emplace_back(0.6f + a / 4, 0.5f + b / 4, 0.4f);
  }
  return points;
}

using Cell = std::array<int, 3>;
using CellRows = std::map<Cell, std::vector<double>>;

/** The same by maps of cells, in double precision. */
class Oracle {
public:
  explicit Oracle(const VoxelNetwork& network)
  : network_(network)
  {}

  CellRows
  scores(CellRows values) const
  {
    std::vector<CellRows> kept;
    values = near(network_.stem, values);
    for (std::size_t k = 0; k < widths.size(); ++k) {
      auto sums = near(network_.second[k], near(network_.first[k], values), false);
      for (auto& [cell, row] : sums)
        for (std::size_t i = 0; i < row.size(); ++i)
          row[i] = std::max(0.0, row[i] + values[cell][i]);
      values = sums;
      if (k + 1 == widths.size())
        break;
      kept.push_back(values);
      CellRows parents;
      for (const auto& [cell, row] : values)
        add(network_.down[k], placeOf(cell), row, parents[half(cell)]);
      rectify(network_.down[k], parents);
      values = parents;
    }
    for (std::size_t k = widths.size() - 1; k-- > 0;) {
      CellRows children;
      for (const auto& [cell, row] : kept[k])
        add(network_.up[k], placeOf(cell), values[half(cell)], children[cell]);
      rectify(network_.up[k], children);
      for (auto& [cell, row] : children)
        row.insert(row.end(), kept[k][cell].begin(), kept[k][cell].end());
      values = near(network_.joined[k], children);
    }
    CellRows scores;
    for (const auto& [cell, row] : values) {
      add(network_.last, 0, row, scores[cell]);
      for (std::size_t o = 0; o < classes + 3; ++o)
        scores[cell][o] += network_.last.bias[o];
    }
    return scores;
  }

private:
  static Cell
  half(const Cell& cell)
  {
    return {cell[0] / 2, cell[1] / 2, cell[2] / 2};
  }

  static std::size_t
  placeOf(const Cell& cell)
  {
    return static_cast<std::size_t>(cell[2] % 2 * 4 + cell[1] % 2 * 2 + cell[0] % 2);
  }

  static void
  add(const VoxelLayer& layer,
      std::size_t tap,
      const std::vector<double>& row,
      std::vector<double>& sums)
  {
    sums.resize(layer.outputs, 0.0);
    for (std::size_t i = 0; i < layer.inputs; ++i)
      for (std::size_t o = 0; o < layer.outputs; ++o)
        sums[o] +=
            row[i] * static_cast<double>(
                         layer.weights[(tap * layer.inputs + i) * layer.outputs + o]);
  }

  static void
  rectify(const VoxelLayer& layer, CellRows& rows)
  {
    for (auto& [cell, row] : rows)
      for (std::size_t o = 0; o < row.size(); ++o)
        row[o] = std::max(0.0, row[o] + static_cast<double>(layer.bias[o]));
  }

  static CellRows
  near(const VoxelLayer& layer, const CellRows& values, bool rectifies = true)
  {
    CellRows sums;
    for (const auto& [cell, row] : values) {
      std::size_t tap = 0;
      auto& sum = sums[cell];
      sum.assign(layer.bias.begin(), layer.bias.end());
      for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
          for (int x = -1; x <= 1; ++x, ++tap) {
            const auto other = values.find({cell[0] + x, cell[1] + y, cell[2] + z});
            if (other != values.end())
              add(layer, tap, other->second, sum);
          }
      if (rectifies)
        for (auto& value : sum)
          value = std::max(0.0, value);
    }
    return sums;
  }

  const VoxelNetwork& network_;
};

TEST(VoxelNetwork, is_what_its_definition_says)
{
  const auto network = randomNetwork();
  const auto points = room();
  const auto found = classifyVoxels(points, network);
  ASSERT_EQ(found.class_count, classes);
  std::vector<float> heights;
  for (const auto& point : points)
    heights.push_back(point.z());
  std::sort(heights.begin(), heights.end());
  const double low = heights[(heights.size() - 1) / 20];
  std::map<Cell, std::array<double, 5>> sums; // offset, height, count
  std::vector<Cell> cell_of_point;
  for (const auto& point : points) {
    Cell cell;
    for (int k = 0; k < 3; ++k)
      cell[k] = static_cast<int>(std::floor(point[k] / network.voxel_size));
    cell_of_point.push_back(cell);
    auto& sum = sums[cell];
    for (int k = 0; k < 3; ++k)
      sum[k] += point[k] / network.voxel_size - cell[k] - 0.5;
    sum[3] += point.z() - low;
    ++sum[4];
  }
  CellRows inputs;
  for (const auto& [cell, s] : sums)
    inputs[cell] = {1, s[3] / s[4] / 2, s[0] / s[4], s[1] / s[4], s[2] / s[4]};
  const auto scores = Oracle(network).scores(inputs);
  for (std::size_t i = 0; i < points.size(); i += 7) {
    const auto& row = scores.at(cell_of_point[i]);
    double sum = 0;
    for (std::size_t c = 0; c < classes; ++c)
      sum += std::exp(row[c]);
    for (std::size_t c = 0; c < classes; ++c)
      ASSERT_NEAR(found.of(i)[c], std::exp(row[c]) / sum, 1e-3) << i << ' ' << c;
    const auto& to_middle = found.to_middle[found.voxel_of_point[i]];
    for (std::size_t k = 0; k < 3; ++k)
      ASSERT_NEAR(to_middle[k], row[classes + k], 1e-3) << i << ' ' << k;
  }
}

TEST(VoxelNetwork, order_of_points_and_place_of_the_room_do_not_matter)
{
  const auto network = randomNetwork();
  auto points = room();
  const auto before = classifyVoxels(points, network);
  const float there = 64 * static_cast<float>(network.voxel_size);
  std::reverse(points.begin(), points.end());
  for (auto& point : points)
    point += Eigen::Vector3f(there, -2 * there, 0);
  const auto after = classifyVoxels(points, network);
  std::size_t other = 0; // on the border of two voxels
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t c = 0; c < classes; ++c)
      other += std::abs(before.of(i)[c] - after.of(points.size() - 1 - i)[c]) > 1e-3f;
  EXPECT_LT(other, points.size() / 100);
  EXPECT_EQ(before.probabilities.size(), after.probabilities.size());
}

TEST(VoxelNetwork, no_points_and_points_far_apart)
{
  const auto network = randomNetwork();
  EXPECT_TRUE(classifyVoxels({}, network).probabilities.empty());
  EXPECT_EQ(classifyVoxels({{1, 2, 3}}, network).probabilities.size(), classes);
  const auto far = classifyVoxels({{0, 0, 0}, {0, 0, 40000}, {9e8f, 0, 0}}, network);
  ASSERT_EQ(far.voxel_of_point.size(), 3u);
  for (std::size_t c = 0; c < classes; ++c) // each is alone
    EXPECT_TRUE(std::isfinite(far.of(1)[c]));
}

TEST(VoxelNetwork, wide_clouds_are_as_if_their_parts_were_alone)
{
  const auto network = randomNetwork();
  const auto points = room();
  const auto alone = classifyVoxels(points, network);
  auto both = points; // 51.2 m apart: a whole number of voxels of all levels
  for (const auto& point : points)
    both.push_back(point + Eigen::Vector3f(51.2f, 0, 0));
  const auto found = classifyVoxels(both, network);
  ASSERT_EQ(found.voxel_of_point.size(), both.size());
  ASSERT_EQ(found.to_middle.size(), both.size());
  std::size_t other = 0; // on the border of two voxels
  for (std::size_t i = 0; i < both.size(); ++i)
    for (std::size_t c = 0; c < classes; ++c)
      other += std::abs(found.of(i)[c] - alone.of(i % points.size())[c]) > 1e-3f;
  EXPECT_LT(other, both.size() / 100);
}

TEST(VoxelLevels, a_voxel_in_the_least_corner_has_no_neighbour_on_any_level)
{
  constexpr std::uint64_t least = least_coordinate;
  const auto levels = voxelLevels({voxelKey(least, least, least)}, most_voxel_levels);
  ASSERT_EQ(levels.size(), most_voxel_levels);
  EXPECT_EQ(levels.back().keys, std::vector<std::uint64_t>{voxelKey(1, 1, 1)});
  for (const auto& level : levels)
    for (std::size_t tap = 0; tap < level.near.size(); ++tap)
      EXPECT_EQ(level.near[tap].to.size(), tap == 13 ? 1u : 0u) << tap;
}

TEST(RowSums, are_made_in_the_order_of_the_inputs)
{
  Random random;
  constexpr std::size_t inputs = 7, outputs = 32, rows = 9;
  const auto values = random.numbers(rows * inputs);
  const auto matrix = random.numbers(inputs * outputs);
  RowPairs pairs;
  for (std::uint32_t row = 0; row < rows; ++row) {
    pairs.from.push_back((row * 5) % rows);
    pairs.to.push_back(row);
  }
  auto sums = random.numbers(rows * outputs);
  auto expected = sums;
  addRowSums(pairs, values, inputs, matrix.data(), outputs, sums);
  for (std::size_t p = 0; p < rows; ++p)
    for (std::size_t o = 0; o < outputs; ++o) {
      volatile float sum = 0; // no product and sum in one
      for (std::size_t i = 0; i < inputs; ++i) {
        const volatile float product =
            values[pairs.from[p] * inputs + i] * matrix[i * outputs + o];
        sum = sum + product;
      }
      expected[pairs.to[p] * outputs + o] += sum;
    }
  EXPECT_EQ(sums, expected);
}

class VoxelNetworkFile : public test::FolderTest {
protected:
  /** A network's file with all weights 0, of two levels. */
  static std::string
  bytes(const std::string& header = R"({"classes":["floor","wall","ceiling"],)"
                                    R"("widths":[16,16],"voxel_size":0.05})",
        std::size_t surplus = 0)
  {
    const auto layer = [](std::size_t taps, std::size_t inputs, std::size_t outputs) {
      return std::string(8 * outputs + taps * inputs * outputs, '\0');
    };
    std::string content =
        "pcl_indoor_voxel_network 1\n" + header + "\n" + layer(27, 5, 16);
    for (int k = 0; k < 4; ++k)
      content += layer(27, 16, 16);
    content +=
        layer(8, 16, 16) + layer(8, 16, 16) + layer(27, 32, 16) + layer(1, 16, 3 + 3);
    content += std::string(surplus, '\0');
    boost::crc_32_type crc;
    crc.process_bytes(content.data(), content.size());
    for (unsigned k = 0; k < 4; ++k)
      content.push_back(static_cast<char>(crc.checksum() >> 8 * k & 0xff));
    return content;
  }

  std::string
  problemOf(const std::string& content) const
  {
    try {
      loadVoxelNetwork(write("a.network", content));
    } catch (const pcl::IOException& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(VoxelNetworkFile, is_read)
{
  const auto network = loadVoxelNetwork(write("a.network", bytes()));
  EXPECT_EQ(network.classes.size(), 3u);
  EXPECT_EQ(network.last.outputs, row_lanes);
  for (const auto probability : classifyVoxels(room(), network).probabilities)
    ASSERT_FLOAT_EQ(probability, 1.0f / 3);
}

TEST_F(VoxelNetworkFile, what_is_wrong_is_said)
{
  const auto has = [this](const std::string& content, const std::string& words) {
    const auto problem = problemOf(content);
    EXPECT_NE(problem.find(words), std::string::npos) << problem;
    EXPECT_EQ(problem.find('\n'), std::string::npos) << problem;
  };
  has("", "no voxel network");
  has("pcl_indoor_voxel_network 1\n{}", "cut off");
  auto damaged = bytes();
  damaged[200] ^= 1;
  has(damaged, "damaged");
  has(bytes().substr(0, 5000), "damaged or cut off");
  has(bytes("[]"), "header");
  has(bytes(R"({"classes":["a","b","c"],"widths":[16,1e308],"voxel_size":0.05})"),
      "header");
  has(bytes(R"({"classes":["a","b","c"],"widths":[16,20],"voxel_size":0.05})"),
      "header");
  has(bytes(R"({"classes":["a","b","c"],"widths":[16,16,16],"voxel_size":0.05})"),
      "cut off");
  has(bytes(R"({"classes":["a","b","c"],"widths":[16,16,16,16,16,16],)"
            R"("voxel_size":0.05})"),
      "cut off");
  has(bytes(R"({"classes":["a","b","c"],"widths":[16,16,16,16,16,16,16],)"
            R"("voxel_size":0.05})"),
      "header");
  has(bytes(R"({"classes":["a","b","c"],"widths":[16,16],"voxel_size":0.05})", 5),
      "5 bytes too many");
  EXPECT_THROW(loadVoxelNetwork(path("none")), pcl::IOException);
}

} // namespace
