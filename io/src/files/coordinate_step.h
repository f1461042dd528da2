/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <vector>

namespace pcl::indoor::tool {

/** \brief The step that coordinates along an axis are multiples of, whatever their
 * type: doubles that were floats have that of floats, rounded ones that of their last
 * digit.
 *
 * Some thousand values are drawn, always the same, in groups: the step of a group is
 * the greatest common divisor of its differences, and the median of the groups is told,
 * so that few values between the steps do not matter. A group of fewer than four
 * different values does not count: planes show no step.
 * \return 0 if there is none above 1e-5 of the extent, that of the middle half
 * of the values, or if there are too few values to tell
 */
double
commonStep(const std::vector<double>& values);

} // namespace pcl::indoor::tool
