/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pipeline/pipeline_results.h"

#include "files/json_text.h"
#include "objects/category_names.h" // for other_class
#include "pictures/class_picture.h"
#include "pictures/plan_dxf.h"
#include "pictures/plan_png.h"
#include "pictures/plan_svg.h"
#include "pictures/room_picture.h"
#include "report/report_page.h"

#include <algorithm>
#include <filesystem>

namespace pcl::indoor::tool {
namespace {

constexpr const char* results[] = {"scene.json",
                                   "cloud.pcd",
                                   "rooms.png",
                                   "potential_field.png",
                                   "classes.png",
                                   "plan.svg",
                                   "plan.png",
                                   "plan.dxf",
                                   "report.html"};

/** Fields that tell each point the class of its object, and how sure that is. */
void
appendClasses(const Scene& scene, pcl::PCLPointCloud2& cloud)
{
  std::vector<std::uint32_t> categories(scene.object_of_point.size(), 0);
  std::vector<float> confidences(scene.object_of_point.size(), 0.0f);
  for (std::size_t i = 0; i < categories.size(); ++i)
    if (const auto object = scene.object_of_point[i]; object > 0) {
      categories[i] = scene.classes.objects[object - 1].category;
      confidences[i] = scene.classes.objects[object - 1].confidence;
    }
  appendField(cloud, "category", categories);
  appendRealField(cloud, "confidence", confidences);
}

/** Put all results into the folder, scene.json the last: where it lies, the others
 * belong to it. */
void
saveResults(const std::string& folder, const NamedBytes& texts, const CloudFile& file)
{
  const auto in_folder = [&](const std::string& name) { return folder + "/" + name; };
  std::vector<OutputFile> files;
  files.push_back(cloudBeside(in_folder("cloud.pcd"), file.cloud, file.frame));
  for (const auto& [path, bytes] : texts)
    files.push_back(writtenBeside(path, bytes));
  commitTogether(
      files,
      {in_folder("scene.json"), in_folder("classes.png"), in_folder("report.html")});
}

} // namespace

void
requireUsable(const PipelineOptions& options)
{
  requireFolder(options.folder);
  if (std::filesystem::exists(options.folder))
    for (const char* name : results)
      requireWritable(options.folder + "/" + name);
  if (options.report != "none" && options.report != "folder")
    requireWritable(options.report);
  if (options.model == "none" && options.colors.wanted == "class")
    throw ToolError("-colour class: there are no classes with -model none");
}

void
complete(const PipelineOptions& options, const Scene& scene, CloudFile& file)
{
  appendField(file.cloud, "room", scene.room_of_point);
  appendField(file.cloud, "object", scene.object_of_point);
  appendField(file.cloud, "structure", scene.structure_of_point);
  const auto& classes = scene.classes.names;
  if (!classes.empty())
    appendClasses(scene, file.cloud);
  const auto other = static_cast<std::uint32_t>(
      std::find(classes.begin(), classes.end(), other_class) - classes.begin());
  options.colors.apply(
      file, classes.empty() ? "object" : "class", options.frame.upAxis(), other);
  options.coordinates.apply(file, options.folder + "/cloud.pcd");
}

NamedBytes
describe(const PipelineOptions& options,
         const std::vector<Setting>& settings,
         const Scene& scene,
         const PointCloud<PointXYZ>& points,
         const CloudFile& file)
{
  NamedBytes files;
  const auto add = [&](const std::string& name, const std::string& bytes) {
    files.emplace_back(options.folder + "/" + name, bytes);
  };
  const auto field = drawPotentialField(scene.building);
  add("rooms.png", pngBytes(drawRooms(scene.building)));
  add("potential_field.png", pngBytes(field));
  if (!scene.classes.names.empty())
    add("classes.png", pngBytes(drawClasses(scene, points)));
  auto plan = floorPlan(scene.building, thingsFromAbove(scene));
  plan.origin = originOf(file, options.frame, scene.building_pose);
  add("plan.svg", planSvg(plan));
  if (canDrawPlans())
    add("plan.png", drawnAsPng(planSvg(plan)));
  add("plan.dxf", planDxf(plan));
  const auto json = sceneJson(scene, file, options.frame, settings);
  if (options.report != "none")
    files.emplace_back(options.reportFile(),
                       reportPage({scene, json, plan, field, points, file.offset}));
  add("scene.json", jsonText(json));
  return files;
}

std::string
save(const std::string& folder, const NamedBytes& texts, const CloudFile& file)
{
  const bool is_made = makeFolder(folder);
  try {
    saveResults(folder, texts, file);
  } catch (...) {
    if (is_made)
      std::filesystem::remove(folder); // is empty
    throw;
  }
  std::string names = "cloud.pcd";
  for (const auto& text : texts)
    names += ", " + std::filesystem::path(text.first).filename().string();
  return names;
}

} // namespace pcl::indoor::tool
