/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "arguments.h"
#include "arrays.h"
#include "bindings.h"
#include "files/scan_content.h"
#include "listener.h"
#include "segmentation/object_settings.h"

#include <pcl/io/scan_file.h>

#include <pybind11/stl.h>

#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace pcl::indoor::python {
namespace {

/** Object and structure of each point, as pcl_noise_resilient_lccp finds them. */
py::tuple
segmentObjects(const Scan& scan, const std::vector<std::string>& words)
{
  const Arguments arguments(words);
  auto settings = tool::objectSettings(arguments.count(), arguments.words());
  tool::OptionParser parser("segment_objects", "");
  tool::addOptions(parser, settings);
  arguments.readBy(std::move(parser));
  tool::requireFitting(settings);
  Listener listener(py::none{});
  auto found = withoutLock([&] {
    return tool::segmentObjects(tool::choicesOf(settings),
                                scan.content().file,
                                [&](const auto& line) { listener.say(line); });
  });
  return py::make_tuple(arrayOf(std::move(found.object_of_point)),
                        arrayOf(std::move(found.structure_of_point)),
                        listener.lines());
}

} // namespace

void
bindObjects(py::module_& module)
{
  module.def("segment_objects", &segmentObjects);
}

} // namespace pcl::indoor::python
