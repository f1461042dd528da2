/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/segmentation/building_rooms_options.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace pcl {
namespace indoor {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double longest = 1000.0;      // metres; larger than any building
constexpr double shortest_voxel = 1e-4; // metres; finer than any scan

/** Keeps the first complaint. */
class Check {
public:
  /** Both ends are legal; NaN never is. */
  void
  between(double low, double high, const char* what, double value, const char* unit)
  {
    if (!problem_.empty() || (low <= value && value <= high))
      return;
    std::ostringstream text;
    text << "The " << what << " must ";
    if (high == infinity)
      text << "not be negative";
    else
      text << "lie in " << low << " ... " << high << unit;
    text << ", not " << value << unit << '.';
    problem_ = text.str();
  }

  /** Also 0; at most so many voxels of the smallest size as an int can count. */
  void
  length(const char* what, double value)
  {
    between(0.0, longest, what, value, " m");
  }

  /** 0 is automatic. */
  void
  voxel(double size)
  {
    length("voxel size", size);
    if (!problem_.empty() || size == 0.0 || size >= shortest_voxel)
      return;
    std::ostringstream text;
    text << "The voxel size must be 0 or at least " << shortest_voxel << " m, not "
         << size << " m.";
    problem_ = text.str();
  }

  void
  positive(const char* what, double value, double high, const char* unit)
  {
    if (value > 0.0)
      between(0.0, high, what, value, unit);
    else if (problem_.empty()) {
      std::ostringstream text;
      text << "The " << what << " must be positive, not " << value << unit << '.';
      problem_ = text.str();
    }
  }

  void
  positiveLength(const char* what, double value)
  {
    positive(what, value, longest, " m");
  }

  void
  area(const char* what, double value)
  {
    between(0.0, infinity, what, value, " m^2");
  }

  void
  share(const char* what, double value)
  {
    between(0.0, 1.0, what, value, "");
  }

  const std::string&
  problem() const
  {
    return problem_;
  }

private:
  std::string problem_;
};

void
checkInterior(const InteriorSpaceOptions& interior, Check& check)
{
  constexpr double heaviest = 80.0;       // the sum of four must fit the cut's integers
  constexpr double most_directions = 5.0; // that enclosure has bits for
  const EnclosureWeights& weights = interior.weights;
  check.positiveLength("voxel size of the interior space", interior.voxel_size);
  check.between(0, heaviest, "weight of a floor", weights.below, "");
  check.between(0, heaviest, "weight of a ceiling", weights.above, "");
  check.between(0, heaviest, "weight of floor and ceiling", weights.vertical, "");
  check.between(0, heaviest, "weight of walls", weights.horizontal, "");
  check.between(0, heaviest, "evidence of the exterior", weights.exterior, "");
  check.between(0, 100.0, "smoothness", interior.smoothness, "");
  check.between(0,
                most_directions,
                "number of directions",
                static_cast<double>(interior.max_directions),
                "");
  check.share("least support of a direction", interior.min_direction_support);
}

void
checkStoreys(const StoreyOptions& storeys, Check& check)
{
  check.positiveLength("clearance of storeys", storeys.min_clearance);
  check.length("height of a slab", storeys.max_slab);
  check.positive("least area of a slab", storeys.min_slab_area, infinity, " m^2");
  check.length("bridged opening of a slab", storeys.bridge);
  check.area("least opening of a hall", storeys.min_opening_area);
}

void
checkFieldRooms(const FieldRoomsOptions& field, Check& check)
{
  const double most = std::numeric_limits<float>::max(); // finite
  const MapDistanceOptions& distance = field.distance;
  check.between(0, most, "visibility weight", distance.visibility_weight, "");
  check.between(0, most, "Euclidean weight", distance.euclidean_weight, "");
  check.between(0, most, "field weight", distance.field_weight, "");
  check.between(0, most, "Euclidean scale", distance.euclidean_scale, " pixels");
  check.between(1, 1e6, "number of the histogram's bins", field.peaks.bins, "");
  check.between(0, 1e6, "histogram's smoothing", field.peaks.smoothing, " bins");
  check.between(0, infinity, "prominence of a peak", field.peaks.prominence, "");
  check.between(0, most, "DBSCAN distance", field.dbscan_distance, "");
  check.positive("least area of a cluster", field.min_cluster_area, 1e6, " m^2");
  check.positive("sample area of a cluster", field.sample_area, 1e6, " m^2");
  check.length("spacing of landmarks", field.landmark_spacing);
  check.between(0, most, "random walker's beta", field.beta, "");
}

void
checkMap(const RoomMapOptions& map, Check& check)
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
  check.length("width of a door", map.merging.door_width);
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
  checkFieldRooms(map.field_rooms, check);
}

} // namespace

BuildingRoomsOptions
thesisRoomOptions()
{
  BuildingRoomsOptions options;
  options.voxel_size = options.interior.voxel_size = 0.2;
  options.align_grid = false;
  options.interior.upright_walls = false;
  options.interior.max_directions = 2;
  options.map.method = RoomMethod::PotentialField;
  options.map.merge_open = false;
  FieldRoomsOptions& field = options.map.field_rooms;
  field.landmark_spacing = 0.0;
  field.peaks_on_slopes = true;
  options.point_rooms = PointRooms::Vote;
  return options;
}

std::string
findProblem(const BuildingRoomsOptions& options)
{
  Check check;
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

} // namespace indoor
} // namespace pcl
