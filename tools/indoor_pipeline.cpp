/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "cloud_file.h"
#include "options.h"
#include "point_spacing.h"
#include "room_objects.h"
#include "room_picture.h"
#include "scene_file.h"

#include <pcl/segmentation/room_segmentation.h>

#include <algorithm>

using namespace pcl::indoor::tool;

namespace {

struct Options {
  std::string input, folder;
  std::string partition = "graph";
  pcl::indoor::BuildingRoomsOptions rooms;
  pcl::indoor::ObjectSegmentationOptions objects;
  double voxel_resolution = 0.0,
         seed_resolution = 0.0; ///< of the objects, 0 = automatic
  int threads = 0;
  bool ignore_normals = false;
};

OptionParser
makeParser(Options& options)
{
  OptionParser parser("pcl_indoor_pipeline",
                      "Finds the rooms of a building's scan, then the objects in each "
                      "room; writes cloud.pcd with the fields room and object, "
                      "scene.json, rooms.png and potential_field.png.");
  parser.positional("input", options.input, "PCD or PLY file, z up, metres")
      .positional(
          "output_dir", options.folder, "folder for the results, made if missing")
      .number("-voxel_size",
              options.rooms.voxel_size,
              "side of a voxel of the rooms",
              "m",
              Range::positive())
      .number("-min_area",
              options.rooms.map.min_area,
              "smallest room",
              "m^2",
              Range::atLeast(0))
      .number("-voxel_resolution",
              options.voxel_resolution,
              "edge of a voxel of the objects, 0 = automatic",
              "m",
              Range::atLeast(0))
      .number("-seed_resolution",
              options.seed_resolution,
              "distance of supervoxels, at least -voxel_resolution, 0 = automatic",
              "m",
              Range::atLeast(0))
      .text("-partition",
            options.partition,
            "how supervoxels are joined",
            {"graph", "lccp"})
      .flag("-ignore_normals",
            options.ignore_normals,
            "estimate normals although there are some")
      .number("-threads",
              options.threads,
              "threads, 0 = automatic",
              "",
              Range::between(0, 1024));
  return parser;
}

/** Choose what was left to the tool: a voxel wider than the gaps between points, or
 * surfaces fall apart. */
void
chooseResolution(Options& options, const CloudFile& file)
{
  auto& objects = options.objects;
  const double seeds_per_voxel = objects.seed_size / objects.voxel_size;
  if (options.voxel_resolution == 0.0)
    options.voxel_resolution =
        std::max(objects.voxel_size, 1.5 * pointSpacing(*file.points));
  if (options.seed_resolution == 0.0)
    options.seed_resolution = seeds_per_voxel * options.voxel_resolution;
  if (options.seed_resolution < options.voxel_resolution)
    throw ToolError("-seed_resolution: '" + std::to_string(options.seed_resolution) +
                    "' is less than -voxel_resolution, " +
                    std::to_string(options.voxel_resolution));
  objects.voxel_size = options.voxel_resolution;
  objects.seed_size = options.seed_resolution;
}

void
segment(const Options& options, const CloudFile& file, Scene& scene, Progress& progress)
{
  progress.start("Segmenting rooms");
  pcl::RoomSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setOptions(options.rooms);
  segmentation.setNumberOfThreads(options.threads);
  segmentation.setInputCloud(file.points);
  segmentation.segment(scene.room_of_point);
  if (scene.room_of_point.empty())
    throw AlreadyReported();
  scene.rooms = segmentation.getRooms();
  scene.openings = segmentation.getOpenings();
  scene.building = segmentation.getBuilding();
  progress.done(std::to_string(scene.rooms.size()) + " rooms");

  progress.start("Segmenting objects");
  auto objects = options.objects;
  objects.partition = options.partition == "lccp" ? pcl::indoor::Partition::Lccp
                                                  : pcl::indoor::Partition::Graph;
  const bool with_normals = file.has_normals && !options.ignore_normals;
  scene.object_of_point = segmentRoomObjects(
      *file.points,
      with_normals ? readNormals(file) : nullptr,
      scene.room_of_point,
      objects,
      options.threads,
      [&](std::size_t done, std::size_t all) { progress.update(done, all); });
  scene.objects =
      measureObjects(*file.points, scene.room_of_point, scene.object_of_point);
  progress.done(std::to_string(scene.objects.size()) + " objects");
}

} // namespace

int
main(int argc, char** argv)
{
  Options options;
  auto parser = makeParser(options);
  return parser.run(argc, argv, [&](Progress& progress) {
    requireFolder(options.folder);
    progress.start("Loading " + options.input);
    CloudFile file = loadCloud(options.input);
    progress.done(std::to_string(file.points->size()) + " points");
    chooseResolution(options, file);

    Scene scene;
    segment(options, file, scene, progress);

    progress.start("Saving to " + options.folder);
    makeFolder(options.folder);
    const auto in_folder = [&](const std::string& name) {
      return options.folder + "/" + name;
    };
    saveText(in_folder("scene.json"), sceneText(scene, file, parser.values()));
    savePng(in_folder("rooms.png"), drawRooms(scene.building));
    savePng(in_folder("potential_field.png"), drawPotentialField(scene.building));
    appendField(file.cloud, "room", scene.room_of_point);
    appendField(file.cloud, "object", scene.object_of_point);
    saveCloud(in_folder("cloud.pcd"), file.cloud, file.origin, file.orientation);
    progress.done("cloud.pcd, scene.json, rooms.png, potential_field.png");
  });
}
