/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "building/building_stages.h"

#include "files/points_aside.h"
#include "files/tool_error.h"
#include "rooms/scene_record.h" // for dropGrids
#include "scan/scan.h"
#include "scene/object_classes.h"
#include "scene/segmented_rooms.h"

#include <pcl/model/building_model.h>
#include <pcl/segmentation/room_segmentation.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace pcl::indoor::tool {
namespace {

void
requireOneOf(const std::string& name,
             const std::string& value,
             const std::vector<std::string>& choices)
{
  if (std::find(choices.begin(), choices.end(), value) == choices.end())
    throw ToolError(name + ": '" + value + "' is none");
}

Scene
segmentScene(const SceneOptions& options,
             const CloudFile& file,
             const ScanCoordinates& found,
             RoomSegmentation<PointXYZ>& segmentation,
             StageReport& report)
{
  Scene scene;
  auto segmented =
      segmentRooms(file,
                   options.scan,
                   found,
                   options.network != "none",
                   segmentation,
                   [&report](const std::string& line) { report.warn(line); });
  scene.room_of_point = std::move(segmented.room_of_point);
  scene.report = std::move(segmented.report);
  scene.rooms = segmentation.getRooms();
  scene.openings = segmentation.getOpenings();
  scene.building = segmentation.takeBuilding();
  dropGrids(scene.building);
  scene.frame = segmented.frame;
  return scene;
}

/** Find the rooms of the scan, unless the store has them. */
Scene
findRooms(const SceneOptions& options,
          ScanContent& scan,
          const UnderstoodScan& understood,
          RoomStore& store,
          StageReport& report)
{
  const auto& file = scan.file;
  report.start("Segmenting rooms");
  if (auto scene = store.scene();
      scene && scene->room_of_point.size() == file.points->size()) {
    for (const auto& line : scene->report.warnings)
      report.warn(file.path + ": " + line);
    report.done(std::to_string(scene->rooms.size()) + " rooms, found before");
    return std::move(*scene);
  }
  RoomSegmentation<PointXYZ> segmentation;
  if (options.thesis_rooms)
    segmentation.setThesisOptions(*options.thesis_rooms);
  else
    segmentation.setOptions(options.rooms);
  segmentation.setNumberOfThreads(options.threads);
  std::optional<PointsAside> aside;
  segmentation.setProgressCallback([&](double share, const char*) {
    if (share == 0.0 && scan.sample && !store.pathAside().empty())
      aside.emplace(*scan.sample->points(), store.pathAside());
    if (share == 1.0 && aside)
      aside->bringBack();
    report.update(static_cast<std::size_t>(100.0 * share), 100);
    return true;
  });
  auto scene =
      segmentScene(options, file, understood.coordinates, segmentation, report);
  store.putScene(scene);
  report.done(summaryOf(segmentation));
  return scene;
}

/** z up, metres, what lies beyond the building not finite. */
PointCloud<PointXYZ>::ConstPtr
uprightPoints(const CloudFile& file, const Scene& scene)
{
  if (scene.frame.isScanUpright() && scene.report.outside.empty())
    return file.points;
  auto points = pcl::make_shared<PointCloud<PointXYZ>>(*file.points);
  for (auto& point : *points)
    point.getVector3fMap() =
        scene.frame.scanToUpright(point.getVector3fMap().cast<double>()).cast<float>();
  for (const auto index : scene.report.outside)
    (*points)[index].getVector3fMap().setConstant(NAN);
  return points;
}

void
findWalls(const SceneOptions& options,
          const PointCloud<PointXYZ>& upright,
          Scene& scene,
          StageReport& report)
{
  report.start("Finding walls, doors and windows");
  const Eigen::Vector3f origin = scene.frame.origin().cast<float>();
  const auto& rooms = scene.building.rooms;
  std::uint32_t largest = 0;
  for (const Room& room : rooms)
    largest = std::max(largest, room.label);
  const PointsOfRooms points(upright, scene.room_of_point, largest, origin);
  scene.model = buildingModel(points, rooms, scene.building.openings, options.threads);
  report.done(std::to_string(scene.model.walls.size()) + " walls, " +
              std::to_string(scene.model.openings.size()) + " openings");
}

/** The rooms of a scan in memory.
 * \param[in] rooms the points of each; both must outlive the source */
RoomSource
sourceInMemory(bool ignore_normals,
               const CloudFile& file,
               const std::vector<Indices>& rooms)
{
  PointCloud<Normal>::Ptr normals;
  if (file.has_normals && !ignore_normals)
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
  scene.counts.all = file.points->size();
  scene.counts.finite = file.finite_count;
  scene.counts.in_rooms = pointsInRooms(scene.room_of_point);
  scene.counts.outside = scene.report.outside.size();
}

/** The same of a scan that was divided into the files of its rooms. */
void
countPoints(const CloudFile& file, const SpooledRooms& spooled, Scene& scene)
{
  scene.counts.all = spooled.point_count;
  scene.counts.finite = file.finite_count;
  for (const RoomExtent& room : spooled.rooms)
    scene.counts.in_rooms += room.point_count;
  scene.counts.outside = spooled.outside;
}

/** Looks for the objects of all rooms and puts them into the scene. */
void
search(const ObjectSearch& search,
       const RoomSource& source,
       Scene& scene,
       const VisitRoom& visit)
{
  auto& report = search.report;
  report.start("Finding objects");
  finishRooms(
      source,
      search.work,
      search.store,
      search.threads,
      [&](std::size_t done, std::size_t all) { report.update(done, all); },
      search.share);
  gatherRooms(source, search.store, scene, visit);
  report.done(std::to_string(scene.objects.size()) + " objects");
}

/** What does not depend on the points. */
void
describeSearch(const RoomWork& work, Scene& scene)
{
  const auto sizes = withSizes(work.thesis ? work.thesis->shared : work.options);
  scene.seeds_per_voxel = sizes.seed_size / sizes.voxel_size;
  if (work.naming)
    scene.classes.names = classNames(*work.naming);
}

} // namespace

