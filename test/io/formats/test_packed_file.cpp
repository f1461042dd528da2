/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Packed by programs that are not ours: gzip, tar and Python's zipfile.
#include "files/opened_scan.h"
#include "files/sampled_surface.h"
#include "formats/packed_file.h"
#include "support/folder_test.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace pcl::indoor::tool {
namespace {

class PackedFiles : public test::FolderTest {
protected:
  void
  SetUp() override
  {
    FolderTest::SetUp();
    setenv("TMPDIR", path("").c_str(), 1);
  }

  void
  TearDown() override
  {
    unsetenv("TMPDIR");
    FolderTest::TearDown();
  }

  /** A PCD with points at x = first, first + 1 ... */
  std::string
  cloud(const std::string& name, int first, int count = 3)
  {
    const auto number = std::to_string(count);
    std::string text = "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
                       "WIDTH " +
                       number + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
                       number + "\nDATA ascii\n";
    for (int k = 0; k < count; ++k)
      text += std::to_string(first + k) + " 1 2\n";
    return write(name, text);
  }

  /** Run a command in the folder. */
  void
  run(const std::string& command)
  {
    ASSERT_EQ(std::system(("cd '" + path("") + "' && " + command).c_str()), 0);
  }

  static std::string
  problemOf(const std::string& file)
  {
    try {
      readWhole(openScan({file}, 0), {});
    } catch (const ToolError& error) {
      return error.what();
    }
    return "";
  }

  static std::size_t
  temporaryFolders()
  {
    namespace fs = std::filesystem;
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(fs::temp_directory_path()))
      count += entry.path().filename().string().rfind("pcl_indoor_", 0) == 0;
    return count;
  }
};

TEST_F(PackedFiles, OfOneFileAreReadAsItIs)
{
  cloud("a.pcd", 5);
  run("gzip -k a.pcd; tar czf a.tgz a.pcd; xz -k a.pcd; python3 -m zipfile -c A.ZIP "
      "a.pcd");
  for (const auto* name : {"a.pcd.gz", "a.tgz", "a.pcd.xz", "A.ZIP"}) {
    EXPECT_TRUE(isPacked(path(name))) << name;
    const auto file = loadSurface(path(name));
    EXPECT_EQ(file.path, path(name));
    ASSERT_EQ(file.points->size(), 3u) << name;
    EXPECT_EQ((*file.points)[1].x, 6.0f);
    const auto scan = readWhole(openScan({path(name)}, 0), {});
    EXPECT_EQ(scan.file.path, path(name));
    EXPECT_EQ(scan.file.cloud.data, loadCloud(path("a.pcd")).cloud.data) << name;
  }
  EXPECT_FALSE(isPacked(path("a.pcd")));
  EXPECT_EQ(temporaryFolders(), 0u);
}

TEST_F(PackedFiles, OfSeveralScansAreStationsAsThoseOfAFolder)
{
  std::filesystem::create_directory(path("one"));
  std::filesystem::create_directory(path("two"));
  cloud("one/a.pcd", 0);
  cloud("two/a.pcd", 10, 2); // the same name
  write("two/read.me", "nothing");
  run("python3 -m zipfile -c all.zip one two");
  auto opened = openScan({path("all.zip")}, 0);
  EXPECT_EQ(opened.name, path("all.zip"));
  EXPECT_EQ(opened.files.size(), 2u);
  EXPECT_EQ(opened.notes.size(), 1u);
  const auto scan = readWhole(std::move(opened), {});
  ASSERT_EQ(scan.file.points->size(), 5u);
  EXPECT_THROW(loadCloud(path("all.zip")), ToolError); // takes one
  EXPECT_EQ(temporaryFolders(), 0u);
}

TEST_F(PackedFiles, LastAsLongAsTheStreamThatReadsThem)
{
  std::string points(12, '\0'); // one at the origin
  write("b.pcd",
        "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\n"
        "HEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA binary\n" +
            points + points);
  run("gzip b.pcd");
  {
    const auto scan = readLater(openScan({path("b.pcd.gz")}, 1), {});
    EXPECT_EQ(temporaryFolders(), 1u);
    ASSERT_EQ(scan.pointCount(), 2u);
    EXPECT_EQ(scan.stream->read(0, 2).data.size(), 24u);
  }
  EXPECT_EQ(temporaryFolders(), 0u);
}

TEST_F(PackedFiles, OneMeshWithItsPicturesIsRead)
{
  write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write("m.jpg", "\xff\xd8\xff");
  run("python3 -m zipfile -c m.zip m.obj m.jpg");
  EXPECT_GT(readWhole(openScan({path("m.zip")}, 0), {}).file.points->size(), 1000u);
}

TEST_F(PackedFiles, ThatCannotBeReadAreRefusedInOneLine)
{
  write("cut.gz", "\x1f\x8b\x08");
  EXPECT_NE(problemOf(path("cut.gz")).find("cut.gz: it cannot be unpacked"),
            std::string::npos);
  cloud("long.pcd", 0, 5000);
  write("read.me", "nothing");
  run("python3 -m zipfile -c long.zip long.pcd; head -c 300 long.zip > cut.zip; "
      "python3 -m zipfile -c none.zip read.me; mkdir -p empty; "
      "tar cf none.tar empty read.me; gzip -k read.me; gzip -k long.pcd; "
      "python3 -m zipfile -c twice.zip long.pcd.gz");
  EXPECT_NE(problemOf(path("twice.zip")).find("long.pcd.gz in it is packed, too"),
            std::string::npos);
  EXPECT_NE(problemOf(path("cut.zip")).find("cut.zip: it cannot be unpacked"),
            std::string::npos);
  EXPECT_NE(problemOf(path("none.tar")).find("read.me: "), std::string::npos);
  EXPECT_NE(problemOf(path("read.me.gz")), "");
  EXPECT_EQ(temporaryFolders(), 0u);
}

TEST_F(PackedFiles, DocumentsThatAreZipFilesAreNone)
{
  for (const auto* name : {"a.usdz", "a.npz", "a.rcp"})
    EXPECT_FALSE(isPacked(write(name, "PK\x03\x04 and more"))) << name;
}

} // namespace
} // namespace pcl::indoor::tool
