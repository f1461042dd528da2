/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/mesh_file.h"

#include "formats/file_ending.h"
#include "formats/ply/ply_file.h"
#include "formats/polygons.h"
#include "text/words.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

namespace pcl::indoor::tool {
namespace {

/** \brief The lines of a text without comments and empty ones, as their words. */
class MeshLines {
public:
  MeshLines(std::string text, std::string path)
  : text_(std::move(text))
  , path_(std::move(path))
  {}

  /** \brief Go to the next line that holds a word. \return false at the end */
  bool
  next()
  {
    words_.clear();
    while (words_.empty() && at_ < text_.size()) {
      const auto end = std::min(text_.find('\n', at_), text_.size());
      auto line = std::string_view(text_).substr(at_, end - at_);
      at_ = end + 1;
      ++number_;
      splitWords(line.substr(0, std::min(line.find('#'), line.size())), words_);
    }
    return !words_.empty();
  }

  const std::vector<std::string_view>&
  words() const
  {
    return words_;
  }

  /** \brief A word of the line as a number. */
  template <typename T>
  T
  number(std::size_t word) const
  {
    if (word >= words_.size())
      complain("has too few numbers");
    return parse<T>(words_[word]);
  }

  template <typename T>
  T
  parse(std::string_view word) const
  {
    T value{};
    if (!readWord(word, value))
      complain("holds '" + std::string(word.substr(0, 20)) +
               "', which is no number of its kind");
    return value;
  }

