/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "report/report_page.h"

#include "report/report_cloud.h"
#include "text/base64.h"

#include <gtest/gtest.h>

#include <random>

using namespace pcl;
using namespace pcl::indoor;
using namespace pcl::indoor::tool;

namespace {

std::string
fromBase64(const std::string& text)
{
  const std::string letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=')
      break;
    bits = bits << 6 | static_cast<std::uint32_t>(letters.find(c));
    count += 6;
    if (count >= 8)
      bytes += static_cast<char>(bits >> (count -= 8) & 0xffu);
  }
  return bytes;
}

std::uint32_t
numberAt(const std::string& bytes, std::size_t i)
{
  return static_cast<unsigned char>(bytes[2 * i]) |
         static_cast<unsigned char>(bytes[2 * i + 1]) << 8;
}

} // namespace

TEST(ReportPage, BytesBecomeText)
{
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(ReportPage, TheCloudIsThinnedToVoxelsThatAreAllStillThere)
{
  std::mt19937 random(3);
  Scene scene;
  PointCloud<PointXYZ> cloud;
  for (int i = 0; i < 30000; ++i) // a floor of 10 m by 5 m
    cloud.emplace_back(random() % 10000 * 0.001f, random() % 5000 * 0.001f, -1.0f);
  cloud.emplace_back(500.0f, 0.0f, 0.0f); // in no room, of no object
  scene.room_of_point.assign(cloud.size(), 2);
  scene.object_of_point.assign(cloud.size(), 70000); // does not fit
  scene.room_of_point.back() = scene.object_of_point.back() = 0;
  const Eigen::Vector3d shift(1.0, 2.0, 3.0);
  scene.frame.pose.translation() = shift;
  const auto thinned = thinnedCloud(scene, cloud, 2000);
  const std::size_t count = thinned["points"];
  EXPECT_LE(count, 2000u);
  EXPECT_GT(count, 1200u);
  const auto bytes = fromBase64(thinned["data"]);
  ASSERT_EQ(bytes.size(), 10 * count);
  std::vector<int> per_metre(50, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const auto at = [&](std::size_t axis) {
      return thinned["lower"][axis].get<double>() +
             numberAt(bytes, axis * count + i) * thinned["step"][axis].get<double>() +
             shift[static_cast<Eigen::Index>(axis)];
    };
    EXPECT_NEAR(at(2), -1.0, 1e-6);
    ++per_metre.at(static_cast<std::size_t>(std::min(9.0, at(0))) * 5 +
                   static_cast<std::size_t>(std::min(4.0, at(1))));
    EXPECT_EQ(numberAt(bytes, 3 * count + i), 2u);
    EXPECT_EQ(numberAt(bytes, 4 * count + i), 0u);
  }
  EXPECT_GT(*std::min_element(per_metre.begin(), per_metre.end()), 15);
}

TEST(ReportPage, TextsOfTheSceneStayTexts)
{
  Scene scene;
  PointCloud<PointXYZ> none;
  const std::string name = "a</script><b>&.pcd";
  const nlohmann::ordered_json json = {{"input", name}, {"coordinate_unit", "m"}};
  const auto page = reportPage({scene, json, floorPlan({}), "<svg/>", none});
  EXPECT_EQ(page.find(name), std::string::npos);
  EXPECT_NE(page.find("<title>a&#60;/script&#62;&#60;b&#62;&#38;.pcd</title>"),
            std::string::npos);
  EXPECT_NE(page.find("src=\"data:image/svg+xml;base64,PHN2Zy8+\""), std::string::npos);
  EXPECT_NE(page.find("{\"input\":\"a\\u003c/script>\\u003cb>&.pcd\""),
            std::string::npos);
}
