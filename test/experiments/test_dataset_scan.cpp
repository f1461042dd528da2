/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Runs pcl_dataset_scan, found by PCL_INDOOR_TOOLS, on small scans in the layouts of
// the data sets.
#include "files/cloud_file.h"
#include "support/folder_test.h"
#include "support/png_bytes.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <sys/wait.h> // for WEXITSTATUS

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

using namespace pcl::indoor::tool;

namespace {

using pcl::indoor::test::bytesOf;
using pcl::indoor::test::pngBytes;
using Json = nlohmann::json;
using Numbers = std::vector<std::uint32_t>;
using Names = std::vector<std::string>;
using Text = std::vector<std::string>;

class DatasetScan : public pcl::indoor::test::FolderTest {
protected:
  void
  save(const std::string& name, const std::string& bytes) const
  {
    std::filesystem::create_directories(
        std::filesystem::path(path(name)).parent_path());
    write(name, bytes);
  }

  int
  run(const std::string& options) const
  {
    const std::string command = "cd " + path("") + " && " + PCL_INDOOR_TOOLS +
                                "/pcl_dataset_scan " + options + " > out 2> said";
    return std::system(command.c_str());
  }

  CloudFile
  convert(const std::string& options) const
  {
    EXPECT_EQ(run(options + " out.pcd -json out.json"), 0) << bytesOf(path("said"));
    return loadCloud(path("out.pcd"), {}, 1);
  }

  Json
  names() const
  {
    return Json::parse(bytesOf(path("out.json")));
  }

