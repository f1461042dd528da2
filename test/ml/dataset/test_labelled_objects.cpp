/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/tool_error.h"
#include "objects/labelled_objects.h"
#include "objects/object_files.h"
#include "support/folder_test.h"

#include <pcl/console/print.h>

#include <cmath>
#include <iostream>
#include <set>

using namespace pcl::indoor::tool;

namespace {

const char* const good_cloud =
    "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 4\nHEIGHT 1\n"
    "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 4\nDATA ascii\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n";

class LabelledObjectFiles : public pcl::indoor::test::FolderTest {
protected:
  void
  file(const std::string& name, const std::string& text = good_cloud) const
  {
    std::filesystem::create_directories(
        std::filesystem::path(path(name)).parent_path());
    write(name, text);
  }

  LabelledObjects
  load(unsigned int threads = 1) const
  {
    StageReport report;
    return loadLabelledObjects(path("set"), 3, threads, report);
  }

  std::string
  complaint() const
  {
    try {
      load();
    } catch (const ToolError& error) {
      return error.what();
    }
    return "";
  }
};

/** Objects of a number of classes; their paths are CLASS/NUMBER.pcd. */
LabelledObjects
objectsOf(const std::vector<int>& counts)
{
  LabelledObjects objects;
  for (std::size_t c = 0; c < counts.size(); ++c) {
    objects.class_names.push_back("class" + std::to_string(c));
    for (int k = 0; k < counts[c]; ++k) {
      objects.paths.push_back(objects.class_names.back() + "/" + std::to_string(k) +
                              ".pcd");
      objects.labels.push_back(static_cast<int>(c));
    }
  }
  return objects;
}

template <typename Split>
std::string
complaintOf(const Split& split)
{
  try {
    split();
  } catch (const ToolError& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_F(LabelledObjectFiles, ClassesAreTheFirstFolders)
{
  file("set/chair/train/b.pcd");
  file("set/chair/a.pcd");
  file("set/chair-2/a.pcd");
  file("set/bed/deep/er/c.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  file("set/bed/notes.txt");
  for (const unsigned int threads : {1u, 3u}) {
    const auto objects = load(threads);
    EXPECT_EQ(objects.class_names,
              (std::vector<std::string>{"bed", "chair-2", "chair"}));
    EXPECT_EQ(
        objects.paths,
        (std::vector<std::string>{
            "bed/deep/er/c.off", "chair-2/a.pcd", "chair/a.pcd", "chair/train/b.pcd"}));
    EXPECT_EQ(objects.labels, (std::vector<int>{0, 1, 2, 2}));
    ASSERT_EQ(objects.clouds.size(), 4u);
    EXPECT_EQ(objects.clouds[0]->size(), 2048u);
    EXPECT_EQ(objects.clouds[3]->size(), 4u);
  }
}

TEST_F(LabelledObjectFiles, ReadingInThreadsLeavesTheConsoleAsItWas)
{
  for (int k = 0; k < 20; ++k)
    file((k % 2 == 0 ? "set/bed/" : "set/cup/") + std::to_string(k) + ".pcd");
  const auto level = pcl::console::getVerbosityLevel();
  auto* const buffer = std::cerr.rdbuf();
  for (int round = 0; round < 200; ++round) {
    load(8);
    ASSERT_EQ(pcl::console::getVerbosityLevel(), level) << round;
    ASSERT_EQ(std::cerr.rdbuf(), buffer) << round;
  }
}

TEST_F(LabelledObjectFiles, EqualPointsDoNotSearchEachOther)
{
  // 200,000 points in each of three places and a few elsewhere: 10^11 neighbours, were
  // each point to find all
  constexpr int count = 600006;
  std::string text = "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
                     "WIDTH 600006\nHEIGHT 1\nPOINTS 600006\nDATA ascii\n";
  for (int i = 0; i < count; ++i)
    text += i % 3 == 0 ? "0 0 0\n" : i % 3 == 1 ? "1 0 0\n" : "0 1 0\n";
  file("equal.pcd", text);
  const auto object = loadObject(path("equal.pcd"), 10);
  ASSERT_EQ(object->size(), static_cast<std::size_t>(count));
  file("few.pcd"); // as many neighbours as there are points
  const auto few = loadObject(path("few.pcd"), 4);
  for (const auto& point : *few)
    EXPECT_NEAR(std::abs(point.normal_z), 1, 1e-6f);
}

TEST_F(LabelledObjectFiles, FilesMayBeLinks)
{
  file("elsewhere/a.pcd");
  file("set/bed/b.pcd");
  std::filesystem::create_directories(path("set/cup"));
  std::filesystem::create_symlink(path("elsewhere/a.pcd"), path("set/cup/a.pcd"));
  StageReport report;
  for (const auto& folder : {path("set"), path("set/"), path("set/../set/.")})
    EXPECT_EQ(loadLabelledObjects(folder, 3, 1, report).paths,
              (std::vector<std::string>{"bed/b.pcd", "cup/a.pcd"}))
        << folder;
}

TEST_F(LabelledObjectFiles, NamesTheFirstUnreadableFileAndTheirNumber)
{
  EXPECT_EQ(complaint(), path("set") + ": no such folder");
  file("set/bed/a.pcd");
  EXPECT_EQ(complaint(), path("set") + ": at least two class folders are needed");
  file("set/chair/a.pcd");
  EXPECT_EQ(complaint(), "");
  file("set/bed/b.off", "OFF\n");
  EXPECT_EQ(complaint(),
            path("set/bed/b.off") +
                ": truncated, the numbers of vertices and faces are missing");
  file("set/chair/c.pcd", "");
  EXPECT_EQ(complaint(),
            path("set/bed/b.off") +
                ": truncated, the numbers of vertices and faces are "
                "missing (the first of 2 unreadable files of 4)");
  file("set/a.pcd");
  EXPECT_EQ(complaint(), "a.pcd: lies in no class folder of " + path("set"));
}

TEST(ObjectSplit, TakesTheShareOfEachClass)
{
  const auto objects = objectsOf({10, 2, 5, 100});
  const auto split = splitAtRandom(objects, 0.8, 3);
  std::vector<int> training(4), test(4);
  for (const auto k : split.training)
    ++training[static_cast<std::size_t>(objects.labels[k])];
  for (const auto k : split.test)
    ++test[static_cast<std::size_t>(objects.labels[k])];
  EXPECT_EQ(training, (std::vector<int>{8, 1, 4, 80}));
  EXPECT_EQ(test, (std::vector<int>{2, 1, 1, 20}));
  std::set<std::size_t> all(split.training.begin(), split.training.end());
  all.insert(split.test.begin(), split.test.end());
  EXPECT_EQ(all.size(), objects.labels.size());
  EXPECT_EQ(splitAtRandom(objects, 0.8, 3).test, split.test);
  EXPECT_NE(splitAtRandom(objects, 0.8, 4).test, split.test);
}

TEST(ObjectSplit, EachObjectIsTestedInItsShareOfTheSeeds)
{
  const auto objects = objectsOf({10});
  std::vector<int> tested(10);
  for (std::uint32_t seed = 0; seed < 1000; ++seed)
    for (const auto k : splitAtRandom(objects, 0.7, seed).test)
      ++tested[k];
  for (const int count : tested)
    EXPECT_NEAR(count, 300, 4 * std::sqrt(1000 * 0.3 * 0.7));
}

TEST(ObjectSplit, AClassOfOneObjectCannotBeSplit)
{
  EXPECT_EQ(complaintOf([] {
              splitAtRandom(objectsOf({3, 1}), 0.5, 1);
            }),
            "class1: a class needs two objects to be split, it has 1");
}

TEST(ObjectSplit, FollowsTheFoldersOfModelNet)
{
  LabelledObjects objects;
  objects.paths = {"bed/test/bed_2.off", "bed/train/bed_1.off", "cup/train/x/c.off"};
  objects.labels = {0, 0, 1};
  objects.class_names = {"bed", "cup"};
  const auto split = splitByFolders(objects);
  EXPECT_EQ(split.training, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(split.test, (std::vector<std::size_t>{0}));
  objects.paths[0] = "bed/train/bed_2.off";
  EXPECT_EQ(complaintOf([&] { splitByFolders(objects); }),
            "there is no object in the folders test");
  for (const std::string path : {"bed/test", "bed/test.off", "bed/other/test/1.off"}) {
    objects.paths[0] = path;
    EXPECT_EQ(complaintOf([&] { splitByFolders(objects); }),
              path + ": lies in neither folder train nor test of its class");
  }
}

TEST(ObjectSplit, IsNamedByAText)
{
  auto objects = objectsOf({2, 2});
  objects.paths = {
      "class0/train/a", "class0/train/b", "class1/train/c", "class1/test/d"};
  EXPECT_EQ(splitNamed(objects, "none", 1).training.size(), 4u);
  EXPECT_EQ(splitNamed(objects, "random:0.5", 7).test,
            splitAtRandom(objects, 0.5, 7).test);
  EXPECT_EQ(splitNamed(objects, "folders", 1).test, (std::vector<std::size_t>{3}));
  EXPECT_EQ(complaintOf([&] { splitNamed(objects, "no_such_list", 1); }),
            "no_such_list: no such list of the test part");
  objects.paths[2] = "class1/test/c";
  EXPECT_EQ(complaintOf([&] { splitNamed(objects, "folders", 1); }),
            "class1: the split leaves no object of this class to train with");
  EXPECT_EQ(randomShare("random:0.8"), 0.8);
  EXPECT_EQ(randomShare("random"), std::nullopt);
  for (const std::string split :
       {"random:", "random:0", "random:1", "random:nan", "random:0.5x"})
    EXPECT_EQ(complaintOf([&] { randomShare(split); }),
              "-split: '" + split +
                  "' has no share of the training part between 0 and 1, as "
                  "random:0.8 has");
}

TEST(ObjectSplit, SetsAShareOfATrainingPartAside)
{
  const auto objects = objectsOf({10, 10});
  const std::vector<std::size_t> training = {1, 3, 5, 7, 9, 10, 11, 12, 13, 14};
  const auto split = withoutShare(objects, training, 0.2, 3);
  EXPECT_EQ(split.training.size(), 8u);
  ASSERT_EQ(split.test.size(), 2u); // one of each class
  EXPECT_LT(split.test[0], 10u);
  EXPECT_GE(split.test[1], 10u);
  std::set<std::size_t> all(split.training.begin(), split.training.end());
  all.insert(split.test.begin(), split.test.end());
  EXPECT_EQ(all, std::set<std::size_t>(training.begin(), training.end()));
  EXPECT_EQ(withoutShare(objects, training, 0.0, 3).training, training);
}

TEST_F(LabelledObjectFiles, FollowsAList)
{
  LabelledObjects objects;
  objects.paths = {"bed/bed_0001.off",
                   "bed/bed_00012.off",
                   "bed/scene0011_00_bed.ply",
                   "cup/scene0011_01_cup.ply",
                   "cup/x/cup.v2.pcd"};
  const auto tested = [&](const std::string& list) {
    file("list", list);
    return splitByList(objects, path("list")).test;
  };
  using Test = std::vector<std::size_t>;
  EXPECT_EQ(tested("bed_0001\n\n"), Test{0});
  EXPECT_EQ(tested("bed_0001.off\r\nbed/bed_00012"), (Test{0, 1}));
  EXPECT_EQ(tested("scene0011_00\n"), Test{2});
  EXPECT_EQ(tested("scene0011\nnot_there\n"), (Test{2, 3}));
  EXPECT_EQ(tested("cup/x/cup.v2.pcd\n"), Test{4});
  EXPECT_EQ(splitByList(objects, path("list")).training, (Test{0, 1, 2, 3}));
  EXPECT_EQ(complaintOf([&] { tested("be\n"); }),
            path("list") + ": names none of the objects");
  EXPECT_EQ(complaintOf([&] { tested("bed\nscene0011\ncup.v2\n"); }),
            path("list") + ": names all objects, none is left to train with");
  EXPECT_EQ(complaintOf([&] { splitByList(objects, path("none")); }),
            path("none") + ": no such list of the test part");
}
