/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/scene/scene.h>
#include <pcl/scene/scene_options.h> // for ObjectNaming
#include <pcl/segmentation/room_objects.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief How probably objects are of the classes of a network. */
struct ObjectVotes {
  std::vector<std::string> classes; ///< of the network: floor, wall, ceiling, others
  std::vector<std::vector<float>> of_object; ///< a value per class; empty: no votes
};

/** \brief The file of the model that was asked for; empty if none was. */
PCL_INDOOR_EXPORTS std::string
modelFile(const SceneOptions& options);

/** \brief How objects get their classes; nothing if they get none.
 * \throws pcl::IOException if the model cannot be read */
std::optional<ObjectNaming>
namingOf(const SceneOptions& options);

/** \brief The names of all classes: SceneClasses::names. */
std::vector<std::string>
classNames(const ObjectNaming& naming);

/** \brief Name objects, each for itself; floors, walls and ceilings have no class.
 * \param[in] surfaces one per object, see objectSurfaces()
 * \param[in] measures of the same objects
 * \param[in] votes of the same objects, or none: then a name's probability is the
 * geometric mean of both, three quarters of it the votes'
 */
std::vector<ObjectClass>
classesOf(const std::vector<ObjectSurface>& surfaces,
          const std::vector<ObjectMeasures>& measures,
          const ObjectNaming& naming,
          const ObjectVotes& votes = {});

} // namespace pcl::indoor::tool
