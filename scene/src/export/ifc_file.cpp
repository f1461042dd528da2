/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/ifc_file.h"

#include "export/ifc_classes.h"
#include "export/ifc_elements.h"
#include "export/ifc_project.h"
#include "export/ifc_shapes.h"
#include "export/opening_place.h"
#include "export/plan_boxes.h"
#include "text/program_version.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor::tool {
namespace {

constexpr double slab_thickness = 0.1;  // metres: a scan shows its upper side
constexpr double leaf_thickness = 0.05; // metres, of doors and windows
constexpr double cut_beyond = 0.1;      // metres, that a hole is deeper than its wall
constexpr const char* no_tag = "$";

/** Where an object of the building is. */
struct IfcPlace {
  StepEntity entity, placement;
  double floor = 0.0; ///< height of the placement, metres
};

/** Writes a scene, part by part. */
class IfcWriter {
public:
  explicit IfcWriter(const SavedScene& scene)
  : scene_(scene)
  , elements_(file_, "pcl_indoor " + scene.input)
  , shapes_(file_)
  , in_storey_(scene.storeys.size())
  , in_room_(scene.rooms.size())
  {}

  std::string
  text(int epsg);

private:
  void
  addSpatialStructure();

  void
  addSpace(const SavedRoom& room);

  void
  addFloor(const SavedRoom& room, const std::vector<PlanPolygon>& polygons);

  void
  addWall(const SavedWall& wall);

  void
  addColumn(const SavedColumn& column);

  void
  addMaterial(StepEntity wall, double thickness);

  void
  addOpening(const SavedOpening& opening);

  IfcPlace
  holeOf(const SavedOpening& opening);

  void
  addFilling(const SavedOpening& opening, const IfcPlace& hole);

  void
  addObject(const SavedObject& object);

