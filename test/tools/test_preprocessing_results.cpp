/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Runs the tools, found by PCL_INDOOR_TOOLS, with the options of pre-processing.
#include "files/cloud_file.h"
#include "support/folder_test.h"
#include "support/labelled_points.h"
#include "support/run_tool.h"
#include "support/synthetic_scenes.h"

#include <pcl/io/pcd_io.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <iterator>
#include <string>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;

namespace {

/** A scene on disk in a folder of its own, gone afterwards. */
class Preprocessing : public pcl::indoor::test::FolderTest {
protected:
  void
  SetUp() override
  {
    ASSERT_NO_FATAL_FAILURE(FolderTest::SetUp());
    scene_ = test::floorWithTwoBoxes(0.003f, 0.025f);
    pcl::PointCloud<pcl::PointXYZI> cloud;
    for (const auto& point : scene_.points) {
      pcl::PointXYZI entry(static_cast<float>(cloud.size() % 97));
      entry.getVector3fMap() = point;
      cloud.push_back(entry);
    }
    for (int i = 0; i < outliers_; ++i) {
      pcl::PointXYZI entry(0.0f);
      entry.getVector3fMap() =
          Eigen::Vector3f(0.4f * static_cast<float>(i), 1, 1.5f + 0.1f * (i % 3));
      cloud.push_back(entry);
    }
    cloud.sensor_origin_ = Eigen::Vector4f(1, 1, 5, 0);
    pcl::io::savePCDFileBinary(path("scene.pcd"), cloud);
  }

  int
  run(const std::string& tool, const std::string& options) const
  {
    return test::runTool(
        tool, path("scene.pcd") + " " + path("out.pcd") + " " + options, path("said"));
  }

  std::string
  said() const
  {
    return test::bytesOf(path("said"));
  }

  /** Share of the scene's normals that point to the side they should. */
  double
  shareOfRight() const
  {
    const auto normals = readNormals(loadCloud(path("out.pcd")));
    std::size_t right = 0;
    for (std::size_t i = 0; i < scene_.points.size(); ++i)
      right += (*normals)[i].getNormalVector3fMap().dot(scene_.normals[i]) > 0.5f;
    return static_cast<double>(right) / static_cast<double>(scene_.points.size());
  }

  static constexpr int outliers_ = 9;
  test::LabelledPoints scene_;
};

} // namespace

TEST_F(Preprocessing, NormalsAreAddedAsFields)
{
  ASSERT_EQ(run("pcl_hough_normals", "-radius 0.1"), 0);
  const auto file = loadCloud(path("out.pcd"));
  EXPECT_TRUE(file.has_normals);
  EXPECT_TRUE(hasField(file.cloud, "curvature"));
  EXPECT_EQ(readLabels(file, "intensity")[98], 1u); // kept
  EXPECT_EQ(file.pose.origin.z(), 5);
  EXPECT_TRUE(std::isnan((*readNormals(file)).back().normal_x));
  EXPECT_GT(shareOfRight(), 0.7); // but sides that the viewpoint does not see
  ASSERT_EQ(run("pcl_hough_normals", "-k 40 -orientation graph -sampling points"), 0);
  EXPECT_GT(shareOfRight(), 0.9);
  ASSERT_EQ(run("pcl_hough_normals", "-no_refinement -orientation free_space"), 0);
  EXPECT_NE(run("pcl_hough_normals", "-k 40 -radius 1"), 0);
  EXPECT_NE(run("pcl_hough_normals", "-orientation up"), 0);
}

TEST_F(Preprocessing, OutliersHaveNoObject)
{
  ASSERT_EQ(run("pcl_noise_resilient_lccp", "-remove_outliers"), 0);
  auto objects = readLabels(loadCloud(path("out.pcd")), "object");
  ASSERT_EQ(objects.size(), scene_.points.size() + outliers_);
  for (std::size_t i = 0; i < objects.size(); ++i)
    EXPECT_EQ(objects[i] == 0, i >= scene_.points.size()) << i;
  ASSERT_EQ(run("pcl_noise_resilient_lccp", ""), 0);
  objects = readLabels(loadCloud(path("out.pcd")), "object");
  for (const auto object : objects)
    EXPECT_GT(object, 0u);
}

