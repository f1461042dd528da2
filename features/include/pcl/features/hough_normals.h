/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/feature.h>
#include <pcl/features/hough_normal_estimator.h>
#include <pcl/features/normal_orientation.h>
#include <pcl/point_types.h>

namespace pcl {

/** \brief Estimates surface normals that stay sharp at edges, by the Robust Randomized
 * Hough Transform.
 *
 * Random triples of a point's neighbours vote for the directions of their planes; the
 * normal is that of the plane with the most votes, not the mean of the surfaces that
 * meet at an edge. Takes the place of NormalEstimation: normals point to the viewpoint,
 * and the curvature is the surface variation of the neighbours, Eq. (2.8).
 *
 * Give a radius or a number of neighbours, about 50 points or more; with neither, the
 * radius is twice that of Eq. (2.9). Results depend neither on the number of threads
 * nor on the order of the points. Cost: linear in points times triples.
 * \note A. Boulch, R. Marlet, "Fast and robust normal estimation for point clouds with
 * sharp features", SGP 2012; here Sec. 2.1.5.2. Deviations: docs/method/normals.md.
 * \ingroup features
 */
template <typename PointInT, typename PointOutT = Normal>
class HoughNormalEstimation : public Feature<PointInT, PointOutT> {
public:
  using Ptr = shared_ptr<HoughNormalEstimation<PointInT, PointOutT>>;
  using ConstPtr = shared_ptr<const HoughNormalEstimation<PointInT, PointOutT>>;
  using PointCloudOut = typename Feature<PointInT, PointOutT>::PointCloudOut;
  using Sampling = indoor::HoughSampling;
  using Choice = indoor::HoughChoice;

  /** \param[in] threads 0 for as many as OpenMP offers */
  explicit HoughNormalEstimation(unsigned threads = 0);

  /** \brief Set or get all parameters at once, also those without a setter. */
  void
  setOptions(const indoor::HoughNormalOptions& options)
  {
    options_ = options;
  }
  const indoor::HoughNormalOptions&
  getOptions() const
  {
    return options_;
  }

  /** \brief Set or get the number of triples per point.
   * \param[in] triples at most this many; 0: as the confidence bounds say (default 0)
   */
  void
  setNumberOfTriples(unsigned triples)
  {
    options_.triples = triples;
  }
  unsigned
  getNumberOfTriples() const
  {
    return options_.triples;
  }

  /** \brief Set or get the bounds from which the number of triples follows.
   * \param[in] confidence alpha, 0 to 1, exclusive (default 0.95)
   * \param[in] deviation delta, by which the share of a bin may miss its expectation,
   * 0.01 to 1 (default 0.08); half of it takes four times as many triples
   */
  void
  setConfidenceBounds(double confidence, double deviation)
  {
    options_.confidence = confidence;
    options_.deviation = deviation;
  }
  double
  getConfidence() const
  {
    return options_.confidence;
  }
  double
  getDeviation() const
  {
    return options_.deviation;
  }

  /** \brief Set or get the size of the accumulators' bins.
   * \param[in] degrees 1 to 45 (default 12). Smaller tells flatter edges apart, and
   * takes more triples.
   */
  void
  setBinAngle(double degrees)
  {
    options_.bin_angle_degrees = degrees;
  }
  double
  getBinAngle() const
  {
    return options_.bin_angle_degrees;
  }

  /** \brief Set or get the number of accumulators, each rotated differently.
   * \param[in] rotations 1 to 16 (default 5)
   */
  void
  setNumberOfRotations(unsigned rotations)
  {
    options_.rotations = rotations;
  }
  unsigned
  getNumberOfRotations() const
  {
    return options_.rotations;
  }

  /** \brief Set or get how one normal comes of all accumulators (default Cluster). */
  void
  setChoice(Choice choice)
  {
    options_.choice = choice;
  }
  Choice
  getChoice() const
  {
    return options_.choice;
  }

  /** \brief Set or get how triples are picked (default Cubes; Points is faster). */
  void
  setSampling(Sampling sampling)
  {
    options_.sampling = sampling;
  }
  Sampling
  getSampling() const
  {
    return options_.sampling;
  }

  /** \brief Set or get whether a plane is fitted to the neighbours near the plane that
   * was voted for (default true); without, the normal is the mean of the winning bin's
   * votes, as in the paper, and noisier on smooth surfaces. */
  void
  setRefinement(bool refine)
  {
    options_.refine = refine;
  }
  bool
  getRefinement() const
  {
    return options_.refine;
  }

  /** \brief Set or get the seed of the triples and rotations (default 5489). */
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

  /** \brief Set or get the number of threads; 0 (default) for as many as OpenMP offers.
   * A search method of one's own must allow searches from several threads. */
  void
  setNumberOfThreads(unsigned threads = 0)
  {
    threads_ = threads;
  }
  unsigned
  getNumberOfThreads() const
  {
    return threads_;
  }

  /** \brief Set or get which way normals are turned: to the viewpoint (default; also
   * Automatic), as those of their 8 nearest neighbours, or to the free space. */
  void
  setOrientation(indoor::NormalOrientation orientation)
  {
    orientation_ = orientation;
  }
  indoor::NormalOrientation
  getOrientation() const
  {
    return orientation_;
  }

  /** \brief Set where the sensor stood, in the frame of the cloud; normals point there
   * (default: the input's sensor origin). */
  void
  setViewPoint(float x, float y, float z)
  {
    viewpoint_ = Eigen::Vector3f(x, y, z);
    use_sensor_origin_ = false;
  }

  /** \brief Get where normals point to: what was set, else the input's sensor origin.
   */
  void
  getViewPoint(float& x, float& y, float& z) const;

  /** \brief Go back to the input's sensor origin. */
  void
  useSensorOriginAsViewPoint()
  {
    use_sensor_origin_ = true;
  }

protected:
  using Feature<PointInT, PointOutT>::feature_name_;
  using Feature<PointInT, PointOutT>::indices_;
  using Feature<PointInT, PointOutT>::input_;
  using Feature<PointInT, PointOutT>::k_;
  using Feature<PointInT, PointOutT>::search_parameter_;
  using Feature<PointInT, PointOutT>::search_radius_;
  using Feature<PointInT, PointOutT>::surface_;

  /** \brief Check input, neighbourhood and parameters. */
  bool
  initCompute() override;
  bool
  deinitCompute() override;

private:
  void
  computeFeature(PointCloudOut& output) override;

  void
  orient(PointCloudOut& output) const;

  indoor::HoughNormalOptions options_;
  indoor::NormalOrientation orientation_ = indoor::NormalOrientation::Viewpoint;
  unsigned threads_ = 0;
  bool automatic_radius_ = false;
  bool use_sensor_origin_ = true;
  Eigen::Vector3f viewpoint_ = Eigen::Vector3f::Zero();
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/features/impl/hough_normals.hpp>
#endif