SceneOptions
checkedOptions(SceneOptions options)
{
  requireOneOf("unit", options.scan.unit, {"auto", "m", "cm", "mm", "ft", "in"});
  requireOneOf("partition", options.partition, {"graph", "lccp"});
  requireOneOf("network", options.network, {"auto", "all", "none"});
  requireOneOf(
      "normals", options.preparation.normals, {"voxels", "rrht", "multi_scale"});
  options.scan.upAxis(); // throws
  const double voxel = options.voxel_resolution, seed = options.seed_resolution;
  if (voxel == 0.0 && seed == 0.0)
    return options;
  auto& objects =
      options.thesis_objects ? options.thesis_objects->shared : options.objects;
  objects.voxel_size = voxel;
  objects.seed_size = seed;
  objects = withSizes(objects);
  if (objects.seed_size < objects.voxel_size)
    throw ToolError("-seed_resolution: '" + std::to_string(seed) +
                    "' is less than -voxel_resolution, " + std::to_string(voxel));
  return options;
}

void
drawSample(const SceneOptions& options,
           std::uint64_t most_points,
           ScanContent& scan,
           StageReport& report)
{
  constexpr double fineness = 0.25; // voxels of the rooms
  const auto& rooms =
      options.thesis_rooms ? options.thesis_rooms->shared : options.rooms;
  const double voxel =
      rooms.voxel_size > 0.0 ? rooms.voxel_size : smallest_automatic_voxel;
  const double metres = options.scan.unit == "auto" ? metresPerUnitOf(*scan.stream)
                                                    : options.scan.metresPerUnit();
  drawSample(
      scan,
      fineness * voxel / metres,
      static_cast<std::size_t>(most_points),
      [&report](std::size_t done, std::size_t all) { report.update(done, all); });
}