  void
  expectRefused(const std::string& options, const std::string& reason) const
  {
    const int status = run(options + " bad.pcd");
    ASSERT_TRUE(WIFEXITED(status)) << options;
    EXPECT_EQ(WEXITSTATUS(status), 1) << options;
    const auto said = bytesOf(path("said"));
    EXPECT_NE(said.find(reason), std::string::npos) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    EXPECT_FALSE(std::filesystem::exists(path("bad.pcd"))) << options;
  }
};

/** "x y z rrggbb" of each point. */
Text
pointsOf(const CloudFile& file)
{
  Text text;
  const bool has_color = hasField(file.cloud, "rgb") || hasField(file.cloud, "rgba");
  const auto name = hasField(file.cloud, "rgb") ? "rgb" : "rgba";
  for (std::size_t i = 0; i < file.points->size(); ++i) {
    const auto& point = (*file.points)[i];
    char line[80];
    std::uint32_t color = 0;
    if (has_color)
      for (const auto& field : file.cloud.fields)
        if (field.name == name)
          std::memcpy(
              &color, &file.cloud.data[i * file.cloud.point_step + field.offset], 4);
    std::snprintf(line,
                  sizeof(line),
                  "%g %g %g %06x",
                  static_cast<double>(point.x),
                  static_cast<double>(point.y),
                  static_cast<double>(point.z),
                  color & 0xffffffu);
    text.emplace_back(line);
  }
  return text;
}

// S3DIS

class S3dis : public DatasetScan {
protected:
  void
  SetUp() override
  {
    DatasetScan::SetUp();
    save("area/office_1/Annotations/chair_1.txt", "1 2 3 255 0 16\n1.5 2 3 1 2 3\n");
    save("area/office_1/Annotations/wall_2.txt", "4 5 6 0 0 0\n");
    save("area/office_1/office_1.txt", "1 2 3 255 0 16\n");
    save("area/hall_1/Annotations/robot_1.txt", "7 8 9 9 9 9\n");
    save("area/hall_1/Annotations/Icon", "");
    save("area/hall_1/Annotations/.hidden_1.txt", "");
    save("area/area_alignmentAngle.txt", "## hall_1 0\n");
  }
};

TEST_F(S3dis, OfARoomEachFileIsAnObject)
{
  const auto file = convert("area/office_1");
  EXPECT_EQ(pointsOf(file), (Text{"1 2 3 ff0010", "1.5 2 3 010203", "4 5 6 000000"}));
  EXPECT_EQ(readLabels(file, "object"), (Numbers{1, 1, 2}));
  EXPECT_EQ(readLabels(file, "category"), (Numbers{9, 9, 3}));
  EXPECT_FALSE(hasField(file.cloud, "room"));
  EXPECT_EQ(names()["categories"][9], "chair");
  EXPECT_EQ(names()["categories"][3], "wall");
  EXPECT_FALSE(names().contains("rooms"));
}

TEST_F(S3dis, OfAnAreaTheRoomsAreNumberedByName)
{
  const auto file = convert("area");
  EXPECT_EQ(pointsOf(file),
            (Text{"7 8 9 090909", "1 2 3 ff0010", "1.5 2 3 010203", "4 5 6 000000"}));
  EXPECT_EQ(readLabels(file, "room"), (Numbers{1, 2, 2, 2}));
  EXPECT_EQ(readLabels(file, "object"), (Numbers{1, 2, 2, 3}));
  EXPECT_EQ(readLabels(file, "category"), (Numbers{15, 9, 9, 3}));
  EXPECT_EQ(names()["categories"][15], "robot");
  EXPECT_EQ(names()["rooms"], Json::parse(R"([{"number": 1, "name": "hall_1"},
                            {"number": 2, "name": "office_1"}])"));
}

TEST_F(S3dis, ObjectsOfStructureAreNone)
{
  const auto file = convert("area -structure wall,floor");
  EXPECT_EQ(readLabels(file, "object"), (Numbers{1, 2, 2, 0}));
  EXPECT_EQ(readLabels(file, "category"), (Numbers{15, 9, 9, 3}));
  expectRefused("area -structure walls",
                "-structure: the scan has no category 'walls'");
}

TEST_F(S3dis, WhatIsNoTextIsLeftOut)
{
  save("area/.DS_Store", std::string("\0\0Bud1", 6));
  save("area/office_1/Annotations/.DS_Store", std::string("\0\0Bud1", 6));
  save("area/office_1/Annotations/wall_2.txt",
       "4 5 6 103.0\x10"
       "000 100.0 90.0\n4 5 6 185\x10"
       "187 7\n");
  const auto file = convert("area/office_1");
  EXPECT_EQ(pointsOf(file),
            (Text{"1 2 3 ff0010", "1.5 2 3 010203", "4 5 6 67645a", "4 5 6 b9bb07"}));
  EXPECT_NE(bytesOf(path("said"))
                .find("Annotations/wall_2.txt: control characters are "
                      "left out in line 1 and 1 more"),
            std::string::npos);
}

TEST_F(S3dis, OfTheWholeSetAnAreaIsAskedFor)
{
  save("set/Area_1/office_1/Annotations/chair_1.txt", "1 2 3 255 0 16\n");
  save("set/Area_2/office_1/Annotations/chair_1.txt", "1 2 3 255 0 16\n");
  expectRefused("set", "set: several areas of S3DIS; give one of them, for example ");
  expectRefused("set", "set/Area_1");
  expectRefused("set/Area_1/office_1/Annotations", "give the folder of the room");
}

TEST_F(S3dis, LargeCoordinatesKeepTheirMillimetres)
{
  save("utm/Annotations/chair_1.txt",
       "500000.125 5800000.25 3 1 2 3\n500000.25 5800000.125 4 1 2 3\n");
  const auto file = convert("utm");
  const Eigen::Vector3d point =
      (*file.points)[1].getVector3fMap().cast<double>() + file.offset;
  EXPECT_EQ(point, Eigen::Vector3d(500000.25, 5800000.125, 4));
}

TEST_F(S3dis, DamagedScansAreRefused)
{
  save("none/notes.txt", "1 2 3\n");
  expectRefused("none", "none: no scan; neither Annotations");
  expectRefused("nowhere", "nowhere: no such file or folder");
  expectRefused("area -labels a.png", "-labels: area is no depth image");
  save("area/office_1/Annotations/wall_3.txt", "4 5 6 0 0\n");
  expectRefused("area", "wall_3.txt: line 1");
  save("area/office_1/Annotations/wall_3.txt", "4 5 6 0 0 0\n4 5 6 0 \x10 0\n");
  expectRefused("area", "wall_3.txt: line 2");
  save("area/office_1/Annotations/wall_3.txt",
       "ply\nformat ascii 1.0\nelement vertex 0\nend_header\n");
  expectRefused("area", "wall_3.txt: names its fields, 'x,y,z,r,g,b' is for tables");
  save("area/office_1/Annotations/wall_3.txt", "");
  expectRefused("area", "wall_3.txt: ");
  std::filesystem::remove(path("area/office_1/Annotations/wall_3.txt"));
  save("area/office_1/Annotations/wall.txt", "4 5 6 0 0 0\n");
  expectRefused("area", "wall.txt: the name is not CLASS_NUMBER.txt");
  std::filesystem::remove(path("area/office_1/Annotations/wall.txt"));
  std::filesystem::create_directories(path("area/attic_1/Annotations"));
  expectRefused("area", "attic_1/Annotations: no file CLASS_NUMBER.txt");
  std::filesystem::remove(path("area/attic_1/Annotations"));
  expectRefused("area", "attic_1: a room without the folder Annotations");
}

// ScanNet

class ScanNet : public DatasetScan {
protected:
  void
  SetUp() override
  {
    DatasetScan::SetUp();
    save("scene0_00/scene0_00_vh_clean_2.ply",
         "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
         "property float z\nproperty uchar red\nproperty uchar green\n"
         "property uchar blue\nproperty uchar alpha\nelement face 1\n"
         "property list uchar int vertex_indices\nend_header\n0 0 1 255 1 2 255\n"
         "1 0 1 0 0 0 255\n2 0 1 0 0 0 255\n3 0 1 0 0 0 255\n4 0 1 0 0 0 255\n"
         "3 0 1 2\n");
    save(segments, R"({"segIndices": [7, 7, 30, 2, 900]})");
    save(groups, R"({"segGroups": [
        {"id": 0, "objectId": 0, "segments": [2, 30], "label": "table"},
        {"id": 4, "objectId": 4, "segments": [7], "label": "chair"}]})");
  }

  const std::string segments = "scene0_00/scene0_00_vh_clean_2.0.010000.segs.json";
  const std::string groups = "scene0_00/scene0_00.aggregation.json";
};

