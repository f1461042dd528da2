/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/ml/classifier_model.h>
#include <pcl/ml/object_context.h>

namespace pcl::indoor {

/** \brief The values that a model's networks are fed with, for one object.
 * \param[in] points with unit normals, finite, metres, near the origin
 * \param[in] seed of the pairs or of the choice of points; another seed, another draw
 * \return NaN values if no two points differ in position
 */
PCL_INDOOR_EXPORTS std::vector<float>
classifierInput(const std::vector<OrientedPoint>& points,
                const ObjectPlace& place,
                const ClassifierInput& input,
                std::uint32_t seed);

/** \brief Number of values that classifierInput() gives. */
PCL_INDOOR_EXPORTS std::size_t
inputValueCount(const ClassifierInput& input);

/** \brief What an object was taken for. */
struct PCL_INDOOR_EXPORTS Classification {
  std::vector<float> probabilities; ///< one per class of the model, their sum is 1;
                                    ///< empty if the object could not be described

  /** \brief Class of the largest probability; -1 if there is none. */
  int
  best() const;
};

/** \brief An object to classify. */
struct ClassifierObject {
  std::vector<OrientedPoint> points; ///< see classifierInput()
  ObjectPlace place;
};

/** \brief Classify objects; the result depends neither on the number of threads nor on
 * the other objects of the batch.
 * \param[in] number_of_threads 0: as many as the machine has
 * \throws pcl::BadArgumentException if the model is wrong
 */
PCL_INDOOR_EXPORTS std::vector<Classification>
classifyObjects(const std::vector<ClassifierObject>& objects,
                const ClassifierModel& model,
                unsigned int number_of_threads = 1);

} // namespace pcl::indoor
