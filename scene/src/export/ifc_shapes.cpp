/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/ifc_shapes.h"

#include "text/printable.h" // for fixedText

#include <algorithm>
#include <cmath>

namespace pcl::indoor::tool {
namespace {

constexpr double least_side = 0.001; // metres: solids have a volume

std::string
numbers(const Eigen::Vector3d& place)
{
  return "(" + stepReal(place.x()) + "," + stepReal(place.y()) + "," +
         stepReal(place.z()) + ")";
}

std::string
numbers(const Eigen::Vector2d& place)
{
  return "(" + stepReal(place.x()) + "," + stepReal(place.y()) + ")";
}

/** A direction needs more digits than a length. */
std::string
direction(double yaw)
{
  return "IFCDIRECTION((" + fixedText(std::cos(yaw) + 0.0, 12) + "," +
         fixedText(std::sin(yaw) + 0.0, 12) + ",0.))";
}

} // namespace

IfcShapes::IfcShapes(StepFile& file)
: file_(file)
{
  context_ = file_.add("IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-5," +
                       stepRef(axes(Eigen::Vector3d::Zero(), 0.0)) + ",$)");
  body_ = file_.add("IFCGEOMETRICREPRESENTATIONSUBCONTEXT('Body','Model',*,*,*,*," +
                    stepRef(context_) + ",$,.MODEL_VIEW.,$)");
}

StepEntity
IfcShapes::axes(const Eigen::Vector3d& place, double yaw)
{
  const auto at = file_.share("IFCCARTESIANPOINT(" + numbers(place) + ")");
  std::string ways = ",$,$";
  if (yaw != 0.0)
    ways = "," + stepRef(file_.share("IFCDIRECTION((0.,0.,1.))")) + "," +
           stepRef(file_.share(direction(yaw)));
  return file_.share("IFCAXIS2PLACEMENT3D(" + stepRef(at) + ways + ")");
}

StepEntity
IfcShapes::placement(StepEntity parent, const Eigen::Vector3d& place, double yaw)
{
  return file_.add("IFCLOCALPLACEMENT(" + stepRef(parent) + "," +
                   stepRef(axes(place, yaw)) + ")");
}

StepEntity
IfcShapes::point(const Eigen::Vector2d& place)
{
  return file_.share("IFCCARTESIANPOINT(" + numbers(place) + ")");
}

StepEntity
IfcShapes::ring(const PlanRing& corners)
{
  std::vector<StepEntity> points;
  for (const auto& corner : corners) {
    const auto at = point(corner);
    if (points.empty() || points.back().number != at.number)
      points.push_back(at);
  }
  if (points.back().number != points.front().number)
    points.push_back(points.front());
  return file_.add("IFCPOLYLINE(" + stepList(points) + ")");
}

StepEntity
IfcShapes::profile(const PlanPolygon& polygon)
{
  const auto outer = stepRef(ring(polygon.outer));
  if (polygon.holes.empty())
    return file_.add("IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$," + outer + ")");
  std::vector<StepEntity> holes;
  for (const auto& hole : polygon.holes)
    holes.push_back(ring(hole));
  return file_.add("IFCARBITRARYPROFILEDEFWITHVOIDS(.AREA.,$," + outer + "," +
                   stepList(holes) + ")");
}

StepEntity
IfcShapes::extruded(StepEntity profile, const Eigen::Vector3d& place, double height)
{
  const auto up = file_.share("IFCDIRECTION((0.,0.,1.))");
  return file_.add("IFCEXTRUDEDAREASOLID(" + stepRef(profile) + "," +
                   stepRef(axes(place, 0.0)) + "," + stepRef(up) + "," +
                   stepReal(std::max(height, least_side)) + ")");
}

StepEntity
IfcShapes::shape(const std::vector<StepEntity>& solids)
{
  if (solids.empty())
    return {};
  const auto body = file_.add("IFCSHAPEREPRESENTATION(" + stepRef(body_) +
                              ",'Body','SweptSolid'," + stepList(solids) + ")");
  return file_.add("IFCPRODUCTDEFINITIONSHAPE($,$,(" + stepRef(body) + "))");
}

StepEntity
IfcShapes::prism(const std::vector<PlanPolygon>& polygons, double bottom, double height)
{
  std::vector<StepEntity> solids;
  for (const auto& polygon : polygons)
    solids.push_back(extruded(profile(polygon), {0.0, 0.0, bottom}, height));
  return shape(solids);
}

StepEntity
IfcShapes::box(const Eigen::Vector3d& middle, const Eigen::Vector3d& size)
{
  const auto center = file_.share("IFCAXIS2PLACEMENT2D(" +
                                  stepRef(point(Eigen::Vector2d::Zero())) + ",$)");
  const auto sides = file_.add("IFCRECTANGLEPROFILEDEF(.AREA.,$," + stepRef(center) +
                               "," + stepReal(std::max(size.x(), least_side)) + "," +
                               stepReal(std::max(size.y(), least_side)) + ")");
  return shape({extruded(sides, middle, size.z())});
}

} // namespace pcl::indoor::tool
