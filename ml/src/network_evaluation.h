/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/ml/network.h>

#include <cstddef>
#include <vector>

namespace pcl::indoor {

/** \brief The values of some objects: one array per object, all of one shape. */
struct ObjectValues {
  Shape shape;
  std::vector<std::vector<float>> arrays;
};

/** \brief Inputs that a network works on together: they stay in the cache. */
constexpr std::size_t inputs_at_once = 16;

/** \brief What a layer with weights makes of the objects' values; nothing is checked.
 */
void
applyLayer(const Layer& layer, ObjectValues& objects);

/** \brief Layers that treat each object on its own. */
std::vector<float>
convolution(const Layer& layer, const Shape& shape, const std::vector<float>& values);

std::vector<float>
maxPool(const Layer& layer, const Shape& shape, const std::vector<float>& values);

} // namespace pcl::indoor
