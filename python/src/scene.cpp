/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "arguments.h"
#include "arrays.h"
#include "bindings.h"
#include "command_line/export_options.h"
#include "export/saved_scene.h"
#include "files/output_file.h"
#include "formats/json_text.h"
#include "listener.h"
#include "pipeline/pipeline_parser.h"
#include "scene/scene_query.h" // for readScene

#include <pcl/scene/describe_building.h>
#include <pcl/scene/scene_file.h>

#include <nlohmann/json.hpp>
#include <pybind11/stl.h>

#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace pcl::indoor::python {
namespace {

/** A building, as pcl_indoor_pipeline describes it: scene.json, and room, object and
 * structure of each point. */
py::tuple
describe(const Scan& scan,
         const std::vector<std::string>& words,
         const py::object& progress)
{
  const Arguments arguments(words, 2);
  auto options = tool::pipelineOptions(arguments.count(), arguments.words());
  arguments.readBy(tool::pipelineParser(options));
  Listener listener(progress);
  options.progress =
      [&listener](const std::string& stage, std::size_t done, std::size_t all) {
        listener.update(stage, done, all);
      };
  std::string text;
  auto scene = withoutLock([&] {
    auto found = describeBuilding(scan, options);
    text = sceneText(found);
    return found;
  });
  return py::make_tuple(text,
                        arrayOf(std::move(scene.room_of_point)),
                        arrayOf(std::move(scene.object_of_point)),
                        arrayOf(std::move(scene.structure_of_point)));
}

/** The text of a scene's file, which is a whole scene. */
std::string
readScene(const std::string& path)
{
  tool::readSavedScene(path);
  return tool::jsonText(tool::readScene(path));
}

void
saveText(const std::string& path, const std::string& text)
{
  const py::gil_scoped_release release;
  tool::requireWritable(path);
  tool::saveText(path, text);
}

/** Write a scene for other programs, as pcl_indoor_export does. */
void
exportScene(const std::string& path,
            const std::string& text,
            const std::vector<std::string>& words)
{
  tool::ExportOptions options;
  tool::OptionParser parser("save", "");
  tool::addOptions(parser, options);
  Arguments(words).readBy(std::move(parser));
  const py::gil_scoped_release release;
  tool::requireExportFormat(path);
  tool::requireWritable(path);
  const auto scene = tool::savedScene(nlohmann::ordered_json::parse(text));
  std::vector<tool::OutputFile> files;
  for (const auto& [name, bytes] : tool::exportedFiles(scene, path, options))
    files.push_back(tool::writtenBeside(name, bytes));
  tool::commitTogether(files);
}

} // namespace

void
bindScene(py::module_& module)
{
  module.def("describe", &describe);
  module.def("read_scene", &readScene);
  module.def("save_text", &saveText);
  module.def("export_scene", &exportScene);
}

} // namespace pcl::indoor::python
