/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pipeline/pipeline_stages.h"

#include "command_line/printable.h"
#include "files/cloud_file.h"
#include "files/digest.h"
#include "pipeline/scene_record.h"
#include "scene/scan_frame.h"

#include <pcl/ml/model_file.h>
#include <pcl/segmentation/room_segmentation.h>

#include <cmath>
#include <string>
#include <utility>

namespace pcl::indoor::tool {
namespace {

/** The file of the classifier that was asked for; empty if none was. */
std::string
modelFile(const PipelineOptions& options)
{
  return options.model == "none"      ? ""
         : options.model == "bundled" ? bundledModel()
                                      : options.model;
}

/** The rooms that an earlier run has found; nothing if they do not fit. */
std::optional<Scene>
roomsBefore(const CloudFile& file, const WorkFolder& folder)
{
  const auto bytes = folder.read("scene");
  auto scene = bytes ? sceneOf(*bytes) : std::nullopt;
  return scene && scene->room_of_point.size() == file.points->size() ? std::move(scene)
                                                                     : std::nullopt;
}

Scene
segmentScene(const PipelineOptions& options,
             const CloudFile& file,
             RoomSegmentation<PointXYZ>& segmentation)
{
  Scene scene;
  scene.room_of_point = segmentRooms(file, options.frame, segmentation);
  scene.rooms = segmentation.getRooms();
  scene.openings = segmentation.getOpenings();
  scene.building = segmentation.getBuilding();
  dropGrids(scene.building);
  scene.building_pose = segmentation.getBuildingPose();
  scene.report = segmentation.getReport();
  return scene;
}

} // namespace

std::uint64_t
keyOfRun(const PipelineOptions& options, const std::vector<Setting>& settings)
{
  auto text = programVersion() + "\n";
  for (const auto& setting : settings)
    text += setting.name + " " + setting.value + "\n";
  const auto model = modelFile(options);
  if (!model.empty())
    text += std::to_string(digestOfFile(model)) + "\n";
  return digestOf(text, digestOfFile(options.input));
}

RoomWork
roomWork(const PipelineOptions& options)
{
  RoomWork work;
  work.options.segmentation = options.objects;
  work.options.segmentation.partition =
      options.partition == "lccp" ? Partition::Lccp : Partition::Pieces;
  work.options.segmentation.threads = 1; // the threads are busy with the rooms
  const auto model = modelFile(options);
  if (!model.empty())
    work.model = loadModel(model);
  work.is_standing = options.frame.unit == "m" && options.frame.up == "z";
  work.metres_per_unit = options.frame.metresPerUnit();
  return work;
}

Scene
findRooms(const PipelineOptions& options,
          const CloudFile& file,
          WorkFolder& folder,
          Progress& progress)
{
  progress.start("Segmenting rooms");
  if (auto scene = roomsBefore(file, folder)) {
    for (const auto& line : scene->report.warnings)
      printWarning(file.path + ": " + line);
    progress.done(std::to_string(scene->rooms.size()) + " rooms, found before");
    return std::move(*scene);
  }
  RoomSegmentation<PointXYZ> segmentation;
  segmentation.setOptions(options.rooms);
  segmentation.setNumberOfThreads(options.threads);
  segmentation.setProgressCallback([&progress](double share, const char*) {
    progress.update(static_cast<std::size_t>(100.0 * share), 100);
    return true;
  });
  auto scene = segmentScene(options, file, segmentation);
  folder.write("scene", sceneBytes(scene));
  progress.done(summaryOf(segmentation));
  return scene;
}

PointCloud<PointXYZ>::ConstPtr
standingPoints(const CloudFile& file, const RoomWork& work, const Scene& scene)
{
  if (work.is_standing && scene.report.outside.empty())
    return file.points;
  auto points = pcl::make_shared<PointCloud<PointXYZ>>(*file.points);
  for (auto& point : *points)
    point.getVector3fMap() = work.standing(point.getVector3fMap());
  for (const auto index : scene.report.outside)
    (*points)[index].getVector3fMap().setConstant(NAN);
  return points;
}

void
findObjects(const PipelineOptions& options,
            const CloudFile& file,
            const PointCloud<PointXYZ>& standing,
            const RoomWork& work,
            WorkFolder& folder,
            Ranks& ranks,
            Scene& scene,
            Progress& progress)
{
  progress.start("Finding objects");
  const auto rooms = pointsOfRooms(standing, scene.room_of_point, scene.rooms.size());
  PointCloud<Normal>::Ptr normals;
  if (file.has_normals && !options.ignore_normals)
    normals = readNormals(file);
  RoomSource source;
  source.has_normals = normals != nullptr;
  for (const auto& room : rooms)
    source.sizes.push_back(room.size());
  source.points = [&](std::size_t room) {
    RoomPoints points;
    for (const auto index : rooms[room]) {
      points.positions.emplace_back((*file.points)[index].getVector3fMap());
      if (normals)
        points.normals.emplace_back((*normals)[index].getNormalVector3fMap());
    }
    return points;
  };
  finishRooms(source,
              work,
              folder,
              ranks,
              options.threads,
              [&](std::size_t done, std::size_t all) { progress.update(done, all); });
  scene.seeds_per_voxel = options.objects.seed_size / options.objects.voxel_size;
  if (work.model)
    scene.classes.names = classNames(*work.model);
  gatherRooms(rooms, folder, scene);
  progress.done(std::to_string(scene.objects.size()) + " objects");
}

} // namespace pcl::indoor::tool
