/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/room_picture.h"

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace pcl::indoor::tool {
namespace {

constexpr Color wall{70, 70, 70};
constexpr double legend_size = 20.0;

/** The part of the maps that is shown: pixels begin ... end - 1, each as a square. */
struct Section {
  int begin_x = 0, end_x = 0, begin_y = 0, end_y = 0;
  int scale = 1; ///< side of a square; whole, so that colours are exact

  /** Of a place on the map, in pixels. */
  SvgDrawing::Place
  operator()(double x, double y) const // y of the map points up
  {
    return {scale * (x - begin_x), scale * (end_y - y)};
  }
};

/** What lies in a room or, where no room was found, is a wall, on any storey. */
Section
shownPixels(const BuildingRooms& building)
{
  const auto box_of = [&building](const auto& shows) {
    Section box{1 << 30, -1, 1 << 30, -1};
    for (const auto& storey : building.maps)
      for (int x = 0; x < storey.labels.nx; ++x)
        for (int y = 0; y < storey.labels.ny; ++y)
          if (shows(storey, x, y)) {
            box = {std::min(box.begin_x, x),
                   std::max(box.end_x, x + 1),
                   std::min(box.begin_y, y),
                   std::max(box.end_y, y + 1)};
          }
    return box;
  };
  auto box = box_of(
      [](const MappedRooms& map, int x, int y) { return map.labels.at(x, y) > 0; });
  if (box.end_x < 0)
    box = box_of(
        [](const MappedRooms& map, int x, int y) { return map.blocked.at(x, y) != 0; });
  if (box.end_x < 0)
    return {};
  constexpr int margin = 6;
  const auto& any = building.maps.front().labels;
  return {std::max(0, box.begin_x - margin),
          std::min(any.nx, box.end_x + margin),
          std::max(0, box.begin_y - margin),
          std::min(any.ny, box.end_y + margin)};
}

Section
shownSection(const BuildingRooms& building)
{
  constexpr int wanted_size = 1400; // of the longer side, roughly
  constexpr int highest = 9000;     // of all storeys
  auto section = shownPixels(building);
  const int wide = std::max(1, section.end_x - section.begin_x);
  const int high = std::max(1, section.end_y - section.begin_y);
  const int storeys = std::max(1, static_cast<int>(building.maps.size()));
  section.scale = std::clamp(
      std::min(wanted_size / std::max(wide, high), highest / (storeys * high)), 1, 12);
  return section;
}

SvgDrawing
drawMap(const Section& section, const std::function<Color(int, int)>& color)
{
  PixelImage image(section.end_x - section.begin_x, section.end_y - section.begin_y);
  for (int x = section.begin_x; x < section.end_x; ++x)
    for (int y = section.begin_y; y < section.end_y; ++y)
      image.set(x - section.begin_x, section.end_y - 1 - y, color(x, y));
  SvgDrawing map(section.scale * image.width(), section.scale * image.height());
  map.image({0.0, 0.0}, image.enlarged(section.scale));
  return map;
}

/** A room's number stands where the room is widest. */
void
addNumbers(SvgDrawing& drawing,
           const MappedRooms& map,
           const std::vector<std::uint32_t>& room_of,
           const Section& section)
{
  struct Place {
    float field = -1.0f;
    int x = 0, y = 0;
  };
  std::vector<Place> places(static_cast<std::size_t>(map.room_count) + 1);
  for (int x = 0; x < map.free_labels.nx; ++x)
    for (int y = 0; y < map.free_labels.ny; ++y) {
      auto& place = places.at(static_cast<std::size_t>(map.free_labels.at(x, y)));
      if (map.field.at(x, y) > place.field)
        place = {map.field.at(x, y), x, y};
    }
  constexpr TextStyle style{Anchor::Middle, 30.0, 0.0, true, true};
  for (std::size_t room = 1; room < places.size(); ++room)
    if (places[room].field >= 0.0f)
      drawing.text(section(places[room].x + 0.5, places[room].y + 0.5),
                   std::to_string(room_of[room]),
                   style);
}

/** A white disc in each opening of a storey. */
void
addOpenings(SvgDrawing& drawing,
            const BuildingRooms& building,
            std::size_t storey,
            const Section& section)
{
  constexpr double size = 0.2; // metres
  const auto& grid = building.grid;
  for (const auto& opening : building.openings) {
    if (building.rooms[opening.room_a - 1].storey != storey)
      continue;
    const Eigen::Vector3d place =
        (grid.toGrid(opening.position) - grid.origin) / grid.voxel_size;
    drawing.circle(section(place.x(), place.y()),
                   std::max(4.0, size / grid.voxel_size * section.scale),
                   paper,
                   ink);
  }
}

/** All storeys, the highest on top, and below them a scale and what else explains them.
 */
SvgDrawing
sheetOf(const std::vector<SvgDrawing>& storeys,
        double units_per_metre,
        const std::function<void(SvgDrawing&, const SvgDrawing::Place&)>& add_legend)
{
  SvgDrawing legend(640.0, 60.0);
  legend.scaleBar({14.0, 30.0}, units_per_metre, legend_size);
  add_legend(legend, {330.0, 30.0});
  return stacked({stackedStoreys(storeys, 14.0), legend});
}

void
addRoomLegend(SvgDrawing& drawing, const SvgDrawing::Place& left)
{
  const auto at = [&left](double x) {
    return SvgDrawing::Place(left.x() + x, left.y());
  };
  drawing.rectangle({left.x(), left.y() - 9.0}, {18.0, 18.0}, wall);
  drawing.text(at(26.0), "Wall", {Anchor::Start, legend_size});
  drawing.circle(at(109.0), 9.0, paper, ink);
  drawing.text(at(126.0), "Opening", {Anchor::Start, legend_size});
}

/** \param[in] highest distance in metres; 0 where the field is none */
void
addFieldLegend(SvgDrawing& drawing, const SvgDrawing::Place& left, float highest)
{
  constexpr int length = 120, height = 16;
  const double begin = left.x() + 50.0;
  PixelImage bar(length, height);
  for (int x = 0; x < length; ++x)
    for (int y = 0; y < height; ++y)
      bar.set(x, y, heatColor((x + 0.5) / length));
  drawing.image({begin, left.y() - 0.5 * height}, bar);
  drawing.text({begin - 8.0, left.y()}, "Wall", {Anchor::End, legend_size});
  drawing.text({begin + length + 8.0, left.y()},
               highest > 0.0f ? formatted("%.1f m", highest) : "Open space",
               {Anchor::Start, legend_size});
}

double
unitsPerMetre(const BuildingRooms& building, const Section& section)
{
  return section.scale / building.grid.voxel_size;
}

} // namespace

SvgDrawing
drawRooms(const BuildingRooms& building)
{
  const auto section = shownSection(building);
  std::vector<SvgDrawing> storeys;
  for (std::size_t i = 0; i < building.maps.size(); ++i) {
    const auto& map = building.maps[i];
    const auto& room_of = building.room_of[i];
    storeys.push_back(drawMap(section, [&](int x, int y) {
      if (map.blocked.at(x, y) != 0)
        return wall;
      const auto label = map.labels.at(x, y);
      return label > 0 ? labelColor(room_of[static_cast<std::size_t>(label)]) : paper;
    }));
    addOpenings(storeys.back(), building, i, section);
    addNumbers(storeys.back(), map, room_of, section);
  }
  return sheetOf(storeys, unitsPerMetre(building, section), addRoomLegend);
}

SvgDrawing
drawPotentialField(const BuildingRooms& building)
{
  const auto section = shownSection(building);
  const auto fieldAt = [](const MappedRooms& map, int x, int y) {
    const int factor = map.potential_factor;
    return map.potential.size() > 0 ? map.potential.at(x / factor, y / factor)
                                    : map.field.at(x, y);
  };
  float highest = 0.0f;
  bool is_distance = true;
  for (const auto& map : building.maps) {
    is_distance = is_distance && map.potential.size() == 0;
    for (int x = 0; x < map.labels.nx; ++x)
      for (int y = 0; y < map.labels.ny; ++y)
        if (map.labels.at(x, y) > 0)
          highest = std::max(highest, fieldAt(map, x, y));
  }
  std::vector<SvgDrawing> storeys;
  for (const auto& map : building.maps)
    storeys.push_back(drawMap(section, [&](int x, int y) {
      if (map.labels.at(x, y) == 0 && map.blocked.at(x, y) == 0)
        return paper;
      const float field = std::max(0.0f, fieldAt(map, x, y));
      return heatColor(highest > 0.0f ? field / highest : 0.0f);
    }));
  return sheetOf(storeys,
                 unitsPerMetre(building, section),
                 [&](SvgDrawing& drawing, const SvgDrawing::Place& left) {
                   addFieldLegend(drawing, left, is_distance ? highest : 0.0f);
                 });
}

} // namespace pcl::indoor::tool
