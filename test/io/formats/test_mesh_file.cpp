/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/mesh_file.h"
#include "objects/object_files.h"
#include "support/folder_test.h"

using namespace pcl::indoor::tool;

namespace {

class MeshFile : public pcl::indoor::test::FolderTest {
protected:
  /** What reading an object complains about; "" if it does not. */
  std::string
  complaint(const std::string& name, const std::string& text) const
  {
    const auto where = write(name, text);
    try {
      loadObject(where, 10);
    } catch (const ToolError& error) {
      const std::string said = error.what();
      EXPECT_EQ(said.find('\n'), std::string::npos) << said;
      EXPECT_EQ(said.rfind(where + ": ", 0), 0u) << said;
      return said.substr(std::min(said.size(), where.size() + 2));
    }
    return "";
  }
};

/** A roof of two faces: a square and a triangle. */
const char* const vertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 2\n";
const std::string roof =
    std::string("OFF\n5 2 0\n") + vertices + "4 0 1 2 3\n3 0 1 4\n";

void
expectRoof(const Mesh& mesh)
{
  ASSERT_EQ(mesh.vertices.size(), 5u);
  EXPECT_EQ(mesh.vertices[2], Eigen::Vector3f(1, 1, 0));
  EXPECT_EQ(mesh.vertices[4], Eigen::Vector3f(0, 0, 2));
  using Triangle = std::array<std::uint32_t, 3>;
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 1, 4}}));
}

} // namespace

TEST_F(MeshFile, ReadsOffWithEveryFormOfHeader)
{
  for (const std::string header : {"OFF\n5 2 0\n",
                                   "OFF 5 2 0\n",
                                   "OFF5 2 0\n",
                                   "OFF5 2\n",
                                   "# a roof\nOFF # really\n\n  5 2 0\r\n"})
    expectRoof(readMesh(write("a.off", header + roof.substr(10))));
  expectRoof(readMesh(write("a.off",
                            "COFF\n5 2 0\n0 0 0 9 9 9\n1 0 0 9 9 9\n1 1 0 9 9 9\n"
                            "0 1 0 9 9 9\n0 0 2 9 9 9\n4 0 1 2 3 255 0 0\n3 0 1 4")));
}

TEST_F(MeshFile, ReadsObj)
{
  expectRoof(readMesh(write("a.obj",
                            "mtllib none.mtl\no roof\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0\n"
                            "v 0 1 0\nvn 0 0 1\nvt 0 0\nv 0 0 +2\ns off\n"
                            "f 1 2/1 3//1 4/1/1\nf -5 -4 -1\n")));
}

TEST_F(MeshFile, ReadsPlyFacesAfterOtherElements)
{
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
      "property float z\nelement edge 1\nproperty int a\nelement face 2\n"
      "property uchar flags\nproperty list uchar int vertex_indices\n"
      "property list uchar float weights\nend_header\n" +
      std::string(vertices) + "7\n0 4 0 1 2 3 1 0.5\n0 3 0 1 4 0\n";
  expectRoof(plyMesh(loadCloud(write("a.ply", text))));
  const auto points =
      text.substr(0, text.find("element face")) + "end_header\n" + vertices + "7\n";
  EXPECT_TRUE(plyMesh(loadCloud(write("b.ply", points))).triangles.empty());
  EXPECT_EQ(loadObject(path("b.ply"), 4)->size(), 5u);
}

TEST_F(MeshFile, ReadsBinaryPlyFaces)
{
  std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty "
                     "float x\nproperty float y\nproperty float z\nelement face 1\n"
                     "property list uchar uint vertex_index\nend_header\n";
  const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::uint32_t face[] = {2, 0, 1};
  text.append(reinterpret_cast<const char*>(corners), sizeof(corners));
  text += '\3';
  text.append(reinterpret_cast<const char*>(face), sizeof(face));
  const auto mesh = plyMesh(loadCloud(write("a.ply", text)));
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.triangles[0], (std::array<std::uint32_t, 3>{2, 0, 1}));
  EXPECT_NE(complaint("b.ply", text.substr(0, text.size() - 1)), "");
}

TEST_F(MeshFile, PlyFacesNameTheirVerticesByNumbersOfAnyType)
{
  // more vertices than a byte counts, of which -1 would be the 255th
  std::string head = "ply\nformat ascii 1.0\nelement vertex 300\nproperty float x\n"
                     "property float y\nproperty float z\nelement face 1\n"
                     "property list uchar ";
  std::string body = " vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n";
  for (int i = 3; i < 300; ++i)
    body += "2 2 2\n";
  for (const char* type : {"char", "short", "int", "float", "double"}) {
    const auto mesh =
        plyMesh(loadCloud(write("a.ply", head + type + body + "3 0 1 2")));
    ASSERT_EQ(mesh.triangles.size(), 1u) << type;
    EXPECT_EQ(mesh.triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2})) << type;
    EXPECT_EQ(complaint("a.ply", head + type + body + "3 0 1 -1"),
              "a face names vertex 4294967295 of 300, from 0")
        << type;
  }
}

