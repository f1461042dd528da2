/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pipeline/pipeline_results.h"

#include "formats/json_text.h"
#include "formats/pcd_writer.h"
#include "pictures/class_picture.h"
#include "pictures/plan_dxf.h"
#include "pictures/plan_png.h"
#include "pictures/plan_svg.h"
#include "pictures/room_picture.h"
#include "report/report_page.h"
#include "scan/result_names.h"
#include "scene/category_names.h" // for other_class

#include <algorithm>
#include <filesystem>

namespace pcl::indoor::tool {
namespace {

/** What was found of each point. */
struct PointLabels {
  std::vector<std::uint32_t> room, object, structure;
};

/** Fields that tell each point the class of its object, and how sure that is. */
void
appendClasses(const std::vector<ObjectClass>& classes,
              const std::vector<std::uint32_t>& object_of_point,
              PCLPointCloud2& cloud)
{
  std::vector<std::uint32_t> categories(object_of_point.size(), 0);
  std::vector<float> confidences(object_of_point.size(), 0.0f);
  for (std::size_t i = 0; i < categories.size(); ++i)
    if (const auto object = object_of_point[i]; object > 0) {
      categories[i] = classes[object - 1].category;
      confidences[i] = classes[object - 1].confidence;
    }
  appendField(cloud, "category", categories);
  appendRealField(cloud, "confidence", confidences);
}

/** Add what was found to a cloud, or to a part of one.
 * \param[in] whole, output see PointColors, PointCoordinates */
void
complete(const PipelineOptions& options,
         const PointLabels& labels,
         const SceneClasses& classes,
         const PointCloud<PointXYZ>* whole,
         const std::string& output,
         CloudFile& file)
{
  appendField(file.cloud, "room", labels.room);
  appendField(file.cloud, "object", labels.object);
  appendField(file.cloud, "structure", labels.structure);
  if (!classes.names.empty())
    appendClasses(classes.objects, labels.object, file.cloud);
  const auto other = static_cast<std::uint32_t>(
      std::find(classes.names.begin(), classes.names.end(), other_class) -
      classes.names.begin());
  options.colors.apply(file,
                       classes.names.empty() ? "object" : "class",
                       options.frame.upAxis(),
                       other,
                       whole);
  options.coordinates.apply(file, output);
}

/** Some points of the sample, which show how high the scan is. */
PointCloud<PointXYZ>
fewPoints(const PointCloud<PointXYZ>& sample)
{
  constexpr std::size_t enough = 100000;
  PointCloud<PointXYZ> few;
  for (std::size_t i = 0; i < sample.size(); i += sample.size() / enough + 1)
    few.push_back(sample[i]);
  return few;
}

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

} // namespace

void
requireUsable(const PipelineOptions& options)
{
  requireFolder(options.folder);
  if (std::filesystem::exists(options.folder))
    for (const auto& name : resultNames())
      requireWritable(options.folder + "/" + name);
  if (options.report != "none" && options.report != "folder") {
    requireOwnName(options.report, options.folder);
    requireWritable(options.report);
  }
  if (options.model == "none" && options.colors.wanted == "class")
    throw ToolError("-colour class: there are no classes with -model none");
}

OutputFile
completeCloud(const PipelineOptions& options, const Scene& scene, CloudFile& file)
{
  const auto path = options.folder + "/cloud.pcd";
  const PointLabels labels = {
      scene.room_of_point, scene.object_of_point, scene.structure_of_point};
  complete(options, labels, scene.classes, nullptr, path, file);
  return cloudBeside(path, file.cloud, file.frame);
}

OutputFile
completeCloudInParts(const PipelineOptions& options,
                     const FiledRooms& filed,
                     const WorkFolder& folder,
                     const std::vector<std::uint32_t>& first_object,
                     Scan& scan,
                     Scene& scene,
                     const PointsDone& report)
{
  const auto path = options.folder + "/cloud.pcd";
  const auto whole = fewPoints(*scan.file.points);
  const auto& layout = scan.stream->layout();
  const auto& sampled = scan.sample->indices();
  scene.object_of_point.clear();
  scene.structure_of_point.clear();
  FiledLabels labels(filed, folder, first_object);
  OutputFile output(path);
  scan.stream->forEachPart([&](std::uint64_t first, PCLPointCloud2& data) {
    auto part = partOf(scan, std::move(data));
    PointLabels own;
    for (std::size_t i = 0; i < part.points->size(); ++i) {
      const auto label = labels.next();
      own.room.push_back(label.room);
      own.object.push_back(label.object);
      own.structure.push_back(label.structure);
      const auto next = scene.object_of_point.size(); // of the sample
      if (next < sampled.size() && sampled[next] == first + i) {
        scene.object_of_point.push_back(label.object);
        scene.structure_of_point.push_back(label.structure);
      }
    }
    complete(options, own, scene.classes, &whole, first == 0 ? path : "", part);
    if (first == 0) {
      auto all = part.cloud;
      all.data.clear();
      all.width = layout.width;
      all.height = layout.height;
      writePcdHeader(output, all, part.frame);
    }
    writePcdPart(output, part.cloud);
    report(first + part.points->size(), filed.point_count);
    if (first + part.points->size() == filed.point_count)
      scan.file.frame = part.frame; // as in the output
  });
  output.close();
  return output;
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
  const auto svg = planSvg(plan);
  add("plan.svg", svg);
  if (const auto picture = planPicture(svg))
    add("plan.png", *picture);
  add("plan.dxf", planDxf(plan));
  const auto json = sceneJson(scene, file, options.frame, settings);
  if (options.report != "none")
    files.emplace_back(options.reportFile(),
                       reportPage({scene, json, plan, field, points, file.offset}));
  add("scene.json", jsonText(json));
  return files;
}

void
save(const std::string& folder, const NamedBytes& texts, OutputFile cloud)
{
  const auto in_folder = [&](const std::string& name) { return folder + "/" + name; };
  std::vector<OutputFile> files;
  files.push_back(std::move(cloud));
  for (const auto& [path, bytes] : texts)
    files.push_back(writtenBeside(path, bytes));
  // where scene.json lies, the last one, the others belong to it
  commitTogether(files,
                 {in_folder("scene.json"),
                  in_folder("classes.png"),
                  in_folder("plan.png"),
                  in_folder("report.html")});
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
