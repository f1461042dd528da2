/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/object_files.h"

#include "files/cloud_formats.h"
#include "formats/file_ending.h"
#include "formats/mesh_file.h"

#include <pcl/common/centroid.h>
#include <pcl/common/io.h>
#include <pcl/conversions.h>
#include <pcl/exceptions.h>
#include <pcl/features/hough_normals.h>
#include <pcl/features/impl/oriented_points.hpp>
#include <pcl/features/normal_3d.h>
#include <pcl/indoor/first_in_place.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <limits>
#include <numeric>

namespace pcl::indoor::tool {
namespace {

bool
isMesh(const std::string& path)
{
  const auto ending = fileEnding(path);
  return ending == ".off" || ending == ".obj";
}

/** Text files beside objects are lists of them. */
bool
isObject(const std::string& path)
{
  return isMesh(path) || (hasCloudEnding(path) && fileEnding(path) != ".txt");
}

PointCloud<PointNormal>::Ptr
sampledObject(const Mesh& mesh, const std::string& path)
{
  constexpr std::uint32_t seed = 1; // the same file gives the same object
  auto object = pcl::make_shared<PointCloud<PointNormal>>();
  if (mesh.triangles.empty())
    throw ToolError(path + ": the mesh has no faces");
  try {
    for (const auto& drawn : sampleMesh(mesh, mesh_point_count, seed)) {
      PointNormal point;
      point.getVector3fMap() = drawn.position;
      point.getNormalVector3fMap() = drawn.normal;
      object->push_back(point);
    }
  } catch (const BadArgumentException&) { // its triangles are within its vertices
    throw ToolError(path + ": no face of the mesh has an area");
  }
  return object;
}

constexpr const char* floor_field = "floor_distance";

/** \brief A float field of the first point; NaN if there is none. */
float
firstValue(const PCLPointCloud2& cloud, const std::string& name)
{
  for (const auto& field : cloud.fields)
    if (field.name == name && field.datatype == PCLPointField::FLOAT32 &&
        cloud.data.size() >= field.offset + sizeof(float)) {
      float value = 0.0f;
      std::memcpy(&value, cloud.data.data() + field.offset, sizeof(float));
      return value;
    }
  return std::numeric_limits<float>::quiet_NaN();
}

/** \brief Points in one row, since a cloud in rows would be searched by its rows, which
 * miss neighbours. */
struct SearchablePoints {
  PointCloud<PointXYZ>::Ptr points = pcl::make_shared<PointCloud<PointXYZ>>();
  std::vector<std::size_t> place_of_point; ///< where among them each point is
};

/** \brief At most so many of each place as a search finds: where there are thousands,
 * each search would visit all of them. */
SearchablePoints
searchablePoints(const PointCloud<PointXYZ>& cloud, int most)
{
  Indices all(cloud.size());
  std::iota(all.begin(), all.end(), 0);
  const auto first = firstInPlace(cloud, all);
  std::vector<int> copies(cloud.size(), 0);
  SearchablePoints result;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const auto of_place = static_cast<std::size_t>(first[i]);
    const bool is_kept = copies[of_place] < most;
    result.place_of_point.push_back(is_kept ? result.points->size()
                                            : result.place_of_point[of_place]);
    if (!is_kept)
      continue;
    ++copies[of_place];
    result.points->push_back(cloud[i]);
  }
  result.points->is_dense = cloud.is_dense;
  return result;
}

/** \brief Normals that face the middle of the finite points. */
template <typename Estimation>
PointCloud<Normal>
normalsFromMiddle(Estimation& estimation, const PointCloud<PointXYZ>& points)
{
  Eigen::Vector4f centroid;
  compute3DCentroid(points, centroid);
  estimation.setViewPoint(centroid.x(), centroid.y(), centroid.z());
  PointCloud<Normal> normals;
  estimation.compute(normals);
  return normals;
}

void
setNormal(PointNormal& point, const Normal& normal)
{
  point.getNormalVector3fMap() = normal.getNormalVector3fMap();
  point.curvature = normal.curvature;
}

} // namespace

