/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/building.h>
#include <pcl/simulation/plan.h>

#include <string>

namespace pcl::indoor::test {

/** A room 0 ... 4, 0 ... 3 and 0 ... 2.5 m, whose walls are as thin as they may be.
 * \param[in] contents of the plan's storey, such as R"("windows": [...])" */
inline Building
boxRoom(const std::string& contents = "")
{
  return buildBuilding(parsePlan(R"({"name": "box", "wall_thickness": 0.2, "storeys": [
    {"name": "", "elevation": 0, "ceiling_height": 2.5, "rooms": [{"name": "box",
     "polygon": [[-0.1, -0.1], [4.1, -0.1], [4.1, 3.1], [-0.1, 3.1]]}])" +
                                     (contents.empty() ? "" : ", " + contents) + "}]}",
                                 "box"));
}

} // namespace pcl::indoor::test
