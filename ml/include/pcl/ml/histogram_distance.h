/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <cstddef>
#include <vector>

namespace pcl::indoor {

/** \brief How different two histograms are; all are symmetric and 0 between equal ones.
 */
enum class HistogramDistance {
  SymmetricKullbackLeibler, ///< sum of (a - b) ln(a / b), Eq. (5.12) mended
  L1,                       ///< sum of |a - b|
  L2,                       ///< square root of the sum of (a - b)^2
  ChiSquared                ///< sum of (a - b)^2 / (a + b), empty bins left out
};

/** \brief Histograms of one descriptor, all of the same number of bins. */
using Histograms = std::vector<std::vector<float>>;

/** \brief A distance of each row's to each column's histogram, row after row. */
struct DistanceTable {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<float>
      values; ///< rows * columns; infinity where a histogram is not finite

  float
  at(std::size_t row, std::size_t column) const
  {
    return values[row * columns + column];
  }
};

/** \brief What takes the place of zero bins in the Kullback-Leibler distance, Sec.
 * 5.2.2.
 * \return half of the smallest bin above zero of all histograms; the smallest normal
 * float if there is none
 */
PCL_INDOOR_EXPORTS float
emptyBinValue(const Histograms& histograms);

/** \brief All distances between two sets of histograms.
 *
 * Bins of 0 take the emptyBinValue() of both sets together. The logarithm of each bin
 * is taken once, not once per pair. The result does not depend on the number of
 * threads.
 * \param[in] queries,gallery without negative bins
 * \param[in] number_of_threads 0: as many as the machine has
 * \return a row per query, a column per histogram of the gallery
 * \throws pcl::BadArgumentException if the numbers of bins differ
 */
PCL_INDOOR_EXPORTS DistanceTable
histogramDistances(const Histograms& queries,
                   const Histograms& gallery,
                   HistogramDistance distance,
                   unsigned int number_of_threads = 1);

} // namespace pcl::indoor
