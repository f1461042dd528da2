/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pipeline/pipeline_stages.h"

#include "files/cloud_file.h"
#include "files/cloud_formats.h" // for promisedPoints
#include "files/digest.h"
#include "files/sampled_surface.h"
#include "pipeline/shared_rooms.h"
#include "rooms/scene_record.h"
#include "scan/scan_files.h"
#include "scene/scan_frame.h"
#include "text/printable.h"

#include <pcl/ml/model_file.h>
#include <pcl/segmentation/room_segmentation.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
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

/** Whether rooms and their objects depend on it: what is done with them at the end is
 * done anew by each run. */
bool
changesRooms(const Setting& setting)
{
  const auto& name = setting.name;
  return name != "-colour" && name != "-report" && name != "-double";
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
             const UprightFrame& found,
             RoomSegmentation<PointXYZ>& segmentation)
{
  Scene scene;
  auto segmented = segmentRooms(file, options.frame, found, segmentation);
  scene.room_of_point = std::move(segmented.room_of_point);
  scene.report = std::move(segmented.report);
  scene.rooms = segmentation.getRooms();
  scene.openings = segmentation.getOpenings();
  scene.building = segmentation.takeBuilding();
  dropGrids(scene.building);
  scene.building_pose = segmentation.getBuildingPose();
  return scene;
}

/** The rooms of a scan in memory.
 * \param[in] rooms the points of each; both must outlive the source */
RoomSource
sourceInMemory(const PipelineOptions& options,
               const CloudFile& file,
               const std::vector<Indices>& rooms)
{
  PointCloud<Normal>::Ptr normals;
  if (file.has_normals && !options.ignore_normals)
    normals = readNormals(file);
  RoomSource source;
  source.has_normals = normals != nullptr;
  for (const auto& room : rooms)
    source.sizes.push_back(room.size());
  source.points = [&file, &rooms, normals](std::size_t room) {
    RoomPoints points;
    for (const auto index : rooms[room]) {
      points.positions.emplace_back((*file.points)[index].getVector3fMap());
      if (normals)
        points.normals.emplace_back((*normals)[index].getNormalVector3fMap());
    }
    return points;
  };
  return source;
}

void
countPoints(const CloudFile& file, Scene& scene)
{
  const auto& rooms = scene.room_of_point;
  scene.counts.all = file.points->size();
  scene.counts.finite = file.finite_count;
  scene.counts.in_rooms =
      rooms.size() -
      static_cast<std::size_t>(std::count(rooms.begin(), rooms.end(), 0u));
  scene.counts.outside = scene.report.outside.size();
}

/** The same of a scan that was divided into the files of its rooms. */
void
countPoints(const CloudFile& file, const FiledRooms& filed, Scene& scene)
{
  scene.counts.all = filed.point_count;
  scene.counts.finite = file.finite_count;
  for (const RoomExtent& room : filed.rooms)
    scene.counts.in_rooms += room.point_count;
  scene.counts.outside = filed.outside;
}

Scan
readInParts(const PipelineOptions& options,
            const std::string& name,
            std::unique_ptr<CloudStream> stream,
            Progress& progress)
{
  constexpr double fineness = 0.25; // voxels of the rooms
  const double voxel = options.rooms.voxel_size > 0.0 ? options.rooms.voxel_size
                                                      : smallest_automatic_voxel;
  const double metres = options.frame.unit == "auto" ? metresPerUnitOf(*stream)
                                                     : options.frame.metresPerUnit();
  return readScan(
      name,
      std::move(stream),
      fineness * voxel / metres,
      static_cast<std::size_t>(options.points_at_once),
      [&progress](std::size_t done, std::size_t all) { progress.update(done, all); });
}

/** \throws ToolError if one of several scans would be replaced by the results */
void
requireOthersThanResults(const std::vector<std::string>& files,
                         const std::string& results)
{
  std::error_code error;
  for (const auto& file : files)
    if (files.size() > 1 &&
        std::filesystem::equivalent(file, results + "/cloud.pcd", error))
      throw ToolError(file + ": the results would replace this scan, give another "
                             "folder for them");
}

/** Scans that are open, null where one cannot be read in parts, and their points. */
struct OpenScans {
  std::vector<std::unique_ptr<CloudStream>> streams;
  std::uint64_t count = 0, in_memory = 0; ///< of all, of those that are null
};

OpenScans
openScans(const std::vector<std::string>& files)
{
  OpenScans scans;
  for (const auto& file : files) {
    const auto& stream = scans.streams.emplace_back(CloudStream::open(file));
    const auto own = stream ? stream->pointCount() : promisedPoints(file);
    scans.count += own;
    scans.in_memory += stream ? 0 : own;
  }
  return scans;
}

} // namespace