TEST_F(ScanNet, GroupsOfSegmentsAreObjects)
{
  const auto file = convert("scene0_00");
  EXPECT_EQ(pointsOf(file).front(), "0 0 1 ff0102");
  EXPECT_EQ(pointsOf(file).back(), "4 0 1 000000");
  EXPECT_EQ(readLabels(file, "object"), (Numbers{5, 5, 1, 1, 0}));
  EXPECT_EQ(readLabels(file, "category"), (Numbers{1, 1, 2, 2, 0}));
  EXPECT_EQ(names()["categories"], (Names{"none", "chair", "table"}));
}

TEST_F(ScanNet, TheLaterOfTwoGroupsGetsASegment)
{
  save(groups, R"({"segGroups": [{"id": 1, "segments": [2, 30], "label": "b"},
                                 {"id": 0, "segments": [30], "label": "a"}]})");
  EXPECT_EQ(readLabels(convert("scene0_00"), "object"), (Numbers{0, 0, 1, 2, 0}));
}

TEST_F(ScanNet, DamagedScansAreRefused)
{
  const auto good_segments = bytesOf(path(segments));
  for (const auto& [text, reason] : std::vector<std::pair<std::string, std::string>>{
           {R"({"segIndices": [7, 7, 30, 2]})", "4 vertices, the scan has 5"},
           {R"({"segIndices": [7, 7, 30, 2, -1]})", "is -1, not a whole number"},
           {R"({"segIndices": [7, 7, 30, 2, 1.5]})", "is 1.5, not a whole number"},
           {R"({"segIndices": [7, 7, 30, 2, "2"]})", "is \"2\", not a whole number"},
           {R"({"segments": [7, 7, 30, 2, 3]})", "segIndices"},
           {R"({"segIndices": [7, 7)", "parse error"}}) {
    save(segments, text);
    expectRefused("scene0_00", reason);
  }
  save(segments, good_segments);
  for (const auto& [text, reason] : std::vector<std::pair<std::string, std::string>>{
           {R"([{"id": 0, "segments": [3], "label": "a"}])",
            "group 0 has the segment 3, which no vertex has"},
           {R"([{"id": 2, "segments": [2], "label": "a"},
                {"id": 2, "segments": [7], "label": "b"}])",
            "two groups have the id 2"},
           {R"([{"id": -2, "segments": [2], "label": "a"}])", "an 'id' is -2"},
           {R"([{"id": 2, "segments": [2]}])", "label"},
           {R"([{"segments": [2], "label": "a"}])", "'id'"}}) {
    save(groups, R"({"segGroups": )" + text + "}");
    expectRefused("scene0_00", reason);
  }
  std::filesystem::remove(path(groups));
  expectRefused("scene0_00", "aggregation.json: cannot be opened");
  save("scene0_00/other_vh_clean_2.ply", "ply\n");
  expectRefused("scene0_00", "2 files *_vh_clean_2.ply, one is needed");
}

// NYU v2, SUN RGB-D

