/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/ifc_project.h"

namespace pcl::indoor::tool {

StepEntity
addProject(StepFile& file,
           const IfcElements& elements,
           StepEntity context,
           const std::string& name)
{
  const auto unit = [&](const char* kind, const char* of) {
    return file.add("IFCSIUNIT(*,." + std::string(kind) + ".,$,." + of + ".)");
  };
  const auto units = file.add("IFCUNITASSIGNMENT(" +
                              stepList({unit("LENGTHUNIT", "METRE"),
                                        unit("AREAUNIT", "SQUARE_METRE"),
                                        unit("VOLUMEUNIT", "CUBIC_METRE"),
                                        unit("PLANEANGLEUNIT", "RADIAN")}) +
                              ")");
  return file.add("IFCPROJECT(" + elements.root("project") + "," + stepText(name) +
                  ",$,$,$,$,(" + stepRef(context) + ")," + stepRef(units) + ")");
}

void
addMapConversion(StepFile& file,
                 StepEntity context,
                 const Eigen::Vector3d& origin,
                 int epsg)
{
  if (epsg == 0 && origin.isZero())
    return;
  const auto system = file.add(
      "IFCPROJECTEDCRS(" +
      (epsg > 0 ? "'EPSG:" + std::to_string(epsg) + "'" : "'coordinates of the scan'") +
      ",$,$,$,$,$,$)");
  file.add("IFCMAPCONVERSION(" + stepRef(context) + "," + stepRef(system) + "," +
           stepReal(origin.x()) + "," + stepReal(origin.y()) + "," +
           stepReal(origin.z()) + ",1.,0.,1.)");
}

} // namespace pcl::indoor::tool
