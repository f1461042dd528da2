/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cloud_stream.h"
#include "files/sampled_surface.h"
#include "support/folder_test.h"

#include <pcl/common/common.h> // for getMinMax3D

#include <cstring>

using namespace pcl::indoor::tool;

namespace {

class SampledSurface : public pcl::indoor::test::FolderTest {};

/** A box as the faces of a PLY; each edge is cut into so many. */
std::string
boxPly(const Eigen::Vector3d& size, int cuts, const Eigen::Vector3d& corner)
{
  std::string vertices, faces;
  int count = 0, face_count = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      const int first = count;
      for (int i = 0; i <= cuts; ++i)
        for (int j = 0; j <= cuts; ++j, ++count) {
          Eigen::Vector3d point;
          point[axis] = side;
          point[(axis + 1) % 3] = static_cast<double>(i) / cuts;
          point[(axis + 2) % 3] = static_cast<double>(j) / cuts;
          point = corner + point.cwiseProduct(size);
          for (int k = 0; k < 3; ++k)
            vertices += std::to_string(point[k]) + " ";
          vertices += "7\n";
        }
      for (int i = 0; i < cuts; ++i)
        for (int j = 0; j < cuts; ++j, ++face_count) {
          const int a = first + i * (cuts + 1) + j, b = a + cuts + 1;
          faces += "4 " + std::to_string(a) + " " + std::to_string(a + 1) + " " +
                   std::to_string(b + 1) + " " + std::to_string(b) + "\n";
        }
    }
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) +
         "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar "
         "label\nelement face " +
         std::to_string(face_count) +
         "\nproperty list uchar int vertex_indices\nend_header\n" + vertices + faces;
}

/** The corners of the points' box, with their offset. */
std::pair<Eigen::Vector3d, Eigen::Vector3d>
boxOf(const CloudFile& file)
{
  Eigen::Vector4f low, high;
  pcl::getMinMax3D(*file.points, low, high);
  return {low.head<3>().cast<double>() + file.offset,
          high.head<3>().cast<double>() + file.offset};
}

void
expectBox(const CloudFile& file,
          const Eigen::Vector3d& low,
          const Eigen::Vector3d& high)
{
  const auto box = boxOf(file);
  EXPECT_LT((box.first - low).norm(), 0.05) << box.first.transpose();
  EXPECT_LT((box.second - high).norm(), 0.05) << box.second.transpose();
}

/** A triangle's bytes in a binary STL. */
std::string
stlTriangle(std::array<float, 9> corners)
{
  return std::string(12, '\0') +
         std::string(reinterpret_cast<const char*>(corners.data()), 36) + "aa";
}

std::string
word(std::uint32_t value)
{
  return std::string(reinterpret_cast<const char*>(&value), 4);
}

/** A binary glTF of a description and a buffer. */
std::string
glb(std::string json, const std::string& buffer)
{
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto size = static_cast<std::uint32_t>(28 + json.size() + buffer.size());
  return "glTF" + word(2) + word(size) + word(static_cast<std::uint32_t>(json.size())) +
         "JSON" + json + word(static_cast<std::uint32_t>(buffer.size())) +
         std::string("BIN\0", 4) + buffer;
}

/** A rectangle of 4 by 3 of two triangles, below two nodes. */
std::string
rectangleGlb()
{
  const float corners[] = {0, 0, 0, 4, 0, 0, 4, 3, 0, 0, 3, 0};
  const std::uint16_t indices[] = {0, 1, 2, 0, 2, 3};
  return glb(
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"children":[1],"translation":[10,0,0]},
{"mesh":0,"rotation":[0.70710678,0,0,0.70710678],"scale":[2,2,2]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
{"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12}],
"buffers":[{"byteLength":60}]})",
      std::string(reinterpret_cast<const char*>(corners), sizeof(corners)) +
          std::string(reinterpret_cast<const char*>(indices), sizeof(indices)));
}

} // namespace

TEST_F(SampledSurface, OfLargeFacesIsCoveredByPoints)
{
  const Eigen::Vector3d size(5, 4, 2.5);
  const auto file = loadSurface(write("box.ply", boxPly(size, 1, {0, 0, 0})));
  const double area = 2 * (5 * 4 + 5 * 2.5 + 4 * 2.5);
  EXPECT_NEAR(
      static_cast<double>(file.points->size()), area / 4e-4, 1e-3 * area / 4e-4);
  expectBox(file, {0, 0, 0}, size);
  for (const auto& point : *file.points) { // each lies on a side
    const Eigen::Vector3d p = point.getVector3fMap().cast<double>();
    EXPECT_LT(std::min(p.cwiseAbs().minCoeff(), (p - size).cwiseAbs().minCoeff()),
              1e-5);
  }
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_NE(file.notes[0].find("a mesh of 12 triangles: 212500 points"),
            std::string::npos)
      << file.notes[0];
}

