/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pybind11/pybind11.h>

namespace pcl::indoor::python {

// What of the library Python sees, a file each
void
bindScan(pybind11::module_& module);
void
bindRooms(pybind11::module_& module);
void
bindObjects(pybind11::module_& module);
void
bindScene(pybind11::module_& module);
void
bindNormals(pybind11::module_& module);
void
bindDescriptor(pybind11::module_& module);
void
bindClasses(pybind11::module_& module);

} // namespace pcl::indoor::python
