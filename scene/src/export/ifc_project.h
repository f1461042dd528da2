/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "export/ifc_elements.h"
#include "export/step_file.h"

#include <Eigen/Core>

#include <string>

namespace pcl::indoor::tool {

/** \brief The project with its units. */
StepEntity
addProject(StepFile& file,
           const IfcElements& elements,
           StepEntity context,
           const std::string& name);

/** \brief Where the model lies on the map; nothing at the origin of no known system.
 * \param[in] epsg code of the coordinate system; 0 = not known */
void
addMapConversion(StepFile& file,
                 StepEntity context,
                 const Eigen::Vector3d& origin,
                 int epsg);

} // namespace pcl::indoor::tool
