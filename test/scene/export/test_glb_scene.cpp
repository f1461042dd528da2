/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/glb_scene.h"

#include "support/folder_test.h"
#include "support/small_scene.h"

#include <pcl/io/scan_file.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

using namespace pcl::indoor::tool;
using pcl::indoor::test::SceneJson;
using pcl::indoor::test::SmallScene;

namespace {

std::uint32_t
wordAt(const std::string& bytes, std::size_t at)
{
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof(word));
  return word;
}

SceneJson
jsonOf(const std::string& bytes)
{
  return SceneJson::parse(bytes.substr(20, wordAt(bytes, 12)));
}

using GlbSceneFile = pcl::indoor::test::FolderTest;

} // namespace

TEST(GlbScene, ObjectsAreNodesWithClassAndConfidence)
{
  const auto bytes = glbBytes(savedScene(SmallScene::json()));
  ASSERT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(wordAt(bytes, 8), bytes.size());
  const auto json = jsonOf(bytes);
  std::size_t chairs = 0, walls = 0;
  for (const auto& node : json["nodes"]) {
    const auto extras = node.value("extras", SceneJson::object());
    walls += extras.value("kind", "") == "wall";
    if (extras.value("class", "") != "chair")
      continue;
    ++chairs;
    EXPECT_EQ(extras["confidence"], 0.75);
    EXPECT_EQ(node["scale"], SceneJson({0.6, 0.5, 1.0}));
  }
  EXPECT_EQ(chairs, 2u);
  EXPECT_EQ(walls, 2u);
}

TEST(GlbScene, ColumnsAreNodes)
{
  auto scene = SmallScene::json();
  scene["columns"] = {SmallScene::column(false), SmallScene::column(true)};
  const auto json = jsonOf(glbBytes(savedScene(scene)));
  std::size_t columns = 0;
  for (const auto& node : json["nodes"])
    if (node.value("extras", SceneJson::object()).value("kind", "") == "column") {
      ++columns;
      EXPECT_TRUE(node.contains("mesh"));
    }
  EXPECT_EQ(columns, 2u);
}

TEST(GlbScene, BufferViewsLieInTheBuffer)
{
  const auto bytes = glbBytes(savedScene(SmallScene::json()));
  const auto json = jsonOf(bytes);
  const auto size = json["buffers"][0]["byteLength"].get<std::size_t>();
  EXPECT_EQ(wordAt(bytes, 20 + wordAt(bytes, 12)), size);
  std::size_t end = 0;
  for (const auto& view : json["bufferViews"]) {
    EXPECT_EQ(view["byteOffset"], end);
    end += view["byteLength"].get<std::size_t>();
  }
  EXPECT_EQ(end, size);
}

TEST_F(GlbSceneFile, IsReadAsAMeshOfItsSize)
{
  const auto path = write("scene.glb", glbBytes(savedScene(SmallScene::json())));
  pcl::indoor::ScanOptions options;
  const auto scan = pcl::indoor::loadScan(path, options);
  Eigen::Vector3f low = Eigen::Vector3f::Constant(INFINITY), high = -low;
  for (const auto& point : *scan.points()) {
    low = low.cwiseMin(point.getVector3fMap());
    high = high.cwiseMax(point.getVector3fMap());
  }
  // y is up in glTF: from below the stairs to the chair upstairs; z is -y
  EXPECT_NEAR(high.y(), 4.0f, 0.05f);
  EXPECT_NEAR(low.y(), 0.0f, 0.05f);
  EXPECT_NEAR(low.z(), -3.0f, 0.05f);
  EXPECT_NEAR(high.x(), 20.3f, 0.05f);
}

TEST(GlbScene, AnEmptySceneHasNoEmptyLists)
{
  auto json = SmallScene::json();
  for (const char* list : {"storeys", "rooms", "walls", "openings", "objects"})
    json[list] = SceneJson::array();
  const auto glb = jsonOf(glbBytes(savedScene(json)));
  EXPECT_FALSE(glb.contains("buffers"));
  EXPECT_FALSE(glb.contains("meshes"));
  EXPECT_EQ(glb["nodes"].size(), 1u);
}