/** Three by two pixels; the camera looks from pixel (1, 0), 2 and 4 pixels per unit. */
class DepthImage : public DatasetScan {
protected:
  void
  SetUp() override
  {
    DatasetScan::SetUp();
    save("depth.png", pngBytes(3, 2, 16, {2000, 0, 1000, 500, 40000, 3000}));
    save("labels.png", pngBytes(3, 2, 8, {3, 3, 0, 1, 3, 3}));
    save("instances.png", pngBytes(3, 2, 8, {2, 2, 1, 1, 1, 2}));
    save("color.png",
         pngBytes(3, 2, 24, {1, 2, 3, 4, 5, 6, 255, 8, 9, 0, 0, 0, 9, 9, 9, 7, 7, 7}));
    save("camera.txt", "2 0 1\n0 4 0\n0 0 1\n");
    save("names.txt", "bed\nbook\nchair\nlamp\n");
  }

  const std::string options = "-labels labels.png -intrinsics camera.txt";
};

TEST_F(DepthImage, PixelsGoWhereTheCameraSawThem)
{
  const auto file = convert("depth.png " + options + " -color color.png");
  EXPECT_EQ(file.points->width, 3u);
  EXPECT_EQ(file.points->height, 2u);
  EXPECT_EQ(pointsOf(file),
            (Text{"-1 0 2 010203",
                  "nan nan nan 040506",
                  "0.5 0 1 ff0809",
                  "-0.25 0.125 0.5 000000",
                  "0 10 40 090909",
                  "1.5 0.75 3 070707"}));
}

TEST_F(DepthImage, AnObjectIsALabelOrAPairWithAnInstance)
{
  auto file = convert("depth.png " + options);
  EXPECT_EQ(readLabels(file, "category"), (Numbers{3, 0, 0, 1, 3, 3}));
  EXPECT_EQ(readLabels(file, "object"), (Numbers{2, 0, 0, 1, 2, 2}));
  EXPECT_EQ(names()["categories"], (Names{"none", "1", "2", "3"}));
  file = convert("depth.png " + options +
                 " -instances instances.png -label_names names.txt");
  EXPECT_EQ(readLabels(file, "object"), (Numbers{3, 0, 0, 1, 2, 3}));
  EXPECT_EQ(names()["categories"], (Names{"none", "bed", "book", "chair", "lamp"}));
}

TEST_F(DepthImage, LabelsAreValuesOf16BitsOrIndicesOfAPalette)
{
  save("labels.png", pngBytes(3, 2, 16, {0, 0, 7, 300, 1, 300}));
  auto file = convert("depth.png " + options);
  EXPECT_EQ(readLabels(file, "category"), (Numbers{0, 0, 7, 300, 1, 300}));
  save("labels.png",
       pngBytes(3, 2, pcl::indoor::test::palette_bits, {2, 0, 0, 1, 2, 1}));
  file = convert("depth.png " + options);
  EXPECT_EQ(readLabels(file, "category"), (Numbers{2, 0, 0, 1, 2, 1}));
}

TEST_F(DepthImage, DepthsHaveAUnit)
{
  const auto file = convert("depth.png " + options + " -depth_unit 0.0001");
  EXPECT_FLOAT_EQ((*file.points)[0].z, 0.2f);
  EXPECT_FLOAT_EQ((*file.points)[4].z, 4.0f);
}

TEST_F(DepthImage, TheBitsOfSunAreTurnedBack)
{
  // 8 * 2000; of 40000 = 2^15 + 7232 the highest bit goes to the third: 8 * 7232 + 4
  const std::vector<std::uint16_t> depths = {16000, 0, 8000, 4000, 57860, 24000};
  save("sun/depth/1.png", pngBytes(3, 2, 16, depths));
  save("sun/intrinsics.txt", "2 0 1 0 4 0 0 0 1");
  const std::string points = "-1 0 2 000000";
  for (const char* input : {"sun -labels labels.png", "sun/depth/1.png -rotated "}) {
    const bool is_folder = std::string(input).size() == 22;
    const auto file = convert(input + (is_folder ? "" : options));
    EXPECT_EQ(pointsOf(file)[0], points) << input;
    EXPECT_FLOAT_EQ((*file.points)[4].z, 40.0f) << input; // 40000 mm
    EXPECT_FLOAT_EQ((*file.points)[5].z, 3.0f) << input;
  }
  save("sun/depth/2.png", pngBytes(3, 2, 16, depths));
  expectRefused("sun -labels labels.png", "sun/depth: 2 PNG files, one is needed");
}