  [[noreturn]] void
  complain(const std::string& problem) const
  {
    throw ToolError(path_ + ": line " + std::to_string(number_) + " " + problem);
  }

private:
  std::string text_;
  std::string path_;
  std::size_t at_ = 0;
  std::size_t number_ = 0;
  std::vector<std::string_view> words_;
};

std::string
textOf(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw ToolError(path + ": no such file");
  std::ifstream stream(path, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  if (stream.bad() || !stream.is_open())
    throw ToolError(path + ": cannot be read");
  return text;
}

Eigen::Vector3d
vertexOf(const MeshLines& line, std::size_t first)
{
  Eigen::Vector3d vertex;
  for (std::size_t axis = 0; axis < 3; ++axis)
    vertex[static_cast<int>(axis)] = line.number<double>(first + axis);
  return vertex;
}

/** \brief Numbers of vertices and faces, which may stand behind "OFF" on its line. */
std::array<std::uint64_t, 2>
offCounts(MeshLines& line, const std::string& path)
{
  if (!line.next())
    throw ToolError(path + ": the file is empty");
  std::string_view first = line.words()[0];
  for (const std::string_view kind : {"ST", "C", "N"}) // more values per vertex
    if (first.substr(0, kind.size()) == kind)
      first.remove_prefix(kind.size());
  if (first.substr(0, 3) != "OFF")
    throw ToolError(path + ": not an OFF file, its first line is no 'OFF'");
  first.remove_prefix(3);
  if (!first.empty())
    return {line.parse<std::uint64_t>(first), line.number<std::uint64_t>(1)};
  if (line.words().size() > 1)
    return {line.number<std::uint64_t>(1), line.number<std::uint64_t>(2)};
  if (!line.next())
    throw ToolError(path +
                    ": truncated, the numbers of vertices and faces are missing");
  return {line.number<std::uint64_t>(0), line.number<std::uint64_t>(1)};
}

Polygons
readOff(std::string text, const std::string& path)
{
  MeshLines line(std::move(text), path);
  const auto [vertex_count, face_count] = offCounts(line, path);
  const auto next = [&](std::uint64_t read, std::uint64_t all, const char* what) {
    if (!line.next())
      throw ToolError(path + ": truncated, its header promises " + std::to_string(all) +
                      " " + what + ", there are " + std::to_string(read));
  };
  Polygons polygons;
  for (std::uint64_t k = 0; k < vertex_count; ++k) {
    next(k, vertex_count, "vertices");
    polygons.vertices.push_back(vertexOf(line, 0));
  }
  std::vector<std::uint32_t> corners;
  for (std::uint64_t k = 0; k < face_count; ++k) {
    next(k, face_count, "faces");
    const auto corner_count = line.number<std::uint32_t>(0);
    if (corner_count >= line.words().size())
      line.complain("names " + std::to_string(line.words().size() - 1) + " of " +
                    std::to_string(corner_count) + " corners");
    corners.clear();
    for (std::uint32_t c = 0; c < corner_count; ++c) {
      corners.push_back(line.number<std::uint32_t>(c + 1));
      if (corners.back() >= polygons.vertices.size())
        line.complain("names vertex " + std::to_string(corners.back()) + " of " +
                      std::to_string(polygons.vertices.size()) + ", from 0");
    }
    addFan(corners, polygons.triangles);
  }
  return polygons;
}

/** \brief Vertex of "7", "7/1", "7//2" or "-1": from 1, or from the last backwards. */
std::uint32_t
objCorner(const MeshLines& line, std::string_view word, std::size_t vertex_count)
{
  const auto number =
      line.parse<std::int64_t>(word.substr(0, std::min(word.find('/'), word.size())));
  const auto count = static_cast<std::int64_t>(vertex_count);
  const auto index = number < 0 ? number + count : number - 1;
  if (index < 0 || index >= count)
    line.complain("names vertex " + std::to_string(number) + " of " +
                  std::to_string(count) + " so far");
  return static_cast<std::uint32_t>(index);
}

Polygons
readObj(std::string text, const std::string& path)
{
  MeshLines line(std::move(text), path);
  Polygons polygons;
  std::vector<std::uint32_t> corners;
  while (line.next()) {
    const auto& words = line.words();
    if (words[0] == "v")
      polygons.vertices.push_back(vertexOf(line, 1));
    else if (words[0] == "f") {
      if (words.size() < 4)
        line.complain("is a face of fewer than three corners");
      corners.clear();
      for (std::size_t k = 1; k < words.size(); ++k)
        corners.push_back(objCorner(line, words[k], polygons.vertices.size()));
      addFan(corners, polygons.triangles);
    }
  }
  return polygons;
}

/** \brief Floats near the origin: large coordinates would be coarse. */
Mesh
nearOrigin(const Polygons& polygons)
{
  constexpr double large = 1000.0; // below, a float resolves 0.06 mm
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  for (const auto& vertex : polygons.vertices)
    if (vertex.allFinite()) {
      if (vertex.cwiseAbs().maxCoeff() > large)
        offset = vertex.array().round();
      break;
    }
  Mesh mesh;
  mesh.offset = offset;
  mesh.triangles = polygons.triangles;
  mesh.vertices.reserve(polygons.vertices.size());
  for (const auto& vertex : polygons.vertices)
    mesh.vertices.push_back((vertex - offset).cast<float>());
  return mesh;
}

} // namespace

std::optional<MeshFormat>
meshFormat(const std::string& path, const std::string& beginning)
{
  if (beginning.compare(0, 4, "glTF") == 0)
    return MeshFormat::GLB;
  if (beginning.compare(0, 5, "solid") == 0)
    return MeshFormat::STL;
  MeshLines line(beginning, path);
  const std::string word(line.next() ? line.words()[0] : "");
  if (word == "OFF" || word == "COFF" || word == "NOFF" || word == "STOFF")
    return MeshFormat::OFF;
  for (const char* first : {"v", "vn", "vt", "mtllib", "usemtl", "o", "g"})
    if (word == first)
      return MeshFormat::OBJ;
  const auto ending = fileEnding(path);
  return ending == ".off"   ? std::optional(MeshFormat::OFF)
         : ending == ".obj" ? std::optional(MeshFormat::OBJ)
         : ending == ".stl" ? std::optional(MeshFormat::STL)
                            : std::nullopt;
}

Mesh
readMesh(const std::string& path)
{
  auto text = textOf(path);
  const auto format = meshFormat(path, text.substr(0, 512)).value_or(MeshFormat::OBJ);
  const auto polygons = format == MeshFormat::OFF   ? readOff(std::move(text), path)
                        : format == MeshFormat::STL ? readStl(text, path)
                        : format == MeshFormat::GLB ? readGlb(text, path)
                                                    : readObj(std::move(text), path);
  auto mesh = nearOrigin(polygons);
  mesh.y_is_up = format == MeshFormat::GLB;
  return mesh;
}

Mesh
plyMesh(const CloudFile& file)
{
  Mesh mesh;
  for (const auto& face : readPlyFaces(file.path)) {
    for (const auto index : face)
      if (index >= file.points->size())
        throw ToolError(file.path + ": a face names vertex " + std::to_string(index) +
                        " of " + std::to_string(file.points->size()) + ", from 0");
    addFan(face, mesh.triangles);
  }
  for (const auto& point : *file.points)
    mesh.vertices.emplace_back(point.getVector3fMap());
  return mesh;
}

} // namespace pcl::indoor::tool
