/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/distinct_segmentation.h"

#include "objects/structure/scene_making.h"

#include <pcl/exceptions.h>
#include <pcl/features/unit_normals.h>
#include <pcl/indoor/distinct_points.h>
#include <pcl/indoor/point_resolution.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace {

using pcl::indoor::DetailedSegmentation;
using pcl::indoor::DistinctPoints;
using pcl::indoor::ObjectSegmentationInput;

void
requireFitting(const ObjectSegmentationInput& input)
{
  if (!input.normals.empty() && input.normals.size() != input.points.size())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        input.points.size()
                            << " points have " << input.normals.size() << " normals.");
  if (!input.colors.empty() && input.colors.size() != input.points.size())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        input.points.size()
                            << " points have " << input.colors.size() << " colors.");
  if (input.capture != pcl::indoor::Capture::Scan && input.viewpoint.empty())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "A single camera needs a viewpoint.");
  if (!(std::abs(input.up.norm() - 1) < 1e-3f))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "The direction up must have the length 1, not "
                            << input.up.norm() << '.');
}

void
keepDistinct(const DistinctPoints& places, ObjectSegmentationInput& input)
{
  input.points = places.once(input.points);
  input.normals = places.least(input.normals);
  input.colors = places.least(input.colors);
}

/** Give the copies of points what their places have. */
void
spreadToCopies(const DistinctPoints& places, DetailedSegmentation& result)
{
  auto& scene = result.scene;
  scene.points = places.forAll(scene.points);
  scene.voxels.cells.cell_of_point = places.forAll(scene.voxels.cells.cell_of_point);
  pcl::indoor::listPoints(scene.voxels.cells);
  result.piece_of_point = places.forAll(result.piece_of_point);
  result.votes.voxel_of_point = places.forAll(result.votes.voxel_of_point);
  result.segment_of_point = places.forAll(result.segment_of_point);
}

} // namespace

namespace pcl::indoor {

ObjectSegmentation
segmentEachPlace(ObjectSegmentationInput input, const SegmentDistinct& segment)
{
  requireFitting(input);
  const auto places = placesOfCopies(input.points);
  if (!places)
    return published(segment(std::move(input)));
  keepDistinct(*places, input);
  auto result = segment(std::move(input));
  if (!result.segment_of_point.empty())
    spreadToCopies(*places, result);
  return published(std::move(result));
}

ObjectSegmentationInput
withoutUnusable(ObjectSegmentationInput input)
{
  requireFitting(input);
  if (!areUnitNormals(input.normals))
    input.normals.clear();
  if (input.capture != Capture::Scan)
    input.voter = {};
  return input;
}

ObjectSegmentationOptions
sizedOptions(const ObjectSegmentationInput& input,
             const ObjectSegmentationOptions& given)
{
  auto options = withSizes(given);
  options.threads = std::min(given.threads, 1024u); // each needs memory for its stack
  if (given.voxel_size == 0 && given.seed_size == 0) {
    const auto grid_points = gridPoints(input);
    const double size = options.voxel_size;
    options.voxel_size =
        raisedToResolution(grid_points.empty() ? input.points : grid_points, size);
    options.seed_size *= options.voxel_size / size;
  }
  return options;
}

} // namespace pcl::indoor
