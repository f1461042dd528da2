/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/scene_query.h"

#include "files/tool_error.h"
#include "support/folder_test.h"

#include <gtest/gtest.h>

using namespace pcl::indoor::tool;

namespace {

class SceneQueryFile : public pcl::indoor::test::FolderTest {
protected:
  /** Why a scene with such a version and more fields is not read. */
  std::string
  problemOf(const std::string& version, const std::string& more = "") const
  {
    const auto file =
        write("scene.json",
              R"({"format": "pcl_indoor scene", "version": )" + version + more + "}");
    try {
      readScene(file);
    } catch (const ToolError& error) {
      return error.what();
    }
    return "none";
  }
};

} // namespace

TEST_F(SceneQueryFile, OtherVersionsAreNamed)
{
  EXPECT_EQ(problemOf("2"), "none");
  EXPECT_NE(problemOf("3").find("version 3, but"), std::string::npos);
}

TEST_F(SceneQueryFile, ListsThatAreNestedDeepAreRefused)
{
  const std::string deep = std::string(300'000, '[') + std::string(300'000, ']');
  EXPECT_NE(problemOf(deep).find("nested more than"), std::string::npos);
  EXPECT_NE(problemOf("2", ", \"rooms\": " + deep).find("nested more than"),
            std::string::npos);
}
