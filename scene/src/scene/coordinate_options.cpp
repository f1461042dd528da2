/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/coordinate_options.h"

#include "files/tool_error.h"
#include "text/place_text.h"

#include <pcl/segmentation/scan_overview.h>

#include <iomanip>
#include <locale>
#include <sstream>
#include <utility>

namespace pcl::indoor::tool {

namespace {

constexpr std::pair<const char*, double> units[] = {
    {"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"ft", 0.3048}, {"in", 0.0254}};

bool
isAxis(const std::string& text)
{
  const bool has_sign =
      text.size() == 2 && (text.front() == '-' || text.front() == '+');
  return (text.size() == 1 || has_sign) && text.back() >= 'x' && text.back() <= 'z';
}

/** As the option -up takes it. */
std::string
textOf(const Eigen::Vector3f& direction)
{
  for (int axis = 0; axis < 3; ++axis)
    for (const float sign : {1.0f, -1.0f})
      if (direction == Eigen::Vector3f(sign * Eigen::Vector3f::Unit(axis)))
        return std::string(sign < 0.0f ? "-" : "") + static_cast<char>('x' + axis);
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(9) << direction.x() << ',' << direction.y() << ','
       << direction.z();
  return text.str();
}

} // namespace

Eigen::Vector3f
upDirection(const std::string& text)
{
  const Eigen::Vector3f direction = readPlace("-up", text).cast<float>();
  if (!direction.allFinite() || !(direction.squaredNorm() > 0.0f))
    throw ToolError("-up: '" + text + "' has no direction");
  return direction;
}

double
metresOfUnit(const std::string& name)
{
  for (const auto& [unit, metres] : units)
    if (unit == name)
      return metres;
  return 1.0;
}

std::string
unitName(double metres_per_unit)
{
  for (const auto& [name, metres] : units)
    if (metres == metres_per_unit)
      return name;
  return {};
}

} // namespace pcl::indoor::tool

namespace pcl::indoor {

double
CoordinateOptions::metresPerUnit() const
{
  return tool::metresOfUnit(unit);
}

Eigen::Vector3f
CoordinateOptions::upAxis() const
{
  if (up == "auto")
    return Eigen::Vector3f::UnitZ();
  if (!tool::isAxis(up))
    return tool::upDirection(up);
  const Eigen::Vector3f axis = Eigen::Vector3f::Unit(up.back() - 'x');
  return up.front() == '-' ? Eigen::Vector3f(-axis) : axis;
}

void
CoordinateOptions::settle(const ScanCoordinates& used)
{
  if (up == "auto")
    up = tool::textOf(used.up_axis);
  if (unit == "auto")
    unit = tool::unitName(used.metres_per_unit);
}

} // namespace pcl::indoor
