/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cloud_file.h"
#include "files/joined_clouds.h"
#include "files/opened_scan.h"
#include "files/scan_files.h"
#include "files/tool_error.h"
#include "support/added_field.h"
#include "support/expect_part.h"
#include "support/folder_test.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <random>

using namespace pcl::indoor::tool;

namespace fs = std::filesystem;

namespace {

using Points = std::vector<Eigen::Vector3d>;

/** A cloud with coordinates of one type, and more fields of a byte and of a float. */
pcl::PCLPointCloud2
cloudWithFields(const Points& points,
                std::uint8_t real,
                const std::vector<std::string>& more)
{
  pcl::PCLPointCloud2 cloud;
  const bool is_double = real == pcl::PCLPointField::FLOAT64;
  for (const char* axis : {"x", "y", "z"})
    pcl::indoor::test::addField(cloud, axis, real);
  for (const auto& name : more)
    pcl::indoor::test::addField(cloud, name, pcl::PCLPointField::UINT8);
  cloud.width = static_cast<std::uint32_t>(points.size());
  cloud.height = 1;
  cloud.data.resize(points.size() * cloud.point_step, 7);
  for (std::size_t i = 0; i < points.size(); ++i) {
    auto* bytes = &cloud.data[i * cloud.point_step];
    const Eigen::Vector3f single = points[i].cast<float>();
    if (is_double)
      std::memcpy(bytes, points[i].data(), 24);
    else
      std::memcpy(bytes, single.data(), 12);
    for (std::size_t k = 0; k < more.size(); ++k)
      bytes[(is_double ? 24 : 12) + k] = static_cast<std::uint8_t>(10 * k + i);
  }
  return cloud;
}

Points
randomPoints(std::size_t count, std::uint32_t seed)
{
  std::mt19937 rng(seed);
  std::uniform_real_distribution<double> place(-20, 20);
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = place(rng), y = place(rng);
    points.emplace_back(x, y, place(rng));
  }
  return points;
}

CloudPose
frameAt(const Eigen::Vector3d& offset)
{
  CloudPose pose;
  pose.offset = offset;
  return pose;
}

std::vector<std::string>
namesOf(const pcl::PCLPointCloud2& cloud)
{
  std::vector<std::string> names;
  for (const auto& field : cloud.fields)
    names.push_back(field.name);
  return names;
}

constexpr auto float32 = pcl::PCLPointField::FLOAT32;
constexpr auto float64 = pcl::PCLPointField::FLOAT64;

/** Scans of 5, 1 and 4 points. */
std::vector<std::unique_ptr<CloudStream>>
threeScans(const std::vector<Points>& points,
           const std::vector<std::uint8_t>& types,
           const std::vector<Eigen::Vector3d>& offsets)
{
  std::vector<std::unique_ptr<CloudStream>> scans;
  for (std::size_t s = 0; s < points.size(); ++s)
    scans.push_back(streamInMemory(cloudWithFields(points[s], types[s], {"label"}),
                                   frameAt(offsets[s])));
  return scans;
}

} // namespace

TEST(JoinedClouds, PointsFollowEachOtherWithTheirStation)
{
  const std::vector<Points> points = {
      randomPoints(5, 1), randomPoints(1, 2), randomPoints(4, 3)};
  const auto zero = Eigen::Vector3d::Zero();
  const auto joined =
      joinedStream(threeScans(points, {float32, float32, float32}, {zero, zero, zero}),
                   {"a", "b", "c"});
  EXPECT_TRUE(joined->notes().empty());
  ASSERT_EQ(joined->pointCount(), 10u);
  EXPECT_EQ(namesOf(joined->layout()),
            (std::vector<std::string>{"x", "y", "z", "label", "station"}));
  const auto file = withPoints("all", joined->read(0, 10), joined->pose());
  const std::vector<std::uint32_t> stations = {1, 1, 1, 1, 1, 2, 3, 3, 3, 3};
  EXPECT_EQ(readLabels(file, "station"), stations);
  const auto labels = readLabels(file, "label");
  std::size_t i = 0;
  for (const auto& scan : points)
    for (std::size_t k = 0; k < scan.size(); ++k, ++i) {
      EXPECT_EQ((*file.points)[i].getVector3fMap(), scan[k].cast<float>());
      EXPECT_EQ(labels[i], k);
    }
  for (std::uint64_t first = 0; first < 10; ++first) // any part is that of the whole
    for (std::size_t count = 1; first + count <= 10; ++count)
      pcl::indoor::test::expectPart(*joined, file.cloud, first, count);
}

