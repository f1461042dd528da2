/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/room_picture.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace pcl::indoor::tool {
namespace {

constexpr int wanted_size = 1400; // pixels of the longer side, roughly
constexpr Color paper{255, 255, 255};
constexpr Color ink{30, 30, 30};
constexpr Color wall{70, 70, 70};

/** The part of the maps that is shown: pixels begin ... end - 1. */
struct Section {
  int begin_x = 0, end_x = 0, begin_y = 0, end_y = 0;
};

/** What lies in a room or, where no room was found, is a wall, on any storey. */
Section
shownSection(const BuildingRooms& building)
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

int
scaleOf(const Section& section)
{
  const int longer =
      std::max({1, section.end_x - section.begin_x, section.end_y - section.begin_y});
  return std::clamp(wanted_size / longer, 1, 12);
}

Picture
drawMap(const Section& section, int scale, const std::function<Color(int, int)>& color)
{
  Picture picture((section.end_x - section.begin_x) * scale,
                  (section.end_y - section.begin_y) * scale,
                  paper);
  for (int x = section.begin_x; x < section.end_x; ++x)
    for (int y = section.begin_y; y < section.end_y; ++y)
      picture.fillRectangle((x - section.begin_x) * scale,
                            (section.end_y - 1 - y) * scale, // y points up
                            scale,
                            scale,
                            color(x, y));
  return picture;
}

/** A room's number stands where the room is widest. */
void
drawNumbers(Picture& picture,
            const MappedRooms& map,
            const std::vector<std::uint32_t>& room_of,
            const Section& section,
            int scale)
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
  for (std::size_t room = 1; room < places.size(); ++room)
    if (places[room].field >= 0.0f)
      picture.drawLabel((places[room].x - section.begin_x) * scale + scale / 2,
                        (section.end_y - 1 - places[room].y) * scale + scale / 2,
                        std::to_string(room_of[room]),
                        3);
}

/** A white disc in each opening of a storey. */
void
drawOpenings(Picture& picture,
             const BuildingRooms& building,
             std::size_t storey,
             const Section& section,
             int scale)
{
  const auto& grid = building.grid;
  const int radius = std::max(3, static_cast<int>(0.2 / grid.voxel_size * scale));
  for (const auto& opening : building.openings) {
    if (building.rooms[opening.room_a - 1].storey != storey)
      continue;
    const Eigen::Vector3d place =
        (grid.toGrid(opening.position) - grid.origin) / grid.voxel_size;
    const int x = static_cast<int>(std::lround((place.x() - section.begin_x) * scale));
    const int y = static_cast<int>(std::lround((section.end_y - place.y()) * scale));
    for (int dx = -radius; dx <= radius; ++dx)
      for (int dy = -radius; dy <= radius; ++dy) {
        const int squared = dx * dx + dy * dy;
        if (squared <= radius * radius)
          picture.set(
              x + dx, y + dy, squared > (radius - 2) * (radius - 2) ? ink : paper);
      }
  }
}

void
drawScaleBar(Picture& picture, double pixels_per_metre)
{
  int metres = 1;
  while (metres * pixels_per_metre < 60.0 && metres < 1000)
    metres *= metres % 2 == 1 ? 5 : 2; // 1, 5, 10, 20, 40, ...
  const int length = static_cast<int>(std::lround(metres * pixels_per_metre));
  const int y = picture.height() - 18;
  picture.fillRectangle(10, y + 5, length, 4, ink);
  picture.drawText(16 + length, y, std::to_string(metres) + " M", ink, 2);
}

/** One picture of the pictures of all storeys, the highest on top, with a scale below.
 */
Picture
stack(const std::vector<Picture>& storeys, double pixels_per_metre)
{
  const bool named = storeys.size() > 1;
  const int caption = named ? 24 : 0;
  int width = 160;
  int height = 24;
  for (const auto& storey : storeys) {
    width = std::max(width, storey.width());
    height += storey.height() + caption;
  }
  Picture all(width, height, paper);
  int y = 0;
  for (std::size_t i = storeys.size(); i-- > 0;) {
    if (named)
      all.drawText(8, y + 6, "storey " + std::to_string(i), ink, 2);
    all.paste(storeys[i], 0, y + caption);
    y += caption + storeys[i].height();
  }
  drawScaleBar(all, pixels_per_metre);
  return all;
}

double
pixelsPerMetre(const BuildingRooms& building, int scale)
{
  return scale / building.grid.voxel_size;
}

} // namespace

Picture
drawRooms(const BuildingRooms& building)
{
  const auto section = shownSection(building);
  const int scale = scaleOf(section);
  std::vector<Picture> storeys;
  for (std::size_t i = 0; i < building.maps.size(); ++i) {
    const auto& map = building.maps[i];
    const auto& room_of = building.room_of[i];
    storeys.push_back(drawMap(section, scale, [&](int x, int y) {
      if (map.blocked.at(x, y) != 0)
        return wall;
      const auto label = map.labels.at(x, y);
      return label > 0 ? labelColor(room_of[static_cast<std::size_t>(label)]) : paper;
    }));
    drawOpenings(storeys.back(), building, i, section, scale);
    drawNumbers(storeys.back(), map, room_of, section, scale);
  }
  return stack(storeys, pixelsPerMetre(building, scale));
}

Picture
drawPotentialField(const BuildingRooms& building)
{
  const auto section = shownSection(building);
  const int scale = scaleOf(section);
  const auto fieldAt = [](const MappedRooms& map, int x, int y) {
    const int factor = map.potential_factor;
    return map.potential.size() > 0 ? map.potential.at(x / factor, y / factor)
                                    : map.field.at(x, y);
  };
  float highest = 0.0f;
  for (const auto& map : building.maps)
    for (int x = 0; x < map.labels.nx; ++x)
      for (int y = 0; y < map.labels.ny; ++y)
        if (map.labels.at(x, y) > 0)
          highest = std::max(highest, fieldAt(map, x, y));
  std::vector<Picture> storeys;
  for (const auto& map : building.maps)
    storeys.push_back(drawMap(section, scale, [&](int x, int y) {
      if (map.labels.at(x, y) == 0 && map.blocked.at(x, y) == 0)
        return paper;
      const float field = std::max(0.0f, fieldAt(map, x, y));
      return heatColor(highest > 0.0f ? field / highest : 0.0f);
    }));
  return stack(storeys, pixelsPerMetre(building, scale));
}

} // namespace pcl::indoor::tool
