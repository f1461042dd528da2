/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/eppf_signature.h>
#include <pcl/features/pair_histogram_estimation.h>
#include <pcl/features/surflet_pair_histogram.h>

namespace pcl {

/** \brief Estimates the surflet-pair-relation histogram of an object.
 *
 * Counts four features of pairs of oriented points, three angles of one normal in the
 * frame of the other and the distance: a global descriptor that stays the same when the
 * object is turned. Needs normals that point to the same side of the surface. Cost:
 * linear in pairs.
 * \note The paper: E. Wahl, U. Hillenbrand, G. Hirzinger, "Surflet-pair-relation
 * histograms: a statistical 3D-shape representation for rapid classification", 3DIM
 * 2003.
 * \ingroup features
 */
template <typename PointInT,
          typename PointNT,
          typename PointOutT = SurfletPairSignature625>
class SurfletPairEstimation
: public indoor::PairHistogramEstimation<PointInT, PointNT, PointOutT> {
public:
  using Ptr = shared_ptr<SurfletPairEstimation<PointInT, PointNT, PointOutT>>;
  using ConstPtr =
      shared_ptr<const SurfletPairEstimation<PointInT, PointNT, PointOutT>>;

  /** \brief Five bins per feature for SurfletPairSignature625, six for ...1296. */
  SurfletPairEstimation();

  /** \brief Set how many point pairs are drawn, at least 1 (default 20000). */
  void
  setPairCount(std::size_t pair_count)
  {
    options_.pair_count = pair_count;
  }

  /** \brief Get how many point pairs are drawn. */
  std::size_t
  getPairCount() const
  {
    return options_.pair_count;
  }

  /** \brief Set the length that the distance bins spread over.
   * \param[in] scale metres; 0: the object's own largest extent (default 0)
   */
  void
  setScale(double scale)
  {
    options_.scale = scale;
  }

  /** \brief Get the length that the distance bins spread over; 0: the object's own. */
  double
  getScale() const
  {
    return options_.scale;
  }

  /** \brief Set the seed of the pairs; the same seed gives the same bits (default
   * 5489). */
  void
  setSeed(std::uint32_t seed)
  {
    options_.seed = seed;
  }

  /** \brief Get the seed of the pairs. */
  std::uint32_t
  getSeed() const
  {
    return options_.seed;
  }

  /** \brief Set the number of threads, 0 meaning all (default 1); no result depends on
   * it. */
  void
  setNumberOfThreads(unsigned int number_of_threads)
  {
    options_.number_of_threads = number_of_threads;
  }

  /** \brief Get the number of threads. */
  unsigned int
  getNumberOfThreads() const
  {
    return options_.number_of_threads;
  }

  /** \brief Set how pairs are chosen (default Uniform). */
  void
  setPairSampling(indoor::PairSampling sampling)
  {
    options_.sampling = sampling;
  }

  /** \brief Get how pairs are chosen. */
  indoor::PairSampling
  getPairSampling() const
  {
    return options_.sampling;
  }

private:
  std::string
  findOptionsProblem() const override;

  std::vector<float>
  histogramOf(const std::vector<indoor::OrientedPoint>& points) const override;

  indoor::SurfletPairOptions options_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/features/impl/surflet_pair.hpp>
#endif
