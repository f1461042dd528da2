/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/ifc_classes.h"

#include <array>

namespace pcl::indoor::tool {

std::string
ifcFurnitureType(const std::string& name)
{
  constexpr std::array<std::array<const char*, 2>, 10> types = {
      {{"armchair", ".CHAIR."},
       {"bed", ".BED."},
       {"bookcase", ".SHELF."},
       {"cabinet", ".FILECABINET."},
       {"chair", ".CHAIR."},
       {"desk", ".DESK."},
       {"shelf", ".SHELF."},
       {"sofa", ".SOFA."},
       {"stool", ".CHAIR."},
       {"table", ".TABLE."}}};
  for (const auto& type : types)
    if (name == type[0])
      return type[1];
  return name.empty() ? ".NOTDEFINED." : ".USERDEFINED.";
}

std::string
ifcEntityOf(const SavedObject& object)
{
  if (object.name == "stairs" || object.name == "stair")
    return "IFCSTAIR";
  if (object.name == "column" || object.name == "pillar")
    return "IFCCOLUMN";
  if (object.name == "door" || object.name == "window") // the openings are these
    return "IFCBUILDINGELEMENTPROXY";
  return "IFCFURNITURE";
}

} // namespace pcl::indoor::tool
