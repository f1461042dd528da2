/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "plan/fail_at.h"

#include <sstream>

namespace pcl::indoor {

void
failAt(const std::string& source,
       const std::string& list,
       const StoreyPlan& storey,
       const std::string& one,
       const Eigen::Vector2d& at,
       const std::string& problem)
{
  std::ostringstream message;
  message << source << ": " << list << " of storey '" << storey.name << "': the " << one
          << " at (" << at.x() << ", " << at.y() << ") " << problem;
  throw PlanError(message.str());
}

} // namespace pcl::indoor
