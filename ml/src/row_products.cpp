/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "row_products.h"

#include <Eigen/Core>

#include <algorithm>

namespace pcl::indoor {

namespace {

constexpr std::size_t lanes = 4;
constexpr std::size_t left_block = 4; // with right_block all that the registers hold
constexpr std::size_t right_block = 3;
constexpr std::size_t depth = 1024; // values of a row that are summed in one go

using Lanes = Eigen::Array<float, lanes, 1>;

Lanes
lanesAt(const float* values)
{
  return Eigen::Map<const Lanes>(values);
}

/** \brief Products of a few rows of both sides, size a multiple of lanes. */
template <std::size_t left_count, std::size_t right_count>
void
blockProducts(const float* left,
              const float* right,
              std::size_t row_size,
              std::size_t size,
              float* products)
{
  Lanes sums[left_count][right_count];
  for (auto& row : sums)
    for (auto& sum : row)
      sum.setZero();
  for (std::size_t k = 0; k < size; k += lanes) {
    Lanes factors[right_count];
    for (std::size_t j = 0; j < right_count; ++j)
      factors[j] = lanesAt(right + j * row_size + k);
    for (std::size_t i = 0; i < left_count; ++i) {
      const Lanes factor = lanesAt(left + i * row_size + k);
      for (std::size_t j = 0; j < right_count; ++j)
        sums[i][j] += factor * factors[j];
    }
  }
  for (std::size_t i = 0; i < left_count; ++i)
    for (std::size_t j = 0; j < right_count; ++j) {
      const Lanes& sum = sums[i][j];
      products[i * right_block + j] = (sum[0] + sum[2]) + (sum[1] + sum[3]);
    }
}

using BlockProducts =
    void (*)(const float*, const float*, std::size_t, std::size_t, float*);

constexpr BlockProducts block_products[left_block][right_block] = {
    {blockProducts<1, 1>, blockProducts<1, 2>, blockProducts<1, 3>},
    {blockProducts<2, 1>, blockProducts<2, 2>, blockProducts<2, 3>},
    {blockProducts<3, 1>, blockProducts<3, 2>, blockProducts<3, 3>},
    {blockProducts<4, 1>, blockProducts<4, 2>, blockProducts<4, 3>}};

} // namespace

void
addRowProducts(const FloatRows& left,
               const FloatRows& right,
               std::size_t size,
               float* sums,
               std::size_t left_stride,
               std::size_t right_stride)
{
  float products[left_block * right_block];
  for (std::size_t first = 0; first < size; first += depth) {
    const std::size_t part = std::min(depth, size - first);
    const std::size_t even = part / lanes * lanes;
    for (std::size_t i = 0; i < left.count; i += left_block)
      for (std::size_t j = 0; j < right.count; j += right_block) {
        const std::size_t rows = std::min(left_block, left.count - i);
        const std::size_t columns = std::min(right_block, right.count - j);
        const float* const a = left.values + i * size + first;
        const float* const b = right.values + j * size + first;
        block_products[rows - 1][columns - 1](a, b, size, even, products);
        for (std::size_t row = 0; row < rows; ++row)
          for (std::size_t column = 0; column < columns; ++column) {
            float sum = products[row * right_block + column];
            for (std::size_t k = even; k < part; ++k)
              sum += a[row * size + k] * b[column * size + k];
            sums[(i + row) * left_stride + (j + column) * right_stride] += sum;
          }
      }
  }
}

} // namespace pcl::indoor
