/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/plan.h>

#include <string>

namespace pcl::indoor {

/** \brief Refuse what lies at a place of a plan.
 * \param[in] source what error messages call the plan
 * \param[in] list of the storey in which it is, such as "doors"
 * \param[in] one what it is called, such as "one"
 * \throws PlanError */
[[noreturn]] void
failAt(const std::string& source,
       const std::string& list,
       const StoreyPlan& storey,
       const std::string& one,
       const Eigen::Vector2d& at,
       const std::string& problem);

} // namespace pcl::indoor
