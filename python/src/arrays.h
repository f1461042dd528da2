/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <pybind11/numpy.h>

#include <memory>
#include <utility>
#include <vector>

namespace pcl::indoor::python {

/** \brief The arrays that a scan is made of. */
struct ScanArrays {
  pybind11::array points;   ///< N x 3, float32 or float64
  pybind11::object normals; ///< the same, or None
  pybind11::object colors;  ///< N x 3, uint8, or None
};

/** \brief A cloud with the fields of the arrays, which are read where they lie,
 * whatever their strides.
 * \throws InputError naming the array and what is wrong */
PCLPointCloud2
cloudOf(const ScanArrays& arrays);

/** \brief A vector as an array, without a copy. */
template <typename T>
pybind11::array
arrayOf(std::vector<T>&& values)
{
  auto owner = std::make_unique<std::vector<T>>(std::move(values));
  const auto* const data = owner.get();
  const pybind11::capsule last(owner.release(), [](void* vector) {
    delete static_cast<std::vector<T>*>(vector);
  });
  return pybind11::array_t<T>(
      static_cast<pybind11::ssize_t>(data->size()), data->data(), last);
}

/** \brief An array that cannot be written to. */
pybind11::array
readOnly(pybind11::array array);

} // namespace pcl::indoor::python
