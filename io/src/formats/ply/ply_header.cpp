/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/ply/ply_header.h"

#include "files/tool_error.h"

#include <pcl/PCLPointField.h>

#include <map>

namespace pcl::indoor::tool {
namespace {

std::uint8_t
typeNamed(const std::string& name, const std::string& path)
{
  static const std::map<std::string, std::uint8_t> types = {
      {"char", PCLPointField::INT8},
      {"int8", PCLPointField::INT8},
      {"uchar", PCLPointField::UINT8},
      {"uint8", PCLPointField::UINT8},
      {"short", PCLPointField::INT16},
      {"int16", PCLPointField::INT16},
      {"ushort", PCLPointField::UINT16},
      {"uint16", PCLPointField::UINT16},
      {"int", PCLPointField::INT32},
      {"int32", PCLPointField::INT32},
      {"uint", PCLPointField::UINT32},
      {"uint32", PCLPointField::UINT32},
      {"float", PCLPointField::FLOAT32},
      {"float32", PCLPointField::FLOAT32},
      {"double", PCLPointField::FLOAT64},
      {"float64", PCLPointField::FLOAT64}};
  const auto found = types.find(name);
  if (found == types.end())
    throw ToolError(path + ": unknown property type '" + name + "' in the header");
  return found->second;
}

} // namespace

std::vector<PlyElement>
elementsOf(const FileHeader& header, const std::string& path)
{
  std::vector<PlyElement> elements;
  for (const auto& words : header.lines) {
    if (words[0] == "element") {
      if (words.size() != 3)
        throw ToolError(path + ": an element in the header lacks its name or number");
      elements.push_back({words[1], headerCount(words[2], "element", path), {}});
    }
    else if (words[0] == "property") {
      const bool list = words.size() == 5 && words[1] == "list";
      if (elements.empty() || (!list && words.size() != 3))
        throw ToolError(path +
                        ": a property in the header has no element, type or name");
      PlyProperty property;
      property.name = words.back();
      property.type = typeNamed(words[words.size() - 2], path);
      property.list_type = list ? typeNamed(words[2], path) : std::uint8_t(0);
      elements.back().properties.push_back(property);
    }
  }
  return elements;
}

PlyBody::Encoding
encodingOf(const FileHeader& header, const std::string& path)
{
  std::string format;
  for (const auto& words : header.lines)
    if (words[0] == "format" && words.size() > 1)
      format = words[1];
  if (format != "ascii" && format != "binary_little_endian" &&
      format != "binary_big_endian")
    throw ToolError(path + ": unknown format '" + format + "' in the header");
  return format == "ascii"                  ? PlyBody::Encoding::Ascii
         : format == "binary_little_endian" ? PlyBody::Encoding::Little
                                            : PlyBody::Encoding::Big;
}

} // namespace pcl::indoor::tool
