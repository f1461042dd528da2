/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "voxels/row_sums.h"

#include "internal/cpu_target.h"

#include <algorithm>
#include <cstdint>

namespace pcl::indoor {

namespace {

constexpr std::size_t block = 4; // rows whose sums the registers hold

struct Products {
  const std::uint32_t* from;
  const std::uint32_t* to;
  std::size_t count;
  const float* values;
  std::size_t inputs;
  const float* matrix;
  std::size_t outputs;
  float* sums;
};

/** \brief A few rows, row_lanes of their outputs. */
template <std::size_t rows>
[[gnu::always_inline]] inline void
addBlock(const Products& p, std::size_t first, std::size_t column)
{
  float sums[rows][row_lanes] = {};
  const float* values[rows];
  for (std::size_t r = 0; r < rows; ++r)
    values[r] = p.values + p.from[first + r] * p.inputs;
  for (std::size_t i = 0; i < p.inputs; ++i) {
    const float* const weights = p.matrix + i * p.outputs + column;
    for (std::size_t r = 0; r < rows; ++r) {
      const float value = values[r][i];
#pragma omp simd
      for (std::size_t lane = 0; lane < row_lanes; ++lane)
        sums[r][lane] += value * weights[lane];
    }
  }
  for (std::size_t r = 0; r < rows; ++r) {
    float* const sum = p.sums + p.to[first + r] * p.outputs + column;
#pragma omp simd
    for (std::size_t lane = 0; lane < row_lanes; ++lane)
      sum[lane] += sums[r][lane];
  }
}

[[gnu::always_inline]] inline void
addAll(const Products& p)
{
  const std::size_t whole = p.count / block * block;
  for (std::size_t column = 0; column < p.outputs; column += row_lanes) {
    for (std::size_t first = 0; first < whole; first += block)
      addBlock<block>(p, first, column);
    for (std::size_t first = whole; first < p.count; ++first)
      addBlock<1>(p, first, column);
  }
}

using Adder = void (*)(const Products&);

void
addPortably(const Products& p)
{
  addAll(p);
}

// Without fma, whose sums would be others.
PCL_INDOOR_TARGET("avx2")
void
addWithAvx2(const Products& p)
{
  addAll(p);
}

const Adder add = PCL_INDOOR_CPU_HAS("avx2") ? addWithAvx2 : addPortably;

} // namespace

void
addRowSums(const RowPairs& pairs,
           const std::vector<float>& values,
           std::size_t inputs,
           const float* matrix,
           std::size_t outputs,
           std::vector<float>& sums)
{
  add({pairs.from.data(),
       pairs.to.data(),
       pairs.from.size(),
       values.data(),
       inputs,
       matrix,
       outputs,
       sums.data()});
}

} // namespace pcl::indoor
