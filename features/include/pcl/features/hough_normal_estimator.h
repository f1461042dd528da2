/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/hough_accumulator.h>
#include <pcl/indoor/exports.h>

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl::indoor {

/** \brief How the three points of a triple are picked among the neighbours. */
enum class HoughSampling {
  Points, ///< each neighbour equally often
  Cubes   ///< each cube of the neighbourhood equally often, then a point in it: where
          ///< density varies, the dense side does not outvote the other
};

/** \brief Which normal the rotated accumulators agree on. */
enum class HoughChoice {
  Best,   ///< that of the accumulator with the most votes in one bin
  Mean,   ///< mean of all, weighted by votes
  Cluster ///< mean of those that lie within a tolerance and have the most votes
};

/** \brief Parameters of the Robust Randomized Hough Transform (Sec. 2.1.5.2; Boulch and
 * Marlet, "Fast and robust normal estimation for point clouds with sharp features",
 * Symposium on Geometry Processing 2012). */
struct HoughNormalOptions {
  double bin_angle_degrees = 12; ///< edge of a bin of the accumulator (1 to 45)
  unsigned rotations = 5;        ///< number of accumulators (1 to 16)
  /** alpha: probability with which no share of a bin is further than \a deviation from
   * its expectation; decides over the largest number of triples (0 to 1, exclusive) */
  double confidence = 0.95;
  double deviation = 0.08; ///< delta, share of the votes (0.01 to 1)
  /** largest number of triples per point; 0: as the confidence bounds say, see
   * houghTripleCount() */
  unsigned triples = 0;
  HoughSampling sampling = HoughSampling::Cubes;
  unsigned cubes_per_edge = 4; ///< for HoughSampling::Cubes (1 to 16)
  /** planes that pass the point at a larger distance have no vote, since it does not
   * lie on them; share of the distance to the furthest neighbour (> 0; 1: all vote) */
  double plane_distance = 0.25;
  HoughChoice choice = HoughChoice::Cluster;
  double cluster_tolerance_degrees = 25; ///< for HoughChoice::Cluster (0 to 90)
  /** fit a plane to the neighbours near the plane that was voted for; without, the mean
   * of the votes is the normal, as in the paper */
  bool refine = true;
  std::uint32_t seed = 5489; ///< of triples and rotations
};

/** \brief What was found about the surface around a point. */
struct HoughNormal {
  Eigen::Vector3f normal; ///< unit length, sign arbitrary; NaN: no plane was found
  float curvature = 0;    ///< surface variation of all neighbours, Eq. (2.8)
  float share = 0;        ///< of the votes in the winning bin: high on smooth surfaces
  unsigned triples = 0;   ///< that were drawn
};

/** \brief Estimates normals from the votes of random triples of neighbours.
 *
 * Each triple spans a plane whose direction votes in accumulators of directions. The
 * bin with the most votes is the plane that most neighbours lie on, and other faces
 * beside an edge have no influence on it, where a least-squares fit would mix them.
 * Drawing stops when the first bin leads over the second by more than chance allows.
 *
 * All points use the same sequence of random numbers, so a result depends only on the
 * neighbours' positions relative to the point, not on their order. Copies share their
 * tables; use one per thread.
 */
class PCL_INDOOR_EXPORTS HoughNormalEstimator {
public:
  /** \throws pcl::BadArgumentException if an option is out of range */
  explicit HoughNormalEstimator(const HoughNormalOptions& options);

  /** \brief Estimate the normal of the surface that the origin lies on.
   * \param[in,out] neighbors finite positions relative to the point, metres, in any
   * order; they are sorted
   */
  HoughNormal
  estimate(std::vector<Eigen::Vector3f>& neighbors);

  /** \brief Get the largest number of triples per point. */
  unsigned
  tripleCount() const
  {
    return triple_count_;
  }

private:
  /** The first and the second of an accumulator's bins. */
  struct Leader {
    std::uint32_t bin = 0, votes = 0, second = 0;
  };

  void
  sortNeighbors(std::vector<Eigen::Vector3f>& neighbors);

  void
  sortIntoCubes(const std::vector<Eigen::Vector3f>& neighbors);

  unsigned
  drawTriples(const std::vector<Eigen::Vector3f>& neighbors);

  bool
  isDecided() const;

  Eigen::Vector3f
  meanOfLeadingBin(unsigned copy) const;

  Eigen::Vector3f
  chooseDirection() const;

  HoughNormalOptions options_;
  unsigned triple_count_;
  std::shared_ptr<const HoughAccumulator> accumulator_;
  std::shared_ptr<const std::vector<std::uint32_t>> random_; // three per triple

  // Scratch of one estimate.
  std::vector<std::uint64_t> keys_; // of neighbours: distance, index
  std::vector<Eigen::Vector3f> sorted_;
  std::vector<std::uint32_t> order_, cube_of_neighbor_, cube_ends_, cube_offsets_;
  std::vector<std::uint32_t> votes_; // per copy and bin
  std::vector<Leader> leaders_;
  std::vector<Eigen::Vector3f> directions_; // of the triples
  std::vector<const std::uint16_t*> bins_;  // of the triples, in each copy
  std::vector<float> heights_;
};

/** \brief Number of triples after which, with probability \a confidence, no share of
 * the votes in one of \a bins bins is further than \a deviation from its expectation
 * (Hoeffding's bound): ln(2 bins / (1 - confidence)) / (2 deviation^2), rounded up. */
PCL_INDOOR_EXPORTS unsigned
houghTripleCount(unsigned bins, double confidence, double deviation);

/** \brief Find what is wrong with the options.
 * \return one sentence with parameter, value and unit; empty if nothing is
 */
PCL_INDOOR_EXPORTS std::string
findProblem(const HoughNormalOptions& options);

} // namespace pcl::indoor