TEST_F(MeshFile, LoadsObjectsByTheirArea)
{
  // 1 m^2 lies, 1 m^2 stands
  const auto object = loadObject(write("a.off", roof), 10);
  ASSERT_EQ(object->size(), mesh_point_count);
  std::size_t lying = 0;
  for (const auto& point : *object)
    lying += point.normal_z == 1.0f;
  EXPECT_NEAR(static_cast<double>(lying), mesh_point_count / 2.0, 2.0);
}

TEST_F(MeshFile, KeepsTheShapeFarFromTheOrigin)
{
  const auto mesh =
      readMesh(write("a.obj",
                     "v 691000.25 5334000.5 512\nv 691000.75 5334000.5 512\n"
                     "v 691000.25 5334001.5 512\nf 1 2 3\n"));
  EXPECT_FLOAT_EQ(mesh.vertices[1].x() - mesh.vertices[0].x(), 0.5f);
  EXPECT_FLOAT_EQ(mesh.vertices[2].y() - mesh.vertices[0].y(), 1.0f);
  EXPECT_LT(mesh.vertices[0].norm(), 2.0f);
}

TEST_F(MeshFile, SaysWhatIsWrongWithOff)
{
  EXPECT_EQ(complaint("a.off", roof), "");
  EXPECT_EQ(complaint("a.off", ""), "the file is empty");
  EXPECT_EQ(complaint("a.off", "Dear reader"),
            "not an OFF file, its first line is no 'OFF'");
  EXPECT_EQ(complaint("a.off", "OFF\n"),
            "truncated, the numbers of vertices and faces are missing");
  EXPECT_EQ(complaint("a.off", "OFF\n5\n"), "line 2 has too few numbers");
  EXPECT_EQ(complaint("a.off", roof.substr(0, 28)),
            "truncated, its header promises 5 vertices, there are 3");
  EXPECT_EQ(
      complaint("a.off", "OFF\n18446744073709551615 1 0\n0 0 0\n"),
      "truncated, its header promises 18446744073709551615 vertices, there are 1");
  EXPECT_EQ(complaint("a.off", roof.substr(0, roof.size() - 8)),
            "truncated, its header promises 2 faces, there are 1");
  EXPECT_EQ(complaint("a.off", roof.substr(0, roof.size() - 3)),
            "line 9 names 2 of 3 corners");
  EXPECT_EQ(complaint("a.off", "OFF\n-5 2 0\n"),
            "line 2 holds '-5', which is no number of its kind");
  EXPECT_EQ(complaint("a.off", "OFF\n3 1 0\n0 0 0\n1 0 x\n0 1 0\n3 0 1 2\n"),
            "line 4 holds 'x', which is no number of its kind");
  EXPECT_EQ(complaint("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
            "line 6 names vertex 3 of 3, from 0");
  EXPECT_EQ(complaint("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n"),
            "line 6 names 3 of 4000000000 corners");
  EXPECT_EQ(complaint("a.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"),
            "the mesh has no faces");
  EXPECT_EQ(complaint("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n"),
            "no face of the mesh has an area");
  EXPECT_EQ(complaint("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\nnan 0 0\n3 0 1 2\n"),
            "no face of the mesh has an area");
}

TEST_F(MeshFile, SaysWhatIsWrongWithObjAndPly)
{
  EXPECT_EQ(complaint("a.obj", "v 0 0 0\n"), "the mesh has no faces");
  EXPECT_EQ(complaint("a.obj", "v 0 0\n"), "line 1 has too few numbers");
  EXPECT_EQ(complaint("a.obj", "v 0 0 0\nf 1 1\n"),
            "line 2 is a face of fewer than three corners");
  EXPECT_EQ(complaint("a.obj", "v 0 0 0\nf 1 1 2\n"),
            "line 2 names vertex 2 of 1 so far");
  EXPECT_EQ(complaint("a.obj", "v 0 0 0\nf 1 1 0\n"),
            "line 2 names vertex 0 of 1 so far");
  EXPECT_EQ(complaint("a.obj", "v 0 0 0\nf 1 1 -2\n"),
            "line 2 names vertex -2 of 1 so far");
  EXPECT_EQ(complaint("a.obj", "v 0 0 0\nf 1 1 99999999999999999999\n"),
            "line 2 holds '99999999999999999999', which is no number of its kind");
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list int int vertex_indices\n"
      "end_header\n0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(complaint("a.ply", ply + "3 0 1 2\n"), "");
  EXPECT_EQ(complaint("a.ply", ply + "3 0 1 3\n"),
            "a face names vertex 3 of 3, from 0");
  EXPECT_NE(complaint("a.ply", ply + "3 0 1\n"), "");
  EXPECT_NE(complaint("a.ply", ply + "-1 0 1 2\n"), "");
  EXPECT_NE(complaint("a.ply", ply), "");
}