TEST_F(DepthImage, DamagedImagesAreRefused)
{
  const auto good = bytesOf(path("labels.png"));
  expectRefused("depth.png -intrinsics camera.txt", "-labels: a depth image needs");
  expectRefused("depth.png -labels labels.png", "-intrinsics: a depth image needs");
  expectRefused("depth.png -intrinsics camera.txt -labels no.png",
                "no.png: cannot be opened");
  expectRefused("labels.png " + options, "labels.png: 8 bits per pixel");
  expectRefused("color.png " + options, "color.png: the image has colours or alpha");
  save("labels.png", pngBytes(2, 3, 8, {3, 3, 0, 1, 3, 3}));
  expectRefused("depth.png " + options,
                "labels.png: 2 x 3 pixels, depth.png has 3 x 2");
  save("labels.png", good);
  save("small.png", pngBytes(1, 1, 24, {1, 2, 3}));
  expectRefused("depth.png -color small.png " + options, "small.png: 1 x 1 pixels");
  expectRefused("depth.png -instances small.png " + options,
                "small.png: the image has");
  for (const auto size : {good.size() - 1, good.size() / 2, std::size_t{20}}) {
    save("labels.png", good.substr(0, size));
    expectRefused("depth.png " + options, "labels.png: the PNG cannot be read");
  }
  save("labels.png", "no image");
  expectRefused("depth.png " + options, "labels.png: the PNG cannot be read");
  save("labels.png", pngBytes(3, 2, 8, {5, 3, 0, 1, 3, 3}));
  expectRefused("depth.png -label_names names.txt " + options,
                "labels.png: the label 5 has no name, names.txt has 4");
  save("labels.png", good);
  save("depth.png", pngBytes(3, 2, 16, {0, 0, 0, 0, 0, 0}));
  expectRefused("depth.png " + options, "depth.png: no pixel has a depth");
}

TEST_F(DepthImage, DamagedIntrinsicsAreRefused)
{
  for (const auto& [text, reason] : std::vector<std::pair<std::string, std::string>>{
           {"", "0 numbers, a camera matrix has 9"},
           {"2 0 1 0 4 0 0 0", "8 numbers"},
           {"2 0 1 0 4 0 0 0 1 0", "10 numbers"},
           {"2 0 1 0 four 0 0 0 1", "'four' is not a number"},
           {"nan 0 1 0 4 0 0 0 1", "'nan' is not a number"},
           {"0 0 1 0 4 0 0 0 1", "not a camera matrix"},
           {"2 0 1 0 4 0 0 0 2", "not a camera matrix"},
           {"2 0.5 1 0 4 0 0 0 1", "not a camera matrix"}}) {
    save("camera.txt", text);
    expectRefused("depth.png " + options, "camera.txt: " + reason);
  }
}

// OSD

class Osd : public DatasetScan {
protected:
  void
  SetUp() override
  {
    DatasetScan::SetUp();
    save("cloud.pcd",
         "VERSION 0.7\nFIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\n"
         "WIDTH 2\nHEIGHT 2\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 4\nDATA ascii\n"
         "0 0 1 7\nnan nan nan 7\n1 0 1 0\n1 1 1 9\n");
    save("labels.png", pngBytes(2, 2, 8, {1, 2, 3, 0}));
  }
};

TEST_F(Osd, ObjectsComeFromAnImageOrAField)
{
  ASSERT_EQ(run("cloud.pcd out.pcd -labels labels.png"), 0) << bytesOf(path("said"));
  auto file = loadCloud(path("out.pcd"), {}, 1);
  EXPECT_EQ(readLabels(file, "object"), (Numbers{1, 0, 3, 0}));
  EXPECT_EQ(file.points->height, 2u);
  ASSERT_EQ(run("cloud.pcd out.pcd"), 0) << bytesOf(path("said"));
  file = loadCloud(path("out.pcd"), {}, 1);
  EXPECT_EQ(readLabels(file, "object"), (Numbers{7, 0, 0, 9}));
  EXPECT_FALSE(hasField(file.cloud, "category"));
}

TEST_F(Osd, DamagedScansAreRefused)
{
  expectRefused("cloud.pcd -json names.json", "-json: cloud.pcd is a cloud without");
  EXPECT_FALSE(std::filesystem::exists(path("names.json")));
  expectRefused("cloud.pcd -color labels.png", "-color: cloud.pcd is no depth image");
  save("labels.png", pngBytes(4, 1, 8, {1, 2, 3, 0}));
  expectRefused("cloud.pcd -labels labels.png",
                "labels.png: 4 x 1 pixels, cloud.pcd has 2 x 2");
  save("cloud.xyz", "1 2 3\n4 5 6\n");
  expectRefused("cloud.xyz", "cloud.xyz: the file has no field 'label'");
}

} // namespace
