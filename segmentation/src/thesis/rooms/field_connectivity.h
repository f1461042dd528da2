/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/indoor/voxel_map.h>
#include <pcl/segmentation/thesis.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::indoor {

/** \brief The distance between pixels through a field map (Eq. (3.3) of the thesis).
 *
 * Two pixels are connected at a threshold if a path of neighbouring pixels (8) leads
 * from one to the other on which no value lies below the threshold. Their distance is a
 * - (the highest threshold at which they are connected), with a the largest value of
 * the map, and a if they never are. Eq. (3.3) is printed with a maximum that could
 * never lower its initial value a; this is what it means. It is an ultrametric, so that
 * N values describe all N x N distances: the pixels stand in a row in which each
 * component at each threshold is a contiguous piece, and the level at which two pixels
 * are connected is the smallest of the levels between their places in that row.
 *
 * Time O(N log N) to build, memory about 16 bytes per pixel, a query takes O(1).
 */
class FieldConnectivity {
public:
  /** \brief Build the row of pixels.
   * \param[in] field at least 0, finite; pixels of value 0 are never connected to
   * others
   * \param[in] thresholds those tried, in any order; empty = every value that occurs,
   * which is the limit of many thresholds
   * \throws pcl::BadArgumentException if a value or threshold is negative or not
   * finite, or if the number of values is not that of the pixels
   */
  explicit FieldConnectivity(const PixelMap<float>& field,
                             std::vector<float> thresholds = {});

  /** \brief The highest threshold at which two pixels are connected.
   * \param[in] i, j places in the map's values
   * \return 0 if they never are; for i == j the highest threshold that the pixel
   * reaches
   */
  float
  level(std::size_t i, std::size_t j) const
  {
    if (i == j)
      return own_level_[i];
    std::size_t first = position_[i], last = position_[j];
    if (first > last)
      std::swap(first, last);
    return smallestGap(first, last - 1);
  }

  /** \brief Eq. (3.3): maximum() - level(i, j), and 0 for i == j. */
  float
  distance(std::size_t i, std::size_t j) const
  {
    return i == j ? 0.0f : maximum_ - level(i, j);
  }

  /** \brief a of Eq. (3.3): the largest value of the map. */
  float
  maximum() const
  {
    return maximum_;
  }

  /** \brief The place of each pixel in the row. */
  const std::vector<int>&
  positions() const
  {
    return position_;
  }

  /** \brief The level between the places p and p + 1 of the row, for each p. */
  const std::vector<float>&
  gaps() const
  {
    return gaps_;
  }

  /** \brief The highest threshold that each pixel reaches; 0 if none. */
  const std::vector<float>&
  ownLevels() const
  {
    return own_level_;
  }

private:
  float
  smallestGap(std::size_t first, std::size_t last) const;
  void
  linkPixels(const PixelMap<float>& field);
  void
  buildRangeMinima();

  float maximum_ = 0.0f;
  std::vector<int> position_;
  std::vector<float> gaps_;
  std::vector<float> own_level_;
  std::vector<std::vector<float>> block_minima_; // sparse table over blocks of gaps
};

/** \brief The thresholds of Sec. 3.2.3: peaks of the 1-D histogram of positive values.
 * \param[in] values those that are not positive are left out
 * \return the lower edges of the bins of the peaks, ascending, so that the values of
 * a peak reach its threshold; a plateau counts as one peak at its first bin
 * \throws pcl::BadArgumentException if an option is out of its range
 */
std::vector<float>
histogramPeaks(const std::vector<float>& values,
               const thesis::HistogramPeakOptions& options);

} // namespace pcl::indoor
