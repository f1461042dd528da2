/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/room_objects.h>

#include "objects/distinct_segmentation.h"

#include <pcl/exceptions.h>
#include <pcl/indoor/distinct_points.h>
#include <pcl/indoor/middle_point.h>
#include <pcl/indoor/stray_points.h>

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace pcl::indoor {
namespace {

/** Numbers 1 ... n for what is called otherwise, by their first points. */
std::vector<std::uint32_t>
numbered(const std::vector<std::uint32_t>& names,
         std::unordered_map<std::uint32_t, std::uint32_t> numbers)
{
  std::uint32_t last = 0;
  std::vector<std::uint32_t> result;
  result.reserve(names.size());
  for (const auto name : names) {
    const auto [entry, is_new] = numbers.emplace(name, last + 1);
    last += is_new;
    result.push_back(entry->second);
  }
  return result;
}

void
requireSizes(const RoomPoints& room)
{
  const auto count = room.positions.size();
  if ((!room.normals.empty() && room.normals.size() != count) ||
      (!room.given.empty() && room.given.size() != count))
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "A room of " << count << " points has " << room.normals.size()
                                     << " normals and " << room.given.size()
                                     << " given objects.");
}

ObjectSegmentationInput
localInput(RoomPoints& room, const VoxelVoter& voter)
{
  ObjectSegmentationInput input;
  moveToMiddle(room.positions);
  input.points = std::move(room.positions);
  input.normals = std::move(room.normals);
  input.voter = voter;
  return input;
}

/** The objects of a room whose points have no copies, or are in given objects. */
RoomObjects
objectsOf(const SegmentDistinct& segment,
          RoomPoints room,
          std::size_t fewest,
          const VoxelVoter& voter)
{
  RoomObjects objects;
  if (room.positions.empty())
    return objects;
  const auto strays = strayPoints(room.positions);
  takeOut(strays, room.positions);
  takeOut(strays, room.normals);
  takeOut(strays, room.given);
  auto result = room.given.empty() ? published(segment(localInput(room, voter)))
                                   : segmentEachPlace(localInput(room, voter), segment);
  objects.voxel_size = stepsOf(result).scene.voxel_size;
  constexpr auto none = ObjectSegmentation::none;
  const auto& segments = result.segment_of_point;
  objects.object_of_point = room.given.empty() ? numbered(segments, {{none, 0}})
                                               : numbered(room.given, {{0, 0}});
  for (std::size_t i = 0; i < segments.size(); ++i)
    objects.structure_of_point.push_back(
        objects.object_of_point[i] == 0 || segments[i] == none
            ? 0
            : static_cast<std::uint32_t>(result.structure_of_segment[segments[i]]));
  auto numbers = objects.object_of_point;
  const auto count = *std::max_element(numbers.begin(), numbers.end());
  for (auto& number : numbers)
    --number; // 0, no object, becomes a number beyond all objects
  objects.surfaces = objectSurfaces(result, numbers, count);
  objects.votes = std::move(result.votes);
  separateRemainder(objects, fewest);
  putBack(strays, 0, objects.object_of_point);
  putBack(strays, 0, objects.structure_of_point);
  if (objects.votes.class_count > 0)
    putBack(strays, 0, objects.votes.voxel_of_point);
  return objects;
}

} // namespace

RoomObjects
roomObjectsBy(const SegmentDistinct& segment,
              RoomPoints room,
              std::size_t fewest,
              const VoxelVoter& voter)
{
  requireSizes(room);
  const auto places =
      room.given.empty() ? placesOfCopies(room.positions) : std::nullopt;
  if (!places)
    return objectsOf(segment, std::move(room), fewest, voter);
  room.positions = places->once(room.positions);
  room.normals = places->least(room.normals);
  auto objects = objectsOf(segment, std::move(room), fewest, voter);
  objects.object_of_point = places->forAll(objects.object_of_point);
  objects.structure_of_point = places->forAll(objects.structure_of_point);
  objects.votes.voxel_of_point = places->forAll(objects.votes.voxel_of_point);
  return objects;
}

RoomObjects
segmentRoomObjects(RoomPoints room,
                   const ObjectSegmentationOptions& options,
                   const VoxelVoter& voter)
{
  const auto segment = [&options](ObjectSegmentationInput input) {
    return segmentDistinct(std::move(input), options);
  };
  return roomObjectsBy(segment, std::move(room), options.fewest_points, voter);
}

void
separateRemainder(RoomObjects& objects, std::size_t fewest)
{
  constexpr auto remainder = static_cast<std::uint32_t>(StructureKind::Remainder);
  auto& object_of_point = objects.object_of_point;
  auto& structure_of_point = objects.structure_of_point;
  std::vector<std::size_t> counts(objects.surfaces.size() + 1, 0);
  for (std::size_t i = 0; i < object_of_point.size(); ++i)
    if (structure_of_point[i] != remainder)
      ++counts[object_of_point[i]];

  std::vector<std::uint32_t> numbers(counts.size(), 0);
  std::vector<ObjectSurface> surfaces;
  for (std::size_t object = 1; object < counts.size(); ++object)
    if (counts[object] >= fewest) {
      surfaces.push_back(std::move(objects.surfaces[object - 1]));
      numbers[object] = static_cast<std::uint32_t>(surfaces.size());
    }
  objects.surfaces = std::move(surfaces);
  for (std::size_t i = 0; i < object_of_point.size(); ++i) {
    const auto number = numbers[object_of_point[i]];
    if (object_of_point[i] > 0 && number == 0)
      structure_of_point[i] = remainder;
    object_of_point[i] = number;
  }
}

std::vector<ObjectMeasures>
measureObjects(const std::vector<Eigen::Vector3f>& positions,
               const std::vector<Eigen::Vector3f>& upright,
               const RoomObjects& objects)
{
  const auto& object_of_point = objects.object_of_point;
  if (positions.size() != object_of_point.size() ||
      upright.size() != object_of_point.size())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        positions.size() << " and " << upright.size()
                                         << " points do not fit objects of "
                                         << object_of_point.size() << " points");
  std::vector<ObjectMeasures> measures(objects.surfaces.size());
  std::vector<std::vector<Eigen::Vector3d>> upright_points(measures.size());
  for (std::size_t i = 0; i < object_of_point.size(); ++i) {
    if (object_of_point[i] == 0)
      continue;
    auto& object = measures[object_of_point[i] - 1];
    const Eigen::Vector3d position = positions[i].cast<double>();
    if (object.point_count++ == 0)
      object.lower = object.upper = position;
    object.lower = object.lower.cwiseMin(position);
    object.upper = object.upper.cwiseMax(position);
    object.centroid += position;
    object.structure = objects.structure_of_point[i];
    upright_points[object_of_point[i] - 1].push_back(upright[i].cast<double>());
  }
  for (std::size_t k = 0; k < measures.size(); ++k) {
    measures[k].upright = uprightBox(upright_points[k]);
    if (measures[k].point_count > 0)
      measures[k].centroid /= static_cast<double>(measures[k].point_count);
  }
  return measures;
}

} // namespace pcl::indoor
