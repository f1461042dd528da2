/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/glb_scene.h"

#include "export/plan_boxes.h"
#include "export/surface_mesh.h"
#include "formats/json_text.h" // for rounded
#include "text/program_version.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstring>

namespace pcl::indoor::tool {
namespace {

using Json = nlohmann::ordered_json;

constexpr int float_type = 5126, index_type = 5125;
constexpr int corner_buffer = 34962, index_buffer = 34963;

enum Material { Floor, Wall, Furniture };

/** A glTF file on its way: its JSON and its one buffer. */
class GlbFile {
public:
  GlbFile()
  {
    json_["asset"] = {{"version", "2.0"},
                      {"generator", "pcl_indoor " + programVersion()}};
    json_["scene"] = 0;
    json_["scenes"] = {{{"nodes", {0}}}};
    json_["nodes"] = Json::array();
    json_["meshes"] = Json::array();
    json_["materials"] = {material("floor", {0.80, 0.76, 0.70}),
                          material("wall", {0.93, 0.93, 0.91}),
                          material("thing", {0.36, 0.55, 0.74})};
    json_["accessors"] = Json::array();
    json_["bufferViews"] = Json::array();
  }

  std::size_t
  addNode(Json node)
  {
    json_["nodes"].push_back(std::move(node));
    return json_["nodes"].size() - 1;
  }

  void
  addChild(std::size_t parent, std::size_t child)
  {
    json_["nodes"][parent]["children"].push_back(child);
  }

  std::size_t
  addMesh(const SurfaceMesh& mesh, Material material)
  {
    Json extent;
    Eigen::Vector3f low = mesh.corners.front(), high = low;
    for (const auto& corner : mesh.corners) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
    const auto list = [](const Eigen::Vector3f& v) {
      return Json{v.x(), v.y(), v.z()};
    };
    const auto corners = addAccessor(mesh.corners.data(), mesh.corners.size(), "VEC3");
    json_["accessors"][corners]["min"] = list(low);
    json_["accessors"][corners]["max"] = list(high);
    const auto normals = addAccessor(mesh.normals.data(), mesh.normals.size(), "VEC3");
    const auto triangles =
        addAccessor(mesh.triangles.data(), mesh.triangles.size(), "SCALAR");
    json_["meshes"].push_back(
        {{"primitives",
          {{{"attributes", {{"POSITION", corners}, {"NORMAL", normals}}},
            {"indices", triangles},
            {"material", static_cast<int>(material)}}}}});
    return json_["meshes"].size() - 1;
  }

  std::string
  bytes()
  {
    if (buffer_.empty()) // lists are not empty in glTF
      for (const char* list : {"meshes", "accessors", "bufferViews"})
        json_.erase(list);
    else
      json_["buffers"] = {{{"byteLength", buffer_.size()}}};
    auto text = json_.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::string content =
        chunk(0x4e4f534a, text) + (buffer_.empty() ? "" : chunk(0x004e4942, buffer_));
    return word(0x46546c67) + word(2) +
           word(static_cast<std::uint32_t>(content.size() + 12)) + content;
  }

private:
  static Json
  material(const char* name, const std::array<double, 3>& color)
  {
    return {{"name", name},
            {"pbrMetallicRoughness",
             {{"baseColorFactor", {color[0], color[1], color[2], 1.0}},
              {"metallicFactor", 0.0},
              {"roughnessFactor", 0.9}}}};
  }

  /** Little endian, as all of the file. */
  static std::string
  word(std::uint32_t value)
  {
    std::string bytes;
    for (int shift = 0; shift < 32; shift += 8)
      bytes += static_cast<char>(value >> shift & 0xff);
    return bytes;
  }

  static std::string
  chunk(std::uint32_t type, const std::string& content)
  {
    return word(static_cast<std::uint32_t>(content.size())) + word(type) + content;
  }

  template <typename Value>
  std::size_t
  addAccessor(const Value* values, std::size_t count, const char* type)
  {
    const bool is_index = sizeof(Value) == sizeof(std::uint32_t);
    const std::size_t size = count * sizeof(Value);
    json_["bufferViews"].push_back(
        {{"buffer", 0},
         {"byteOffset", buffer_.size()},
         {"byteLength", size},
         {"target", is_index ? index_buffer : corner_buffer}});
    buffer_.append(reinterpret_cast<const char*>(values), size);
    json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                  {"componentType", is_index ? index_type : float_type},
                                  {"count", count},
                                  {"type", type}});
    return json_["accessors"].size() - 1;
  }

