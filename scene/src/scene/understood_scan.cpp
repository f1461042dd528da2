/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/understood_scan.h"

#include "scene/coordinate_options.h"
#include "scene/recognised_end.h"
#include "scene/room_json.h" // for positionJson
#include "text/printable.h"

#include <pcl/common/point_tests.h> // for isFinite
#include <pcl/segmentation/building_frame.h>
#include <pcl/segmentation/scan_warnings.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl::indoor {

void
UnderstoodScan::settle(const ScanReport& report)
{
  end_is_recognised |= report.end_is_recognised;
  if (report.up_axis.dot(coordinates.up_axis) >= 0.0f)
    return;
  coordinates.up_axis = report.up_axis;
  coordinates.vertical = coordinates.vertical.reversed();
  std::swap(overview.floor_seen, overview.ceiling_seen);
}

} // namespace pcl::indoor

namespace pcl::indoor::tool {
namespace {

constexpr double hardly = 0.3, mostly = 0.7; // shares that were seen
constexpr double slice = 1.0;                // metres of height
constexpr double few_duplicates = 0.005;     // share that is chance
constexpr double lowest_rooms = 1.5;  // metres, a person cannot stand in lower ones
constexpr double highest_rooms = 6.0; // metres, of most buildings
constexpr double degree = M_PI / 180.0;

/** For example "1,204,331". */
std::string
grouped(std::uint64_t number)
{
  auto text = std::to_string(number);
  for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3)
    text.insert(static_cast<std::size_t>(at), ",");
  return text;
}

/** Of 100; small shares are not none, large ones not all. */
std::string
percent(double share)
{
  const double rounded = std::round(100.0 * share);
  return fixedText(
             share > 0.0 && share < 1.0 ? std::clamp(rounded, 1.0, 99.0) : rounded, 0) +
         " %";
}

std::string
lengthText(double metres)
{
  return metres < 0.1 ? fixedText(100.0 * metres, 1) + " cm"
                      : fixedText(metres, 2) + " m";
}

std::string
sizeText(const Eigen::Vector3d& size)
{
  const int digits = size.maxCoeff() < 1.0 ? 2 : 1;
  return fixedText(size.x(), digits) + " x " + fixedText(size.y(), digits) + " x " +
         fixedText(size.z(), digits) + " m";
}

/** For example "-y", or the three numbers of a direction that is no axis. */
std::string
axisText(const Eigen::Vector3f& axis)
{
  for (int k = 0; k < 3; ++k)
    if (std::abs(axis[k]) == 1.0f)
      return (axis[k] < 0.0f ? "-" : "") + std::string(1, "xyz"[k]);
  return "(" + fixedText(axis.x(), 2) + ", " + fixedText(axis.y(), 2) + ", " +
         fixedText(axis.z(), 2) + ")";
}

std::vector<Eigen::Vector3f>
finitePointsOf(const CloudFile& file)
{
  std::vector<Eigen::Vector3f> points;
  points.reserve(file.points->size());
  for (const auto& point : *file.points)
    if (isFinite(point))
      points.emplace_back(point.getVector3fMap());
  return points;
}

/** Up axis and unit, as RoomSegmentation takes them. */
void
findCoordinates(const std::vector<Eigen::Vector3f>& points,
                const CoordinateOptions& given,
                UnderstoodScan& scan)
{
  scan.up_is_set = given.up != "auto";
  scan.coordinates = scanCoordinates(
      points,
      scan.up_is_set ? std::optional(given.upAxis()) : std::nullopt,
      given.unit != "auto" ? std::optional(given.metresPerUnit()) : std::nullopt);
  scan.unit = unitName(scan.coordinates.metres_per_unit);
  if (unitWarning(scan.coordinates.vertical, scan.coordinates.metres_per_unit).empty())
    return;
  const double height = scan.coordinates.vertical.room_height;
  const double likely = likelyMetresPerUnit(height);
  const bool is_room =
      lowest_rooms <= height * likely && height * likely <= highest_rooms;
  scan.likely_unit = is_room && likely != scan.coordinates.metres_per_unit
                         ? unitName(likely)
                         : ""; // the scale is another one
}

/** Where furniture does not clearly tell which end is up, what can be recognised does.
 */
void
findEnd(const std::vector<Eigen::Vector3f>& finite, UnderstoodScan& scan)
{
  const auto& vertical = scan.coordinates.vertical;
  if (scan.up_is_set || !vertical.is_found ||
      (vertical.is_end_known && vertical.is_furnished))
    return;
  auto points = finite;
  moveIntoBuildingFrame(
      points, scan.coordinates.up_axis, scan.coordinates.metres_per_unit);
  takeOutFarPoints(points);
  const int end = recognisedEnd(points);
  if (end < 0) {
    scan.coordinates.up_axis = -scan.coordinates.up_axis;
    scan.coordinates.vertical = vertical.reversed();
  }
  if (end != 0)
    scan.coordinates.vertical.is_end_known = scan.end_is_recognised = true;
}

NormalsFrom
normalsFrom(const CloudFile& file, bool ignores_normals)
{
  if (!hasNormals(file.cloud))
    return NormalsFrom::NoneInFile;
  return ignores_normals    ? NormalsFrom::Ignored
         : file.has_normals ? NormalsFrom::File
                            : NormalsFrom::NoneUsable;
}

std::string
normalsText(NormalsFrom normals)
{
  switch (normals) {
  case NormalsFrom::File:
    return "Normals: those of the file.";
  case NormalsFrom::NoneInFile:
    return "Normals: estimated, the file has none.";
  case NormalsFrom::NoneUsable:
    return "Normals: estimated, those of the file cannot be used.";
  case NormalsFrom::Ignored:
    break;
  }
  return "Normals: estimated, those of the file are to be ignored.";
}

std::string
pointsText(const UnderstoodScan& scan)
{
  auto text = grouped(scan.points) + " points";
  if (scan.finite_points < scan.points)
    text += ", " + grouped(scan.points - scan.finite_points) + " of them not finite";
  if (scan.overview.spacing > 0.0)
    text += ", one per " + lengthText(scan.overview.spacing) + " of surface";
  if (scan.stations > 1)
    text += ", from " + std::to_string(scan.stations) + " stations";
  if (scan.overview.duplicates >= few_duplicates)
    text += ", " + percent(scan.overview.duplicates) + " where another one is";
  return text + ". " + normalsText(scan.normals) +
         " Colours: " + (scan.has_colors ? "yes." : "none.");
}

std::string
coordinatesText(const UnderstoodScan& scan)
{
  const auto& overview = scan.overview;
  std::string text = "Unit: " + scan.unit;
  if (!scan.likely_unit.empty())
    text += ", but " + scan.likely_unit + " is likely: so taken, the";
  else
    text += overview.room_height > 0.0 ? ", the" : "; no";
  text += overview.room_height > 0.0
              ? " rooms are " + fixedText(overview.room_height, 1) + " m high. "
              : " height of rooms was seen. ";
  text += "Up: " + axisText(scan.coordinates.up_axis);
  if (scan.up_is_set)
    return text + ", as set.";
  if (!scan.coordinates.vertical.is_found)
    return text + ", for want of floors and walls that tell it.";
  const double off =
      std::acos(std::min(1.0,
                         static_cast<double>(scan.coordinates.vertical.direction.dot(
                             scan.coordinates.up_axis))));
  text += ", by floors and walls";
  if (off >= 0.5 * degree)
    text += ", which lean by " + fixedText(off / degree, 1) + " degrees";
  else if (scan.coordinates.up_axis.cwiseAbs().maxCoeff() < 1.0f)
    text += ", " + fixedText(scan.coordinates.vertical.tilt() / degree, 1) +
            " degrees from z";
  if (scan.end_is_recognised)
    text += "; objects are recognised with this end up";
  else if (!scan.coordinates.vertical.is_furnished)
    text += "; no furniture tells floors from ceilings";
  return text + ".";
}

std::string
seenText(const ScanOverview& overview)
{
  auto text = sizeText(overview.extent);
  if (overview.extent.z() < slice)
    return "Size: " + text + ".";
  text = std::to_string(overview.storeys) +
         (overview.storeys == 1 ? " storey, " : " storeys, ") + text + ". Of " +
         fixedText(overview.area, 0) + " m^2 between the walls, " +
         percent(overview.floor_seen) + " of the floor and " +
         percent(overview.ceiling_seen) + " of the ceiling were seen, with walls on " +
         fixedText(overview.wall_sides, 1) + " of 4 sides.";
  if (overview.open_area > overview.area)
    text += " Open ground around them: " + fixedText(overview.open_area, 0) + " m^2.";
  return text;
}

/** "floor" or "ceiling" in part. */
std::string
partText(const char* surface, double share)
{
  return std::string("Only ") + percent(share) + " of the " + surface +
         " was seen: elsewhere heights are those of the walls.";
}

/** Degrees are a hundred thousand times as long as metres; buildings are less than a
 * thousand times as wide as high, and less than a degree wide. */
bool
mayBeDegrees(const UnderstoodScan& scan)
{
  constexpr double far_too_narrow = 0.01, wide = 1.0;
  const double width = scan.overview.extent.head<2>().maxCoeff();
  return scan.unit == "m" && width < wide &&
         width < far_too_narrow * scan.overview.extent.z();
}

/** Of rooms that seem to be higher than most, in metres that nobody told. */
std::string
heightText(const UnderstoodScan& scan)
{
  constexpr double foot = 0.3048, least = 2.0, most = 3.5; // of what people build
  const double height = scan.coordinates.vertical.room_height;
  if (scan.unit != "m" || !scan.likely_unit.empty() || foot * height < least)
    return {};
  return "Its rooms seem to be " + fixedText(height, 1) + " m high" +
         (foot * height <= most
              ? ", in feet they would be " + fixedText(foot * height, 1) +
                    " m: if they are, set -unit ft."
              : ": if they are not, set the unit (-unit).");
}

/** What lacks of floor, ceiling and walls. */
void
addSurfaces(const ScanOverview& overview, std::vector<std::string>& lines)
{
  const bool no_floor = overview.floor_seen < hardly;
  const bool no_ceiling = overview.ceiling_seen < hardly;
  if (no_floor && no_ceiling)
    lines.push_back(
        "Neither floor nor ceiling was seen: rooms are told by walls alone, "
        "their areas and heights are guesses.");
  else if (no_floor)
    lines.push_back("No floor was seen: rooms are found by ceiling and walls, and "
                    "heights are those of the walls.");
  else if (no_ceiling)
    lines.push_back("No ceiling was seen: heights are those of the walls.");
  else {
    if (overview.floor_seen < mostly)
      lines.push_back(partText("floor", overview.floor_seen));
    if (overview.ceiling_seen < mostly)
      lines.push_back(partText("ceiling", overview.ceiling_seen));
  }
  if (overview.wall_sides < 1.0)
    lines.push_back("Hardly any walls were seen: there is nothing to tell rooms by.");
}

/** What there is, a sentence or two each: points, unit and vertical, what was seen. */
std::vector<std::string>
factsOf(const UnderstoodScan& scan)
{
  return {pointsText(scan), coordinatesText(scan), seenText(scan.overview)};
}

/** What lacks, and what that means for the result, a sentence each, the gravest first;
 * empty if all is there that rooms are found from. */
std::vector<std::string>
consequencesOf(const UnderstoodScan& scan)
{
  constexpr double room = 1.5;    // metres: no room is shorter
  constexpr double sparse = 0.12; // metres, from where on surfaces get holes
  const auto& overview = scan.overview;
  std::vector<std::string> lines;
  if (!scan.likely_unit.empty())
    lines.push_back("The unit is likely " + scan.likely_unit + ": set -unit " +
                    scan.likely_unit + ".");
  const double longest = overview.extent.maxCoeff();
  if (mayBeDegrees(scan))
    lines.push_back("x and y extend over less than a hundredth of the height, as "
                    "longitude and latitude in degrees do: project them to metres.");
  else if (longest < room)
    lines.push_back(
        "The scan is " + lengthText(longest) +
        " large: an object or a table, or its unit is another one (-unit).");
  else if (overview.extent.z() < slice)
    lines.push_back("The scan is a slice or a flat map, " +
                    fixedText(overview.extent.z(), 2) +
                    " m high: rooms need walls from floor to ceiling.");
  else
    addSurfaces(overview, lines);
  if (overview.spacing > sparse)
    lines.push_back("The points are sparse: surfaces are closed between them, and "
                    "small objects are lost.");
  return lines;
}

} // namespace

