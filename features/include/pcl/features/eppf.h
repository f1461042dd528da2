/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/eppf_histogram.h>
#include <pcl/features/eppf_signature.h>
#include <pcl/features/pair_harmonics_signature.h>
#include <pcl/features/pair_histogram_estimation.h>

namespace pcl {

/** \brief Estimates the enhanced point pair feature (EPPF) histogram of an object.
 *
 * Draws pairs of oriented points and counts their distance, surface angle, normal angle
 * and the occupancy of the line between them in one four-dimensional histogram: a
 * global descriptor, one output point whatever the number of input points, that stays
 * the same when the object is turned. The output type says what is computed:
 * EPPFSignature1200 is the thesis's, EPPFSignature540 its short form, and
 * PairHarmonicsSignature1200, which tells objects best, has another setting of pairs
 * and, by spherical harmonics in the object's own axes, where the points lie and which
 * way they face. All defaults follow the type.
 *
 * Only points and normals of the indices are read; one that is not finite is skipped,
 * and a normal of another length than 1 is brought to it. A search surface or search
 * method plays no part. Cost: linear in pairs, about 60 ns each.
 * \note Bobkov et al., "Noise-resistant deep learning for object classification in
 * three-dimensional point clouds using a point pair descriptor", IEEE Robotics and
 * Automation Letters 3 (2018). Deviations: docs/method/descriptors.md.
 * \ingroup features
 */
template <typename PointInT, typename PointNT, typename PointOutT = EPPFSignature1200>
class EPPFEstimation
: public indoor::PairHistogramEstimation<PointInT, PointNT, PointOutT> {
public:
  using Ptr = shared_ptr<EPPFEstimation<PointInT, PointNT, PointOutT>>;
  using ConstPtr = shared_ptr<const EPPFEstimation<PointInT, PointNT, PointOutT>>;

  EPPFEstimation();

  /** \brief Set, or get, all parameters at once. */
  void
  setOptions(const indoor::EPPFOptions& options)
  {
    options_ = options;
  }
  const indoor::EPPFOptions&
  getOptions() const
  {
    return options_;
  }

  /** \brief Set or get how many point pairs are drawn.
   * More pairs lower the noise of a bin as 1 / sqrt(pair_count); time grows linearly.
   * \param[in] pair_count number of pairs, at least 1 (default 20000)
   */
  void
  setPairCount(std::size_t pair_count)
  {
    options_.pair_count = pair_count;
  }
  std::size_t
  getPairCount() const
  {
    return options_.pair_count;
  }

  /** \brief Set or get the number of bins of each feature.
   * \param[in] bins as many in all as PointOutT has, and for EPPF signatures of pairs
   * alone; compute() refuses others (default: those that PointOutT names)
   */
  void
  setBins(const indoor::EPPFBins& bins)
  {
    options_.bins = bins;
  }
  const indoor::EPPFBins&
  getBins() const
  {
    return options_.bins;
  }

  /** \brief Set or get the length that the distance bins spread over.
   * If it is that of the largest object of a set, descriptors tell sizes apart; if it
   * is each object's own, shapes alone. Longer distances fall into the last bin.
   * \param[in] scale metres; 0: the object's own largest extent (default 0)
   */
  void
  setScale(double scale)
  {
    options_.scale = scale;
  }
  double
  getScale() const
  {
    return options_.scale;
  }

  /** \brief Set or get the seed: the same gives the same bits (default 5489). */
  void
  setSeed(std::uint32_t seed)
  {
    options_.seed = seed;
  }
  std::uint32_t
  getSeed() const
  {
    return options_.seed;
  }

  /** \brief Set or get the number of threads; 0: all (default 1); no result differs. */
  void
  setNumberOfThreads(unsigned int number_of_threads)
  {
    options_.number_of_threads = number_of_threads;
  }
  unsigned int
  getNumberOfThreads() const
  {
    return options_.number_of_threads;
  }

  /** \brief Set or get the constant of the bin weights, c of Eq. (5.11).
   * \param[in] constant above 1; larger gives near pairs more weight (default 1.2)
   */
  void
  setWeightingConstant(double constant)
  {
    options_.weighting_constant = constant;
  }
  double
  getWeightingConstant() const
  {
    return options_.weighting_constant;
  }

  /** \brief Set or get how two surface angles become one feature (default Maximum;
   * Joint for pair harmonics). */
  void
  setSurfaceAngleRule(indoor::SurfaceAngleRule rule)
  {
    options_.surface_angle_rule = rule;
  }
  indoor::SurfaceAngleRule
  getSurfaceAngleRule() const
  {
    return options_.surface_angle_rule;
  }

  /** \brief Set or get which side of a surface normals point to (default Given;
   * MostlyOutward for pair harmonics). */
  void
  setNormalSides(indoor::NormalSides sides)
  {
    options_.normal_sides = sides;
  }
  indoor::NormalSides
  getNormalSides() const
  {
    return options_.normal_sides;
  }

  /** \brief Set or get how pairs are chosen (default Uniform; Stratified for pair
   * harmonics). */
  void
  setPairSampling(indoor::PairSampling sampling)
  {
    options_.sampling = sampling;
  }
  indoor::PairSampling
  getPairSampling() const
  {
    return options_.sampling;
  }

  /** \brief Switch features on and off, or get which are on; one that is off falls into
   * its first bin always. */
  void
  setFeatures(const indoor::EPPFFeatures& features)
  {
    options_.features = features;
  }
  const indoor::EPPFFeatures&
  getFeatures() const
  {
    return options_.features;
  }

  /** \brief Set or get the voxels per edge of the occupancy grid.
   * \param[in] grid_size 2 ... 64, or 0: as fine as the points are dense, see
   * indoor::automaticGridSize() (default 64; 0 for pair harmonics)
   */
  void
  setGridSize(int grid_size)
  {
    options_.grid_size = grid_size;
  }
  int
  getGridSize() const
  {
    return options_.grid_size;
  }

  /** \brief Set or get whether noise is measured and lowered, see
   * indoor::measureNoise(); nothing changes without noise (default false; true
   * for pair harmonics). */
  void
  setDenoising(bool denoising)
  {
    options_.denoising = denoising;
  }
  bool
  getDenoising() const
  {
    return options_.denoising;
  }

private:
  std::string
  findOptionsProblem() const override;

  std::vector<float>
  histogramOf(const std::vector<indoor::OrientedPoint>& points) const override;

  indoor::EPPFOptions options_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/features/impl/eppf.hpp>
#endif
