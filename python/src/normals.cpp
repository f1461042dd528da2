/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "arguments.h"
#include "arrays.h"
#include "bindings.h"
#include "files/scan_content.h"
#include "listener.h"
#include "normals/normal_settings.h"

#include <pcl/io/scan_file.h>

#include <pybind11/stl.h>

#include <string>
#include <vector>

namespace py = pybind11;

namespace pcl::indoor::python {
namespace {

/** Normals and curvatures, as pcl_hough_normals estimates them. */
py::tuple
estimateNormals(const Scan& scan, const std::vector<std::string>& words)
{
  tool::NormalSettings settings;
  Arguments(words, 2).readBy(tool::normalParser(settings));
  tool::requireFitting(settings);
  const auto found = withoutLock(
      [&] { return tool::estimatedNormals(settings, scan.content().file); });
  py::array_t<float> normals({found.size(), std::size_t(3)});
  py::array_t<float> curvatures(static_cast<py::ssize_t>(found.size()));
  auto normal_values = normals.mutable_unchecked<2>();
  auto curvature_values = curvatures.mutable_unchecked<1>();
  for (py::ssize_t i = 0; i < curvature_values.shape(0); ++i) {
    const auto& normal = found[static_cast<std::size_t>(i)];
    for (int k = 0; k < 3; ++k)
      normal_values(i, k) = normal.normal[k];
    curvature_values(i) = normal.curvature;
  }
  return py::make_tuple(normals, curvatures);
}

} // namespace

void
bindNormals(py::module_& module)
{
  module.def("estimate_normals", &estimateNormals);
}

} // namespace pcl::indoor::python
