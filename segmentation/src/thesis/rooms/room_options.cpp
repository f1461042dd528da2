/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "rooms/option_check.h"

#include <pcl/segmentation/thesis.h>

namespace pcl {
namespace indoor {
namespace thesis {

std::string
findProblem(const RoomOptions& options)
{
  if (const auto problem = indoor::findProblem(options.shared); !problem.empty())
    return problem;
  constexpr double infinity = OptionCheck::infinity;
  OptionCheck check;
  const FieldRoomsOptions& field = options.field;
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
  return check.problem();
}

} // namespace thesis

thesis::RoomOptions
thesisRoomOptions()
{
  thesis::RoomOptions options;
  auto& shared = options.shared;
  shared.voxel_size = shared.interior.voxel_size = 0.2;
  shared.align_grid = false;
  shared.interior.upright_walls = false;
  shared.interior.max_directions = 2;
  shared.map.merge_open = false;
  options.field.landmark_spacing = 0.0;
  options.field.peaks_on_slopes = true;
  options.point_rooms = thesis::PointRooms::Vote;
  return options;
}

} // namespace indoor
} // namespace pcl
