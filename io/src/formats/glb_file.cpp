/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/field_value.h"
#include "files/tool_error.h"
#include "formats/polygons.h"
#include "text/printable.h"

#include <nlohmann/json.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstring>
#include <utility>

namespace pcl::indoor::tool {
namespace {

using Json = nlohmann::json;

/** A number type of an accessor, as its componentType names it; nothing for others. */
std::uint8_t
fieldType(std::uint64_t component_type)
{
  switch (component_type) {
  case 5120:
    return PCLPointField::INT8;
  case 5121:
    return PCLPointField::UINT8;
  case 5122:
    return PCLPointField::INT16;
  case 5123:
    return PCLPointField::UINT16;
  case 5125:
    return PCLPointField::UINT32;
  case 5126:
    return PCLPointField::FLOAT32;
  default:
    return 0;
  }
}

/** A number, or what else it is: nested lists would need a call for each level. */
std::string
valueText(const Json& value)
{
  return value.is_number() ? value.dump() : std::string("JSON ") + value.type_name();
}

/** What is divided by to get numbers from -1 to 1; 0: they are no fractions. */
double
greatestOf(std::uint64_t component_type)
{
  switch (component_type) {
  case 5120:
    return 127.0;
  case 5121:
    return 255.0;
  case 5122:
    return 32767.0;
  case 5123:
    return 65535.0;
  default:
    return 0.0;
  }
}

class GlbReader {
public:
  GlbReader(const std::string& content, std::string path)
  : path_(std::move(path))
  , most_(std::min<std::size_t>(0xffffffff, (1 << 24) + 16 * content.size()))
  , most_primitives_((1 << 20) + content.size())
  {
    splitChunks(content);
  }

  Polygons
  read()
  {
    if (json_.contains("extensionsRequired"))
      for (const auto& name : json_.at("extensionsRequired"))
        for (const char* known : {"compression", "draco", "meshopt"})
          if (name.get<std::string>().find(known) != std::string::npos)
            complain("its triangles are compressed (" + name.get<std::string>() +
                     "): save it without compression, or as OBJ or PLY");
    placeNodes();
    return std::move(polygons_);
  }

private:
  [[noreturn]] void
  complain(const std::string& problem) const
  {
    throw ToolError(path_ + ": " + problem);
  }

  void
  splitChunks(const std::string& content)
  {
    constexpr std::uint32_t json_kind = 0x4e4f534a, binary_kind = 0x004e4942;
    std::uint32_t head[5] = {}; // magic, version, length; length and kind of a chunk
    if (content.size() < sizeof(head))
      complain("the file is truncated, its header is missing");
    std::memcpy(head, content.data(), sizeof(head));
    if (head[1] != 2)
      complain("is glTF " + std::to_string(head[1]) + ", only glTF 2 is read");
    if (head[2] > content.size())
      complain("the file is truncated, its header promises " + std::to_string(head[2]) +
               " bytes, it has " + std::to_string(content.size()));
    std::size_t at = 12;
    if (head[4] != json_kind)
      complain("the file is damaged, it does not begin with its description");
    while (content.size() - at >= 8) {
      std::uint32_t chunk[2];
      std::memcpy(chunk, &content[at], sizeof(chunk));
      at += sizeof(chunk);
      if (chunk[0] > content.size() - at)
        complain("the file is truncated within a chunk");
      if (chunk[1] == json_kind && json_.is_null())
        json_ =
            Json::parse(content.begin() + static_cast<std::ptrdiff_t>(at),
                        content.begin() + static_cast<std::ptrdiff_t>(at + chunk[0]));
      else if (chunk[1] == binary_kind && binary_.empty())
        binary_ = content.substr(at, chunk[0]);
      at += chunk[0];
    }
  }

  /** A number, count or offset: the library would turn 1e20 into anything. */
  std::uint64_t
  whole(const Json& value) const
  {
    if (!value.is_number_unsigned())
      complain("the file is damaged, " + valueText(value) + " is no whole number");
    return value.get<std::uint64_t>();
  }

  std::uint64_t
  whole(const Json& parent, const char* name, std::uint64_t otherwise) const
  {
    return parent.contains(name) ? whole(parent.at(name)) : otherwise;
  }

  static Eigen::Affine3d
  poseOf(const Json& node)
  {
    Eigen::Affine3d pose = Eigen::Affine3d::Identity();
    const auto numbers = [&node](const char* name, std::size_t count) {
      auto values = node.at(name).get<std::vector<double>>();
      values.resize(count);
      return values;
    };
    if (node.contains("matrix")) // by columns
      pose.matrix() = Eigen::Map<const Eigen::Matrix4d>(numbers("matrix", 16).data());
    if (node.contains("translation"))
      pose.translate(Eigen::Vector3d(numbers("translation", 3).data()));
    if (node.contains("rotation")) // x, y, z, w
      pose.rotate(Eigen::Quaterniond(numbers("rotation", 4).data()).normalized());
    if (node.contains("scale"))
      pose.scale(Eigen::Vector3d(numbers("scale", 3).data()));
    return pose;
  }

