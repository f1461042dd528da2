/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "internal/option_check.h"

#include <cmath>
#include <cstddef>

namespace pcl::indoor {

/** \brief Check what the options of all histograms of pairs have in common. */
inline void
checkPairOptions(OptionCheck& check, std::size_t pair_count, double scale)
{
  check.require(pair_count >= 1 && pair_count <= 0xFFFFFFFFu,
                "number of pairs must be in 1 ... 2^32 - 1",
                pair_count);
  check.require(scale >= 0.0 && std::isfinite(scale),
                "scale must be 0 (automatic) or a positive length",
                scale,
                " m");
}

} // namespace pcl::indoor
