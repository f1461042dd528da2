/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/options.h"
#include "command_line/preset.h"
#include "files/cloud_file.h"
#include "files/json_text.h"
#include "files/memory_limit.h"
#include "files/point_colors.h"
#include "files/point_coordinates.h"
#include "objects/category_names.h" // for other_class
#include "pictures/class_picture.h"
#include "pictures/plan_dxf.h"
#include "pictures/plan_png.h"
#include "pictures/plan_svg.h"
#include "pictures/room_picture.h"
#include "pipeline/scene_rooms.h"
#include "report/report_page.h"
#include "scene/scan_frame.h"
#include "scene/scene_file.h"
#include "scene/scene_summary.h"

#include <pcl/ml/model_file.h>
#include <pcl/segmentation/room_segmentation.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

using namespace pcl::indoor::tool;

namespace {

using Points = pcl::PointCloud<pcl::PointXYZ>;

constexpr double bytes_per_point = 400; // that are in use at once, measured

struct Options {
  std::string input, folder;
  std::string partition = "graph";
  std::string preset = "default";
  std::string model = "bundled"; ///< file, "none" or "bundled"
  std::string report = "folder"; ///< file, "none" or "folder"
  ScanFrame frame;
  pcl::indoor::BuildingRoomsOptions rooms;
  pcl::indoor::ObjectSegmentationOptions objects;
  double voxel_resolution = 0.0,
         seed_resolution = 0.0; ///< of the objects, 0 = automatic
  PointColors colors;
  PointCoordinates coordinates;
  MemoryLimit memory;
  int threads = 0;
  bool ignore_normals = false;

