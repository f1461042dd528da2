/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/plan_dxf.h"

#include "internal/cross.h"
#include "text/printable.h" // for fixedText

#include <cmath>

namespace pcl::indoor::tool {
namespace {

/** A drawing as pairs of group codes and values. */
class Drawing {
public:
  explicit Drawing(const Eigen::Vector2d& origin)
  : origin_(origin)
  {}

  Drawing&
  add(int code, const std::string& value)
  {
    text_ += std::to_string(code) + "\n" + value + "\n";
    return *this;
  }

  Drawing&
  add(int code, double value)
  {
    return add(code, fixedText(value, 4));
  }

  /** \param[in] code 10 for the first place of an entity, 11 for its second */
  Drawing&
  addPlace(int code, const Eigen::Vector2d& place)
  {
    return add(code, place.x() + origin_.x())
        .add(code + 10, place.y() + origin_.y())
        .add(code + 20, 0.0);
  }

  Drawing&
  begin(const std::string& kind, const std::string& layer)
  {
    return add(0, kind).add(8, layer);
  }

  void
  addLine(const std::string& layer, const Eigen::Vector2d& a, const Eigen::Vector2d& b)
  {
    begin("LINE", layer).addPlace(10, a).addPlace(11, b);
  }

  const std::string&
  text() const
  {
    return text_;
  }

private:
  Eigen::Vector2d origin_;
  std::string text_;
};

struct Layer {
  const char* name;
  const char* color; ///< number of AutoCAD's palette
};
constexpr Layer layers[] = {
    {"_ROOMS", "8"}, {"_WALLS", "7"}, {"_OPENINGS", "5"}, {"_TEXT", "3"}};

std::string
layerName(std::size_t storey, const char* name)
{
  return "STOREY" + std::to_string(storey) + name;
}

void
addHeader(Drawing& drawing, const FloorPlan& plan)
{
  drawing.add(0, "SECTION").add(2, "HEADER").add(9, "$ACADVER").add(1, "AC1009");
  drawing.add(9, "$EXTMIN").addPlace(10, plan.box.min());
  drawing.add(9, "$EXTMAX").addPlace(10, plan.box.max());
  drawing.add(0, "ENDSEC").add(0, "SECTION").add(2, "TABLES");
  drawing.add(0, "TABLE").add(2, "LTYPE").add(70, "1");
  drawing.add(0, "LTYPE").add(2, "CONTINUOUS").add(70, "0").add(3, "Solid line");
  drawing.add(72, "65").add(73, "0").add(40, 0.0).add(0, "ENDTAB");
  drawing.add(0, "TABLE").add(2, "LAYER");
  drawing.add(70, std::to_string(plan.storeys.size() * std::size(layers)));
  for (std::size_t s = 0; s < plan.storeys.size(); ++s)
    for (const auto& layer : layers)
      drawing.add(0, "LAYER")
          .add(2, layerName(s, layer.name))
          .add(70, "0")
          .add(62, layer.color)
          .add(6, "CONTINUOUS");
  drawing.add(0, "ENDTAB").add(0, "ENDSEC");
}

void
addRoom(Drawing& drawing, const PlanRoom& room, std::size_t storey)
{
  const auto layer = layerName(storey, "_ROOMS");
  for (const auto& ring : room.rings) {
    drawing.begin("POLYLINE", layer).add(66, "1").add(70, "1");
    drawing.add(10, 0.0).add(20, 0.0).add(30, 0.0);
    for (const auto& corner : ring)
      drawing.begin("VERTEX", layer).addPlace(10, corner);
    drawing.begin("SEQEND", layer);
  }
  const auto write =
      [&](const Eigen::Vector2d& place, double height, const char* text) {
        drawing.begin("TEXT", layerName(storey, "_TEXT")).addPlace(10, place);
        drawing.add(40, height).add(1, text).add(72, "1").addPlace(11, place);
      };
  write(room.place, 0.3, std::to_string(room.label).c_str());
  const std::string name = room.name.empty() ? "" : room.name + " ";
  write(room.place - Eigen::Vector2d(0.0, 0.35),
        0.2,
        (name + fixedText(room.area, 1) + " m2").c_str());
}

void
addOpening(Drawing& drawing, const PlanOpening& opening, std::size_t storey)
{
  const auto layer = layerName(storey, "_OPENINGS");
  const auto [begin, end] = opening.threshold();
  drawing.addLine(layer, begin, end);
  if (!opening.is_door)
    return;
  drawing.addLine(layer, begin, opening.leafEnd());
  const Eigen::Vector2d leaf = opening.into, gap = opening.along;
  const bool gap_first = crossOf(gap, leaf) > 0.0;
  const auto degrees = [](const Eigen::Vector2d& way) {
    return std::atan2(way.y(), way.x()) * 180.0 / M_PI;
  };
  drawing.begin("ARC", layer).addPlace(10, begin).add(40, opening.width);
  drawing.add(50, degrees(gap_first ? gap : leaf)); // counter-clockwise to
  drawing.add(51, degrees(gap_first ? leaf : gap));
}

/** Its frame and the pane in the middle. */
void
addWindow(Drawing& drawing, const PlanBar& window, std::size_t storey)
{
  const auto layer = layerName(storey, "_OPENINGS");
  const auto corners = window.corners();
  for (std::size_t i = 0; i < corners.size(); ++i)
    drawing.addLine(layer, corners[i], corners[(i + 1) % corners.size()]);
  drawing.addLine(layer, window.axis.first, window.axis.second);
}

} // namespace

std::string
planDxf(const FloorPlan& plan)
{
  Drawing drawing(plan.origin);
  addHeader(drawing, plan);
  drawing.add(0, "SECTION").add(2, "ENTITIES");
  for (std::size_t s = 0; s < plan.storeys.size(); ++s) {
    const auto& storey = plan.storeys[s];
    for (const auto& room : storey.rooms)
      addRoom(drawing, room, s);
    for (const auto& [begin, end] : storey.walls)
      drawing.addLine(layerName(s, "_WALLS"), begin, end);
    for (const auto& opening : storey.openings)
      addOpening(drawing, opening, s);
    for (const auto& window : storey.windows)
      addWindow(drawing, window, s);
  }
  drawing.add(0, "ENDSEC").add(0, "EOF");
  return drawing.text();
}

} // namespace pcl::indoor::tool
