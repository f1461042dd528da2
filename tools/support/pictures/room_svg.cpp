/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/room_svg.h"

#include "pictures/picture.h" // for labelColor

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

namespace pcl::indoor::tool {
namespace {

constexpr double scale = 50.0;   // units per metre
constexpr double margin = 30.0;  // units around a storey
constexpr double caption = 20.0; // units above a storey

template <typename... Values>
std::string
formatted(const char* format, Values... values)
{
  char text[400];
  std::snprintf(text, sizeof(text), format, values...);
  return text;
}

/** Where a storey lies on the sheet. */
class Sheet {
public:
  Sheet(const Eigen::AlignedBox2d& box, double top)
  : box_(box)
  , top_(top)
  {}

  Eigen::Vector2d
  operator()(const Eigen::Vector3d& place) const // y points up
  {
    return {margin + scale * (place.x() - box_.min().x()),
            top_ + caption + scale * (box_.max().y() - place.y())};
  }

private:
  const Eigen::AlignedBox2d& box_;
  double top_;
};

std::string
roomShape(const Room& room, const Sheet& sheet)
{
  std::string path;
  for (const auto& line : room.footprint) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Eigen::Vector2d corner = sheet(line[i]);
      path += formatted("%c%.1f,%.1f", i == 0 ? 'M' : 'L', corner.x(), corner.y());
    }
    path += "Z";
  }
  const Color color = labelColor(room.label);
  return formatted("  <path id=\"room-%u\" fill=\"#%02x%02x%02x\" d=\"",
                   room.label,
                   unsigned(color.red),
                   unsigned(color.green),
                   unsigned(color.blue)) +
         path + "\"/>\n";
}

/** The middle of that pixel, among those where a room is about widest, which lies
 * nearest to their mean. */
Eigen::Vector3d
widestPlace(const BuildingRooms& building, const Room& room)
{
  constexpr float about = 0.95f;
  const auto& map = building.storeys[room.storey];
  const auto& room_of = building.room_of[room.storey];
  std::vector<Eigen::Vector2d> pixels;
  std::vector<float> widths;
  for (int x = 0; x < map.free_labels.nx; ++x)
    for (int y = 0; y < map.free_labels.ny; ++y)
      if (room_of[map.free_labels.at(x, y)] == room.label) {
        pixels.emplace_back(x, y);
        widths.push_back(map.field.at(x, y));
      }
  if (pixels.empty())
    return building.occupancy.toCloud(Eigen::Vector3d::Zero());
  const float enough = about * *std::max_element(widths.begin(), widths.end());
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  std::size_t count = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i)
    if (widths[i] >= enough) {
      mean += pixels[i];
      ++count;
    }
  mean /= static_cast<double>(count);
  Eigen::Vector2d place = mean;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < pixels.size(); ++i)
    if (widths[i] >= enough && (pixels[i] - mean).squaredNorm() < nearest) {
      nearest = (pixels[i] - mean).squaredNorm();
      place = pixels[i];
    }
  return building.occupancy.toCloud(building.occupancy.grid.center(
      static_cast<int>(place.x()), static_cast<int>(place.y()), 0));
}

/** White on dark fillings, else black. */
const char*
inkOn(const Color& filling)
{
  const double lightness = // as seen, 0 ... 255 (ITU-R BT.601)
      0.299 * filling.red + 0.587 * filling.green + 0.114 * filling.blue;
  return lightness < 115.0 ? "white" : "black";
}

std::string
roomText(const BuildingRooms& building, const Room& room, const Sheet& sheet)
{
  const Eigen::Vector2d place = sheet(widestPlace(building, room));
  const char* ink = inkOn(labelColor(room.label));
  return formatted("  <text x=\"%.1f\" y=\"%.1f\" fill=\"%s\" "
                   "font-weight=\"bold\">%u</text>\n",
                   place.x(),
                   place.y() - 3.0,
                   ink,
                   room.label) +
         formatted("  <text x=\"%.1f\" y=\"%.1f\" fill=\"%s\" font-size=\"10\">%.1f "
                   "m²</text>\n",
                   place.x(),
                   place.y() + 10.0,
                   ink,
                   room.area);
}

std::string
openingMark(const RoomOpening& opening, const Sheet& sheet)
{
  const Eigen::Vector2d place = sheet(opening.position);
  return formatted("  <circle class=\"door\" cx=\"%.1f\" cy=\"%.1f\" r=\"4\" "
                   "fill=\"white\" stroke=\"black\"/>\n",
                   place.x(),
                   place.y()) +
         formatted("  <text x=\"%.1f\" y=\"%.1f\" font-size=\"8\">%.2f m</text>\n",
                   place.x(),
                   place.y() - 7.0,
                   opening.width);
}

std::string
scaleBar(double top)
{
  constexpr int metres = 2;
  return formatted(
             "<path id=\"scale\" stroke=\"black\" stroke-width=\"3\" fill=\"none\" "
             "d=\"M%.1f,%.1fh%.1f\"/>\n",
             margin,
             top,
             metres * scale) +
         formatted("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"start\">%d m</text>\n",
                   margin + metres * scale + 8.0,
                   top + 5.0,
                   metres);
}

} // namespace

std::string
roomsSvg(const BuildingRooms& building)
{
  Eigen::AlignedBox2d box;
  for (const auto& room : building.rooms)
    for (const auto& line : room.footprint)
      for (const auto& corner : line)
        box.extend(corner.head<2>());
  if (box.isEmpty())
    box = {Eigen::Vector2d::Zero(), Eigen::Vector2d(1.0, 1.0)};
  const double storey_height = caption + scale * box.sizes().y() + margin;
  std::string storeys;
  double top = 0.0;
  for (std::size_t s = building.storeys.size(); s-- > 0; top += storey_height) {
    const Sheet sheet(box, top);
    std::string shapes, texts;
    for (const auto& room : building.rooms)
      if (room.storey == s) {
        shapes += roomShape(room, sheet);
        texts += roomText(building, room, sheet);
      }
    for (const auto& opening : building.openings)
      if (building.rooms[opening.room_a - 1].storey == s)
        texts += openingMark(opening, sheet);
    storeys += formatted("<g id=\"storey-%zu\">\n", s);
    if (building.storeys.size() > 1)
      storeys += formatted(
          "  <text x=\"%.1f\" y=\"%.1f\" text-anchor=\"start\">storey %zu</text>\n",
          margin,
          top + 14.0,
          s);
    storeys += shapes + texts + "</g>\n";
  }
  const double width = std::max(220.0, 2.0 * margin + scale * box.sizes().x());
  const double height = top + margin;
  return formatted(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.1f %.1f\" "
             "width=\"%.0f\" height=\"%.0f\" font-family=\"sans-serif\" "
             "font-size=\"14\" text-anchor=\"middle\">\n",
             width,
             height,
             width,
             height) +
         "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n" + storeys +
         scaleBar(top + 5.0) + "</svg>\n";
}

} // namespace pcl::indoor::tool
