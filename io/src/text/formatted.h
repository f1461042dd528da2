/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <string>

namespace pcl::indoor::tool {

/** \brief A text as printf() writes it in the locale "C", in at most 499 characters. */
PCL_INDOOR_EXPORTS std::string
formatted(const char* format, ...) __attribute__((format(printf, 1, 2)));

} // namespace pcl::indoor::tool
