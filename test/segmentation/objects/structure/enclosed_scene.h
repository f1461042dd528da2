/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "support/labelled_points.h"

#include "objects/structure/enclosed_structure.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace pcl::indoor {
namespace test {

constexpr double enclosed_voxel_size = 0.03;
constexpr float spacing = 0.015f, noise = 0.002f;
constexpr std::uint32_t furniture = 4;
using Box = Eigen::AlignedBox3f;
using Labels = std::vector<std::uint32_t>;
enum Face { left = 1, right = 2, front = 4, back = 8, top = 16, bottom = 32 };
constexpr int tube = left | right | top | bottom; // open in front and behind

/** A corner of a room: floor (1), a wall (2) along y and one (3) along x; objects have
 * the numbers from 4. */
struct EnclosedScene {
  LabelledPoints labelled;
  std::vector<StructurePlane> planes;
  std::mt19937 rng{3};

  /** \param[in] askew how far the first wall is turned, out of the corner */
  explicit EnclosedScene(const Eigen::Matrix3f& askew = Eigen::Matrix3f::Identity())
  {
    const Eigen::Vector3f o(0, 0, 0), x(2, 0, 0), y(0, 2, 0), z(0, 0, 2);
    addPlane(o, x, y, {0, 0, 1});
    addPlane(o, askew * y, z, askew.col(0));
    addPlane(o, x, z, {0, 1, 0});
  }

  void
  addPlane(const Eigen::Vector3f& corner,
           const Eigen::Vector3f& u,
           const Eigen::Vector3f& v,
           const Eigen::Vector3f& normal)
  {
    planes.push_back({normal.cast<double>(), normal.dot(corner), {}});
    const auto number = static_cast<std::uint32_t>(planes.size());
    labelled.addRectangle(corner, u, v, normal, number, spacing, noise, rng);
  }

  /** Some faces of a box. */
  void
  addFaces(const Box& box, int faces, std::uint32_t object = furniture)
  {
    const Eigen::Vector3f low = box.min(), size = box.sizes();
    for (int axis = 0; axis < 3; ++axis)
      for (const float sign : {-1.0f, 1.0f}) {
        constexpr int face_of[3][2] = {{left, right}, {back, front}, {bottom, top}};
        if (!(faces & face_of[axis][sign > 0]))
          continue;
        const auto edge = [&](int along) {
          return Eigen::Vector3f(size[along % 3] * Eigen::Vector3f::Unit(along % 3));
        };
        Eigen::Vector3f corner = low;
        if (sign > 0)
          corner += edge(axis);
        labelled.addRectangle(corner,
                              edge(axis + 1),
                              edge(axis + 2),
                              sign * Eigen::Vector3f::Unit(axis),
                              object,
                              spacing,
                              noise,
                              rng);
      }
  }

  void
  turn(const Eigen::Matrix3f& rotation)
  {
    labelled.turn(rotation);
    for (auto& plane : planes)
      plane.normal = rotation.cast<double>() * plane.normal;
  }

  void
  move(const Eigen::Vector3f& shift)
  {
    for (auto& point : labelled.points)
      point += shift;
    for (auto& plane : planes)
      plane.offset += plane.normal.dot(shift.cast<double>());
  }

  bool
  isOfPlane(std::size_t point) const
  {
    return labelled.objects[point] <= planes.size();
  }

  /** The segments after planes have yielded; before, those are the objects. */
  Labels
  yielded(std::size_t* count = nullptr) const
  {
    ObjectScene scene;
    scene.points = labelled.points;
    scene.planes = planes;
    scene.voxel_size = enclosed_voxel_size;
    Labels plane_of_point;
    for (std::size_t i = 0; i < labelled.points.size(); ++i)
      plane_of_point.push_back(isOfPlane(i) ? labelled.objects[i] : 0);
    scene.voxels = separateVoxels(
        labelled.points, plane_of_point, enclosed_voxel_size, scene.plane_of_voxel);
    estimateNormals(labelled.points, scene.voxels, 1);
    auto segments = labelled.objects;
    const auto changed = yieldEnclosed(scene, segments);
    std::size_t different = 0;
    for (std::size_t i = 0; i < segments.size(); ++i)
      different += segments[i] != labelled.objects[i];
    EXPECT_EQ(changed, different);
    if (count)
      *count = changed;
    return segments;
  }
};

inline Box
boxAt(const Eigen::Vector3f& low, const Eigen::Vector3f& size)
{
  return Box(low, low + size);
}

inline Box
widened(const Box& box, double by)
{
  const Eigen::Vector3f margin = Eigen::Vector3f::Constant(static_cast<float>(by));
  return Box(box.min() - margin, box.max() + margin);
}

inline Eigen::Matrix3f
aboutZ(float degrees)
{
  const float angle = degrees * static_cast<float>(M_PI) / 180;
  return Eigen::AngleAxisf(angle, Eigen::Vector3f::UnitZ()).toRotationMatrix();
}

} // namespace test
} // namespace pcl::indoor