  Json json_;
  std::string buffer_;
};

Json
storeyExtras(const SavedStorey& storey)
{
  return {{"floor", rounded(storey.floor)}, {"ceiling", rounded(storey.ceiling)}};
}

void
addRooms(GlbFile& file,
         const SavedScene& scene,
         const std::vector<std::size_t>& storeys)
{
  for (const auto& room : scene.rooms) {
    Json node = {{"name", "room " + std::to_string(room.number)}};
    const auto floor = flatMesh(room.rings, room.floor);
    if (!floor.triangles.empty())
      node["mesh"] = file.addMesh(floor, Floor);
    node["extras"] = {{"kind", "room"},
                      {"room", room.number},
                      {"area", rounded(room.area)},
                      {"height", rounded(room.height)}};
    file.addChild(storeys[room.storey], file.addNode(std::move(node)));
  }
}

void
addWalls(GlbFile& file,
         const SavedScene& scene,
         const std::vector<std::size_t>& storeys)
{
  for (std::size_t i = 0; i < scene.walls.size(); ++i) {
    const auto& wall = scene.walls[i];
    const auto mesh = wallMesh(scene, i);
    if (mesh.triangles.empty())
      continue;
    Json node = {{"name", "wall " + std::to_string(wall.number)},
                 {"mesh", file.addMesh(mesh, Wall)},
                 {"extras", {{"kind", "wall"}, {"wall", wall.number}}}};
    if (wall.thickness > 0.0)
      node["extras"]["thickness"] = rounded(wall.thickness);
    file.addChild(storeys[wall.storey], file.addNode(std::move(node)));
  }
}

void
addColumns(GlbFile& file,
           const SavedScene& scene,
           const std::vector<std::size_t>& storeys)
{
  for (const auto& column : scene.columns) {
    SurfaceMesh mesh;
    const double bottom = column.foot.z();
    addPrism(mesh, outlineOf(column), bottom, bottom + column.size.z());
    file.addChild(
        storeys[column.storey],
        file.addNode({{"name", "column " + std::to_string(column.number)},
                      {"mesh", file.addMesh(mesh, Wall)},
                      {"extras", {{"kind", "column"}, {"column", column.number}}}}));
  }
}

void
addObjects(GlbFile& file,
           const SavedScene& scene,
           const std::vector<std::size_t>& storeys)
{
  SurfaceMesh cube;
  addPrism(cube, {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}, -0.5, 0.5);
  Json mesh;
  for (const auto& object : scene.objects) {
    if (object.is_structure)
      continue;
    if (mesh.is_null())
      mesh = file.addMesh(cube, Furniture);
    const auto& box = object.box;
    const auto number = std::to_string(object.number);
    Json node = {
        {"name", (object.name.empty() ? "object" : object.name) + " " + number},
        {"mesh", mesh},
        {"translation",
         {rounded(box.center.x()), rounded(box.center.y()), rounded(box.center.z())}},
        {"rotation", {0.0, 0.0, std::sin(0.5 * box.yaw), std::cos(0.5 * box.yaw)}},
        {"scale", {box.size.x(), box.size.y(), box.size.z()}},
        {"extras", {{"kind", "object"}, {"object", object.number}}}};
    if (!object.name.empty()) {
      node["extras"]["class"] = object.name;
      node["extras"]["confidence"] = rounded(object.confidence);
    }
    file.addChild(storeys[object.storey], file.addNode(std::move(node)));
  }
}

} // namespace

std::string
glbBytes(const SavedScene& scene)
{
  GlbFile file;
  const auto root = file.addNode(
      {{"name", scene.input}, {"rotation", {-M_SQRT1_2, 0.0, 0.0, M_SQRT1_2}}});
  std::vector<std::size_t> storeys;
  for (std::size_t s = 0; s < scene.storeys.size(); ++s) {
    storeys.push_back(file.addNode({{"name", "storey " + std::to_string(s)},
                                    {"extras", storeyExtras(scene.storeys[s])}}));
    file.addChild(root, storeys.back());
  }
  addRooms(file, scene, storeys);
  addWalls(file, scene, storeys);
  addColumns(file, scene, storeys);
  addObjects(file, scene, storeys);
  return file.bytes();
}

} // namespace pcl::indoor::tool