UnderstoodScan
understand(const CloudFile& file,
           const CoordinateOptions& coordinates,
           std::uint64_t points,
           const ScanLook& look)
{
  UnderstoodScan scan;
  scan.points = points;
  scan.finite_points = file.finite_count;
  scan.is_sample = points > file.points->size();
  scan.normals = normalsFrom(file, look.ignores_normals);
  scan.has_colors = hasField(file.cloud, "rgb") || hasField(file.cloud, "rgba");
  scan.stations = std::max<std::size_t>(1, file.stations.size());
  const auto finite = finitePointsOf(file);
  findCoordinates(finite, coordinates, scan);
  if (look.at_objects)
    findEnd(finite, scan);
  const auto& unit = scan.likely_unit.empty() ? scan.unit : scan.likely_unit;
  scan.overview = scanOverview(finite, scan.coordinates.up_axis, metresOfUnit(unit));
  if (scan.is_sample) { // which tells nothing of points that are in one place
    scan.overview.spacing *= std::sqrt(static_cast<double>(finite.size()) /
                                       static_cast<double>(scan.finite_points));
    scan.overview.duplicates = 0.0;
  }
  return scan;
}

std::string
verdictOf(const UnderstoodScan& scan)
{
  const auto lacks = consequencesOf(scan);
  return lacks.empty() ? "all is there that rooms are found from" : lacks[0];
}