RoomWork
roomWork(const SceneOptions& options)
{
  RoomWork work;
  work.preparation = options.preparation;
  work.options = options.objects;
  work.options.threads = 1; // the threads are busy with the rooms
  work.thesis = options.thesis_objects;
  if (work.thesis)
    work.thesis->shared.threads = 1;
  if (options.partition == "lccp") {
    if (!work.thesis)
      work.thesis = thesis::ObjectOptions{work.options, {}, {}};
    work.thesis->edges.partition = thesis::EdgePartition::Lccp;
  }
  work.naming = namingOf(options);
  if (options.network != "none")
    work.network = {true,
                    options.network == "all",
                    options.model == "bundled" && !options.naming.classify};
  return work;
}

FoundBuilding
findBuilding(SceneOptions& options,
             ScanContent& scan,
             const UnderstoodScan& understood,
             ObjectSearch& search)
{
  FoundBuilding found;
  auto& scene = found.scene;
  scene = findRooms(options, scan, understood, search.store, search.report);
  search.work.frame = scene.frame;
  options.scan.settle(scene.report);
  scene.understood = understood;
  scene.understood.settle(scene.report);
  found.upright = uprightPoints(scan.file, scene);
  findWalls(options, *found.upright, scene, search.report);
  return found;
}

void
findObjects(const ObjectSearch& objects, const CloudFile& file, FoundBuilding& building)
{
  auto& scene = building.scene;
  const auto& upright = *building.upright;
  describeSearch(objects.work, scene);
  const auto rooms = pointsOfRooms(upright, scene.room_of_point, scene.rooms.size());
  countPoints(file, scene);
  scene.object_of_point.assign(upright.size(), 0);
  scene.structure_of_point.assign(upright.size(), 0);
  search(objects,
         sourceInMemory(objects.ignore_normals, file, rooms),
         scene,
         [&](std::size_t room, std::uint32_t first, const RoomObjects& own) {
           for (std::size_t i = 0; i < rooms[room].size(); ++i) {
             const auto point = static_cast<std::size_t>(rooms[room][i]);
             if (own.object_of_point[i] > 0)
               scene.object_of_point[point] = first + own.object_of_point[i];
             scene.structure_of_point[point] = own.structure_of_point[i];
           }
         });
}

RoomFiles
findObjectsInParts(const ObjectSearch& objects,
                   WorkFolder& folder,
                   ScanContent& scan,
                   FoundBuilding& building)
{
  auto& scene = building.scene;
  describeSearch(objects.work, scene);
  auto& report = objects.report;
  report.start("Dividing the scan into its rooms");
  const bool with_normals = scan.file.has_normals && !objects.ignore_normals;
  RoomFiles files;
  files.spooled = spoolRooms(
      scan,
      with_normals,
      folder,
      *building.upright,
      scene,
      [&report](std::size_t done, std::size_t all) { report.update(done, all); });
  countPoints(scan.file, files.spooled, scene);
  report.done();
  search(objects,
         spooledSource(files.spooled, with_normals, folder),
         scene,
         [&](std::size_t, std::uint32_t first, const RoomObjects&) {
           files.first_object.push_back(first);
         });
  return files;
}

SampleLabels::SampleLabels(const AscendingNumbers& sampled, Scene& scene)
: next_(sampled)
, has_more_(next_.next())
, scene_(scene)
{
  scene.object_of_point.clear();
  scene.structure_of_point.clear();
}

void
SampleLabels::add(std::uint64_t point, const SpooledLabels::Label& label)
{
  if (!has_more_ || next_.number() != point)
    return;
  scene_.object_of_point.push_back(label.object);
  scene_.structure_of_point.push_back(label.structure);
  has_more_ = next_.next();
}

void
labelSample(const RoomFiles& files,
            const WorkFolder& folder,
            const AscendingNumbers& sampled,
            Scene& scene)
{
  SpooledLabels labels(files.spooled, folder, files.first_object);
  SampleLabels sample(sampled, scene);
  for (std::uint64_t i = 0; i < files.spooled.point_count; ++i)
    sample.add(i, labels.next());
}

} // namespace pcl::indoor::tool