TEST_F(SampledSurface, OfLargeCoordinatesKeepsItsPlace)
{
  const Eigen::Vector3d corner(691234.5, 5334567.25, 500), size(5, 4, 2.5);
  const auto file = loadSurface(write("utm.ply", boxPly(size, 1, corner)));
  expectBox(file, corner, corner + size);
  std::string text = "o wall\n";
  for (const char* xy : {"691234.5 5334567.25",
                         "691239.5 5334567.25",
                         "691239.5 5334571.25",
                         "691234.5 5334571.25"})
    text += std::string("v ") + xy + " 500\n";
  expectBox(loadSurface(write("utm.obj", text + "f 1 2 3 4\n")),
            corner,
            corner + Eigen::Vector3d(5, 4, 0));
}

TEST_F(SampledSurface, IsTheSameEachTime)
{
  write("box.ply", boxPly({5, 4, 2.5}, 1, {0, 0, 0}));
  EXPECT_EQ(loadSurface(path("box.ply")).cloud.data,
            loadSurface(path("box.ply")).cloud.data);
}

TEST_F(SampledSurface, VerticesOfAMeshThatWasMadeOfAScanStay)
{
  const auto name = write("fine.ply", boxPly({5, 4, 2.5}, 80, {0, 0, 0}));
  const auto file = loadSurface(name);
  EXPECT_EQ(file.points->size(), 6u * 81u * 81u);
  EXPECT_TRUE(hasField(file.cloud, "label"));
  for (const auto& note : file.notes) // vertices of two sides lie at one place
    EXPECT_NE(note.find("at the place of another"), std::string::npos) << note;
  EXPECT_EQ(loadCloud(name).points->size(), file.points->size());
}

/** Fine furniture between walls of large faces: the walls count. */
TEST_F(SampledSurface, LargeWallsCountMoreThanSmallObjects)
{
  auto text = boxPly({5, 4, 2.5}, 1, {0, 0, 0});
  const auto fine = boxPly({0.5, 0.5, 0.5}, 20, {1, 1, 0});
  const auto body = [](const std::string& ply) {
    return ply.substr(ply.find("end_header\n") + 11);
  };
  const auto lines = [](const std::string& of, std::size_t from, std::size_t count) {
    std::size_t begin = 0;
    for (; from > 0; --from)
      begin = of.find('\n', begin) + 1;
    std::size_t end = begin;
    for (; count > 0; --count)
      end = of.find('\n', end) + 1;
    return of.substr(begin, end - begin);
  };
  const std::size_t vertices = 6 * 21 * 21, faces = 6 * 400;
  std::string all = fine.substr(0, fine.find("end_header\n") + 11);
  all.replace(all.find("vertex 2646"), 11, "vertex 2670");
  all.replace(all.find("face 2400"), 9, "face 2406");
  all += lines(body(fine), 0, vertices) + lines(body(text), 0, 24) +
         lines(body(fine), vertices, faces);
  for (int side = 0; side < 6; ++side) {
    const int first = static_cast<int>(vertices) + 4 * side;
    all += "4 " + std::to_string(first) + " " + std::to_string(first + 1) + " " +
           std::to_string(first + 3) + " " + std::to_string(first + 2) + "\n";
  }
  EXPECT_GT(loadSurface(write("room.ply", all)).points->size(), 100000u);
}

TEST_F(SampledSurface, OfAnyUnitHasNeitherTooFewNorTooManyPoints)
{
  EXPECT_EQ(loadSurface(write("mm.ply", boxPly({5000, 4000, 2500}, 1, {0, 0, 0})))
                .points->size(),
            2000000u);
  EXPECT_EQ(loadSurface(write("chair.ply", boxPly({0.5, 0.5, 0.5}, 1, {0, 0, 0})))
                .points->size(),
            100000u);
}

TEST_F(SampledSurface, StlIsReadInBothForms)
{
  const std::string text =
      "solid a\nfacet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 4 0 0\n"
      "  vertex 4 +3 0\n endloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 "
      "0\nvertex 4 3 0\nvertex 0 3 1e0\nendloop\nendfacet\nendsolid a\n";
  expectBox(loadCloud(write("text.stl", text)), {0, 0, 0}, {4, 3, 1});
  std::string binary = "solid, though it is none" + std::string(56, '\0') + word(2) +
                       stlTriangle({0, 0, 0, 4, 0, 0, 4, 3, 0}) +
                       stlTriangle({0, 0, 0, 4, 3, 0, 0, 3, 1});
  ASSERT_EQ(binary.size(), 184u);
  expectBox(loadCloud(write("binary.stl", binary)), {0, 0, 0}, {4, 3, 1});
  EXPECT_THROW(loadCloud(write("cut.stl", binary.substr(5, 170))), ToolError);
  EXPECT_THROW(loadCloud(write("cut.stl", text.substr(0, 150))), ToolError);
  EXPECT_THROW(loadCloud(write("word.stl", "solid\nvertex 0 0 a\nendsolid\n")),
               ToolError);
  EXPECT_THROW(loadCloud(write("none.stl", "solid\nendsolid\n")), ToolError);
}

