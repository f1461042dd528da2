/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "building/result_files.h"

#include "export/scene_files.h"
#include "files/result_names.h"
#include "files/tool_error.h"
#include "formats/json_text.h"
#include "pictures/class_picture.h"
#include "pictures/plan_dxf.h"
#include "pictures/plan_svg.h"
#include "pictures/room_picture.h"
#include "pictures/svg_raster.h"
#include "report/report_page.h"
#include "scene/scene_json.h"
#include "text/printable.h"

#include <pcl/scene/room_names.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <vector>

namespace pcl::indoor::tool {
namespace {

/** The report is no other of the results. */
void
requireOwnName(const std::string& report, const std::string& folder)
{
  namespace fs = std::filesystem;
  const auto place = fs::weakly_canonical(report);
  for (const auto& name : resultNames())
    if (name != "report.html" && place == fs::weakly_canonical(fs::path(folder) / name))
      throw ToolError("-report: '" + report + "' is the place of another result");
}

/** What is written for other programs, by the name that says the format. */
std::vector<std::string>
exportsOf(const ResultOptions& options)
{
  std::vector<std::string> names;
  if (options.ifc)
    names.emplace_back("building.ifc");
  if (options.geojson)
    names.emplace_back("building.geojson");
  if (options.map)
    names.emplace_back("map.pgm");
  return names;
}

/** What the scene is written as for other programs. */
void
addExports(const ResultOptions& options,
           const nlohmann::ordered_json& json,
           NamedBytes& files)
{
  const auto names = exportsOf(options);
  if (names.empty())
    return;
  const auto scene = savedScene(json);
  ExportOptions how;
  how.epsg = options.epsg;
  for (const auto& name : names)
    try {
      auto more = exportedFiles(scene, options.folder + "/" + name, how);
      std::move(more.begin(), more.end(), std::back_inserter(files));
    } catch (const ToolError& problem) { // the other results are none the worse
      printWarning(name + " is not written: " + problem.what());
    }
}

/** What each room is for; empty = not known. */
std::vector<std::string>
knownNames(const Scene& scene)
{
  std::vector<std::string> names;
  for (const auto& room : roomNames(scene))
    names.push_back(room.isKnown() ? room.text() : "");
  return names;
}

/** The plan, and what is drawn for a look at the result. */
std::vector<Picture>
picturesOf(const Scene& scene,
           const PointCloud<PointXYZ>& points,
           const std::string& plan,
           const std::string& field)
{
  std::vector<Picture> pictures = {{"rooms.png", drawRooms(scene.building).str(), 1.0},
                                   {"potential_field.png", field, 1.0}};
  if (!scene.classes.names.empty())
    pictures.push_back({"classes.png", drawClasses(scene, points).str(), 1.0});
  pictures.push_back({"plan.png", plan});
  return pictures;
}

/** Results of an earlier run that this one need not replace. */
std::vector<std::string>
outdatedResults(const std::string& folder)
{
  std::vector<std::string> outdated;
  for (const char* name : {"scene.json",
                           "rooms.png",
                           "potential_field.png",
                           "classes.png",
                           "plan.png",
                           "report.html"})
    outdated.push_back(folder + "/" + name);
  if (std::filesystem::exists(outdated.front()))
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (isExportName(entry.path().filename().string()))
        outdated.push_back(entry.path().string());
  return outdated;
}

} // namespace

void
requireWritableResults(const ResultOptions& options)
{
  requireFolder(options.folder);
  if (std::filesystem::exists(options.folder)) {
    for (const auto& name : resultNames())
      requireWritable(options.folder + "/" + name);
    for (const auto& name : exportsOf(options))
      requireWritable(options.folder + "/" + name);
  }
  if (options.report != "none" && options.report != "folder") {
    requireOwnName(options.report, options.folder);
    requireWritable(options.report);
  }
}

NamedBytes
describe(const ResultOptions& options,
         const Scene& scene,
         const PointCloud<PointXYZ>& points)
{
  NamedBytes files;
  const auto add = [&](const std::string& name, const std::string& bytes) {
    files.emplace_back(options.folder + "/" + name, bytes);
  };
  auto plan = floorPlan(scene.building, objectsFromAbove(scene));
  addModel(scene.model, plan);
  addNames(knownNames(scene), plan);
  plan.origin = scene.frame.originInFile().head<2>();
  const auto svg = planSvg(plan), field = drawPotentialField(scene.building).str();
  auto pictures = rasterised(picturesOf(scene, points, svg, field)); // meanwhile
  const auto json = sceneJson(scene);
  std::string report;
  if (options.report != "none")
    report = reportPage({scene, json, plan, field, points});
  for (const auto& [name, bytes] : pictures.get())
    add(name, bytes);
  add("plan.svg", svg);
  add("plan.dxf", planDxf(plan));
  if (!report.empty())
    files.emplace_back(options.reportFile(), report);
  addExports(options, json, files);
  add("scene.json", jsonText(json));
  return files;
}

void
save(const std::string& folder, const NamedBytes& texts, OutputFile cloud)
{
  std::vector<OutputFile> files;
  files.push_back(std::move(cloud));
  for (const auto& [path, bytes] : texts)
    files.push_back(writtenBeside(path, bytes));
  // where scene.json lies, the last one, the others belong to it
  commitTogether(files, outdatedResults(folder));
}

std::string
namesOf(const NamedBytes& texts)
{
  std::string names = "cloud.pcd";
  for (const auto& text : texts)
    names += ", " + std::filesystem::path(text.first).filename().string();
  return names;
}

} // namespace pcl::indoor::tool
