/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/e57/e57_scans.h"

#include <cstddef>
#include <cstdint>

namespace pcl::indoor::tool {

/** \brief Values of a field as numbers, with minimum, scale and offset applied.
 * \param[in] bytes the stream of the field, 8 bytes longer than its values
 * \param[in] first_bit of the first value
 */
void
unpackE57Values(const E57Field& field,
                const char* bytes,
                std::size_t first_bit,
                std::size_t count,
                double* values);

} // namespace pcl::indoor::tool