  const SavedScene& scene_;
  StepFile file_;
  IfcElements elements_;
  IfcShapes shapes_;
  std::vector<IfcPlace> storeys_, rooms_, walls_;
  std::vector<std::vector<StepEntity>> in_storey_, in_room_; ///< elements in them
};

void
IfcWriter::addSpatialStructure()
{
  const auto project = addProject(file_, elements_, shapes_.context(), scene_.input);
  const Eigen::Vector3d nowhere = Eigen::Vector3d::Zero();
  const auto site_place = shapes_.placement({}, nowhere);
  const auto site = elements_.add({"IFCSITE",
                                   "site",
                                   "",
                                   "",
                                   site_place,
                                   {},
                                   {"$", ".ELEMENT.", "$", "$", "$", "$", "$"}});
  const auto building_place = shapes_.placement(site_place, nowhere);
  const auto building = elements_.add({"IFCBUILDING",
                                       "building",
                                       "",
                                       "",
                                       building_place,
                                       {},
                                       {"$", ".ELEMENT.", "$", "$", "$"}});
  std::vector<StepEntity> storeys;
  for (std::size_t s = 0; s < scene_.storeys.size(); ++s) {
    const double floor = scene_.storeys[s].floor;
    const auto place = shapes_.placement(building_place, {0.0, 0.0, floor});
    storeys.push_back(elements_.add({"IFCBUILDINGSTOREY",
                                     "storey",
                                     std::to_string(s),
                                     "",
                                     place,
                                     {},
                                     {"$", ".ELEMENT.", stepReal(floor)}}));
    storeys_.push_back({storeys.back(), place, floor});
  }
  elements_.relate("IFCRELAGGREGATES", project, {site});
  elements_.relate("IFCRELAGGREGATES", site, {building});
  elements_.relate("IFCRELAGGREGATES", building, storeys);
}

void
IfcWriter::addSpace(const SavedRoom& room)
{
  const auto& storey = storeys_[room.storey];
  const auto polygons = polygonsOf(room.rings);
  const auto place =
      shapes_.placement(storey.placement, {0.0, 0.0, room.floor - storey.floor});
  const auto space = elements_.add({"IFCSPACE",
                                    "room",
                                    std::to_string(room.number),
                                    "",
                                    place,
                                    shapes_.prism(polygons, 0.0, room.height),
                                    {room.name.empty() ? "$" : stepText(room.name),
                                     ".ELEMENT.",
                                     ".INTERNAL.",
                                     "$"}});
  rooms_.push_back({space, place, room.floor});
  double around = 0.0;
  for (const auto& polygon : polygons)
    around += perimeter(polygon.outer);
  elements_.addQuantities(space,
                          "Qto_SpaceBaseQuantities",
                          {ifcLength("Height", room.height),
                           ifcLength("GrossPerimeter", around),
                           ifcArea("NetFloorArea", room.area),
                           ifcVolume("NetVolume", room.volume)});
  elements_.addProperties(space, "Pset_SpaceCommon", {ifcFlag("IsExternal", false)});
  addFloor(room, polygons);
}

void
IfcWriter::addFloor(const SavedRoom& room, const std::vector<PlanPolygon>& polygons)
{
  if (polygons.empty())
    return;
  const auto& storey = storeys_[room.storey];
  const auto slab = elements_.add(
      {"IFCSLAB",
       "floor",
       std::to_string(room.number),
       "",
       shapes_.placement(storey.placement, {0.0, 0.0, room.floor - storey.floor}),
       shapes_.prism(polygons, -slab_thickness, slab_thickness),
       {no_tag, ".FLOOR."}});
  elements_.addQuantities(
      slab, "Qto_SlabBaseQuantities", {ifcArea("GrossArea", room.area)});
  in_storey_[room.storey].push_back(slab);
}

void
IfcWriter::addMaterial(StepEntity wall, double thickness)
{
  const auto material = file_.share("IFCMATERIAL('not known',$,$)");
  const auto layer = file_.share("IFCMATERIALLAYER(" + stepRef(material) + "," +
                                 stepReal(thickness) + ",$,$,$,$,$)");
  const auto layers = file_.share("IFCMATERIALLAYERSET((" + stepRef(layer) + "),$,$)");
  const auto usage =
      file_.share("IFCMATERIALLAYERSETUSAGE(" + stepRef(layers) +
                  ",.AXIS2.,.POSITIVE.," + stepReal(-0.5 * thickness) + ",$)");
  file_.add("IFCRELASSOCIATESMATERIAL(" + elements_.root("material " + stepRef(wall)) +
            ",$,$,(" + stepRef(wall) + ")," + stepRef(usage) + ")");
}

void
IfcWriter::addWall(const SavedWall& wall)
{
  const auto& storey = storeys_[wall.storey];
  const Eigen::Vector2d way = wall.end - wall.begin;
  const bool is_known = wall.thickness > 0.0;
  const double thickness = is_known ? wall.thickness : unknown_thickness;
  const auto place =
      shapes_.placement(storey.placement,
                        {wall.begin.x(), wall.begin.y(), wall.floor - storey.floor},
                        std::atan2(way.y(), way.x()));
  const Eigen::Vector3d middle(
      0.5 * way.norm(), is_known ? 0.0 : -0.5 * thickness, 0.0);
  const auto entity =
      elements_.add({"IFCWALL",
                     "wall",
                     std::to_string(wall.number),
                     "",
                     place,
                     shapes_.box(middle, {way.norm(), thickness, wall.height}),
                     {no_tag, is_known ? ".STANDARD." : ".NOTDEFINED."}});
  walls_.push_back({entity, place, wall.floor});
  in_storey_[wall.storey].push_back(entity);
  std::vector<IfcValue> quantities = {
      ifcLength("Length", way.norm()),
      ifcLength("Height", wall.height),
      ifcArea("GrossSideArea", way.norm() * wall.height)};
  if (is_known) {
    quantities.push_back(ifcLength("Width", thickness));
    quantities.push_back(
        ifcVolume("GrossVolume", way.norm() * wall.height * thickness));
    addMaterial(entity, thickness);
  }
  elements_.addQuantities(entity, "Qto_WallBaseQuantities", quantities);
  elements_.addProperties(
      entity, "pcl_indoor_Wall", {ifcFlag("ThicknessIsMeasured", is_known)});
}

void
IfcWriter::addColumn(const SavedColumn& column)
{
  const auto& storey = storeys_[column.storey];
  const double bottom = column.foot.z() - storey.floor;
  const auto place = shapes_.placement(storey.placement, Eigen::Vector3d::Zero());
  const auto shape = shapes_.prism({{outlineOf(column), {}}}, bottom, column.size.z());
  const auto entity = elements_.add({"IFCCOLUMN",
                                     "column",
                                     std::to_string(column.number),
                                     "",
                                     place,
                                     shape,
                                     {no_tag, ".COLUMN."}});
  in_storey_[column.storey].push_back(entity);
  elements_.addQuantities(
      entity, "Qto_ColumnBaseQuantities", {ifcLength("Length", column.size.z())});
}

/** Where an opening's leaf stands, and of one in a wall its hole, from the foot of the
 * leaf; x goes along the wall. */
IfcPlace
IfcWriter::holeOf(const SavedOpening& opening)
{
  const auto& storey = storeys_[opening.storey];
  const auto& at = opening.position;
  if (opening.wall >= scene_.walls.size()) {
    const auto along = openingPlace(scene_, opening).along;
    const auto place = shapes_.placement(storey.placement,
                                         {at.x(), at.y(), at.z() - storey.floor},
                                         std::atan2(along.y(), along.x()));
    return {{}, place, at.z()};
  }
  const auto& wall = scene_.walls[opening.wall];
  const auto& standing = walls_[opening.wall];
  const Eigen::Vector2d way = openingPlace(scene_, opening).along;
  const double along = (at.head<2>() - wall.begin).dot(way);
  const double thickness = wall.thickness > 0.0 ? wall.thickness : unknown_thickness;
  const double across = wall.thickness > 0.0 ? 0.0 : -0.5 * thickness;
  const auto place =
      shapes_.placement(standing.placement, {along, across, at.z() - wall.floor});
  const auto hole = elements_.add(
      {"IFCOPENINGELEMENT",
       "opening",
       std::to_string(opening.number),
       "",
       place,
       shapes_.box(Eigen::Vector3d::Zero(),
                   {opening.width, thickness + 2.0 * cut_beyond, opening.height}),
       {no_tag, ".OPENING."}});
  elements_.relateOne("IFCRELVOIDSELEMENT", standing.entity, hole);
  return {hole, place, at.z()};
}

void
IfcWriter::addFilling(const SavedOpening& opening, const IfcPlace& hole)
{
  const bool is_door = opening.kind == ModelOpeningKind::Door;
  const auto place = shapes_.placement(hole.placement, Eigen::Vector3d::Zero());
  const auto leaf =
      elements_.add({is_door ? "IFCDOOR" : "IFCWINDOW",
                     is_door ? "door" : "window",
                     std::to_string(opening.number),
                     "",
                     place,
                     shapes_.box(Eigen::Vector3d::Zero(),
                                 {opening.width, leaf_thickness, opening.height}),
                     {no_tag,
                      stepReal(opening.height),
                      stepReal(opening.width),
                      is_door ? ".DOOR." : ".WINDOW.",
                      ".NOTDEFINED.",
                      "$"}});
  if (hole.entity.number > 0)
    elements_.relateOne("IFCRELFILLSELEMENT", hole.entity, leaf);
  in_storey_[opening.storey].push_back(leaf);
  elements_.addQuantities(leaf,
                          is_door ? "Qto_DoorBaseQuantities"
                                  : "Qto_WindowBaseQuantities",
                          {ifcLength("Width", opening.width),
                           ifcLength("Height", opening.height),
                           ifcArea("Area", opening.width * opening.height)});
  elements_.addProperties(leaf,
                          "pcl_indoor_Opening",
                          {{"SillHeight", "IFCLENGTHMEASURE", stepReal(opening.sill)},
                           ifcFlag("WasOpen", opening.is_open)});
}

void
IfcWriter::addOpening(const SavedOpening& opening)
{
  const auto hole = holeOf(opening);
  if (opening.kind != ModelOpeningKind::Passage)
    return addFilling(opening, hole);
  if (hole.entity.number > 0)
    return;
  // between spaces without a wall: a border that can only be thought
  in_storey_[opening.storey].push_back(
      elements_.add({"IFCVIRTUALELEMENT",
                     "passage",
                     std::to_string(opening.number),
                     "",
                     hole.placement,
                     shapes_.box(Eigen::Vector3d::Zero(),
                                 {opening.width, leaf_thickness, opening.height}),
                     {no_tag}}));
}

void
IfcWriter::addObject(const SavedObject& object)
{
  if (object.is_structure)
    return;
  const auto& parent =
      object.room > 0 ? rooms_[object.room - 1] : storeys_[object.storey];
  const auto& box = object.box;
  const double foot = box.center.z() - 0.5 * box.size.z();
  const auto entity = ifcEntityOf(object);
  const auto type = entity == "IFCFURNITURE" ? ifcFurnitureType(object.name)
                                             : std::string(".NOTDEFINED.");
  const auto element = elements_.add(
      {entity,
       "object",
       std::to_string(object.number),
       object.name,
       shapes_.placement(parent.placement,
                         {box.center.x(), box.center.y(), foot - parent.floor},
                         box.yaw),
       shapes_.box(Eigen::Vector3d::Zero(), box.size),
       {no_tag, type}});
  (object.room > 0 ? in_room_[object.room - 1] : in_storey_[object.storey])
      .push_back(element);
  std::vector<IfcValue> properties = {
      {"Object", "IFCINTEGER", std::to_string(object.number)}};
  if (!object.name.empty()) {
    properties.push_back({"Class", "IFCLABEL", stepText(object.name)});
    properties.push_back({"Confidence", "IFCREAL", stepReal(object.confidence)});
  }
  elements_.addProperties(element, "pcl_indoor_Object", properties);
}

std::string
IfcWriter::text(int epsg)
{
  addSpatialStructure();
  addMapConversion(file_, shapes_.context(), scene_.origin, epsg);
  std::vector<std::vector<StepEntity>> spaces(storeys_.size());
  for (const auto& room : scene_.rooms) {
    addSpace(room);
    spaces[room.storey].push_back(rooms_.back().entity);
  }
  for (const auto& wall : scene_.walls)
    addWall(wall);
  for (const auto& column : scene_.columns)
    addColumn(column);
  for (const auto& opening : scene_.openings)
    addOpening(opening);
  for (const auto& object : scene_.objects)
    addObject(object);
  for (std::size_t s = 0; s < storeys_.size(); ++s) {
    elements_.relate("IFCRELAGGREGATES", storeys_[s].entity, spaces[s]);
    elements_.relate(
        "IFCRELCONTAINEDINSPATIALSTRUCTURE", storeys_[s].entity, in_storey_[s]);
  }
  for (std::size_t r = 0; r < rooms_.size(); ++r)
    elements_.relate(
        "IFCRELCONTAINEDINSPATIALSTRUCTURE", rooms_[r].entity, in_room_[r]);
  const auto program = "'pcl_indoor " + std::string(programVersion()) + "'";
  return file_.text("IFC4",
                    "FILE_DESCRIPTION(('ViewDefinition "
                    "[DesignTransferView_V1.0]'),'2;1');\n"
                    "FILE_NAME(" +
                        stepText(scene_.input) + ",'1970-01-01T00:00:00',(''),('')," +
                        program + "," + program + ",'');\n");
}

} // namespace

std::string
ifcText(const SavedScene& scene, int epsg)
{
  return IfcWriter(scene).text(epsg);
}

} // namespace pcl::indoor::tool
