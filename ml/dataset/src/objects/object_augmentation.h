/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/object_disturbance.h"

#include <pcl/features/oriented_point.h>
#include <pcl/indoor/exports.h>
#include <pcl/ml/object_classifier.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>
#include <vector>

namespace pcl::indoor::tool {

/** \brief How the draws of an object differ from it.
 *
 * Each change is made to its share of the draws, by an amount that is drawn evenly from
 * 0 to its most. By default nothing is changed, but for a turn about the z axis.
 */
struct ObjectAugmentation {
  double noisy_share = 0.0;     ///< of the draws, 0 ... 1
  double noise_percent = 0.0;   ///< most, deviation in per cent of the extent
  double hidden_share = 0.0;    ///< of the draws, 0 ... 1
  double hidden_percent = 0.0;  ///< most, share of the points not seen, below 100
  double thinned_share = 0.0;   ///< of the draws, 0 ... 1
  double thinned_percent = 0.0; ///< most, share of the points left out, below 100
  double stretched_share = 0.0; ///< of the draws, 0 ... 1
  double stretch_percent = 0.0; ///< most, of each axis, longer or shorter
};

/** \brief Other objects of the same kind: other proportions, fewer points. */
PCL_INDOOR_EXPORTS ObjectAugmentation
mildAugmentation();

/** \brief As scans differ from models: with noise and hidden parts, too. */
PCL_INDOOR_EXPORTS ObjectAugmentation
scanAugmentation();

/** \brief An object as it might have been scanned; also turned about the z axis.
 * \param[in] cloud with normals, which are estimated anew where there is noise
 * \param[in] neighbor_count of such a normal, at least
 * \param[in] seed same seed, same object
 */
PointCloud<PointNormal>
augmentedObject(const PointCloud<PointNormal>& cloud,
                const ObjectAugmentation& augmentation,
                int neighbor_count,
                std::uint32_t seed);

/** \brief How the draws of an object are made. */
struct DrawOptions {
  ClassifierInput input;                                ///< of the model
  ObjectAugmentation augmentation = scanAugmentation(); ///< of all draws but the first
  Disturbance disturbance; ///< of every draw, after its augmentation
  int draw_count = 16;     ///< at least 1
  int neighbor_count = 20; ///< of a normal that has to be estimated
  std::uint32_t seed = 1;
};

/** \brief What the first draw of an object describes: the object as it is, but for the
 * disturbance. Objects to test with are disturbed the same way.
 * \param[in] number of the object, by which its seed differs from others'
 */
PCL_INDOOR_EXPORTS PointCloud<PointNormal>
firstDrawnObject(const PointCloud<PointNormal>& cloud,
                 const DrawOptions& options,
                 std::size_t number);

/** \brief Draws of an object: the first of firstDrawnObject(), the others augmented and
 * disturbed, each with its own pairs.
 * \param[in] number of the object, by which its seeds differ from others'
 * \return draw_count inputs; a draw of which too little is left is like the first; none
 * if the object cannot be described
 */
PCL_INDOOR_EXPORTS std::vector<std::vector<float>>
drawsOf(const PointCloud<PointNormal>& cloud,
        const ObjectPlace& place,
        const DrawOptions& options,
        std::size_t number);

} // namespace pcl::indoor::tool