TEST_F(SampledSurface, GlbIsMovedByItsNodes)
{
  const auto file = loadCloud(write("a.glb", rectangleGlb()));
  expectBox(file, {10, 0, 0}, {18, 0, 6});
  ASSERT_EQ(file.notes.size(), 2u);
  EXPECT_NE(file.notes[1].find("y axis"), std::string::npos);
}

TEST_F(SampledSurface, GlbThatCannotBeReadIsRefused)
{
  const auto whole = rectangleGlb();
  const auto changed = [&](const std::string& from, const std::string& to) {
    auto bytes = whole;
    bytes.replace(bytes.find(from), from.size(), to);
    return bytes;
  };
  const auto complaint = [&](const std::string& bytes) {
    try {
      loadCloud(write("a.glb", bytes));
      return std::string();
    } catch (const ToolError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(complaint(whole), "");
  EXPECT_NE(complaint(whole.substr(0, 300)).find("truncated"), std::string::npos);
  EXPECT_NE(complaint(whole.substr(0, 10)).find("truncated"), std::string::npos);
  EXPECT_NE(complaint(changed("\"children\":[1]", "\"children\":[7]")).find("no tree"),
            std::string::npos);
  EXPECT_NE(complaint(changed("\"count\":6", "\"count\":9")).find("missing"),
            std::string::npos);
  for (const auto* other : {"1e20", "-123", "\"51\""})
    EXPECT_NE(complaint(changed("5123", other)).find("no whole number"),
              std::string::npos);
  constexpr std::size_t levels = 1 << 20; // more than there is room for calls
  const auto nested = std::string(levels, '[') + std::string(levels, ']');
  EXPECT_NE(complaint(glb("{\"nodes\":[{\"mesh\":" + nested + "}],\"meshes\":[]}", ""))
                .find("JSON array is no whole number"),
            std::string::npos);
  EXPECT_NE(complaint(changed("\"byteLength\":60", "\"uri\":\"a.bin\"  ")), "");
  EXPECT_NE(complaint(changed("\"asset\"", "\"asset ")), "");
  EXPECT_NE(complaint("glTF" + std::string(200, '\0')), "");
}

TEST_F(SampledSurface, GlbThatRepeatsAMeshWithoutEndIsRefused)
{
  const float corners[] = {0, 0, 0, 4, 0, 0, 4, 3, 0};
  constexpr std::size_t indices = 100000; // a strip of as many triangles
  std::string nodes;
  for (int k = 0; k < 400; ++k)
    nodes += std::string(k > 0 ? "," : "") + "{\"mesh\":0}";
  const auto json =
      "{\"nodes\":[" + nodes +
      R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"mode":5}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
{"bufferView":1,"componentType":5121,"count":100000,"type":"SCALAR"}],
"bufferViews":[{"buffer":0},{"buffer":0,"byteOffset":36}],"buffers":[{}]})";
  const auto file =
      write("a.glb",
            glb(json,
                std::string(reinterpret_cast<const char*>(corners), sizeof(corners)) +
                    std::string(indices, '\1')));
  std::string lines, parts;
  for (int k = 0; k < 1200; ++k) {
    lines += std::string(k > 0 ? "," : "") + "{\"mode\":1}";
    parts += std::string(k > 0 ? "," : "") + "{\"mesh\":0}";
  }
  const auto other = write(
      "b.glb",
      glb("{\"nodes\":[" + parts + "],\"meshes\":[{\"primitives\":[" + lines + "]}]}",
          ""));
  for (const auto& path : {file, other})
    try {
      loadCloud(path);
      ADD_FAILURE();
    } catch (const ToolError& error) {
      EXPECT_NE(std::string(error.what()).find("repeats its meshes too often"),
                std::string::npos);
    }
}

TEST_F(SampledSurface, ObjIsKnownBehindCommentsAndByAnyName)
{
  const std::string body = "v 0 0 0\nv 4 0 0\nv 4 3 0\nf 1 2 3\n";
  expectBox(loadCloud(write("blender.obj", "# Blender\n# www\n" + body)),
            {0, 0, 0},
            {4, 3, 0});
  expectBox(loadCloud(write("a.OBJ", std::string(600, '#') + "\n" + body)),
            {0, 0, 0},
            {4, 3, 0});
  expectBox(loadCloud(write("mesh", "mtllib a.mtl\n" + body)), {0, 0, 0}, {4, 3, 0});
  EXPECT_FALSE(CloudStream::open(path("mesh")));
  const auto points = loadCloud(write("points.obj", "v 1 2 3 0.5 0.5 0.5\nv 4 0 0\n"));
  EXPECT_EQ(points.points->size(), 2u);
  EXPECT_EQ((*points.points)[0].z, 3.0f);
  ASSERT_EQ(points.notes.size(), 1u);
  EXPECT_THROW(loadCloud(write("none.obj", "o a\n")), ToolError);
  EXPECT_THROW(loadCloud(write("flat.obj", "v 0 0 0\nv 4 0 0\nf 1 2 2\n")), ToolError);
}
