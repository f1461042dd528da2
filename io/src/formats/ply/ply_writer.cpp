/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/ply/ply_writer.h"

#include "files/tool_error.h"
#include "formats/file_header.h" // for offsetText

#include <pcl/common/io.h> // for getFieldSize

#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

namespace pcl::indoor::tool {
namespace {

std::string
typeName(const PCLPointField& field, const std::string& path)
{
  static const std::map<int, std::string> names = {{PCLPointField::BOOL, "uchar"},
                                                   {PCLPointField::INT8, "char"},
                                                   {PCLPointField::UINT8, "uchar"},
                                                   {PCLPointField::INT16, "short"},
                                                   {PCLPointField::UINT16, "ushort"},
                                                   {PCLPointField::INT32, "int"},
                                                   {PCLPointField::UINT32, "uint"},
                                                   {PCLPointField::FLOAT32, "float"},
                                                   {PCLPointField::FLOAT64, "double"}};
  const auto found = names.find(field.datatype);
  if (found == names.end())
    throw ToolError(path + ": cannot be written, PLY has no integers of 64 bits for '" +
                    field.name + "'; PCD has");
  return found->second;
}

std::string
propertyName(const std::string& field)
{
  for (const char* letter : {"x", "y", "z"})
    if (field == std::string("normal_") + letter)
      return std::string("n") + letter;
  return field;
}

/** Which bytes of a point a property is. */
struct Property {
  std::string text; ///< of the header
  std::size_t offset = 0;
  std::size_t size = 0;
  std::uint32_t list_length = 0; ///< 0: no list
};

/** A colour is four bytes: blue, green, red, alpha. */
void
addColor(const PCLPointField& field, std::vector<Property>& properties)
{
  properties.push_back({"uchar red", field.offset + 2, 1});
  properties.push_back({"uchar green", field.offset + 1, 1});
  properties.push_back({"uchar blue", field.offset, 1});
  if (field.name == "rgba")
    properties.push_back({"uchar alpha", field.offset + 3, 1});
}

std::vector<Property>
propertiesOf(const PCLPointCloud2& cloud, const std::string& path)
{
  std::vector<Property> properties;
  bool has_color = false;
  for (const auto& field : cloud.fields) {
    if (field.name == "_") // PCL's padding
      continue;
    const auto type = typeName(field, path);
    const auto size = static_cast<std::size_t>(getFieldSize(field.datatype));
    if ((field.name == "rgb" || field.name == "rgba") && size == 4 && !has_color) {
      addColor(field, properties);
      has_color = true;
    }
    else if (field.count > 1)
      properties.push_back({"list uint " + type + " " + propertyName(field.name),
                            field.offset,
                            size * field.count,
                            field.count});
    else
      properties.push_back({type + " " + propertyName(field.name), field.offset, size});
  }
  return properties;
}

template <typename T>
void
append(std::string& bytes, T value)
{
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

/** The names that PCL gives to the pose and, as a viewport, to rows and columns. */
constexpr const char* camera_header =
    "element camera 1\n"
    "property float view_px\nproperty float view_py\nproperty float view_pz\n"
    "property float x_axisx\nproperty float x_axisy\nproperty float x_axisz\n"
    "property float y_axisx\nproperty float y_axisy\nproperty float y_axisz\n"
    "property float z_axisx\nproperty float z_axisy\nproperty float z_axisz\n"
    "property int viewportx\nproperty int viewporty\n";

std::string
cameraBytes(const PCLPointCloud2& cloud, const CloudPose& pose)
{
  std::string bytes;
  for (int axis = 0; axis < 3; ++axis)
    append(bytes, pose.origin[axis]);
  const Eigen::Matrix3f rotation = pose.orientation.toRotationMatrix();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      append(bytes, rotation(row, column));
  append(bytes, static_cast<std::int32_t>(cloud.width));
  append(bytes, static_cast<std::int32_t>(cloud.height));
  return bytes;
}

} // namespace

void
writePly(OutputFile& file,
         const std::string& path,
         const PCLPointCloud2& cloud,
         const CloudPose& pose)
{
  constexpr std::size_t block_size = 1 << 16;
  const auto point_count = static_cast<std::size_t>(cloud.width) * cloud.height;
  const auto properties = propertiesOf(cloud, path);
  std::string block = "ply\nformat binary_little_endian 1.0\n";
  if (!pose.offset.isZero(0.0))
    block += "comment " + offsetText(pose.offset) + "\n";
  block += "element vertex " + std::to_string(point_count) + "\n";
  for (const auto& property : properties)
    block += "property " + property.text + "\n";
  block += camera_header;
  block += "end_header\n";
  for (std::size_t i = 0; i < point_count; ++i) {
    const auto* point =
        reinterpret_cast<const char*>(&cloud.data[i * cloud.point_step]);
    for (const auto& property : properties) {
      if (property.list_length > 0)
        append(block, property.list_length);
      block.append(point + property.offset, property.size);
    }
    if (block.size() >= block_size) {
      file.write(block);
      block.clear();
    }
  }
  file.write(block + cameraBytes(cloud, pose));
}

} // namespace pcl::indoor::tool
