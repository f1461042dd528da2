/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/scene_files.h"

#include "files/tool_error.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <map>

using namespace pcl::indoor::tool;
using pcl::indoor::test::SmallScene;

namespace {

std::vector<std::string>
namesOf(const std::string& path)
{
  std::vector<std::string> names;
  for (const auto& [name, bytes] :
       exportedFiles(savedScene(SmallScene::json()), path, {}))
    names.push_back(name);
  return names;
}

} // namespace

TEST(SceneFiles, TheEndingSaysTheFormat)
{
  const std::map<std::string, std::string> begins = {{"a.ifc", "ISO-10303-21;"},
                                                     {"a.IFC", "ISO-10303-21;"},
                                                     {"a.glb", "glTF"},
                                                     {"a.geojson", "{"},
                                                     {"a.dxf", "0\nSECTION"},
                                                     {"a.svg", "<svg"}};
  for (const auto& [path, begin] : begins) {
    const auto files = exportedFiles(savedScene(SmallScene::json()), path, {});
    ASSERT_EQ(files.size(), 1u);
    EXPECT_EQ(files[0].first, path);
    EXPECT_EQ(files[0].second.rfind(begin, 0), 0u) << path;
  }
  for (const char* path : {"a", "a.json", "a.ifc.zip", ".ifc", ""})
    EXPECT_THROW(requireExportFormat(path), ToolError) << path;
}

TEST(SceneFiles, RobotsGetMapsAndGraphsOfAllStoreys)
{
  EXPECT_EQ(namesOf("f.x/map.pgm"),
            (std::vector<std::string>{"f.x/map_storey1_route.geojson",
                                      "f.x/map_storey1_furnished.yaml",
                                      "f.x/map_storey1_furnished.pgm",
                                      "f.x/map_storey1.yaml",
                                      "f.x/map_storey1.pgm",
                                      "f.x/map_route.geojson",
                                      "f.x/map_furnished.yaml",
                                      "f.x/map_furnished.pgm",
                                      "f.x/map.yaml",
                                      "f.x/map.pgm"}));
}

TEST(SceneFiles, WithoutRoomsThereIsNoMap)
{
  auto json = SmallScene::json();
  for (const char* list : {"storeys", "rooms", "walls", "openings", "objects"})
    json[list] = pcl::indoor::test::SceneJson::array();
  EXPECT_THROW(exportedFiles(savedScene(json), "map.pgm", {}), ToolError);
}
