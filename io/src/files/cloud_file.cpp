/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cloud_file.h"

#include "files/cloud_formats.h"
#include "files/coordinate_step.h"
#include "files/field_value.h"
#include "files/placed_points.h"
#include "files/scan_files.h"
#include "text/printable.h"

#include <pcl/common/io.h> // for getFieldIndex
#include <pcl/indoor/quantile.h>
#include <pcl/indoor/usable_point.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace pcl::indoor::tool {
namespace {

constexpr const char* axes[] = {"x", "y", "z"};

std::size_t
pointCount(const PCLPointCloud2& cloud)
{
  return static_cast<std::size_t>(cloud.width) * cloud.height;
}

std::vector<double>
readReals(const PCLPointCloud2& cloud, const std::string& name)
{
  const auto& field = cloud.fields[getFieldIndex(cloud, name)];
  std::vector<double> values(pointCount(cloud));
  const std::uint8_t* bytes = cloud.data.data() + field.offset;
  for (auto& value : values) {
    value = valueAt(bytes, field.datatype);
    bytes += cloud.point_step;
  }
  return values;
}

/** Large coordinates lose their millimetres in a float: choose what to subtract, the
 * same for any order of points. */
double
offsetOf(const std::vector<double>& values)
{
  constexpr double large = 1000.0; // metres; below, a float resolves 0.06 mm
  std::vector<double> finite;
  finite.reserve(values.size());
  for (const double value : values)
    if (std::isfinite(value))
      finite.push_back(value);
  if (finite.empty())
    return 0.0;
  const double middle = median(finite); // outliers do not move it
  return std::abs(middle) > large ? std::floor(middle) : 0.0;
}

/** The distance between two values of a field that are as large as this one. */
double
stepAt(const PCLPointCloud2& cloud, const std::string& name, double value)
{
  const double size = std::abs(value);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (cloud.fields[getFieldIndex(cloud, name)].datatype == PCLPointField::FLOAT64)
    return std::nextafter(size, infinity) - size;
  const auto real = static_cast<float>(size);
  return std::nextafter(real, std::numeric_limits<float>::infinity()) - real;
}

void
fillPoints(CloudFile& file)
{
  const auto placed = placedPoints(file.cloud, file.cloud.height > 1);
  const auto& origin = placed.origin;
  file.coordinate_step = origin.step;
  file.offset = file.pose.offset + origin.middle;
  file.finite_count = placed.finite_count;
  file.copy_count = placed.copy_count;
  file.left_out = placed.left_out;
  std::vector<std::uint64_t> counts;
  for (const auto& place : file.left_out)
    counts.push_back(countAt(file.cloud, place));
  for (const auto& line : leftOutNotes(file.left_out, counts, pointCount(file.cloud)))
    file.notes.push_back(line);
  const auto note = copiesNote(file.copy_count, file.finite_count);
  if (!note.empty())
    file.notes.push_back(note);
  const auto& points = placed.points;
  points->sensor_origin_ = file.pose.origin;
  points->sensor_origin_.head<3>() =
      (file.pose.origin.head<3>().cast<double>() - origin.middle).cast<float>();
  points->sensor_orientation_ = file.pose.orientation;
  file.points = points;
}

} // namespace

void
printNotes(const CloudFile& file)
{
  for (const auto& note : file.notes)
    printWarning(file.path + ": " + note);
}

bool
isRealField(const PCLPointCloud2& cloud, const std::string& name)
{
  const int index = getFieldIndex(cloud, name);
  if (index < 0)
    return false;
  const auto type = cloud.fields[index].datatype;
  return type == PCLPointField::FLOAT32 || type == PCLPointField::FLOAT64;
}

bool
hasNormals(const PCLPointCloud2& cloud)
{
  return isRealField(cloud, "normal_x") && isRealField(cloud, "normal_y") &&
         isRealField(cloud, "normal_z");
}

CoordinateOrigin
coordinateOrigin(const PCLPointCloud2& cloud)
{
  CoordinateOrigin origin;
  for (int axis = 0; axis < 3; ++axis) {
    const auto values = readReals(cloud, axes[axis]);
    origin.middle[axis] = offsetOf(values);
    origin.step = std::max(origin.step, commonStep(values));
    if (origin.middle[axis] != 0.0)
      origin.step =
          std::max(origin.step, stepAt(cloud, axes[axis], origin.middle[axis]));
  }
  return origin;
}

bool
isOneOf(const Eigen::Vector3d& point, const std::vector<Eigen::Vector3d>& places)
{
  return std::find(places.begin(), places.end(), point) != places.end();
}

