/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/scene/describe_building.h>

#include "building/building_stages.h"
#include "building/scene_settings.h"
#include "building/temporary_folder.h"
#include "files/point_coordinates.h"
#include "scene/room_json.h" // for inputOf
#include "scene/understood_scan.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace pcl::indoor {
namespace {

/** Tells the caller's function. */
class CallerReport : public tool::StageReport {
public:
  explicit CallerReport(const SceneOptions& options)
  : progress_(options.progress)
  {}

  void
  start(const std::string& what) override
  {
    stage_ = what;
    update(0, 1);
  }

  void
  update(std::size_t done, std::size_t all) override
  {
    if (progress_)
      progress_(stage_, done, all);
  }

private:
  decltype(SceneOptions::progress) progress_;
  std::string stage_;
};

/** Rooms, walls and objects of a scan that was looked at. */
Scene
described(SceneOptions& options,
          ScanContent& scan,
          const UnderstoodScan& understood,
          tool::StageReport& report)
{
  std::optional<tool::TemporaryFolder> files;
  std::optional<tool::RoomsInFiles> in_files;
  tool::RoomsInMemory in_memory;
  if (scan.stream)
    in_files.emplace(files.emplace(options.work_folder).folder());
  auto& store = in_files ? static_cast<tool::RoomStore&>(*in_files) : in_memory;
  tool::ObjectSearch search = {
      tool::roomWork(options), store, report, options.threads, options.ignore_normals};
  auto building = tool::findBuilding(options, scan, understood, search);
  if (!scan.stream) {
    tool::findObjects(search, scan.file, building);
    return std::move(building.scene);
  }
  const auto found = tool::findObjectsInParts(search, files->folder(), scan, building);
  tool::labelSample(found, files->folder(), scan.sample->indices(), building.scene);
  return std::move(building.scene);
}

} // namespace

Scene
describeBuilding(const Scan& scan, const SceneOptions& given)
{
  auto options = tool::checkedOptions(given);
  auto& content = scan.content();
  CallerReport report(options);
  if (content.stream) {
    report.start("Reading in parts");
    tool::drawSample(options, content.points_at_once, content, report);
  }
  const auto understood = tool::understand(
      content.file, options.scan, content.pointCount(), {options.ignore_normals});
  auto scene = described(options, content, understood, report);
  const auto emptiness =
      tool::emptinessOf(understood, scene.rooms.size(), scene.counts.in_rooms);
  if (!emptiness.empty())
    scene.report.warnings.push_back(emptiness);
  scene.input = tool::inputOf(content.file);
  scene.input.cloud_offset = tool::PointCoordinates().offsetOf(content.file);
  scene.settings = tool::settingsOf(
      options,
      {content.columns, content.stations, content.stream ? content.points_at_once : 0});
  return scene;
}

SceneOptions
thesisSceneOptions()
{
  SceneOptions options;
  options.preset = "thesis";
  options.network = "none";
  options.thesis_rooms = thesisRoomOptions();
  options.thesis_objects = thesisOptions();
  return options;
}

} // namespace pcl::indoor