  std::string
  reportFile() const
  {
    return report == "folder" ? folder + "/report.html" : report;
  }
};

constexpr const char* results[] = {"scene.json",
                                   "cloud.pcd",
                                   "rooms.png",
                                   "potential_field.png",
                                   "classes.png",
                                   "plan.svg",
                                   "plan.png",
                                   "plan.dxf",
                                   "report.html"};

OptionParser
makeParser(Options& options)
{
  OptionParser parser(
      "pcl_indoor_pipeline",
      "Finds the rooms of a building's scan, the objects in each room "
      "and the class of each object; writes cloud.pcd with the fields "
      "room, object, structure, category and confidence, scene.json, report.html, "
      "plan.svg, plan.png, plan.dxf, rooms.png, potential_field.png and classes.png.");
  parser.positional("input", options.input, "PCD or PLY file")
      .positional(
          "output_dir", options.folder, "folder for the results, made if missing")
      .number(
          "-voxel_size",
          options.rooms.voxel_size,
          "side of a voxel of the rooms, 0 = automatic: 0.1, more for sparse points",
          "m",
          Range::atLeast(0))
      .number("-min_area",
              options.rooms.map.min_area,
              "smallest room",
              "m^2",
              Range::atLeast(0))
      .number("-voxel_resolution",
              options.voxel_resolution,
              "edge of a voxel of the objects, 0 = automatic: 0.03, more in rooms with "
              "sparse points",
              "m",
              Range::atLeast(0))
      .number(
          "-seed_resolution",
          options.seed_resolution,
          "distance of supervoxels, at least -voxel_resolution, 0 = automatic: four "
          "times that",
          "m",
          Range::atLeast(0))
      .text("-preset",
            options.preset,
            "thesis: rooms and objects by the methods of the thesis with their "
            "parameters, and no more",
            {"default", "thesis"})
      .text("-partition",
            options.partition,
            "how supervoxels are joined",
            {"graph", "lccp"})
      .text("-model",
            options.model,
            "file of a classifier that pcl_eppf_train has made; bundled = furniture, "
            "doors and windows, none = no classes")
      .text("-report",
            options.report,
            "file of the report, a page for browsers; folder = report.html beside the "
            "other results, none = no report")
      .flag("-ignore_normals",
            options.ignore_normals,
            "estimate normals although there are some")
      .number("-threads",
              options.threads,
              "threads, 0 = automatic",
              "",
              Range::between(0, 1024));
  options.colors.addOption(parser, {"class", "object", "room"});
  options.coordinates.addOption(parser);
  options.memory.addOption(parser);
  options.frame.addOptions(parser);
  parser.expert({"-voxel_resolution",
                 "-seed_resolution",
                 "-partition",
                 "-preset",
                 "-ignore_normals",
                 "-double",
                 "-memory_limit"});
  return parser;
}

/** Sizes that are given hold, and each gives the other; if none is, the library raises
 * both where points are sparse. */
void
chooseResolution(Options& options)
{
  auto& objects = options.objects;
  const double seeds_per_voxel = objects.seed_size / objects.voxel_size;
  const double voxel = options.voxel_resolution, seed = options.seed_resolution;
  if (voxel == 0.0 && seed == 0.0)
    return;
  objects.adapt_to_resolution = false;
  objects.voxel_size = voxel > 0.0 ? voxel : seed / seeds_per_voxel;
  objects.seed_size = seed > 0.0 ? seed : seeds_per_voxel * voxel;
  if (objects.seed_size < objects.voxel_size)
    throw ToolError("-seed_resolution: '" + std::to_string(seed) +
                    "' is less than -voxel_resolution, " + std::to_string(voxel));
}

/** The classifier that was asked for; none if none was. */
std::optional<pcl::indoor::ClassifierModel>
loadClassifier(const Options& options)
{
  if (options.model == "none")
    return std::nullopt;
  return pcl::indoor::loadModel(options.model == "bundled" ? bundledModel()
                                                           : options.model);
}

/** What the objects of each room are looked for with. */
RoomWork
roomWork(const Options& options, const Eigen::Isometry3d& pose)
{
  RoomWork work;
  work.options.segmentation = options.objects;
  if (options.partition == "lccp")
    work.options.segmentation.partition = pcl::indoor::Partition::Lccp;
  work.options.segmentation.threads = 1; // the threads are busy with the rooms
  work.model = loadClassifier(options);
  work.is_standing = options.frame.unit == "m" && options.frame.up == "z";
  work.turn = options.frame.metresPerUnit() * pose.linear().transpose();
  if (options.frame.up != "z")
    work.normal_turn = pose.linear().transpose().cast<float>();
  return work;
}

/** The points as the objects are looked for: z up, metres, what lies beyond the
 * building not finite. */
Points::ConstPtr
standingPoints(const CloudFile& file, const RoomWork& work, const Scene& scene)
{
  if (work.is_standing && scene.report.outside.empty())
    return file.points;
  auto points = pcl::make_shared<Points>(*file.points);
  if (!work.is_standing)
    for (auto& point : *points)
      point.getVector3fMap() =
          (work.turn * point.getVector3fMap().cast<double>()).cast<float>();
  for (const auto index : scene.report.outside)
    (*points)[index].getVector3fMap().setConstant(NAN);
  return points;
}

/** Find the rooms of the scan. */
Scene
findRooms(const Options& options, const CloudFile& file, Progress& progress)
{
  progress.start("Segmenting rooms");
  pcl::RoomSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setOptions(options.rooms);
  segmentation.setNumberOfThreads(options.threads);
  segmentation.setProgressCallback([&progress](double share, const char*) {
    progress.update(static_cast<std::size_t>(100.0 * share), 100);
    return true;
  });
  Scene scene;
  scene.room_of_point = segmentRooms(file, options.frame, segmentation);
  scene.rooms = segmentation.getRooms();
  scene.openings = segmentation.getOpenings();
  scene.building = segmentation.getBuilding();
  scene.building_pose = segmentation.getBuildingPose();
  scene.report = segmentation.getReport();
  progress.done(summaryOf(segmentation));
  return scene;
}

/** Find the objects of the rooms, one room after the other, and what they are.
 * \param[in] standing tells which points count */
void
findObjects(const Options& options,
            const CloudFile& file,
            const Points& standing,
            const RoomWork& work,
            Scene& scene,
            Progress& progress)
{
  progress.start("Finding objects");
  const auto rooms =
      pcl::indoor::pointsOfRooms(standing, scene.room_of_point, scene.rooms.size());
  pcl::PointCloud<pcl::Normal>::Ptr normals;
  if (file.has_normals && !options.ignore_normals)
    normals = readNormals(file);
  RoomSource source;
  for (const auto& room : rooms)
    source.sizes.push_back(room.size());
  source.points = [&](std::size_t room) {
    pcl::indoor::RoomPoints points;
    for (const auto index : rooms[room]) {
      points.positions.emplace_back((*file.points)[index].getVector3fMap());
      if (normals)
        points.normals.emplace_back((*normals)[index].getNormalVector3fMap());
    }
    return points;
  };
  auto finished = finishRooms(
      source, work, options.threads, [&](std::size_t done, std::size_t all) {
        progress.update(done, all);
      });
  scene.seeds_per_voxel = options.objects.seed_size / options.objects.voxel_size;
  if (work.model)
    scene.classes.names = classNames(*work.model);
  gatherRooms(rooms, std::move(finished), scene);
  progress.done(std::to_string(scene.objects.size()) + " objects");
}

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

/** Add what was found to the cloud, as it is to be written. */
void
complete(const Options& options, const Scene& scene, CloudFile& file)
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

using NamedBytes = std::vector<std::pair<std::string, std::string>>;

/** The files beside the cloud, by their paths; scene.json is the last. */
NamedBytes
describe(const Options& options,
         const std::vector<Setting>& settings,
         const Scene& scene,
         const pcl::PointCloud<pcl::PointXYZ>& points,
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

/** Make the folder and fill it, or leave nothing. Returns the names of the results. */
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

/** Find out, before the long work, what cannot be written. */
void
requireUsable(const Options& options)
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

} // namespace

int
main(int argc, char** argv)
{
  Options options;
  if (presetOf(argc, argv) == "thesis") {
    options.rooms = pcl::indoor::thesisRoomOptions();
    options.objects = pcl::indoor::thesisOptions();
  }
  auto parser = makeParser(options);
  return parser.run(argc, argv, [&](Progress& progress) {
    requireUsable(options);
    options.memory.require(options.input, bytes_per_point);
    progress.start("Loading " + options.input);
    CloudFile file = loadCloud(options.input);
    progress.done(std::to_string(file.points->size()) + " points");
    chooseResolution(options);

    Scene scene = findRooms(options, file, progress);
    const auto work = roomWork(options, scene.building_pose);
    const auto standing = standingPoints(file, work, scene);
    findObjects(options, file, *standing, work, scene, progress);
    complete(options, scene, file);
    progress.start("Saving to " + options.folder);
    const auto texts = describe(options, parser.settings(), scene, *standing, file);
    progress.done(save(options.folder, texts, file));
    progress.summary(options.folder + ": " + summaryOf(scene));
    for (const auto& table : tablesOf(scene, progress.stages()))
      progress.table(table);
  });
}