CloudPlaces::CloudPlaces(const PCLPointCloud2& cloud)
: cloud_(&cloud)
{
  for (int axis = 0; axis < 3; ++axis)
    fields_[axis] = getFieldIndex(cloud, axes[axis]);
}

std::size_t
CloudPlaces::size() const
{
  return pointCount(*cloud_);
}

Eigen::Vector3d
CloudPlaces::at(std::size_t point) const
{
  Eigen::Vector3d place;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& field = cloud_->fields[fields_[axis]];
    place[axis] = valueAt(&cloud_->data[point * cloud_->point_step + field.offset],
                          field.datatype);
  }
  return place;
}

PointCloud<PointXYZ>::Ptr
pointsAround(const PCLPointCloud2& cloud,
             const Eigen::Vector3d& middle,
             std::size_t& finite_count,
             const std::vector<Eigen::Vector3d>& left_out)
{
  const std::vector<double> coordinates[3] = {
      readReals(cloud, axes[0]), readReals(cloud, axes[1]), readReals(cloud, axes[2])};
  auto points = pcl::make_shared<PointCloud<PointXYZ>>();
  points->header.frame_id = cloud.header.frame_id;
  points->resize(pointCount(cloud), PointXYZ(NAN, NAN, NAN));
  points->width = cloud.width; // resize() made it one row
  points->height = cloud.height;
  finite_count = 0;
  for (std::size_t i = 0; i < points->size(); ++i) {
    const Eigen::Vector3d point(
        coordinates[0][i], coordinates[1][i], coordinates[2][i]);
    const Eigen::Vector3f local = (point - middle).cast<float>();
    if (!isUsable(local) || isOneOf(point, left_out))
      continue;
    (*points)[i].getVector3fMap() = local;
    ++finite_count;
  }
  points->is_dense = finite_count == points->size();
  return points;
}

CloudFile
loadUnpacked(const std::string& path,
             const std::function<CloudFile(const std::string& file)>& load)
{
  ScanFiles files{{path}, {}};
  const auto unpacked = unpackScans(files);
  if (files.paths.size() != 1)
    throw ToolError(path + ": there are " + std::to_string(files.paths.size()) +
                    " scans in it; unpack it and give one of them");
  auto file = load(files.paths[0]);
  file.path = path;
  file.notes.insert(file.notes.begin(), files.notes.begin(), files.notes.end());
  return file;
}

CloudFile
loadCloud(const std::string& path,
          const TableColumns& columns,
          std::size_t least_points)
{
  if (isPacked(path))
    return loadUnpacked(path, [&](const std::string& file) {
      return loadCloud(file, columns, least_points);
    });
  CloudFile file;
  file.path = path;
  readCloud(file, columns);
  auto loaded =
      withPoints(path, std::move(file.cloud), file.pose, least_points, file.notes);
  loaded.stations = std::move(file.stations);
  return loaded;
}

CloudFile
withPoints(const std::string& path,
           PCLPointCloud2 cloud,
           const CloudPose& pose,
           std::size_t least_points,
           std::vector<std::string> notes)
{
  CloudFile file;
  file.notes = std::move(notes);
  file.path = path;
  file.cloud = std::move(cloud);
  file.pose = pose;
  for (const char* name : axes)
    if (!isRealField(file.cloud, name))
      throw ToolError(
          path + ": the file has no floating-point field '" + name + "', " +
          (file.cloud.fields.empty()
               ? "nor any other"
               : "its fields are: " + printable(getFieldsList(file.cloud))));
  if (pointCount(file.cloud) == 0)
    throw ToolError(path + ": the cloud is empty (0 points)");
  if (file.cloud.data.size() < pointCount(file.cloud) * file.cloud.point_step)
    throw ToolError(path + ": the file is damaged, points are missing");
  fillPoints(file);
  if (file.finite_count == 0)
    throw ToolError(path + ": none of its " + std::to_string(file.points->size()) +
                    " points is finite and less than 1e9 units from their middle");
  if (file.finite_count < least_points)
    throw ToolError(path + ": " + std::to_string(file.finite_count) +
                    " finite points are too few, " + std::to_string(least_points) +
                    " are needed");
  if (hasNormals(file.cloud)) {
    const auto note = normalsNote(file.cloud, *file.points);
    file.has_normals = note.empty();
    if (!note.empty())
      file.notes.push_back(note);
  }
  return file;
}

PointCloud<Normal>::Ptr
readNormals(const CloudFile& file)
{
  if (!file.has_normals)
    throw ToolError(file.path + ": the file has no normals");
  return readNormals(file.cloud);
}