TEST_F(Preprocessing, ThePipelinePreparesRooms)
{
  const auto cloud = [this](const std::string& options) {
    std::filesystem::remove_all(path("out.pcd")); // here a folder
    EXPECT_EQ(run("pcl_indoor_pipeline", "-model none -report none " + options), 0);
    return test::bytesOf(path("out.pcd/cloud.pcd"));
  };
  const auto usual = cloud("");
  const auto hough = cloud("-normals rrht");
  const auto scales = cloud("-normals multi_scale -threads 1");
  EXPECT_NE(usual, hough);
  EXPECT_NE(usual, scales);
  EXPECT_EQ(scales, cloud("-normals multi_scale -threads 2 -points_at_once 0"));
  cloud("-remove_outliers");
  const auto objects = readLabels(loadCloud(path("out.pcd/cloud.pcd")), "object");
  const auto structure = readLabels(loadCloud(path("out.pcd/cloud.pcd")), "structure");
  for (std::size_t i = scene_.points.size(); i < objects.size(); ++i) {
    EXPECT_EQ(objects[i], 0u) << i;
    EXPECT_EQ(structure[i], 0u) << i; // not even of the remainder
  }
  EXPECT_NE(run("pcl_indoor_pipeline", "-normals pca"), 0);
}

TEST_F(Preprocessing, OrientationIsAnOption)
{
  for (const std::string way : {"auto", "viewpoint", "graph", "free_space"})
    EXPECT_EQ(run("pcl_noise_resilient_lccp", "-orientation " + way), 0) << way;
  EXPECT_NE(run("pcl_noise_resilient_lccp", "-orientation up"), 0);
}

TEST_F(Preprocessing, TheUnitOfRoomsIsSaid)
{
  pcl::PointCloud<pcl::PointXYZ> rooms;
  for (const auto& p : test::twoRooms().points)
    rooms.emplace_back(1000 * p.x(), 1000 * p.y(), 1000 * p.z()); // millimetres
  pcl::io::savePCDFileBinary(path("scene.pcd"), rooms);
  ASSERT_EQ(run("pcl_noise_resilient_lccp", ""), 0);
  EXPECT_NE(said().find("The scan is probably in millimetres"), std::string::npos)
      << said();
  ASSERT_EQ(run("pcl_noise_resilient_lccp", "-unit mm"), 0);
  EXPECT_EQ(said().find("millimetres"), std::string::npos) << said();
  ASSERT_EQ(run("pcl_noise_resilient_lccp", "-unit mm -up z -preset objects"), 0);
  EXPECT_EQ(said().find("millimetres"), std::string::npos) << said();
}

TEST_F(Preprocessing, TheUnitOfAViewIsSaidAndTaken)
{
  pcl::PointCloud<pcl::PointXYZ> view(160, 120);
  for (int v = 0; v < 120; ++v)
    for (int u = 0; u < 160; ++u) {
      const float depth = u > 60 && u < 100 && v > 40 ? 900 : 1000; // millimetres
      view.at(u, v) =
          pcl::PointXYZ(std::round(depth * (static_cast<float>(u) - 79.5f) / 131),
                        std::round(-depth * (static_cast<float>(v) - 59.5f) / 131),
                        -depth);
    }
  pcl::io::savePCDFileBinary(path("scene.pcd"), view);
  ASSERT_EQ(run("pcl_noise_resilient_lccp", ""), 0);
  EXPECT_NE(said().find("scale it to metres (-unit mm)"), std::string::npos) << said();
  ASSERT_EQ(run("pcl_noise_resilient_lccp", "-unit mm"), 0);
  EXPECT_EQ(said().find("millimetres"), std::string::npos) << said();
  EXPECT_EQ(said().find("steps of"), std::string::npos) << "1 mm is no coarse step";
  EXPECT_NE(said().find("looking along -z"), std::string::npos) << said();
  const auto file = loadCloud(path("out.pcd"));
  EXPECT_EQ(file.points->at(80, 60).z, -900) << "as it came";
  const auto objects = readLabels(file, "object");
  EXPECT_NE(objects[60 * 160 + 80], objects[60 * 160 + 10]) << "two objects";
}
