/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "bindings.h"

#include "text/printable.h"
#include "text/program_version.h"

#include <pcl/console/print.h>
#include <pcl/exceptions.h>
#include <pcl/io/input_error.h>

#include <exception>

namespace py = pybind11;
using namespace pcl::indoor;

namespace {

/** What cannot be used is a ValueError with the line that the tools say. */
void
bindErrors(py::module_& module)
{
  static py::exception<InputError> input_error(module, "InputError", PyExc_ValueError);
  input_error.doc() = "What is given cannot be used; one line, as the tools say it.";
  py::register_exception_translator([](std::exception_ptr thrown) {
    const auto say = [](const std::exception& error) {
      PyErr_SetString(input_error.ptr(),
                      tool::printable(tool::messageOf(error)).c_str());
    };
    try {
      if (thrown)
        std::rethrow_exception(thrown);
    } catch (const InputError& error) {
      say(error);
    } catch (const pcl::PCLException& error) {
      say(error);
    }
  });
}

} // namespace

PYBIND11_MODULE(_core, module)
{
  module.doc() = "What of the library pcl_indoor the package pcl_indoor is made of.";
  module.attr("__version__") = tool::programVersion();
  pcl::console::setVerbosityLevel(pcl::console::L_ERROR); // as the tools in a pipe
  bindErrors(module);
  python::bindScan(module);
  python::bindRooms(module);
  python::bindObjects(module);
  python::bindScene(module);
  python::bindNormals(module);
  python::bindDescriptor(module);
  python::bindClasses(module);
}
