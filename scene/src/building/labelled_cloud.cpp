/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "building/labelled_cloud.h"

#include "formats/pcd/pcd_writer.h"
#include "scan/scan.h"            // for partOf
#include "scene/category_names.h" // for otherClass

#include <utility>

namespace pcl::indoor::tool {
namespace {

/** What was found of each point. */
struct PointLabels {
  std::vector<std::uint32_t> room, object, structure;
};

/** The class of each point's object, and how sure that is. */
struct PointClasses {
  std::vector<std::uint32_t> category;
  std::vector<float> confidence;
};

PointClasses
pointClasses(const std::vector<ObjectClass>& classes,
             const std::vector<std::uint32_t>& object_of_point)
{
  PointClasses of_point;
  of_point.category.assign(object_of_point.size(), 0);
  of_point.confidence.assign(object_of_point.size(), 0.0f);
  for (std::size_t i = 0; i < object_of_point.size(); ++i)
    if (const auto object = object_of_point[i]; object > 0) {
      of_point.category[i] = classes[object - 1].category;
      of_point.confidence[i] = classes[object - 1].confidence;
    }
  return of_point;
}

/** Add what was found to a cloud, or to a part of one.
 * \param[in] whole, output see PointColors, PointCoordinates */
void
complete(const CloudLook& look,
         const PointLabels& labels,
         const SceneClasses& classes,
         const PointCloud<PointXYZ>* whole,
         const std::string& output,
         CloudFile& file)
{
  std::vector<NewField> fields = {{"room", labels.room},
                                  {"object", labels.object},
                                  {"structure", labels.structure}};
  PointClasses of_point;
  if (!classes.names.empty()) {
    of_point = pointClasses(classes.objects, labels.object);
    fields.emplace_back("category", of_point.category);
    fields.emplace_back("confidence", of_point.confidence);
  }
  appendFields(file.cloud, fields);
  look.colors.apply(file,
                    classes.names.empty() ? "object" : "class",
                    look.up,
                    otherClass(classes.names),
                    whole);
  look.coordinates.apply(file, output);
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

} // namespace

OutputFile
completeCloud(const CloudLook& look, const Scene& scene, CloudFile& file)
{
  const PointLabels labels = {
      scene.room_of_point, scene.object_of_point, scene.structure_of_point};
  complete(look, labels, scene.classes, nullptr, look.path, file);
  return cloudBeside(look.path, file.cloud, file.pose, look.threads);
}

OutputFile
completeCloudInParts(const CloudLook& look,
                     const RoomFiles& files,
                     const WorkFolder& folder,
                     ScanContent& scan,
                     Scene& scene,
                     const PointsDone& report)
{
  const auto whole = fewPoints(*scan.file.points);
  const auto& layout = scan.stream->layout();
  SampleLabels sample(scan.sample->indices(), scene);
  SpooledLabels labels(files.spooled, folder, files.first_object);
  OutputFile output(look.path);
  scan.stream->forEachPart([&](std::uint64_t first, PCLPointCloud2& data) {
    auto part = partOf(scan, std::move(data));
    PointLabels own;
    for (std::size_t i = 0; i < part.points->size(); ++i) {
      const auto label = labels.next();
      own.room.push_back(label.room);
      own.object.push_back(label.object);
      own.structure.push_back(label.structure);
      sample.add(first + i, label);
    }
    complete(look, own, scene.classes, &whole, first == 0 ? look.path : "", part);
    if (first == 0) {
      auto all = part.cloud;
      all.data.clear();
      all.width = layout.width;
      all.height = layout.height;
      writePcdHeader(output, all, part.pose);
    }
    writePcdPart(output, part.cloud);
    report(first + part.points->size(), files.spooled.point_count);
    if (first + part.points->size() == files.spooled.point_count)
      scan.file.pose = part.pose; // as in the output
  });
  output.close();
  return output;
}

} // namespace pcl::indoor::tool
