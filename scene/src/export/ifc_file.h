/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "export/saved_scene.h"

#include <string>

namespace pcl::indoor::tool {

/** \brief A scene as IFC4, a STEP file: metres, z up.
 *
 * Project, site, building and storeys; of each room a space with the floor below it;
 * walls with their openings, and the doors and windows in these; stairs, columns and
 * other objects as upright boxes, in their rooms. Places are those of the scan without
 * its offset, which is the map conversion. GlobalIds follow from the name of the scan,
 * the kind and the number; the same scene gives the same bytes.
 * \param[in] epsg code of the coordinate system of the scan; 0 = not known
 */
std::string
ifcText(const SavedScene& scene, int epsg = 0);

} // namespace pcl::indoor::tool