std::string
paragraphOf(const std::string& path, const UnderstoodScan& scan)
{
  std::string text = printable(path) + ":\n";
  for (const auto& line : factsOf(scan))
    text += "  " + line + "\n";
  for (const auto& line : consequencesOf(scan))
    text += "  - " + line + "\n";
  return text;
}

nlohmann::ordered_json
overviewJson(const UnderstoodScan& scan)
{
  constexpr const char* normals[] = {"file", "none in file", "none usable", "ignored"};
  const auto& overview = scan.overview;
  nlohmann::ordered_json json;
  json["spacing"] = rounded(overview.spacing);
  json["extent"] = positionJson(overview.extent);
  if (!scan.likely_unit.empty())
    json["likely_unit"] = scan.likely_unit;
  json["room_height"] = rounded(overview.room_height);
  json["up"] = positionJson(scan.coordinates.up_axis.cast<double>());
  if (scan.coordinates.vertical.is_found)
    json["tilt_degrees"] = rounded(scan.coordinates.vertical.tilt() / degree);
  json["storeys"] = overview.storeys;
  json["area"] = rounded(overview.area);
  json["open_area"] = rounded(overview.open_area);
  json["floor_seen"] = rounded(overview.floor_seen);
  json["ceiling_seen"] = rounded(overview.ceiling_seen);
  json["wall_sides"] = rounded(overview.wall_sides);
  if (!scan.is_sample)
    json["duplicates"] = rounded(overview.duplicates);
  json["normals"] = normals[static_cast<int>(scan.normals)];
  json["colours"] = scan.has_colors;
  json["stations"] = scan.stations;
  json["facts"] = factsOf(scan);
  json["consequences"] = consequencesOf(scan);
  return json;
}

std::string
emptinessOf(const UnderstoodScan& scan, std::size_t rooms, std::uint64_t in_rooms)
{
  const double share =
      scan.finite_points > 0
          ? static_cast<double>(in_rooms) / static_cast<double>(scan.finite_points)
          : 0.0;
  if (rooms > 0 && share >= 0.5)
    return {};
  auto why = consequencesOf(scan);
  if (const auto height = heightText(scan); !height.empty())
    why.insert(why.begin(), height);
  const auto& overview = scan.overview;
  const auto reason = !why.empty() ? why.front()
                      : overview.open_area > overview.area
                          ? "Most of the scan is open ground, without walls around it."
                          : "The scan shows no reason; -map and -min_area may.";
  return (rooms == 0 ? "no room was found: "
                     : "only " + percent(share) + " of the points are in rooms: ") +
         reason;
}

} // namespace pcl::indoor::tool
