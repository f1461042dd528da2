/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/point_representation.h>
#include <pcl/register_point_struct.h>

#include <ostream>

namespace pcl {

/** \brief The enhanced point pair feature (EPPF) histogram of an object as in the
 * thesis, Sec. 5.2: 20 x 4 x 5 x 3 bins of pairs.
 *
 * 20 of the distance, 4 of the surface angle, 5 of the normal angle and 3 of the
 * occupancy, the last one fastest. They add up to 1; all are NaN if the object had no
 * usable pair of points. See EPPFEstimation and indoor::thesisEPPFOptions(); for
 * descriptors that tell more, PairHarmonicsSignature1200.
 * \ingroup features
 */
struct EPPFSignature1200 {
  float histogram[1200] = {};

  static constexpr int
  descriptorSize()
  {
    return 1200;
  }
};

/** \brief The short EPPF histogram: 15 x 3 x 4 x 3 bins of pairs, see
 * indoor::shortEPPFOptions().
 * \ingroup features
 */
struct EPPFSignature540 {
  float histogram[540] = {};

  static constexpr int
  descriptorSize()
  {
    return 540;
  }
};

/** \brief The surflet-pair histogram of Wahl et al. (2003), 5^4 bins.
 * \ingroup features
 */
struct SurfletPairSignature625 {
  float histogram[625] = {};

  static constexpr int
  descriptorSize()
  {
    return 625;
  }
};

/** \brief The surflet-pair histogram with six bins per feature, 6^4 bins.
 * \ingroup features
 */
struct SurfletPairSignature1296 {
  float histogram[1296] = {};

  static constexpr int
  descriptorSize()
  {
    return 1296;
  }
};

namespace indoor {

/** \brief Print the bins of a signature as "(a, b, ...)", as PCL prints its own. */
template <typename SignatureT>
std::ostream&
printBins(std::ostream& stream, const SignatureT& signature)
{
  for (int bin = 0; bin < SignatureT::descriptorSize(); ++bin)
    stream << (bin == 0 ? "(" : ", ") << signature.histogram[bin];
  return stream << ")";
}

} // namespace indoor

inline std::ostream&
operator<<(std::ostream& stream, const EPPFSignature1200& signature)
{
  return indoor::printBins(stream, signature);
}

inline std::ostream&
operator<<(std::ostream& stream, const EPPFSignature540& signature)
{
  return indoor::printBins(stream, signature);
}

inline std::ostream&
operator<<(std::ostream& stream, const SurfletPairSignature625& signature)
{
  return indoor::printBins(stream, signature);
}

inline std::ostream&
operator<<(std::ostream& stream, const SurfletPairSignature1296& signature)
{
  return indoor::printBins(stream, signature);
}

} // namespace pcl

POINT_CLOUD_REGISTER_POINT_STRUCT(pcl::EPPFSignature1200,
                                  (float[1200], histogram, eppf))
POINT_CLOUD_REGISTER_POINT_STRUCT(pcl::EPPFSignature540,
                                  (float[540], histogram, eppf_short))
POINT_CLOUD_REGISTER_POINT_STRUCT(pcl::SurfletPairSignature625,
                                  (float[625], histogram, surflet_pair))
POINT_CLOUD_REGISTER_POINT_STRUCT(pcl::SurfletPairSignature1296,
                                  (float[1296], histogram, surflet_pair_6))

namespace pcl {

/** \brief Lets kd-trees see all bins; the generic representation stops at three. */
template <>
class DefaultPointRepresentation<EPPFSignature1200>
: public DefaultFeatureRepresentation<EPPFSignature1200> {};

/** \brief Lets kd-trees see all bins; the generic representation stops at three. */
template <>
class DefaultPointRepresentation<EPPFSignature540>
: public DefaultFeatureRepresentation<EPPFSignature540> {};

/** \brief Lets kd-trees see all bins; the generic representation stops at three. */
template <>
class DefaultPointRepresentation<SurfletPairSignature625>
: public DefaultFeatureRepresentation<SurfletPairSignature625> {};

/** \brief Lets kd-trees see all bins; the generic representation stops at three. */
template <>
class DefaultPointRepresentation<SurfletPairSignature1296>
: public DefaultFeatureRepresentation<SurfletPairSignature1296> {};

} // namespace pcl
