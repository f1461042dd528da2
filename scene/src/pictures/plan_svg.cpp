/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/plan_svg.h"

#include "internal/cross.h"
#include "pictures/svg_drawing.h"

#include <algorithm>

namespace pcl::indoor::tool {
namespace {

constexpr double scale = 50.0;   // units per metre
constexpr double margin = 40.0;  // units around a storey
constexpr double caption = 24.0; // units above a storey
/** Where a storey lies on the sheet. */
class Sheet {
public:
  Sheet(const Eigen::AlignedBox2d& box, double top)
  : corner_(box.min().x(), box.max().y())
  , top_(top)
  {}

  Eigen::Vector2d
  operator()(const Eigen::Vector2d& place) const // y points up
  {
    return {margin + scale * (place.x() - corner_.x()),
            top_ + scale * (corner_.y() - place.y())};
  }

private:
  Eigen::Vector2d corner_;
  double top_;
};

/** A step of a path: a letter and a place. */
std::string
step(char letter, const Eigen::Vector2d& at)
{
  return formatted("%c%.1f,%.1f", letter, at.x(), at.y());
}

std::string
ringPath(const std::vector<Eigen::Vector2d>& ring, const Sheet& sheet)
{
  std::string path;
  for (std::size_t i = 0; i < ring.size(); ++i)
    path += step(i == 0 ? 'M' : 'L', sheet(ring[i]));
  return path + "Z";
}

std::string
roomShape(const PlanRoom& room, const Sheet& sheet)
{
  const Color color = labelColor(room.label);
  const auto pale = [](std::uint8_t part) { return 255u - (255u - part) / 4u; };
  std::string path;
  for (const auto& ring : room.rings)
    path += ringPath(ring, sheet);
  return formatted("  <path id=\"room-%u\" class=\"room\" data-room=\"%u\" "
                   "fill=\"#%02x%02x%02x\" d=\"",
                   room.label,
                   room.label,
                   pale(color.red),
                   pale(color.green),
                   pale(color.blue)) +
         path + "\"/>\n";
}

std::string
objectShape(const PlanObject& object, const Sheet& sheet)
{
  return formatted("  <path class=\"thing\" data-object=\"%u\" fill=\"#ddd\" "
                   "stroke=\"#555\" d=\"",
                   object.number) +
         ringPath(object.corners, sheet) + "\"/>\n";
}

std::string
wallLines(const StoreyPlan& storey, const Sheet& sheet)
{
  std::string path;
  for (const auto& [begin, end] : storey.walls)
    path += step('M', sheet(begin)) + step('L', sheet(end));
  return "  <path class=\"walls\" fill=\"none\" stroke=\"#222\" stroke-width=\"3\" "
         "stroke-linecap=\"round\" d=\"" +
         path + "\"/>\n";
}

std::string
barPath(const PlanBar& bar, const Sheet& sheet)
{
  return ringPath(bar.corners(), sheet);
}

std::string
wallBodies(const StoreyPlan& storey, const Sheet& sheet)
{
  std::string path;
  for (const auto& body : storey.bodies)
    path += barPath(body, sheet);
  return path.empty() ? ""
                      : "  <path class=\"bodies\" fill=\"#888\" d=\"" + path + "\"/>\n";
}

/** A window: its frame, and the pane in the middle. */
std::string
windowShape(const PlanBar& window, const Sheet& sheet)
{
  return "  <path class=\"window\" fill=\"white\" stroke=\"#222\" d=\"" +
         barPath(window, sheet) + step('M', sheet(window.axis.first)) +
         step('L', sheet(window.axis.second)) + "\"/>\n";
}

/** A door's leaf and its arc, or the dashed threshold of a passage. */
std::string
openingShape(const PlanOpening& opening, const Sheet& sheet)
{
  const auto [begin, end] = opening.threshold();
  const std::string form = " fill=\"none\" stroke=\"#444\" stroke-width=\"1.2\" ";
  const std::string number = formatted("data-opening=\"%zu\"", opening.number);
  if (!opening.is_door)
    return "  <path class=\"passage\" " + number + form +
           "stroke-dasharray=\"5,4\" d=\"" + step('M', sheet(begin)) +
           step('L', sheet(end)) + "\"/>\n";
  const double radius = scale * opening.width;
  const Eigen::Vector2d leaf = opening.leafEnd() - begin, gap = end - begin;
  const int sweep = crossOf(leaf, gap) < 0.0 ? 1 : 0; // y is down
  return "  <path class=\"door\" " + number + form + "d=\"" + step('M', sheet(begin)) +
         step('L', sheet(opening.leafEnd())) +
         formatted("A%.1f,%.1f 0 0 %d ", radius, radius, sweep) +
         step(' ', sheet(end)).substr(1) + "\"/>\n";
}

/** A tripod from above. */
std::string
stationShape(const Eigen::Vector2d& station, const Sheet& sheet)
{
  const Eigen::Vector2d at = sheet(station);
  return formatted("  <path class=\"station\" fill=\"none\" stroke=\"#06c\" "
                   "stroke-width=\"1.2\" d=\"M%.1f,%.1fv-5m0,5l-4.3,2.5m4.3,-2.5l4.3,"
                   "2.5\"/>\n",
                   at.x(),
                   at.y());
}

std::string
roomText(const PlanRoom& room, const Sheet& sheet)
{
  const Eigen::Vector2d at = sheet(room.place);
  return formatted("  <text class=\"room-number\" x=\"%.1f\" y=\"%.1f\" "
                   "font-weight=\"600\">%u</text>\n",
                   at.x(),
                   at.y() - 3.0,
                   room.label) +
         formatted("  <text class=\"room-area\" x=\"%.1f\" y=\"%.1f\" "
                   "font-size=\"10\">%s%s%.1f m²</text>\n",
                   at.x(),
                   at.y() + 10.0,
                   xmlText(room.name).c_str(),
                   room.name.empty() ? "" : " ",
                   room.area);
}

std::string
widthText(const PlanOpening& opening, const Sheet& sheet)
{
  const Eigen::Vector2d at = sheet(opening.middle - 0.16 * opening.into);
  return formatted("  <text x=\"%.1f\" y=\"%.1f\" font-size=\"8\" "
                   "fill=\"#444\">%.2f</text>\n",
                   at.x(),
                   at.y() + 3.0,
                   opening.width);
}

/** An arrow in the direction of y. */
std::string
directionOfY(double right, double top)
{
  return formatted("<path id=\"direction\" stroke=\"black\" fill=\"none\" "
                   "d=\"M%.1f,%.1fv-24m-4,7l4,-7l4,7\"/>\n",
                   right,
                   top + 8.0) +
         formatted("<text x=\"%.1f\" y=\"%.1f\" font-size=\"11\">y</text>\n",
                   right + 9.0,
                   top + 7.0);
}

std::string
storeyShapes(const StoreyPlan& storey, const Sheet& sheet, bool with_objects)
{
  std::string text = wallBodies(storey, sheet);
  for (const auto& room : storey.rooms)
    text += roomShape(room, sheet);
  if (with_objects)
    for (const auto& object : storey.objects)
      text += objectShape(object, sheet);
  text += wallLines(storey, sheet);
  for (const auto& window : storey.windows)
    text += windowShape(window, sheet);
  for (const auto& opening : storey.openings)
    text += openingShape(opening, sheet);
  for (const auto& station : storey.stations)
    text += stationShape(station, sheet);
  for (const auto& room : storey.rooms)
    text += roomText(room, sheet);
  return text;
}

} // namespace

std::string
planSvg(const FloorPlan& plan)
{
  const bool named = plan.storeys.size() > 1;
  const double storey_height = scale * plan.box.sizes().y() + margin;
  std::string storeys;
  double top = margin;
  for (std::size_t s = plan.storeys.size(); s-- > 0; top += storey_height) {
    storeys += formatted("<g id=\"storey-%zu\">\n", s);
    if (named) {
      storeys += formatted("  <text x=\"%.1f\" y=\"%.1f\" text-anchor=\"start\">Storey "
                           "%zu</text>\n",
                           margin,
                           top,
                           s);
      top += caption;
    }
    const Sheet sheet(plan.box, top);
    storeys += storeyShapes(plan.storeys[s], sheet, false);
    for (const auto& opening : plan.storeys[s].openings)
      storeys += widthText(opening, sheet);
    storeys += "</g>\n";
  }
  SvgDrawing drawing(std::max(260.0, 2.0 * margin + scale * plan.box.sizes().x()),
                     top + margin);
  drawing.add(storeys);
  drawing.scaleBar({margin, top + 5.0}, scale);
  drawing.add(directionOfY(drawing.width() - margin, top));
  return drawing.str();
}

std::vector<std::string>
storeySvgs(const FloorPlan& plan)
{
  std::vector<std::string> drawings;
  for (const auto& storey : plan.storeys) {
    SvgDrawing drawing(2.0 * margin + scale * plan.box.sizes().x(),
                       2.0 * margin + scale * plan.box.sizes().y(),
                       false);
    drawing.add(storeyShapes(storey, Sheet(plan.box, margin), true));
    drawings.push_back(drawing.str());
  }
  return drawings;
}

} // namespace pcl::indoor::tool