PointCloud<Normal>::Ptr
readNormals(const PCLPointCloud2& cloud)
{
  const auto x = readReals(cloud, "normal_x");
  const auto y = readReals(cloud, "normal_y");
  const auto z = readReals(cloud, "normal_z");
  std::vector<double> curvature(x.size(), 0.0);
  if (isRealField(cloud, "curvature"))
    curvature = readReals(cloud, "curvature");
  auto normals = pcl::make_shared<PointCloud<Normal>>();
  normals->resize(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    (*normals)[i].getNormalVector3fMap() =
        Eigen::Vector3d(x[i], y[i], z[i]).cast<float>();
    (*normals)[i].curvature = static_cast<float>(curvature[i]);
    normals->is_dense &= (*normals)[i].getNormalVector3fMap().allFinite();
  }
  normals->width = cloud.width;
  normals->height = cloud.height;
  return normals;
}

PointCloud<RGB>::Ptr
readColors(const CloudFile& file)
{
  const auto& cloud = file.cloud;
  const int index = std::max(getFieldIndex(cloud, "rgb"), getFieldIndex(cloud, "rgba"));
  if (index < 0 || getFieldSize(cloud.fields[index].datatype) != sizeof(std::uint32_t))
    throw ToolError(file.path + ": the points have no colours (field rgb)");
  auto colors = pcl::make_shared<PointCloud<RGB>>();
  for (std::size_t i = 0; i < file.points->size(); ++i) {
    std::uint32_t bits = 0;
    std::memcpy(&bits,
                &cloud.data[i * cloud.point_step + cloud.fields[index].offset],
                sizeof(bits));
    colors->push_back(RGB(bits >> 16 & 0xff, bits >> 8 & 0xff, bits & 0xff));
  }
  return colors;
}

bool
hasField(const PCLPointCloud2& cloud, const std::string& name)
{
  return getFieldIndex(cloud, name) >= 0;
}

std::vector<double>
readNumbers(const CloudFile& file, const std::string& name)
{
  if (!hasField(file.cloud, name))
    throw ToolError(file.path + ": the file has no field '" + name + "'");
  return readReals(file.cloud, name);
}

std::vector<std::uint32_t>
readLabels(const CloudFile& file, const std::string& name)
{
  const auto values = readNumbers(file, name);
  std::vector<std::uint32_t> labels(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double value = values[i];
    if (!(value >= 0.0 && value <= 4294967295.0) || value != std::floor(value))
      throw ToolError(file.path + ": field '" + name + "' of point " +
                      std::to_string(i) + " is " + std::to_string(value) +
                      ", not a label");
    labels[i] = static_cast<std::uint32_t>(value);
  }
  return labels;
}

void
removeField(PCLPointCloud2& cloud, const std::string& name)
{
  const auto same_name = [&name](const PCLPointField& f) { return f.name == name; };
  cloud.fields.erase(
      std::remove_if(cloud.fields.begin(), cloud.fields.end(), same_name),
      cloud.fields.end());
}

NewField::NewField(std::string its_name, const std::vector<std::uint32_t>& labels)
: name(std::move(its_name))
, datatype(PCLPointField::UINT32)
, values(labels.data())
, count(labels.size())
{}

NewField::NewField(std::string its_name, const std::vector<float>& reals)
: name(std::move(its_name))
, datatype(PCLPointField::FLOAT32)
, values(reals.data())
, count(reals.size())
{}

void
appendFields(PCLPointCloud2& cloud, const std::vector<NewField>& fields)
{
  constexpr std::size_t size = 4; // bytes of a value
  const auto count = pointCount(cloud);
  const std::size_t old_step = cloud.point_step;
  for (const auto& field : fields)
    if (field.count != count)
      throw ToolError("field '" + field.name + "': " + std::to_string(field.count) +
                      " values for " + std::to_string(count) + " points");
  for (const auto& field : fields) {
    removeField(cloud, field.name);
    appendTo(cloud, field.name, field.datatype);
  }
  cloud.row_step = cloud.point_step * cloud.width;
  const std::size_t new_step = cloud.point_step;
  // in place, from the end; with room for more, which costs nothing before it is used
  if (cloud.data.capacity() < count * new_step)
    cloud.data.reserve(count * (new_step + 4 * size));
  cloud.data.resize(count * new_step);
  for (std::size_t i = count; i-- > 0;) {
    std::uint8_t* value = cloud.data.data() + i * new_step;
    std::memmove(value, cloud.data.data() + i * old_step, old_step);
    value += old_step;
    for (const auto& field : fields) {
      std::memcpy(
          value, static_cast<const std::uint8_t*>(field.values) + i * size, size);
      value += size;
    }
  }
}

} // namespace pcl::indoor::tool