  /** Each node has one parent at most, so each is visited once. */
  void
  placeNodes()
  {
    const auto& nodes = json_.at("nodes");
    std::vector<bool> is_child(nodes.size(), false);
    const auto children = [&](std::size_t node) {
      std::vector<std::size_t> numbers;
      if (nodes[node].contains("children"))
        for (const auto& child : nodes[node].at("children"))
          numbers.push_back(whole(child));
      return numbers;
    };
    for (std::size_t node = 0; node < nodes.size(); ++node)
      for (const auto child : children(node)) {
        if (child >= nodes.size() || is_child[child])
          complain("the file is damaged, its nodes are no tree");
        is_child[child] = true;
      }
    std::vector<std::pair<std::size_t, Eigen::Affine3d>> left;
    for (std::size_t node = nodes.size(); node-- > 0;)
      if (!is_child[node])
        left.emplace_back(node, Eigen::Affine3d::Identity());
    while (!left.empty()) {
      const auto [node, parent] = left.back();
      left.pop_back();
      const Eigen::Affine3d pose = parent * poseOf(nodes[node]);
      if (nodes[node].contains("mesh"))
        addMesh(json_.at("meshes").at(whole(nodes[node].at("mesh"))), pose);
      for (const auto child : children(node))
        left.emplace_back(child, pose);
    }
  }

  void
  addMesh(const Json& mesh, const Eigen::Affine3d& pose)
  {
    for (const auto& primitive : mesh.at("primitives")) {
      requireRoom(++primitives_, most_primitives_);
      const auto mode = whole(primitive, "mode", 4);
      if (mode != 0 && (mode < 4 || mode > 6)) // lines
        continue;
      const auto first = static_cast<std::uint32_t>(polygons_.vertices.size());
      const auto numbers = accessor(primitive.at("attributes").at("POSITION"), 3);
      requireRoom(polygons_.vertices.size() + numbers.size() / 3, most_);
      for (std::size_t k = 0; k + 2 < numbers.size(); k += 3)
        polygons_.vertices.emplace_back(pose * Eigen::Vector3d(&numbers[k]));
      if (mode == 0) // points
        continue;
      std::vector<double> corners;
      if (primitive.contains("indices"))
        corners = accessor(primitive.at("indices"), 1);
      else
        for (std::size_t k = 0; k < numbers.size() / 3; ++k)
          corners.push_back(static_cast<double>(k));
      addTriangles(corners, mode, first);
    }
  }

  void
  requireRoom(std::size_t count, std::size_t most) const
  {
    if (count > most)
      complain("repeats its meshes too often: more than " + std::to_string(most) +
               " vertices, triangles or parts");
  }

  /** \param[in] mode 4: three corners each, 5: a strip, 6: a fan */
  void
  addTriangles(const std::vector<double>& corners,
               std::uint64_t mode,
               std::uint32_t first)
  {
    const auto count = static_cast<double>(polygons_.vertices.size() - first);
    const auto corner = [&](std::size_t k) {
      if (!(corners[k] >= 0.0 && corners[k] < count))
        complain("a face names a vertex that is not there");
      return first + static_cast<std::uint32_t>(corners[k]);
    };
    requireRoom(polygons_.triangles.size() + corners.size() / (mode == 4 ? 3 : 1),
                most_);
    for (std::size_t k = 0; k + 2 < corners.size(); k += mode == 4 ? 3 : 1)
      polygons_.triangles.push_back(
          {corner(mode == 6 ? 0 : k), corner(k + 1), corner(k + 2)});
  }

  /** The numbers of an accessor; \a width of them belong together. */
  std::vector<double>
  accessor(const Json& index, std::size_t width) const
  {
    const auto& accessor = json_.at("accessors").at(whole(index));
    if (accessor.contains("sparse") || !accessor.contains("bufferView"))
      complain(
          "has sparse numbers, which are not read: save it again, or as OBJ or PLY");
    const auto component = whole(accessor.at("componentType"));
    const auto type = fieldType(component);
    const char* const kind = width == 3 ? "VEC3" : "SCALAR";
    if (type == 0 || accessor.at("type") != kind)
      complain("the file is damaged, its numbers are of an unknown kind");
    const std::size_t size =
        type == PCLPointField::INT8 || type == PCLPointField::UINT8     ? 1
        : type == PCLPointField::INT16 || type == PCLPointField::UINT16 ? 2
                                                                        : 4;
    const auto& view = json_.at("bufferViews").at(whole(accessor.at("bufferView")));
    if (view.at("buffer") != 0 || json_.at("buffers").at(0).contains("uri"))
      complain("refers to other files: save it as one GLB, or as OBJ or PLY");
    const auto count = whole(accessor.at("count"));
    const auto stride = whole(view, "byteStride", size * width);
    const auto begin = whole(view, "byteOffset", 0) + whole(accessor, "byteOffset", 0);
    if (count > binary_.size() || stride > binary_.size() || begin > binary_.size() ||
        (count > 0 && begin + (count - 1) * stride + size * width > binary_.size()))
      complain("the file is truncated, numbers of its triangles are missing");
    const double greatest =
        accessor.value("normalized", false) ? greatestOf(component) : 0.0;
    std::vector<double> numbers;
    numbers.reserve(count * width);
    for (std::uint64_t k = 0; k < count; ++k)
      for (std::size_t c = 0; c < width; ++c) {
        const double value = valueAt(reinterpret_cast<const std::uint8_t*>(
                                         &binary_[begin + k * stride + c * size]),
                                     type);
        numbers.push_back(greatest > 0.0 ? std::max(value / greatest, -1.0) : value);
      }
    return numbers;
  }

  std::string path_;
  std::size_t most_; ///< vertices, and triangles: nodes may repeat a mesh
  std::size_t most_primitives_;
  std::size_t primitives_ = 0; ///< that were visited
  Json json_;
  std::string binary_;
  Polygons polygons_;
};

} // namespace

Polygons
readGlb(const std::string& content, const std::string& path)
{
  try {
    return GlbReader(content, path).read();
  } catch (const Json::exception& problem) {
    throw ToolError(path + ": the file is damaged: " + messageOf(problem));
  }
}

} // namespace pcl::indoor::tool