TEST(JoinedClouds, OffsetsAndDoublesLoseNothing)
{
  const std::vector<Points> points = {
      randomPoints(5, 4), randomPoints(1, 5), randomPoints(4, 6)};
  const std::vector<Eigen::Vector3d> offsets = {
      {691000, 5334000, 500}, {691000, 5334000, 500}, {691010.25, 5334000, 0}};
  for (const bool all_doubles : {false, true}) {
    const auto joined = joinedStream(
        threeScans(
            points, {float32, float64, all_doubles ? float64 : float32}, offsets),
        {"a", "b", "c"});
    EXPECT_EQ(joined->pose().offset, offsets[0]);
    const auto all = joined->read(0, 10);
    EXPECT_EQ(all.fields[0].datatype, float64);
    const auto file = withPoints("all", all, joined->pose());
    std::size_t i = 0;
    for (std::size_t s = 0; s < points.size(); ++s)
      for (const auto& point : points[s]) {
        const Eigen::Vector3d expected = point + offsets[s];
        const Eigen::Vector3d found =
            (*file.points)[i++].getVector3fMap().cast<double>() + file.offset;
        EXPECT_LT((found - expected).norm(), 1e-4);
      }
  }
}

TEST(JoinedClouds, FieldsThatNotAllHaveAreLeftOutAndNamed)
{
  std::vector<std::unique_ptr<CloudStream>> scans;
  const auto points = randomPoints(3, 7);
  scans.push_back(streamInMemory(
      cloudWithFields(points, float32, {"label", "station", "class"}), CloudPose()));
  scans.push_back(streamInMemory(cloudWithFields(points, float32, {"return", "label"}),
                                 CloudPose()));
  const auto joined = joinedStream(std::move(scans), {"a", "b"});
  EXPECT_EQ(joined->notes(),
            (std::vector<std::string>{
                "fields that not all of the scans have are left out: class, return"}));
  EXPECT_EQ(namesOf(joined->layout()),
            (std::vector<std::string>{"x", "y", "z", "label", "station"}));
  const auto file = withPoints("both", joined->read(0, 6), joined->pose());
  EXPECT_EQ(readLabels(file, "label"),
            (std::vector<std::uint32_t>{0, 1, 2, 10, 11, 12})); // of its own place
}

TEST(JoinedClouds, StationsOfAScanKeepTheirNamesAndPlaces)
{
  CloudPose seen;
  seen.origin = {1, 2, 3, 0};
  seen.offset = {691000, 0, 0};
  std::vector<std::unique_ptr<CloudStream>> two;
  two.push_back(streamInMemory(cloudWithFields(randomPoints(2, 8), float32, {}), seen));
  two.push_back(
      streamInMemory(cloudWithFields(randomPoints(1, 9), float32, {}), CloudPose()));
  std::vector<std::unique_ptr<CloudStream>> scans;
  scans.push_back(
      streamInMemory(cloudWithFields(randomPoints(1, 7), float64, {}), CloudPose()));
  scans.push_back(joinedStream(std::move(two), {"hall", "yard"}));
  const auto joined = joinedStream(std::move(scans), {"a.las", "b.e57"});
  const auto file = withPoints("all", joined->read(0, 4), joined->pose());
  EXPECT_EQ(readLabels(file, "station"), (std::vector<std::uint32_t>{1, 2, 2, 3}));
  ASSERT_EQ(joined->stations().size(), 3u);
  EXPECT_EQ(joined->stations()[0].name, "a.las");
  EXPECT_EQ(joined->stations()[1].name, "b.e57: hall");
  EXPECT_EQ(joined->stations()[2].name, "b.e57: yard");
  EXPECT_FALSE(joined->stations()[0].position);
  EXPECT_EQ(joined->stations()[1].position, Eigen::Vector3d(691001, 2, 3));
  EXPECT_FALSE(joined->stations()[2].position);
  EXPECT_EQ(joined->read(2, 2).data,
            std::vector<std::uint8_t>(
                file.cloud.data.end() -
                    static_cast<std::ptrdiff_t>(2 * file.cloud.point_step),
                file.cloud.data.end()));
}

