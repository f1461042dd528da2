/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/pair_sampling.h>
#include <pcl/features/surface_harmonics.h>
#include <pcl/indoor/exports.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace pcl::indoor {

/** \brief How the two surface angles of a pair become one feature, Sec. 5.2.1
 * and 5.3.2. */
enum class SurfaceAngleRule {
  Joint,     ///< both, the larger and the smaller one, in n = L (L + 1) / 2 bins
  Maximum,   ///< the larger one, Eq. (5.6)
  Minimum,   ///< the smaller one
  Mean,      ///< their mean
  RandomOne, ///< one of the two, drawn at random
  BothInsteadOfOccupancy ///< the first here, the second in place of f4, Eq. (5.13)
};

/** \brief The angle between the two normals of a pair that f3 is. */
enum class NormalAngleRule {
  Between,   ///< from one normal to the other, Eq. (5.7)
  AroundLine ///< the turn from one to the other about the line between the points, 0
             ///< ... pi, as in Wahl et al. (2003) but for its sign; 0 where a normal
             ///< lies along the line
};

/** \brief Which side of a surface a normal points to. */
enum class NormalSides {
  Outward, ///< each turned away from the centroid of the object, whatever was given
  Given,   ///< as given, with the formulas of the thesis
  Ignored, ///< unknown: only the magnitudes of the cosines count
  MostlyOutward ///< as given, or all turned over if most face the centroid
};

/** \brief Whether the side of a normal counts in all features; the thesis takes the
 * magnitude of the cosine between two normals, Eq. (5.7). */
inline bool
areSidesKnown(NormalSides sides)
{
  return sides == NormalSides::Outward || sides == NormalSides::MostlyOutward;
}

/** \brief Number of bins of each feature.
 *
 * Points of one plane have surface angles of 0, those of two walls of a room a normal
 * angle of pi / 2: where sides of normals count, an odd number of levels keeps these in
 * the middle of a bin, where rounding and noise do not matter.
 */
struct EPPFBins {
  int distance = 1;         ///< of f1, N_f1 of the thesis
  int surface_angle = 1;    ///< of f2, N_f2; for Joint 1, 3, 6, 10, 15, ...
  int normal_angle = 1;     ///< of f3, N_f3
  int occupancy = 1;        ///< of f4, N_f4
  HarmonicBins harmonics{}; ///< of the surface beside the pairs; none in the thesis

  /** \brief Bins of pairs, which come first. */
  std::size_t
  pairSize() const
  {
    return static_cast<std::size_t>(distance) * surface_angle * normal_angle *
           occupancy;
  }

  /** \brief All bins. */
  std::size_t
  size() const
  {
    return pairSize() + harmonics.size();
  }
};

/** \brief A switch per feature; one that is off falls into the first bin always. */
struct EPPFFeatures {
  bool distance = true;
  bool surface_angle = true;
  bool normal_angle = true;
  bool occupancy = true;
  bool harmonics = true; ///< if not, their bins are all 0
};

/** \brief Parameters of eppfHistogram(); the defaults are the setting of the thesis.
 */
struct EPPFOptions {
  EPPFBins bins{20, 4, 5, 3, {}}; ///< each at least 1, of harmonics 0, too
  EPPFFeatures features;          ///< which features are used
  std::size_t pair_count = 20000; ///< pairs drawn, at least 1
  double scale = 0.0;         ///< metres that f1 spreads over; 0: the object's extent
  std::uint32_t seed = 5489u; ///< same seed, same pairs
  unsigned int number_of_threads = 1; ///< 0: as many as the machine has
  double weighting_constant = 1.2;    ///< c of Eq. (5.11), above 1
  bool weighting = true;              ///< whether Eq. (5.11) is applied at all
  SurfaceAngleRule surface_angle_rule = SurfaceAngleRule::Maximum;
  NormalAngleRule normal_angle_rule = NormalAngleRule::Between;
  NormalSides normal_sides = NormalSides::Given;
  PairSampling sampling = PairSampling::Uniform;
  /** \brief Whether noise is measured and, where there is any, lowered before points
   * are described, see measureNoise() and denoised(). */
  bool denoising = false;
  int grid_size = 64; ///< voxels per edge, 2 to 64; 0: see automaticGridSize()
};

/** \brief The setting of the thesis, which an EPPFSignature1200 holds: 20 x 4 x 5 x 3
 * bins, the larger of the two surface angles, normals as given, 64 voxels, pairs drawn
 * uniformly, noise left in. The same as EPPFOptions().
 */
PCL_INDOOR_EXPORTS EPPFOptions
thesisEPPFOptions();

/** \brief The short form of the thesis, which an EPPFSignature540 holds: 15 x 3 x 4 x 3
 * bins, else thesisEPPFOptions().
 */
PCL_INDOOR_EXPORTS EPPFOptions
shortEPPFOptions();

/** \brief The setting that tells most, which a PairHarmonicsSignature1200 holds: 8 x 15
 * x 5 bins of pairs without the occupancy, both surface angles, the turn of the normals
 * about the line, sides as given, no weights; harmonics up to degree 6 in 3 shells and
 * 12 distances; stratified pairs, noise lowered.
 */
PCL_INDOOR_EXPORTS EPPFOptions
pairHarmonicsOptions();

/** \brief Voxels per edge for a number of points: sqrt(point_count / 4), within 8
 * ... 64.
 *
 * The surface of an object crosses about 2 * N^2 voxels of a grid of N^3. With this N
 * there are about two points for each of them: in a much finer grid the surface has
 * holes, which the occupancy takes for free space.
 */
PCL_INDOOR_EXPORTS int
automaticGridSize(std::size_t point_count);

/** \brief Levels L of the joint rule's L (L + 1) / 2 bins; 0 if they are not that many.
 */
PCL_INDOOR_EXPORTS int
jointLevels(const EPPFBins& bins);

/** \brief Say what is wrong with options: "" if nothing, else parameter, value and
 * range. */
PCL_INDOOR_EXPORTS std::string
findProblem(const EPPFOptions& options);

} // namespace pcl::indoor
