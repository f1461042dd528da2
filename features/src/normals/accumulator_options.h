/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "internal/option_check.h"

namespace pcl::indoor {

/** \brief Check what a HoughAccumulator is made from. */
inline void
checkAccumulator(OptionCheck& check, double bin_angle_degrees, unsigned rotations)
{
  check.require(bin_angle_degrees >= 1 && bin_angle_degrees <= 45,
                "angle of a bin must be in [1, 45]",
                bin_angle_degrees,
                " degrees");
  check.require(rotations >= 1 && rotations <= 16,
                "number of accumulators must be in [1, 16]",
                rotations);
}

} // namespace pcl::indoor
