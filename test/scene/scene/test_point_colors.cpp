/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/point_colors.h"

#include "pictures/color.h"
#include "support/folder_test.h"

#include <pcl/conversions.h>
#include <pcl/io/pcd_io.h>

#include <gtest/gtest.h>

using namespace pcl::indoor::tool;

namespace {

class Colors : public pcl::indoor::test::FolderTest {
protected:
  /** Four points, one above the other, with rooms and categories. */
  CloudFile
  fileWithLabels(bool with_colors = false) const
  {
    pcl::PointCloud<pcl::PointXYZRGB> cloud;
    for (int k = 0; k < 4; ++k)
      cloud.emplace_back(0.0f, -static_cast<float>(k), static_cast<float>(k), 1, 2, 3);
    if (with_colors)
      pcl::io::savePCDFileBinary(path("in.pcd"), cloud);
    else {
      pcl::PointCloud<pcl::PointXYZ> plain;
      copyPointCloud(cloud, plain);
      pcl::io::savePCDFileBinary(path("in.pcd"), plain);
    }
    auto file = loadCloud(path("in.pcd"));
    appendField(file.cloud, "room", {0, 1, 2, 1});
    appendField(file.cloud, "category", {3, 0, 3, 4});
    return file;
  }

  /** As PCL's viewer reads them from the file that is written. */
  std::vector<Eigen::Vector3i>
  colorsIn(const CloudFile& file) const
  {
    saveCloud(path("out.pcd"), file.cloud, file.pose);
    pcl::PointCloud<pcl::PointXYZRGB> cloud;
    EXPECT_EQ(pcl::io::loadPCDFile(path("out.pcd"), cloud), 0);
    std::vector<Eigen::Vector3i> colors;
    for (const auto& point : cloud)
      colors.push_back(point.getRGBVector3i());
    return colors;
  }
};

Eigen::Vector3i
colorOf(std::uint32_t label)
{
  const auto color = labelColor(label);
  return {color.red, color.green, color.blue};
}

} // namespace

TEST_F(Colors, ALabelHasItsColourAndNoneIsGrey)
{
  auto file = fileWithLabels();
  PointColors{}.apply(file, "room");
  EXPECT_EQ(
      colorsIn(file),
      (std::vector<Eigen::Vector3i>{colorOf(0), colorOf(1), colorOf(2), colorOf(1)}));
  PointColors{"class"}.apply(file, "room", Eigen::Vector3f::UnitZ(), 4);
  EXPECT_EQ(
      colorsIn(file),
      (std::vector<Eigen::Vector3i>{colorOf(3), colorOf(0), colorOf(3), colorOf(0)}));
  const auto grey = colorOf(0);
  EXPECT_TRUE(grey[0] == grey[1] && grey[1] == grey[2]);
}

TEST_F(Colors, ThoseOfTheInputStayUnlessOthersAreWanted)
{
  const Eigen::Vector3i given(1, 2, 3);
  for (const char* kept : {"auto", "none"}) {
    auto file = fileWithLabels(true);
    PointColors{kept}.apply(file, "room");
    EXPECT_EQ(colorsIn(file), std::vector<Eigen::Vector3i>(4, given));
  }
  auto file = fileWithLabels(true);
  PointColors{"room"}.apply(file, "class");
  EXPECT_EQ(colorsIn(file)[2], colorOf(2));

  auto other = fileWithLabels();
  appendField(other.cloud, "rgba", {0x010203, 0x010203, 0x010203, 0x010203});
  PointColors{}.apply(other, "room");
  EXPECT_FALSE(hasField(other.cloud, "rgb"));
  PointColors{"room"}.apply(other, "room");
  EXPECT_FALSE(hasField(other.cloud, "rgba"));
  EXPECT_EQ(colorsIn(other)[2], colorOf(2));

  auto without = fileWithLabels();
  PointColors{"none"}.apply(without, "room");
  EXPECT_FALSE(hasField(without.cloud, "rgb"));
}

TEST_F(Colors, HeightsGoFromDarkToLight)
{
  auto file = fileWithLabels();
  PointColors{"height"}.apply(file, "room");
  const auto colors = colorsIn(file);
  for (std::size_t i = 1; i < 4; ++i)
    EXPECT_GT(colors[i].sum(), colors[i - 1].sum());
  EXPECT_GT(colors[0].sum(), 30); // not black on black
  auto turned = fileWithLabels();
  PointColors{"height"}.apply(turned, "room", Eigen::Vector3f::UnitY());
  const auto reversed = colorsIn(turned);
  EXPECT_EQ(std::vector<Eigen::Vector3i>(reversed.rbegin(), reversed.rend()), colors);
}
