/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/sampled_surface.h"

#include "files/placed_points.h"
#include "formats/mesh_file.h"
#include "formats/packed_file.h"
#include "formats/ply/ply_file.h"
#include "text/printable.h" // for shortText

#include <pcl/conversions.h>
#include <pcl/exceptions.h>

#include <Eigen/Geometry> // for cross

#include <algorithm>
#include <cmath>

namespace pcl::indoor::tool {
namespace {

constexpr double spacing = 0.02;            // metres: five per voxel of the rooms
constexpr double covered_spacing = 0.1;     // metres: a voxel of the rooms
constexpr std::size_t least_drawn = 100000; // also of a chair
constexpr std::size_t most_drawn = 2000000; // also in millimetres; 0.8 GB of memory

/** The area of each triangle, 0 where it is not finite. */
std::vector<double>
areasOf(const Mesh& mesh)
{
  std::vector<double> areas;
  areas.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d origin = mesh.vertices[a].cast<double>();
    const Eigen::Vector3d first = mesh.vertices[b].cast<double>() - origin;
    const Eigen::Vector3d second = mesh.vertices[c].cast<double>() - origin;
    const double area = 0.5 * first.cross(second).norm();
    areas.push_back(std::isfinite(area) ? area : 0.0);
  }
  return areas;
}

double
sumOf(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
    sum += value;
  return sum;
}

/** As many triangles as would have the area if all were as large as where a point of
 * the surface typically lies: a few large ones count, many small ones do not. */
double
effectiveCount(const std::vector<double>& areas)
{
  double squares = 0.0;
  for (const double area : areas)
    squares += area * area;
  const double sum = sumOf(areas);
  return squares > 0.0 ? sum * sum / squares : 0.0;
}

/** Do the faces have an area that the vertices do not cover? */
bool
isSparse(const Mesh& mesh)
{
  constexpr double triangles_per_vertex = 2.0; // of any large closed mesh
  const double sparser = std::pow(spacing / covered_spacing, 2);
  const double vertices = effectiveCount(areasOf(mesh)) / triangles_per_vertex;
  return vertices > 0.0 &&
         vertices <= sparser * static_cast<double>(surfacePointCount(mesh));
}

std::string
noteOf(const Mesh& mesh, std::size_t count)
{
  const auto apart =
      shortText(std::sqrt(sumOf(areasOf(mesh)) / static_cast<double>(count)), 2);
  return "is a mesh of " + std::to_string(mesh.triangles.size()) +
         (mesh.triangles.size() == 1 ? " triangle: " : " triangles: ") +
         std::to_string(count) + " points are drawn on them, about " + apart +
         " units apart; colours and all else of its vertices are left out";
}

} // namespace

std::size_t
surfacePointCount(const Mesh& mesh)
{
  const double wanted = sumOf(areasOf(mesh)) / (spacing * spacing);
  return static_cast<std::size_t>(std::clamp(
      wanted, static_cast<double>(least_drawn), static_cast<double>(most_drawn)));
}

void
drawPoints(const Mesh& mesh, CloudFile& file)
{
  constexpr std::uint32_t seed = 1; // the same file gives the same points
  PointCloud<PointXYZ> points;
  const auto add = [&points](const Eigen::Vector3f& p) {
    points.emplace_back(p.x(), p.y(), p.z());
  };
  if (mesh.triangles.empty()) {
    std::for_each(mesh.vertices.begin(), mesh.vertices.end(), add);
    file.notes.emplace_back("has no faces: its vertices are the points");
  }
  else {
    const auto count = surfacePointCount(mesh);
    try {
      for (const auto& drawn : sampleMesh(mesh, count, seed))
        add(drawn.position);
    } catch (const BadArgumentException&) { // its triangles are within its vertices
      throw ToolError(file.path + ": no face of the mesh has an area");
    }
    file.notes.push_back(noteOf(mesh, count));
  }
  toPCLPointCloud2(points, file.cloud);
  file.pose.offset = mesh.offset;
  if (mesh.y_is_up)
    file.notes.emplace_back("its y axis points up, as its format has it");
}

void
loadMesh(CloudFile& file, const TableColumns& /*columns*/)
{
  drawPoints(readMesh(file.path), file);
}

CloudFile
loadSurface(const std::string& path,
            const TableColumns& columns,
            std::size_t least_points)
{
  if (isPacked(path))
    return loadUnpacked(path, [&](const std::string& file) {
      return loadSurface(file, columns, least_points);
    });
  auto file = loadCloud(path, columns, least_points);
  if (file.points->size() >= most_drawn || !hasPlyFaces(path))
    return file;
  auto mesh = plyMesh(file);
  if (!isSparse(mesh))
    return file;
  mesh.offset = file.offset;
  CloudFile drawn;
  drawn.path = path;
  drawn.notes = file.notes;
  const auto of_vertices = copiesNote(file.copy_count, file.finite_count);
  drawn.notes.erase(std::remove(drawn.notes.begin(), drawn.notes.end(), of_vertices),
                    drawn.notes.end());
  drawPoints(mesh, drawn);
  return withPoints(
      path, std::move(drawn.cloud), drawn.pose, least_points, drawn.notes);
}

} // namespace pcl::indoor::tool
