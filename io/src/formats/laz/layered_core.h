/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/laz/layered_items.h"

namespace pcl::indoor::tool {

constexpr std::size_t layered_core_size = 30; ///< bytes in a point
constexpr std::size_t layered_core_layers = 9;

/** \brief What all points of formats 6 to 10 have; see makeLayeredItem(). */
std::unique_ptr<LayeredItem>
makeLayeredCore(unsigned version, const char* first, std::vector<Layer> layers);

} // namespace pcl::indoor::tool