using ScanFilesTest = pcl::indoor::test::FolderTest;

TEST_F(ScanFilesTest, OfAFolderAllCloudsByName)
{
  fs::create_directory(path("stations"));
  for (const char* name : {"b.las", "a.PCD", "readme.txt", "notes.md", "d.json"})
    write(std::string("stations/") + name, "x of 2026\n3 floors\n");
  write("stations/c.csv", "// " + std::string(5000, '-') + "\nx,y,z\n1,2,3\n");
  fs::create_directory(path("stations/e.pcd"));
  const auto folder = path("stations");
  const auto found = scanFiles({folder, "other.ply"});
  EXPECT_EQ(found.paths,
            (std::vector<std::string>{
                folder + "/a.PCD", folder + "/b.las", folder + "/c.csv", "other.ply"}));
  EXPECT_EQ(found.notes,
            (std::vector<std::string>{"left out: d.json: not read by this ending",
                                      "left out: notes.md: not read by this ending",
                                      "left out: readme.txt: a text without rows of "
                                      "points"}));
  EXPECT_EQ(nameOfScan({folder + "/"}, found.paths), folder);
  EXPECT_EQ(nameOfScan({"a.pcd", "b.pcd", "c.pcd"}, {"a.pcd", "b.pcd", "c.pcd"}),
            "a.pcd and 2 more");
  fs::create_directory(path("empty"));
  EXPECT_THROW(scanFiles({path("empty")}), ToolError);
}

namespace {

std::string
refusalOf(const std::string& folder)
{
  try {
    scanFiles({folder});
  } catch (const ToolError& error) {
    return error.what();
  }
  return "it was taken";
}

} // namespace

TEST_F(ScanFilesTest, FilesThatAreLeftOutAreNamed)
{
  const auto folder = path("stations");
  fs::create_directory(folder);
  for (const char* name : {"1.fls", "2.fls", "3.FLS", ".DS_Store"})
    write(std::string("stations/") + name, "x");
  const auto refusal = refusalOf(folder);
  EXPECT_NE(
      refusal.find(
          "stations: the folder holds no PCD, PLY, LAS, E57 or PTX file or table, "
          "but 1.fls and 2 more: a scan of FARO"),
      std::string::npos)
      << refusal;
  write("stations/a.las", "x");
  const auto found = scanFiles({folder});
  EXPECT_EQ(found.paths, std::vector<std::string>{folder + "/a.las"});
  ASSERT_EQ(found.notes.size(), 1u);
  EXPECT_EQ(found.notes[0].rfind("left out: 1.fls and 2 more: a scan of FARO", 0), 0u);
  fs::create_directories(path("days/monday"));
  EXPECT_NE(refusalOf(path("days"))
                .find("but folders: give one of them, for example " + path("days") +
                      "/monday"),
            std::string::npos);
}

TEST_F(ScanFilesTest, ResultsAreNoScans)
{
  const auto folder = path("stations");
  fs::create_directory(folder);
  for (const char* name : {"a.las", "cloud.pcd", "rooms.png"})
    write(std::string("stations/") + name, "x");
  EXPECT_EQ(scanFiles({folder}).paths.size(), 2u); // a scan may have this name
  write("stations/scene.json", "{}");
  const auto found = scanFiles({folder});
  EXPECT_EQ(found.paths, std::vector<std::string>{folder + "/a.las"});
  EXPECT_EQ(found.notes,
            std::vector<std::string>{"cloud.pcd beside scene.json is the result of an "
                                     "earlier run and left out"});
  fs::remove(folder + "/a.las");
  EXPECT_EQ(scanFiles({folder}).paths, std::vector<std::string>{folder + "/cloud.pcd"});
}
