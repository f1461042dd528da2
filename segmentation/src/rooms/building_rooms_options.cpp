/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/building_rooms_options.h>

#include "internal/option_check.h"
#include "rooms/space/enclosure.h"
#include "rooms/space/grid_cut.h"

namespace pcl::indoor {
namespace {

constexpr double infinity = OptionCheck::infinity;

void
checkInterior(const InteriorSpaceOptions& interior, OptionCheck& check)
{
  constexpr double heaviest = 80.0;
  static_assert(4.0 * heaviest < grid_cut_max_gain * gain_unit,
                "the sum of four must fit the cut's integers");
  const EnclosureWeights& weights = interior.weights;
  check.positiveLength("voxel size of the interior space", interior.voxel_size);
  check.between(0, heaviest, "weight of a floor", weights.below, "");
  check.between(0, heaviest, "weight of a ceiling", weights.above, "");
  check.between(0, heaviest, "weight of floor and ceiling", weights.vertical, "");
  check.between(0, heaviest, "weight of walls", weights.horizontal, "");
  check.between(0, heaviest, "evidence of the exterior", weights.exterior, "");
  check.between(0, 100.0, "smoothness", interior.smoothness, "");
  check.between(0,
                static_cast<double>(most_enclosure_directions),
                "number of directions",
                static_cast<double>(interior.max_directions),
                "");
  check.share("least support of a direction", interior.min_direction_support);
}

void
checkStoreys(const StoreyOptions& storeys, OptionCheck& check)
{
  check.positiveLength("clearance of storeys", storeys.min_clearance);
  check.length("height of a slab", storeys.max_slab);
  check.positive("least area of a slab", storeys.min_slab_area, infinity, " m^2");
  check.length("bridged opening of a slab", storeys.bridge);
  check.area("least opening of a hall", storeys.min_opening_area);
}

void
checkMap(const RoomMapOptions& map, OptionCheck& check)
{
  const CeilingSlabOptions& slab = map.slab;
  check.length("window of the ceiling", slab.window);
  check.length("step of the ceiling", slab.step);
  check.share("level share of the ceiling", slab.level_share);
  check.length("least height of a ceiling", slab.min_height);
  check.length("gap below the ceiling", slab.gap);
  check.length("greatest gap below the ceiling", slab.max_gap);
  check.length("least wall", slab.min_wall);
  check.positiveLength("depth of the slab", slab.depth);
  check.share("persistence", map.persistence);
  check.length("width of a door", map.door_width);
  check.share("open share", map.merging.open_share);
  check.share("open share of a door", map.merging.door_share);
  check.share("open height", map.merging.open_height);
  check.area("habitable area", map.open_plan.habitable_area);
  check.between(0, infinity, "elongation of a room", map.open_plan.max_elongation, "");
  check.share("persistence of an open plan", map.open_plan.persistence);
  check.share("share of an inner wall", map.open_plan.min_wall_share);
  check.share("shared view", map.open_plan.max_shared_view);
  check.length("smallest room width", map.min_width);
  check.area("smallest room area", map.min_area);
  check.length("reach of a label", map.reach);
}

} // namespace

std::string
findProblem(const BuildingRoomsOptions& options)
{
  OptionCheck check;
  check.voxel(options.voxel_size);
  checkInterior(options.interior, check);
  checkStoreys(options.storeys, check);
  checkMap(options.map, check);
  check.positiveLength("window of a wall", options.walls.window);
  check.length("thickness of a wall", options.walls.max_thickness);
  check.length("reach of a wall", options.walls.reach);
  check.between(2, // or there is no line
                1e9,
                "number of points of a wall",
                static_cast<double>(options.walls.min_points),
                "");
  check.between(0, infinity, "number of threads", options.threads, "");
  return check.problem();
}

} // namespace pcl::indoor
