/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/scene_options.h"

namespace pcl::indoor::tool {

void
addOption(OptionParser& parser,
          PointColors& colors,
          const std::vector<std::string>& labels)
{
  std::vector<std::string> choices = {"auto"};
  choices.insert(choices.end(), labels.begin(), labels.end());
  choices.insert(choices.end(), {"height", "none"});
  parser.text("-colour",
              colors.wanted,
              "what the colours of the output (field rgb) show; auto: the input's own, "
              "without any " +
                  labels.front() + "; none: adds no colours",
              choices);
}

void
addOptions(OptionParser& parser, CoordinateOptions& coordinates)
{
  parser.text(
      "-unit",
      coordinates.unit,
      "unit of the coordinates; lengths of options and areas are in metres; auto: "
      "metres, but where rooms would be higher than 50 m",
      {"auto", "m", "cm", "mm", "ft", "in"});
  addUpOption(parser, coordinates);
}

void
addUpOption(OptionParser& parser, CoordinateOptions& coordinates)
{
  parser.text(
      "-up",
      coordinates.up,
      "axis that points up, or a direction such as 0.1,0,0.99; auto: as floors, "
      "ceilings and walls tell it",
      {"auto", "x", "y", "z", "-x", "-y", "-z"},
      upDirection);
}

} // namespace pcl::indoor::tool