std::vector<std::string>
objectFilesIn(const std::string& folder)
{
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw ToolError(folder + ": no such folder");
  std::vector<std::string> paths;
  for (fs::recursive_directory_iterator entry(folder, error), end; entry != end;
       entry.increment(error)) {
    if (error)
      break;
    if (entry->is_regular_file() && isObject(entry->path().string()))
      paths.push_back(entry->path().lexically_relative(folder).string()); // links stay
  }
  if (error)
    throw ToolError(folder + ": cannot be read: " + error.message());
  if (paths.empty())
    throw ToolError(folder + ": no object in this folder, by its endings: " +
                    cloudEndings() + ", .off, .obj");
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::string
classFolder(const std::string& path)
{
  const auto end = path.find('/');
  return end == std::string::npos ? "" : path.substr(0, end);
}

void
estimateNormals(PointCloud<PointNormal>& cloud, int neighbor_count)
{
  PointCloud<PointXYZ> points;
  copyPointCloud(cloud, points);
  const auto searched = searchablePoints(points, neighbor_count);
  NormalEstimation<PointXYZ, Normal> estimation;
  estimation.setInputCloud(searched.points);
  estimation.setKSearch(neighbor_count);
  const auto normals = normalsFromMiddle(estimation, points);
  for (std::size_t k = 0; k < cloud.size(); ++k)
    setNormal(cloud[k], normals[searched.place_of_point[k]]);
}

void
estimateHoughNormals(PointCloud<PointNormal>& cloud)
{
  const auto points = pcl::make_shared<PointCloud<PointXYZ>>();
  copyPointCloud(cloud, *points);
  HoughNormalEstimation<PointXYZ> estimation(1);
  estimation.setInputCloud(points);
  const auto normals = normalsFromMiddle(estimation, *points);
  for (std::size_t k = 0; k < normals.size(); ++k)
    setNormal(cloud[k], normals[k]);
}

PlacedObject
placedObject(const CloudFile& file, int neighbor_count)
{
  auto object = pcl::make_shared<PointCloud<PointNormal>>();
  copyPointCloud(*file.points, *object);
  object->is_dense = file.finite_count == object->size();
  if (!file.has_normals)
    estimateNormals(*object, neighbor_count);
  else {
    const auto normals = readNormals(file);
    for (std::size_t k = 0; k < object->size(); ++k)
      (*object)[k].getNormalVector3fMap() = (*normals)[k].getNormalVector3fMap();
  }
  return {object, readPlace(file)};
}

PlacedObject
loadPlacedObject(const std::string& path, int neighbor_count)
{
  if (isMesh(path))
    return {sampledObject(readMesh(path), path), {}};
  const auto file = loadCloud(path);
  const auto mesh = plyMesh(file);
  if (!mesh.triangles.empty())
    return {sampledObject(mesh, path), {}};
  if (!file.has_normals && hasNormals(file.cloud))
    printNotes(file);
  return placedObject(file, neighbor_count);
}

PointCloud<PointNormal>::Ptr
loadObject(const std::string& path, int neighbor_count)
{
  return loadPlacedObject(path, neighbor_count).cloud;
}

std::vector<OrientedPoint>
classifierPoints(const PointCloud<PointNormal>& cloud)
{
  Indices all(cloud.size());
  std::iota(all.begin(), all.end(), 0);
  return orientedPoints(cloud, cloud, all);
}

void
saveObject(const std::string& path, const ObjectSurface& object)
{
  PointCloud<PointNormal> points;
  for (const auto& [position, normal] : object.points) {
    PointNormal point;
    point.getVector3fMap() = position;
    point.getNormalVector3fMap() = normal;
    points.push_back(point);
  }
  PCLPointCloud2 cloud;
  toPCLPointCloud2(points, cloud);
  appendRealField(
      cloud, floor_field, std::vector<float>(points.size(), object.floor_distance));
  saveCloud(path, cloud);
}

ObjectPlace
readPlace(const CloudFile& file)
{
  const float distance = firstValue(file.cloud, floor_field);
  return distance >= 0.0f ? ObjectPlace{true, distance} : ObjectPlace();
}

} // namespace pcl::indoor::tool
