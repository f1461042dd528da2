/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/geojson_file.h"

#include "export/opening_place.h"
#include "export/plan_boxes.h"
#include "formats/json_text.h" // for rounded
#include "scene/model_json.h"  // for nameOf

namespace pcl::indoor::tool {
namespace {

using Json = nlohmann::ordered_json;

/** Places of a scene as GeoJSON has them. */
class Coordinates {
public:
  Coordinates(const SavedScene& scene, double height)
  : origin_(scene.origin)
  , height_(height)
  {}

  Json
  operator()(const Eigen::Vector2d& place) const
  {
    return {rounded(place.x() + origin_.x()),
            rounded(place.y() + origin_.y()),
            rounded(height_ + origin_.z())};
  }

  /** A ring ends where it begins. */
  Json
  operator()(const PlanRing& ring) const
  {
    Json line = Json::array();
    for (const auto& corner : ring)
      line.push_back((*this)(corner));
    line.push_back((*this)(ring.front()));
    return line;
  }

private:
  Eigen::Vector3d origin_;
  double height_;
};

Json
roomFeature(const SavedScene& scene, const SavedRoom& room)
{
  const Coordinates at(scene, room.floor);
  Json polygons = Json::array();
  for (const auto& polygon : polygonsOf(room.rings)) {
    Json rings = Json::array({at(polygon.outer)});
    for (const auto& hole : polygon.holes)
      rings.push_back(at(hole));
    polygons.push_back(std::move(rings));
  }
  Json properties = {{"kind", "room"},
                     {"room", room.number},
                     {"storey", room.storey},
                     {"area", rounded(room.area)},
                     {"height", rounded(room.height)},
                     {"volume", rounded(room.volume)}};
  if (!room.name.empty()) {
    properties["name"] = room.name;
    properties["name_probability"] = rounded(room.name_probability);
  }
  return geoFeature("MultiPolygon", polygons, properties);
}

Json
wallFeature(const SavedScene& scene, const SavedWall& wall)
{
  const Coordinates at(scene, wall.floor);
  Json properties = {{"kind", "wall"},
                     {"wall", wall.number},
                     {"storey", wall.storey},
                     {"height", rounded(wall.height)}};
  if (!(wall.thickness > 0.0))
    return geoFeature(
        "LineString", Json::array({at(wall.begin), at(wall.end)}), properties);
  properties["thickness"] = rounded(wall.thickness);
  return geoFeature("Polygon", Json::array({at(wallBox(wall))}), properties);
}

Json
openingFeature(const SavedScene& scene, const SavedOpening& opening)
{
  const Coordinates at(scene, opening.position.z());
  const auto place = openingPlace(scene, opening);
  const Eigen::Vector2d half = 0.5 * opening.width * place.along;
  return geoFeature("LineString",
                    Json::array({at(Eigen::Vector2d(place.middle - half)),
                                 at(Eigen::Vector2d(place.middle + half))}),
                    {{"kind", nameOf(opening.kind)},
                     {"opening", opening.number},
                     {"storey", opening.storey},
                     {"rooms", {opening.room_a, opening.room_b}},
                     {"width", rounded(opening.width)},
                     {"height", rounded(opening.height)},
                     {"sill", rounded(opening.sill)},
                     {"open", opening.is_open}});
}

Json
columnFeature(const SavedScene& scene, const SavedColumn& column)
{
  const Coordinates at(scene, column.foot.z());
  return geoFeature("Polygon",
                    Json::array({at(outlineOf(column))}),
                    {{"kind", "column"},
                     {"column", column.number},
                     {"storey", column.storey},
                     {"height", rounded(column.size.z())}});
}

Json
objectFeature(const SavedScene& scene, const SavedObject& object)
{
  const auto& box = object.box;
  const double foot = box.center.z() - 0.5 * box.size.z();
  Json properties = {{"kind", "object"},
                     {"object", object.number},
                     {"storey", object.storey},
                     {"room", object.room},
                     {"height", rounded(box.size.z())}};
  if (!object.name.empty()) {
    properties["class"] = object.name;
    properties["confidence"] = rounded(object.confidence);
  }
  const Coordinates at(scene, foot);
  return geoFeature("Polygon", Json::array({at(boxFromAbove(box))}), properties);
}

} // namespace

nlohmann::ordered_json
geoFeature(const char* geometry, const Json& coordinates, const Json& properties)
{
  return {{"type", "Feature"},
          {"properties", properties},
          {"geometry", {{"type", geometry}, {"coordinates", coordinates}}}};
}

nlohmann::ordered_json
geoJson(const SavedScene& scene, int epsg)
{
  Json json = {{"type", "FeatureCollection"}};
  json["name"] = scene.input;
  if (epsg > 0)
    json["crs"] = {
        {"type", "name"},
        {"properties", {{"name", "urn:ogc:def:crs:EPSG::" + std::to_string(epsg)}}}};
  json["features"] = Json::array();
  auto& features = json["features"];
  for (const auto& room : scene.rooms)
    features.push_back(roomFeature(scene, room));
  for (const auto& wall : scene.walls)
    features.push_back(wallFeature(scene, wall));
  for (const auto& column : scene.columns)
    features.push_back(columnFeature(scene, column));
  for (const auto& opening : scene.openings)
    features.push_back(openingFeature(scene, opening));
  for (const auto& object : scene.objects)
    if (!object.is_structure)
      features.push_back(objectFeature(scene, object));
  return json;
}

} // namespace pcl::indoor::tool
