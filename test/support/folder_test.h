/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace pcl::indoor::test {

/** What a file holds; nothing if it is missing. */
inline std::string
bytesOf(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

/** A test with a folder of its own, gone afterwards. */
class FolderTest : public testing::Test {
protected:
  void
  SetUp() override
  {
    std::string name =
        (std::filesystem::temp_directory_path() / "pcl_indoor_XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }

  void
  TearDown() override
  {
    std::filesystem::remove_all(folder_);
  }

  std::string
  path(const std::string& name) const
  {
    return (folder_ / name).string();
  }

  /** Write a file; its path. */
  std::string
  write(const std::string& name, const std::string& bytes) const
  {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

private:
  std::filesystem::path folder_;
};

/** Tests whose folders begin with the same files, which are made once. */
template <class Maker>
class PreparedFolderTest : public FolderTest {
protected:
  /** Maker::make() gets the path of a folder and returns whether it could fill it. */
  static void
  SetUpTestSuite()
  {
    std::string name =
        (std::filesystem::temp_directory_path() / "pcl_indoor_XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    prepared_ = name;
    ASSERT_TRUE(Maker::make(prepared_.string()));
  }

  static void
  TearDownTestSuite()
  {
    std::filesystem::remove_all(prepared_);
  }

  void
  SetUp() override
  {
    ASSERT_NO_FATAL_FAILURE(FolderTest::SetUp());
    for (const auto& entry : std::filesystem::directory_iterator(prepared_))
      std::filesystem::copy(entry.path(), path(entry.path().filename().string()));
  }

private:
  inline static std::filesystem::path prepared_;
};

} // namespace pcl::indoor::test
