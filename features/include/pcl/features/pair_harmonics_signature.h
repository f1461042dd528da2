/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/eppf_signature.h>

namespace pcl {

/** \brief The descriptor of an object that tells most: a histogram of point pairs and
 * spherical harmonics of the surface beside it, 1,200 bins.
 *
 * 8 x 15 x 5 bins of pairs (distance, both surface angles, turn of the normals about
 * the line, the last one fastest), then 588 magnitudes of harmonics and 12 distances
 * from the centre, see indoor::surfaceHarmonics() and indoor::pairHarmonicsOptions().
 * They add up to 1; all are NaN if the object had no usable pair of points. It has a
 * PCD field of its own, as its values cannot be compared with those of an
 * EPPFSignature1200.
 * \ingroup features
 */
struct PairHarmonicsSignature1200 {
  float histogram[1200] = {};

  static constexpr int
  descriptorSize()
  {
    return 1200;
  }
};

inline std::ostream&
operator<<(std::ostream& stream, const PairHarmonicsSignature1200& signature)
{
  return indoor::printBins(stream, signature);
}

} // namespace pcl

POINT_CLOUD_REGISTER_POINT_STRUCT(pcl::PairHarmonicsSignature1200,
                                  (float[1200], histogram, pair_harmonics))

namespace pcl {

/** \brief Lets kd-trees see all bins; the generic representation stops at three. */
template <>
class DefaultPointRepresentation<PairHarmonicsSignature1200>
: public DefaultFeatureRepresentation<PairHarmonicsSignature1200> {};

} // namespace pcl
