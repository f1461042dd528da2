/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/plan.h>

namespace pcl::indoor {

/** \brief A flat piece of a ceiling: a plane and where, seen from above, it counts. */
struct CeilingFacet {
  CeilingPlane plane;
  std::vector<HalfPlane> borders; ///< it counts where all of them hold
  int part = -1;                  ///< index into CeilingPlan::parts; -1: none
};

/** \brief The pieces of a ceiling; together they cover the plane once. */
std::vector<CeilingFacet>
ceilingFacets(const CeilingPlan& ceiling);

/** \brief The lowest and the highest height over a polygon, metres above the floor. */
std::pair<double, double>
ceilingRange(const CeilingPlan& ceiling, const Polygon& polygon);

} // namespace pcl::indoor