Scan
loadScan(const PipelineOptions& options, Progress& progress)
{
  constexpr double bytes_per_point = 400; // that are in use at once, measured
  constexpr std::uint64_t enough_to_check = 4000000; // points: read in about a second
  auto [files, notes] = scanFiles(options.inputs);
  if (!options.check)
    requireOthersThanResults(files, options.folder);
  const auto name = nameOfScan(options.inputs, files);
  auto [opened, count, in_memory] = openScans(files);
  const auto part = options.check ? enough_to_check : options.points_at_once;
  const bool in_parts = options.points_at_once > 0 && count > in_memory && count > part;
  const auto at_once = part + in_memory;
  options.memory.require(name, bytes_per_point, in_parts ? at_once : count);
  progress.start((!in_parts       ? "Loading "
                  : options.check ? "Reading some points of "
                                  : "Reading in parts ") +
                 name);
  auto stream = files.size() == 1
                    ? std::move(opened[0])
                    : joinedScans(files, std::move(opened), options.columns);
  const auto told = stream ? stream->notes() : std::vector<std::string>();
  const auto stations = stream ? stream->stations() : std::vector<Station>();
  Scan scan;
  if (in_parts && options.check)
    scan = readSample(name, std::move(stream));
  else if (in_parts)
    scan = readInParts(options, name, std::move(stream), progress);
  else if (files.size() == 1)
    scan.file = loadSurface(files[0], options.columns);
  else
    scan.file =
        withPoints(name,
                   stream->read(0, static_cast<std::size_t>(stream->pointCount())),
                   stream->frame());
  if (in_parts ? !options.check : files.size() > 1) // else the file has them
    notes.insert(notes.end(), told.begin(), told.end());
  scan.file.notes.insert(scan.file.notes.begin(), notes.begin(), notes.end());
  printNotes(scan.file);
  if (!stations.empty())
    scan.file.stations = stations;
  const auto points = std::to_string(scan.file.points->size());
  progress.done(scan.stream ? std::to_string(scan.stream->pointCount()) + " points, " +
                                  points + " for the rooms"
                            : points + " points");
  return scan;
}

std::uint64_t
keyOfRun(const PipelineOptions& options, const std::vector<Setting>& settings)
{
  auto text = programVersion() + "\n";
  for (const auto& setting : settings)
    if (changesRooms(setting))
      text += setting.name + " " + setting.value + "\n";
  const auto model = modelFile(options);
  if (!model.empty())
    text += std::to_string(digestOfFile(model)) + "\n";
  std::uint64_t key = 0;
  for (const auto& file : scanFiles(options.inputs).paths) {
    text += std::filesystem::path(file).filename().string() + "\n";
    key = digestOf(std::to_string(digestOfFile(file)), key);
  }
  return digestOf(text, key);
}

RoomWork
roomWork(const PipelineOptions& options)
{
  RoomWork work;
  work.preparation = options.preparation;
  work.options = options.objects;
  if (options.partition == "lccp")
    work.options.partition = Partition::Lccp;
  work.options.threads = 1; // the threads are busy with the rooms
  const auto model = modelFile(options);
  if (!model.empty())
    work.model = loadModel(model);
  return work;
}

Scene
findRooms(const PipelineOptions& options,
          const CloudFile& file,
          const UnderstoodScan& understood,
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
  auto scene = segmentScene(options, file, understood.frame, segmentation);
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

OutputFile
findObjects(const PipelineOptions& options,
            Scan& scan,
            const PointCloud<PointXYZ>& standing,
            const RoomWork& work,
            WorkFolder& folder,
            Ranks& ranks,
            Scene& scene,
            Progress& progress)
{
  const auto sizes = withSizes(options.objects);
  scene.seeds_per_voxel = sizes.seed_size / sizes.voxel_size;
  if (work.model)
    scene.classes.names = classNames(*work.model);
  const auto report = [&progress](std::size_t done, std::size_t all) {
    progress.update(done, all);
  };
  const auto finish = [&](const RoomSource& source, const VisitRoom& visit) {
    progress.start("Finding objects");
    ShareRooms share;
    if (ranks.count() > 1)
      share = [&](const auto& order, const auto& is_done) {
        shareRooms(order, source, work, folder, ranks, is_done);
      };
    finishRooms(source, work, folder, options.threads, report, share);
    gatherRooms(source, folder, scene, visit);
    progress.done(std::to_string(scene.objects.size()) + " objects");
  };
  if (!scan.stream) {
    const auto rooms = pointsOfRooms(standing, scene.room_of_point, scene.rooms.size());
    countPoints(scan.file, scene);
    scene.object_of_point.assign(standing.size(), 0);
    scene.structure_of_point.assign(standing.size(), 0);
    finish(sourceInMemory(options, scan.file, rooms),
           [&](std::size_t room, std::uint32_t first, const RoomObjects& objects) {
             for (std::size_t i = 0; i < rooms[room].size(); ++i) {
               const auto point = static_cast<std::size_t>(rooms[room][i]);
               if (objects.object_of_point[i] > 0)
                 scene.object_of_point[point] = first + objects.object_of_point[i];
               scene.structure_of_point[point] = objects.structure_of_point[i];
             }
           });
    progress.start("Completing the cloud");
    auto cloud = completeCloud(options, scene, scan.file);
    progress.done();
    return cloud;
  }
  progress.start("Dividing the scan into its rooms");
  const bool with_normals = scan.file.has_normals && !options.ignore_normals;
  const auto filed = fileRooms(scan, with_normals, folder, standing, scene, report);
  countPoints(scan.file, filed, scene);
  progress.done();
  std::vector<std::uint32_t> first_object;
  finish(filedSource(filed, with_normals, folder),
         [&](std::size_t, std::uint32_t first, const RoomObjects&) {
           first_object.push_back(first);
         });
  progress.start("Completing the cloud");
  auto cloud =
      completeCloudInParts(options, filed, folder, first_object, scan, scene, report);
  progress.done();
  return cloud;
}

} // namespace pcl::indoor::tool
