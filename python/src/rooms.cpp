/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "arguments.h"
#include "arrays.h"
#include "bindings.h"
#include "files/scan_content.h"
#include "listener.h"
#include "scene/segmented_rooms.h"
#include "scene/understood_scan.h"
#include "segmentation/room_settings.h"

#include <pcl/segmentation/room_segmentation.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace pcl::indoor::python {
namespace {

/** The room of each point, as pcl_room_segmentation finds it. */
std::vector<std::uint32_t>
foundRooms(const tool::RoomSettings& options,
           const tool::CloudFile& file,
           Listener& listener)
{
  const auto understood = tool::understand(file, options.scan, file.points->size());
  auto segmentation = tool::segmentationBy(options);
  segmentation.setProgressCallback([&listener](double share, const char*) {
    listener.update("Segmenting rooms", static_cast<std::size_t>(100.0 * share), 100);
    return true;
  });
  auto found = tool::segmentRooms(file,
                                  options.scan,
                                  understood.coordinates,
                                  true,
                                  segmentation,
                                  [&](const auto& line) { listener.say(line); });
  const auto in_none =
      std::count(found.room_of_point.begin(), found.room_of_point.end(), 0u);
  const auto emptiness =
      tool::emptinessOf(understood,
                        segmentation.getRooms().size(),
                        found.room_of_point.size() - static_cast<std::size_t>(in_none));
  if (!emptiness.empty())
    listener.say(file.path + ": " + emptiness);
  return std::move(found.room_of_point);
}

py::tuple
segmentRooms(const Scan& scan,
             const std::vector<std::string>& words,
             const py::object& progress)
{
  const Arguments arguments(words, 2);
  auto options = tool::roomSettings(arguments.count(), arguments.words());
  arguments.readBy(tool::roomParser(options));
  options.input = scan.name();
  tool::requireLegal(options);
  Listener listener(progress);
  auto rooms =
      withoutLock([&] { return foundRooms(options, scan.content().file, listener); });
  return py::make_tuple(arrayOf(std::move(rooms)), listener.lines());
}

} // namespace

void
bindRooms(py::module_& module)
{
  module.def("segment_rooms", &segmentRooms);
}

} // namespace pcl::indoor::python
