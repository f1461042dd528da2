/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/scene_files.h"

#include "export/door_graph.h"
#include "export/geojson_file.h"
#include "export/glb_scene.h"
#include "export/ifc_file.h"
#include "export/robot_map.h"
#include "export/route_graph.h"
#include "export/scene_plan.h"
#include "files/tool_error.h"
#include "formats/file_ending.h"
#include "formats/json_text.h"
#include "pictures/plan_dxf.h"
#include "pictures/plan_svg.h"

#include <algorithm>
#include <filesystem>

namespace pcl::indoor::tool {
namespace {

using NamedFiles = std::vector<std::pair<std::string, std::string>>;

constexpr const char* endings[] = {".ifc", ".glb", ".geojson", ".dxf", ".svg", ".pgm"};

/** The maps of a storey.
 * \param[in] name of its files, without what follows for each */
void
addMaps(NamedFiles& files,
        const SavedScene& scene,
        const std::string& name,
        const std::string& ending,
        std::uint32_t storey,
        double resolution)
{
  for (const bool furnished : {true, false}) {
    const auto map = robotMap(scene, storey, resolution, furnished);
    const auto base = name + (furnished ? "_furnished" : "");
    const auto image = std::filesystem::path(base + ending).filename().string();
    files.emplace_back(base + ".yaml", mapYaml(map, image));
    files.emplace_back(base + ending, pgmBytes(map));
  }
}

NamedFiles
robotBundle(const SavedScene& scene, const std::string& path, double resolution)
{
  NamedFiles files;
  const auto graph = doorGraph(scene);
  const auto ending = std::filesystem::path(path).extension().string();
  const auto base = path.substr(0, path.size() - ending.size());
  for (auto s = static_cast<std::uint32_t>(scene.storeys.size()); s-- > 0;) {
    const auto name = base + (s > 0 ? "_storey" + std::to_string(s) : "");
    files.emplace_back(name + "_route.geojson", jsonText(routeGraph(graph, s)));
    addMaps(files, scene, name, ending, s, resolution);
  }
  return files;
}

} // namespace

void
requireExportFormat(const std::string& path)
{
  const auto ending = fileEnding(path);
  if (std::find(std::begin(endings), std::end(endings), ending) != std::end(endings))
    return;
  std::string known;
  for (const char* name : endings)
    known += (known.empty() ? "" : ", ") + std::string(name);
  throw ToolError(path + ": cannot be written, " +
                  (ending.empty() ? "without an ending it is" : ending + " is") +
                  " none of the formats " + known);
}

NamedFiles
exportedFiles(const SavedScene& scene,
              const std::string& path,
              const ExportOptions& options)
{
  requireExportFormat(path);
  const auto ending = fileEnding(path);
  if (ending == ".ifc")
    return {{path, ifcText(scene, options.epsg)}};
  if (ending == ".glb")
    return {{path, glbBytes(scene)}};
  if (ending == ".geojson")
    return {{path, jsonText(geoJson(scene, options.epsg))}};
  if (ending == ".dxf")
    return {{path, planDxf(scenePlan(scene))}};
  if (ending == ".svg")
    return {{path, planSvg(scenePlan(scene))}};
  if (std::none_of(scene.rooms.begin(), scene.rooms.end(), [](const auto& room) {
        return room.storey == 0 && !room.rings.empty();
      }))
    throw ToolError("the scene has no rooms on its lowest storey, so no map");
  return robotBundle(scene, path, options.resolution);
}

} // namespace pcl::indoor::tool
