/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "face_evidence.h"
#include "internal/cross.h"
#include "wall_dimensions.h"

#include <pcl/exceptions.h>
#include <pcl/indoor/parallel_for.h>
#include <pcl/model/building_model.h>
#include <pcl/model/model_columns.h>
#include <pcl/model/model_openings.h>
#include <pcl/model/model_walls.h>
#include <pcl/model/wall_holes.h>
#include <pcl/model/wall_image.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::indoor {
namespace {

/** Take what the image of a side shows: its holes, and where the wall is seen. */
void
lookAt(const WallFace& face,
       const PointsOfRooms& points,
       FaceHoles& holes,
       SeenColumns& columns)
{
  constexpr double least_length = 0.4, least_height = 1.0; // metres
  constexpr double behind = 0.5, before = 1.0; // metres: leaves and glass; furniture
  const double height = face.ceiling - face.floor;
  if (!face.is_seen || face.length() < 0.5 * least_length || height < least_height)
    return;
  std::vector<WallPoint> near;
  points.beside({face.begin, face.end, 0.0, behind, before}, face.room, true, near);
  const WallImage image = wallImage(near, face.length(), face.floor, height);
  columns = seenColumns(image);
  if (face.length() >= least_length)
    holes = wallHoles(image, near);
}

/** The walls that those sides make of which enough is seen. */
std::vector<ModelWall>
wallsOf(const std::vector<WallFace>& faces, const std::vector<FaceEvidence>& evidence)
{
  std::vector<WallFace> seen;
  std::vector<double> depths;
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (evidence[i].is_wall) {
      seen.push_back(faces[i]);
      depths.push_back(evidence[i].depth);
    }
  return modelWalls(seen, facePairs(seen), depths);
}

/** Tell each opening its wall: the nearest parallel one of a room that it joins. */
void
giveWalls(BuildingModel& model)
{
  for (ModelOpening& opening : model.openings) {
    opening.wall = model.walls.size();
    double nearest = opening_reach;
    for (std::size_t i = 0; i < model.walls.size(); ++i) {
      const ModelWall& wall = model.walls[i];
      const Eigen::Vector2d way = wall.end - wall.begin;
      const double length = way.norm();
      const auto bounds = [&](std::uint32_t room) {
        return std::binary_search(wall.rooms.begin(), wall.rooms.end(), room);
      };
      if (length == 0.0 || std::abs(way.dot(opening.along)) < 0.95 * length ||
          !bounds(opening.room_a))
        continue;
      const Eigen::Vector2d from = opening.position.head<2>() - wall.begin;
      const double along = from.dot(way) / length;
      const double beside = std::abs(crossOf(from, way)) / length;
      const double distance =
          beside + std::max({0.0, -along, along - length}) +
          (opening.room_b > 0 && !bounds(opening.room_b) ? 0.1 : 0.0);
      if (distance < nearest) {
        nearest = distance;
        opening.wall = i;
      }
    }
  }
}

} // namespace

BuildingModel
buildingModel(const PointsOfRooms& points,
              const std::vector<Room>& rooms,
              const std::vector<RoomOpening>& openings,
              int threads)
{
  BuildingModel model;
  if (rooms.empty())
    return model;
  for (const Room& room : rooms)
    if (room.label > points.roomCount())
      PCL_THROW_EXCEPTION(BadArgumentException,
                          "room " << room.label << ", but the points are of "
                                  << points.roomCount() << " rooms");
  model.faces = wallFaces(rooms, points, threads);
  std::vector<FaceHoles> holes(model.faces.size());
  std::vector<SeenColumns> columns(model.faces.size());
  parallelFor(
      static_cast<std::ptrdiff_t>(holes.size()), threads, 1, [&](std::ptrdiff_t i) {
        lookAt(model.faces[i], points, holes[i], columns[i]);
      });
  const auto pairs = facePairs(model.faces);
  model.openings = modelOpenings(model.faces, pairs, holes, openings);
  model.walls =
      wallsOf(model.faces, faceEvidence(model.faces, columns, holes, model.openings));
  giveWalls(model);
  model.columns = modelColumns(rooms, points);
  return model;
}

} // namespace pcl::indoor
