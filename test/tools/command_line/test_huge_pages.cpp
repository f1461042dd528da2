/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/huge_pages.h"

#include "support/folder_test.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace pcl::indoor::tool;

using HugePages = pcl::indoor::test::FolderTest;

TEST_F(HugePages, AreAskedForWhereTheSystemGivesThemOnRequest)
{
  EXPECT_TRUE(areHugePagesOnRequest("always [madvise] never"));
  EXPECT_FALSE(areHugePagesOnRequest("[always] madvise never"));
  EXPECT_FALSE(areHugePagesOnRequest("always madvise [never]"));
  EXPECT_FALSE(areHugePagesOnRequest("")); // no such kernel
}

TEST_F(HugePages, FilesAndFoldersHaveASize)
{
  EXPECT_EQ(sizeOfInput(write("a.pcd", std::string(1000, 'a'))), 1000.0);
  write("b.pcd", std::string(234, 'b'));
  std::filesystem::create_directory(path("inner"));
  EXPECT_EQ(sizeOfInput(path("")), 1234.0);
  EXPECT_EQ(sizeOfInput(path("inner")), 0.0);
  EXPECT_EQ(sizeOfInput(path("none")), 0.0);
  EXPECT_EQ(sizeOfInput("-quiet"), 0.0);
  EXPECT_EQ(sizeOfInput(""), 0.0);
}
