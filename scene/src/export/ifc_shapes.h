/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "export/step_file.h"
#include "pictures/plan_polygon.h"

#include <Eigen/Core>

#include <vector>

namespace pcl::indoor::tool {

/** \brief Placements and shapes of an IFC file. */
class IfcShapes {
public:
  /** \param[in,out] file the contexts of shapes are added */
  explicit IfcShapes(StepFile& file);

  /** \brief The context of the whole model. */
  StepEntity
  context() const
  {
    return context_;
  }

  /** \brief A frame within another, or of its own; z stays up.
   * \param[in] yaw of its x axis, radians */
  StepEntity
  placement(StepEntity parent, const Eigen::Vector3d& place, double yaw = 0.0);

  /** \brief What rings enclose, from a height upwards. */
  StepEntity
  prism(const std::vector<PlanPolygon>& polygons, double bottom, double height);

  /** \brief An upright box.
   * \param[in] middle of its lower side
   * \param[in] size along x, y and z */
  StepEntity
  box(const Eigen::Vector3d& middle, const Eigen::Vector3d& size);

private:
  StepEntity
  point(const Eigen::Vector2d& place);

  StepEntity
  axes(const Eigen::Vector3d& place, double yaw);

  StepEntity
  ring(const PlanRing& corners);

  StepEntity
  profile(const PlanPolygon& polygon);

  StepEntity
  extruded(StepEntity profile, const Eigen::Vector3d& place, double height);

  StepEntity
  shape(const std::vector<StepEntity>& solids);

  StepFile& file_;
  StepEntity context_, body_;
};

} // namespace pcl::indoor::tool
