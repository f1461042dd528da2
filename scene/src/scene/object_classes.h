/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/ml/classifier_model.h>
#include <pcl/segmentation/object_surfaces.h>
#include <pcl/segmentation/room_objects.h> // for ObjectMeasures

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pcl::indoor::tool {

/** \brief What an object was taken for. */
struct ObjectClass {
  std::uint32_t category = 0; ///< position in SceneClasses::names; 0, "none", of
                              ///< floors, walls and ceilings, which are no things
  float confidence = 0.0f; ///< probability of that class; 0 of objects too small to be
                           ///< described, which are "other"
  std::vector<std::pair<std::uint32_t, float>>
      top; ///< up to three, the likeliest first
};

/** \brief The classes of a scene's objects. */
struct SceneClasses {
  std::vector<std::string> names;   ///< names[0] is "none", then those of the model
  std::vector<ObjectClass> objects; ///< one per object; empty without a model
};

/** \brief Path of the model that comes with the tools: ../share/pcl_indoor of the
 * folder that the program lies in. */
std::string
bundledModel();

/** \brief The names of the classes that a model gives: SceneClasses::names. */
std::vector<std::string>
classNames(const ClassifierModel& model);

/** \brief Name things, each for itself; floors, walls and ceilings have no class.
 * \param[in] surfaces one per object, see objectSurfaces()
 * \param[in] measures of the same objects
 * \param[in] threads 0 = automatic; the result does not depend on it
 */
std::vector<ObjectClass>
classesOf(const std::vector<ObjectSurface>& surfaces,
          const std::vector<ObjectMeasures>& measures,
          const ClassifierModel& model,
          int threads);

} // namespace pcl::indoor::tool
