/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/surface_mesh.h"

#include "support/small_scene.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::indoor::tool;
using pcl::indoor::test::SmallScene;

namespace {

Eigen::Vector3d
corner(const SurfaceMesh& mesh, std::size_t index)
{
  return mesh.corners[mesh.triangles[index]].cast<double>();
}

/** Of the triangles that face a way, m^2; triangles that face their normals only. */
double
areaFacing(const SurfaceMesh& mesh, const Eigen::Vector3d& way)
{
  double area = 0.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    const Eigen::Vector3d normal = (corner(mesh, i + 1) - corner(mesh, i))
                                       .cross(corner(mesh, i + 2) - corner(mesh, i));
    EXPECT_GE(normal.dot(mesh.normals[mesh.triangles[i]].cast<double>()), -1e-6);
    if (normal.normalized().dot(way) > 0.999)
      area += 0.5 * normal.norm();
  }
  return area;
}

double
volumeOf(const SurfaceMesh& mesh)
{
  double volume = 0.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
    volume += corner(mesh, i).dot(corner(mesh, i + 1).cross(corner(mesh, i + 2))) / 6.0;
  return volume;
}

} // namespace

TEST(SurfaceMesh, FloorsHaveTheAreaOfTheirRings)
{
  const auto scene = savedScene(SmallScene::json());
  const auto mesh = flatMesh(scene.rooms[1].rings, 1.0);
  EXPECT_NEAR(areaFacing(mesh, Eigen::Vector3d::UnitZ()), 12.0 - 0.25, 1e-4);
  const std::vector<PlanRing> turned = {{{0, 0}, {3, 1}, {2, 4}, {-1, 3}}};
  EXPECT_NEAR(areaFacing(flatMesh(turned, 0.0), Eigen::Vector3d::UnitZ()), 10.0, 1e-4);
  EXPECT_TRUE(flatMesh({}, 0.0).triangles.empty());
}

TEST(SurfaceMesh, RoundColumnsHaveTheVolumeOfTheirOutline)
{
  SavedColumn column;
  column.foot = {5.0, 2.0, 1.0};
  column.size = {0.5, 0.5, 2.5};
  column.is_round = true;
  SurfaceMesh mesh;
  addPrism(mesh, outlineOf(column), 1.0, 3.5);
  const double area = 24 * 0.5 * 0.25 * 0.25 * std::sin(2.0 * M_PI / 24);
  EXPECT_NEAR(volumeOf(mesh), 2.5 * area, 1e-4);
  EXPECT_NEAR(areaFacing(mesh, Eigen::Vector3d::UnitZ()), area, 1e-4);
  EXPECT_NEAR(areaFacing(mesh, -Eigen::Vector3d::UnitZ()), area, 1e-4);
}

TEST(SurfaceMesh, WallsHaveHoles)
{
  const auto scene = savedScene(SmallScene::json());
  EXPECT_NEAR(volumeOf(wallMesh(scene, 0)), 0.2 * (3.0 * 2.5 - 0.9 * 2.0), 1e-4);
  const auto window = wallMesh(scene, 1);
  EXPECT_NEAR(volumeOf(window), 0.1 * (4.0 * 2.5 - 1.2 * 1.0), 1e-4);
  EXPECT_NEAR(areaFacing(window, Eigen::Vector3d::UnitY()), 10.0 - 1.2, 1e-4);
}
