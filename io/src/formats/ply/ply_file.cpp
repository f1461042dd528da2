/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/ply/ply_file.h"

#include "files/field_value.h"
#include "files/record_stream.h"
#include "files/tool_error.h"
#include "files/usual_fields.h" // for nameFields
#include "formats/file_header.h"
#include "formats/ply/ply_body.h"
#include "formats/ply/ply_header.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <vector>

namespace pcl::indoor::tool {
namespace {

/** How many values a list has: not more than can follow. */
std::uint64_t
listLength(PlyBody& body, const PlyProperty& property, const std::string& path)
{
  const auto type = property.list_type;
  if (type == PCLPointField::FLOAT32 || type == PCLPointField::FLOAT64)
    throw ToolError(path +
                    ": the length of a list in the header is not a whole number");
  std::uint8_t bytes[8] = {};
  body.read(type, bytes);
  const double length = valueAt(bytes, type);
  if (length < 0.0)
    throw ToolError(path + ": the file is damaged, a list has " +
                    std::to_string(static_cast<int>(length)) + " values");
  if (length > static_cast<double>(body.left()))
    body.throwEnd();
  return static_cast<std::uint64_t>(length);
}

/** Reads a property's value, of a list the last one. */
void
readProperty(PlyBody& body,
             const PlyProperty& property,
             const std::string& path,
             std::uint8_t* out)
{
  const std::uint64_t length =
      property.list_type == 0 ? 1 : listLength(body, property, path);
  for (std::uint64_t i = 0; i < length; ++i)
    body.read(property.type, out);
}

/** Adds a field for each property that is no list.
 * \return where the value of each property goes in a point; of a list, nowhere */
std::vector<std::optional<std::size_t>>
layOut(const PlyElement& vertex, PCLPointCloud2& cloud)
{
  std::vector<std::optional<std::size_t>> targets;
  for (const auto& property : vertex.properties) {
    targets.emplace_back();
    if (property.list_type != 0)
      continue;
    targets.back() = appendTo(cloud, property.name, property.type);
  }
  return targets;
}

void
readVertices(PlyBody& body,
             const PlyElement& vertex,
             const std::string& path,
             PCLPointCloud2& cloud)
{
  if (vertex.count == 0)
    throw ToolError(path + ": the cloud is empty (0 points)");
  if (vertex.properties.empty())
    throw ToolError(path + ": the points have no properties");
  const auto targets = layOut(vertex, cloud);
  std::uint64_t least_bytes =
      0; // of a point in the file: a letter and a gap, or its binary size
  for (const auto& property : vertex.properties)
    least_bytes += body.isAscii()            ? 2
                   : property.list_type == 0 ? plyTypeSize(property.type)
                                             : 1;
  if (vertex.count * least_bytes > body.left() + 1)
    throwTruncated(
        path, vertex.count * least_bytes, body.left(), "bytes of points at least");
  cloud.width = static_cast<std::uint32_t>(vertex.count);
  cloud.height = 1;
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.data.assign(static_cast<std::size_t>(cloud.width) * cloud.point_step, 0);
  std::uint8_t value[8] = {};
  for (std::size_t i = 0; i < cloud.width; ++i)
    for (std::size_t p = 0; p < targets.size(); ++p) {
      readProperty(body, vertex.properties[p], path, value);
      if (targets[p])
        std::memcpy(&cloud.data[i * cloud.point_step + *targets[p]],
                    value,
                    plyTypeSize(vertex.properties[p].type));
    }
}

/** The pose that PCL's writer puts into an element "camera", and the rows of the cloud
 * if they fit its points. */
void
readCamera(PlyBody& body,
           const PlyElement& camera,
           const std::string& path,
           PCLPointCloud2& cloud,
           CloudPose& pose)
{
  std::map<std::string, float> values;
  std::map<std::string, std::uint32_t> counts;
  for (const auto& property : camera.properties) {
    std::uint8_t bytes[8] = {};
    readProperty(body, property, path, bytes);
    if (property.type == PCLPointField::FLOAT32)
      std::memcpy(&values[property.name], bytes, sizeof(float));
    else if (property.type == PCLPointField::INT32)
      std::memcpy(&counts[property.name], bytes, sizeof(std::uint32_t));
  }
  const std::uint64_t columns = counts["viewportx"], rows = counts["viewporty"];
  if (columns * rows == static_cast<std::uint64_t>(cloud.width) * cloud.height &&
      rows > 0) {
    cloud.width = counts["viewportx"];
    cloud.height = counts["viewporty"];
    cloud.row_step = cloud.width * cloud.point_step;
  }
  Eigen::Matrix3f rotation;
  for (int row = 0; row < 3; ++row) {
    const std::string letter(1, "xyz"[row]);
    pose.origin[row] = values["view_p" + letter];
    for (int column = 0; column < 3; ++column) // PCL writes the axes as rows
      rotation(row, column) =
          values[std::string(1, "xyz"[row]) + "_axis" + "xyz"[column]];
  }
  if (rotation.isUnitary(1e-3f))
    pose.orientation = Eigen::Quaternionf(rotation);
}

void
skip(PlyBody& body, const PlyElement& element, const std::string& path)
{
  std::uint8_t value[8] = {};
  if (element.properties.empty())
    return;
  for (std::uint64_t i = 0; i < element.count; ++i)
    for (const auto& property : element.properties)
      readProperty(body, property, path, value);
}

/** What the header says of a PLY file, and what follows it. */
struct PlyFile {
  std::vector<PlyElement> elements;
  PlyBody body;
  Eigen::Vector3d offset; ///< see FileHeader
};

PlyFile
readWhole(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  const auto header = readFileHeader(stream, "end_header", path);
  const auto encoding = encodingOf(header, path);
  return {
      elementsOf(header, path),
      PlyBody(std::string(std::istreambuf_iterator<char>(stream), {}), encoding, path),
      header.offset};
}

/** One element of points, whose size is fixed, and at most a camera behind it. */
bool
areRecords(const std::vector<PlyElement>& elements)
{
  if (elements.empty() || elements.size() > 2 || elements[0].name != "vertex" ||
      elements[0].count == 0 || elements[0].properties.empty() ||
      (elements.size() == 2 && elements[1].name != "camera"))
    return false;
  const auto& properties = elements[0].properties;
  return std::all_of(properties.begin(), properties.end(), [](const PlyProperty& p) {
    return p.list_type == 0;
  });
}

bool
isFaceList(const PlyProperty& property)
{
  return property.list_type != 0 &&
         (property.name == "vertex_indices" || property.name == "vertex_index");
}

bool
hasFaces(const PlyElement& element)
{
  return element.name == "face" && element.count > 0 &&
         std::any_of(element.properties.begin(), element.properties.end(), isFaceList);
}

/** The vertices of the next face; its other properties are left out. A number that is
 * no vertex of any file stays none. */
std::vector<std::uint32_t>
readFace(PlyBody& body, const PlyElement& element, const std::string& path)
{
  constexpr std::uint32_t no_vertex = 0xffffffff;
  std::vector<std::uint32_t> face;
  std::uint8_t value[8] = {};
  for (const auto& property : element.properties) {
    if (!isFaceList(property)) {
      readProperty(body, property, path, value);
      continue;
    }
    face.resize(listLength(body, property, path));
    for (auto& index : face) {
      body.read(property.type, value);
      const double number = valueAt(value, property.type);
      index = number >= 0.0 && number < no_vertex ? static_cast<std::uint32_t>(number)
                                                  : no_vertex;
    }
  }
  return face;
}

} // namespace

bool
isPly(const std::string& /*path*/, const std::string& beginning)
{
  const auto words =
      wordsOf(beginning.substr(0, std::min<std::size_t>(64, beginning.find('\n'))));
  return !words.empty() && words[0] == "ply";
}

std::uint64_t
plyPointCount(const std::string& path, const std::string& /*beginning*/)
{
  std::ifstream stream(path, std::ios::binary);
  for (const auto& words : readFileHeader(stream, "end_header", path).lines)
    if (words.size() == 3 && words[0] == "element" && words[1] == "vertex")
      return headerCount(words[2], words[0], path);
  return 0;
}

std::unique_ptr<CloudStream>
openPly(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  const auto header = readFileHeader(stream, "end_header", path);
  const auto elements = elementsOf(header, path);
  const auto encoding = encodingOf(header, path);
  if (encoding == PlyBody::Encoding::Ascii || !areRecords(elements))
    return nullptr;
  const auto& vertex = elements[0];
  CloudRecords records;
  records.pose.offset = header.offset;
  records.body_begin = header.body_begin;
  for (const auto& property : vertex.properties)
    records.record_size += plyTypeSize(property.type);
  records.points = [vertex, encoding, path](std::string bytes, std::size_t count) {
    PCLPointCloud2 cloud;
    PlyBody body(std::move(bytes), encoding, path);
    auto part = vertex;
    part.count = count;
    readVertices(body, part, path, cloud);
    return cloud;
  };
  layOut(vertex, records.layout);
  records.layout.width = static_cast<std::uint32_t>(vertex.count);
  records.layout.height = 1;
  if (elements.size() == 2 && elements[1].count == 1) {
    stream.seekg(static_cast<std::streamoff>(header.body_begin +
                                             vertex.count * records.record_size));
    PlyBody body(
        std::string(std::istreambuf_iterator<char>(stream), {}), encoding, path);
    readCamera(body, elements[1], path, records.layout, records.pose);
  }
  return recordStream(path, std::move(records));
}

void
loadPly(CloudFile& file, const TableColumns& /*columns*/)
{
  auto [elements, body, offset] = readWhole(file.path);
  bool found = false;
  const auto wanted = [](const PlyElement& element) {
    return element.name == "vertex" || element.name == "camera";
  };
  for (auto element = elements.begin();
       std::any_of(element, elements.end(), wanted); // nothing else is needed
       ++element) {
    if (element->name == "vertex" && !found) {
      readVertices(body, *element, file.path, file.cloud);
      found = true;
    }
    else if (element->name == "camera" && element->count == 1)
      readCamera(body, *element, file.path, file.cloud, file.pose);
    else
      skip(body, *element, file.path);
  }
  if (!found)
    throw ToolError(file.path + ": the file has no points (no element vertex)");
  file.pose.offset = offset;
  nameFields(file);
}

bool
hasPlyFaces(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::string first(3, ' ');
  stream.read(first.data(), 3);
  if (first != "ply")
    return false;
  stream.seekg(0);
  const auto elements = elementsOf(readFileHeader(stream, "end_header", path), path);
  return std::any_of(elements.begin(), elements.end(), hasFaces);
}

std::vector<std::vector<std::uint32_t>>
readPlyFaces(const std::string& path)
{
  if (!hasPlyFaces(path))
    return {};
  auto [elements, body, offset] = readWhole(path);
  std::vector<std::vector<std::uint32_t>> faces;
  for (const auto& element : elements) {
    if (!hasFaces(element)) {
      skip(body, element, path);
      continue;
    }
    for (std::uint64_t k = 0; k < element.count; ++k)
      faces.push_back(readFace(body, element, path));
    break;
  }
  return faces;
}

} // namespace pcl::indoor::tool
