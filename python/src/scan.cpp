/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "arguments.h"
#include "arrays.h"
#include "bindings.h"
#include "command_line/cloud_options.h"
#include "files/scan_content.h"
#include "listener.h"

#include <pcl/common/io.h> // for getFieldType
#include <pcl/io/scan_file.h>

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace pcl::indoor::python {
namespace {

/** A scan of files, with the options of how tools read them. */
Scan
scanOfFiles(const std::vector<std::string>& paths,
            const std::vector<std::string>& words)
{
  ScanOptions options;
  tool::TableColumns columns;
  tool::StationChoice stations;
  tool::OptionParser parser("load", "");
  tool::addOption(parser, columns);
  tool::addOptions(parser, stations);
  parser.number("-points_at_once", options.points_at_once, "0 = all", "points");
  Arguments(words).readBy(std::move(parser));
  options.columns = columns.names;
  options.stations = stations.file;
  options.ignore_stations = stations.is_ignored;
  return withoutLock([&] { return loadScan(paths, options); });
}

Scan
scanOf(const py::array& points,
       const py::object& normals,
       const py::object& colors,
       const std::array<float, 3>& viewpoint,
       const std::vector<std::string>& words)
{
  auto content = std::make_shared<ScanContent>();
  tool::OptionParser parser("scan_of", "");
  tool::addOptions(parser, content->stations);
  Arguments(words).readBy(std::move(parser));
  auto cloud = cloudOf({points, normals, colors});
  return withoutLock([&] {
    tool::CloudPose pose;
    pose.origin.head<3>() = Eigen::Vector3f(viewpoint.data());
    content->file = tool::withPoints("points", std::move(cloud), pose);
    tool::choose(content->stations, content->file);
    return Scan(std::move(content));
  });
}

/** The points where they lie; the array keeps them. */
py::object
pointsOf(const Scan& scan)
{
  using Points = PointCloud<PointXYZ>::ConstPtr;
  auto owner = std::make_unique<Points>(scan.points());
  if (*owner == nullptr)
    return py::none();
  const auto& points = **owner;
  const py::capsule last(owner.release(),
                         [](void* kept) { delete static_cast<Points*>(kept); });
  return readOnly(py::array(py::dtype::of<float>(),
                            {points.size(), std::size_t(3)},
                            {sizeof(PointXYZ), sizeof(float)},
                            points.points.data(),
                            last));
}

/** As numpy names it: "u8" are integers without a sign, of 8 bytes. */
py::dtype
typeOf(const PCLPointField& field)
{
  const auto letter = std::tolower(getFieldType(field.datatype));
  return py::dtype(static_cast<char>(letter) +
                   std::to_string(getFieldSize(field.datatype)));
}

/** Every field where it lies; the arrays keep the scan. */
py::dict
fieldsOf(const py::object& self)
{
  const auto& cloud = self.cast<const Scan&>().cloud();
  const std::size_t count = cloud.data.size() / std::max(1u, cloud.point_step);
  py::dict fields;
  for (const auto& field : cloud.fields) {
    const auto type = typeOf(field);
    const auto value_size = static_cast<std::size_t>(type.itemsize());
    std::vector<std::size_t> shape = {count}, strides = {cloud.point_step};
    if (field.count > 1) {
      shape.push_back(field.count);
      strides.push_back(value_size);
    }
    fields[py::str(field.name)] = readOnly(
        py::array(type, shape, strides, cloud.data.data() + field.offset, self));
  }
  return fields;
}

py::object
normalsOf(const Scan& scan)
{
  const auto& file = scan.content().file;
  if (!file.has_normals || scan.isReadInParts())
    return py::none();
  const auto normals = withoutLock([&] { return tool::readNormals(file); });
  py::array_t<float> array({normals->size(), std::size_t(3)});
  auto values = array.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < values.shape(0); ++i)
    for (int k = 0; k < 3; ++k)
      values(i, k) = (*normals)[static_cast<std::size_t>(i)].normal[k];
  return array;
}

py::object
colorsOf(const Scan& scan)
{
  const auto& file = scan.content().file;
  const bool has_colors =
      tool::hasField(file.cloud, "rgb") || tool::hasField(file.cloud, "rgba");
  if (!has_colors || scan.isReadInParts())
    return py::none();
  const auto colors = withoutLock([&] { return tool::readColors(file); });
  py::array_t<std::uint8_t> array({colors->size(), std::size_t(3)});
  auto values = array.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < values.shape(0); ++i) {
    const auto& color = (*colors)[static_cast<std::size_t>(i)];
    values(i, 0) = color.r;
    values(i, 1) = color.g;
    values(i, 2) = color.b;
  }
  return array;
}

} // namespace

void
bindScan(py::module_& module)
{
  py::class_<Scan>(module, "Scan", "A scan in memory, as its files have it.")
      .def_property_readonly(
          "name", &Scan::name, "Name of the file; of arrays \"points\".")
      .def_property_readonly("points",
                             &pointsOf,
                             "N x 3, float32, read-only, no copy: each coordinate "
                             "minus offset; NaN where one "
                             "is not finite. None of a scan that is read in parts.")
      .def_property_readonly(
          "offset",
          &Scan::offset,
          "Three float64: what to add to points to get the coordinates of the file.")
      .def_property_readonly("fields",
                             &fieldsOf,
                             "Every field of the file by its name, one value per "
                             "point, read-only, no copy.")
      .def_property_readonly("normals",
                             &normalsOf,
                             "N x 3, float32; None if there are none that can be used.")
      .def_property_readonly(
          "colors", &colorsOf, "N x 3, uint8; None if there are none.")
      .def_property_readonly(
          "stations",
          [](const Scan& scan) {
            py::list stations;
            for (const auto& station : scan.stations())
              stations.append(py::make_tuple(station.name, station.position));
            return stations;
          },
          "Where the scanner stood: name and position, None if the file does not tell.")
      .def_property_readonly(
          "notes",
          &Scan::notes,
          "What was odd in the file and how it was taken, a line each.")
      .def_property_readonly("is_read_in_parts",
                             &Scan::isReadInParts,
                             "Has it more points than are read at once?")
      .def("__len__", &Scan::pointCount);
  module.def("load", &scanOfFiles);
  module.def("scan_of", &scanOf);
}

} // namespace pcl::indoor::python
