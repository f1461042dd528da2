/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/tool_error.h"
#include "formats/file_header.h" // for wordsOf, throwTruncated
#include "formats/polygons.h"
#include "text/words.h"

#include <cstring>
#include <sstream>

namespace pcl::indoor::tool {
namespace {

constexpr std::size_t header_size = 84; // of a binary file: a text and the count
constexpr std::size_t record_size = 50; // a normal, three corners, two bytes

std::uint32_t
triangleCount(const std::string& content)
{
  std::uint32_t count = 0;
  std::memcpy(&count, &content[header_size - sizeof(count)], sizeof(count));
  return count;
}

/** Also binary files may begin with "solid", and text needs no name behind it. */
bool
isText(const std::string& content)
{
  if (content.compare(0, 5, "solid") != 0)
    return false;
  return content.size() < header_size ||
         content.size() !=
             header_size + record_size * std::uint64_t{triangleCount(content)};
}

void
addTriangle(Polygons& polygons)
{
  const auto end = static_cast<std::uint32_t>(polygons.vertices.size());
  polygons.triangles.push_back({end - 3, end - 2, end - 1});
}

Polygons
readBinary(const std::string& content, const std::string& path)
{
  if (content.size() < header_size)
    throwTruncated(path, header_size, content.size(), "bytes at least");
  const std::uint64_t count = triangleCount(content);
  const std::uint64_t found = (content.size() - header_size) / record_size;
  if (found < count)
    throwTruncated(path, count, found, "triangles");
  Polygons polygons;
  for (std::uint64_t k = 0; k < count; ++k) {
    float corners[12]; // behind the normal
    std::memcpy(corners, &content[header_size + k * record_size], sizeof(corners));
    for (int c = 3; c < 12; c += 3)
      polygons.vertices.emplace_back(
          Eigen::Map<Eigen::Vector3f>(corners + c).cast<double>());
    addTriangle(polygons);
  }
  return polygons;
}

Polygons
readText(const std::string& content, const std::string& path)
{
  Polygons polygons;
  std::istringstream stream(content);
  bool is_ended = false;
  for (std::string line; std::getline(stream, line);) {
    const auto words = wordsOf(line);
    if (words.empty())
      continue;
    is_ended = words[0] == "endsolid";
    if (words[0] == "endfacet") {
      if (polygons.vertices.size() != 3 * (polygons.triangles.size() + 1))
        throw ToolError(path + ": a facet has not three corners");
      addTriangle(polygons);
    }
    if (words[0] != "vertex")
      continue;
    Eigen::Vector3d vertex;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto word = axis + 1 < words.size() ? words[axis + 1] : std::string();
      if (!readWord(word, vertex[static_cast<int>(axis)]))
        throw ToolError(path + ": '" + word.substr(0, 20) +
                        "' is no coordinate of a vertex");
    }
    polygons.vertices.push_back(vertex);
  }
  if (!is_ended || polygons.vertices.size() != 3 * polygons.triangles.size())
    throw ToolError(path + ": the file is truncated, it does not end with 'endsolid'");
  return polygons;
}

} // namespace

Polygons
readStl(const std::string& content, const std::string& path)
{
  return isText(content) ? readText(content, path) : readBinary(content, path);
}

} // namespace pcl::indoor::tool
