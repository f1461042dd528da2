/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "formats/pcd/pcd_body.h"

#include <pcl/io/lzf.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace pcl::indoor::tool {
namespace {

using Bytes = std::vector<std::uint8_t>;

void
addField(PCLPointCloud2& cloud, std::uint8_t datatype, unsigned count, unsigned size)
{
  PCLPointField field;
  field.name = "field " + std::to_string(cloud.fields.size());
  field.offset = cloud.point_step;
  field.datatype = datatype;
  field.count = count;
  cloud.fields.push_back(field);
  cloud.point_step += count * size;
}

/** Random bytes, each as often as said one after the other. */
PCLPointCloud2
randomCloud(std::size_t points, std::size_t run, unsigned large = 1)
{
  PCLPointCloud2 cloud;
  addField(cloud, PCLPointField::FLOAT32, 1, 4);
  addField(cloud, PCLPointField::UINT8, 3, 1);
  addField(cloud, PCLPointField::FLOAT64, 2, 8);
  addField(cloud, PCLPointField::UINT16, large, 2);
  cloud.width = static_cast<std::uint32_t>(points);
  cloud.height = 1;
  cloud.data.resize(points * cloud.point_step);
  std::mt19937 random(static_cast<unsigned>(run));
  std::uint8_t value = 0;
  for (std::size_t i = 0; i < cloud.data.size(); ++i) {
    if (i % run == 0)
      value = static_cast<std::uint8_t>(random() % 64); // no exponent is all ones
    cloud.data[i] = value;
  }
  return cloud;
}

/** All values of a field, then those of the next. */
Bytes
byFields(const PCLPointCloud2& cloud)
{
  Bytes bytes;
  for (std::size_t f = 0; f < cloud.fields.size(); ++f) {
    const std::size_t begin = cloud.fields[f].offset;
    const std::size_t end =
        f + 1 < cloud.fields.size() ? cloud.fields[f + 1].offset : cloud.point_step;
    for (std::size_t i = 0; i < cloud.width; ++i)
      bytes.insert(bytes.end(),
                   cloud.data.begin() + i * cloud.point_step + begin,
                   cloud.data.begin() + i * cloud.point_step + end);
  }
  return bytes;
}

Bytes
packed(const Bytes& bytes)
{
  Bytes result(bytes.size() + bytes.size() / 16 + 64);
  result.resize(pcl::lzfCompress(bytes.data(),
                                 static_cast<unsigned>(bytes.size()),
                                 result.data(),
                                 static_cast<unsigned>(result.size())));
  return result;
}

TEST(PcdBody, UnpacksWhatPclPacks)
{
  for (const std::size_t points : {1u, 2u, 1000u, 70000u})
    for (const std::size_t run : {1u, 3u, 300u, 100000u}) { // of repeated bytes
      const auto cloud = randomCloud(points, run);
      const auto bytes = packed(byFields(cloud));
      auto unpacked = cloud;
      unpacked.data.assign(cloud.data.size(), 255);
      ASSERT_TRUE(unpackPoints(bytes.data(), bytes.size(), unpacked))
          << points << " points, " << run;
      EXPECT_TRUE(unpacked.data == cloud.data);
      EXPECT_TRUE(unpacked.is_dense);
    }
}

TEST(PcdBody, APointMayBeLargerThanWhatIsUnpackedAtOnce)
{
  const auto cloud = randomCloud(3, 7, 200000);
  const auto bytes = packed(byFields(cloud));
  auto unpacked = cloud;
  unpacked.data.assign(cloud.data.size(), 255);
  ASSERT_TRUE(unpackPoints(bytes.data(), bytes.size(), unpacked));
  EXPECT_TRUE(unpacked.data == cloud.data);
}

TEST(PcdBody, NumbersThatAreNotFiniteAreTold)
{
  auto cloud = randomCloud(100, 5);
  const double infinity = std::numeric_limits<double>::infinity();
  std::memcpy(&cloud.data[50 * cloud.point_step + cloud.fields[2].offset + 8],
              &infinity,
              sizeof(infinity));
  const auto bytes = packed(byFields(cloud));
  ASSERT_TRUE(unpackPoints(bytes.data(), bytes.size(), cloud));
  EXPECT_FALSE(cloud.is_dense);
}

TEST(PcdBody, RefusesWhatIsDamaged)
{
  const auto cloud = randomCloud(200, 9);
  const auto all = byFields(cloud);
  const auto bytes = packed(all);
  auto unpacked = cloud;
  for (std::size_t size = 0; size < bytes.size(); ++size)
    ASSERT_FALSE(unpackPoints(bytes.data(), size, unpacked)) << size;
  auto longer = bytes;
  longer.push_back(0); // a byte follows as it is, which is missing
  EXPECT_FALSE(unpackPoints(longer.data(), longer.size(), unpacked));
  longer.push_back(7);
  EXPECT_FALSE(unpackPoints(longer.data(), longer.size(), unpacked));
  const Bytes before_the_first = {0, 1, 0x20, 5};
  EXPECT_FALSE(
      unpackPoints(before_the_first.data(), before_the_first.size(), unpacked));
  auto outside = cloud;
  outside.fields.back().offset = cloud.point_step - 1;
  EXPECT_FALSE(unpackPoints(bytes.data(), bytes.size(), outside));
}

TEST(PcdBody, AnyBytesEnd)
{
  std::mt19937 random(1);
  const auto cloud = randomCloud(300, 4);
  auto bytes = packed(byFields(cloud));
  for (int turn = 0; turn < 3000; ++turn) {
    auto changed = bytes;
    for (int k = 0; k < 3; ++k)
      changed[random() % changed.size()] = static_cast<std::uint8_t>(random());
    auto unpacked = cloud;
    unpackPoints(changed.data(), changed.size(), unpacked);
    EXPECT_EQ(unpacked.data.size(), cloud.data.size());
  }
}

} // namespace
} // namespace pcl::indoor::tool
