/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cloud_file.h"
#include "files/cloud_formats.h"
#include "files/cloud_stream.h"
#include "files/tool_error.h"
#include "formats/las/las_file.h"
#include "support/folder_test.h"

#include <pcl/common/io.h>

#include <gtest/gtest.h>

#include "io/formats/put_value.h"

#include <array>
#include <cmath>
#include <cstring>
#include <vector>

using namespace pcl::indoor::tool;
using pcl::indoor::test::put;

namespace {

class LasFiles : public pcl::indoor::test::FolderTest {};

/** A LAS file of three points at 691234 + i, 5334567 - 2 i, 0.25 i metres. */
struct LasMaker {
  int minor = 2;
  std::uint8_t format = 3;
  std::size_t step = 34;
  std::string extra; ///< descriptions of extra bytes
  std::uint64_t count = 3;
  std::uint16_t color = 0x1100; ///< of red; twice and three times for green and blue

  std::string
  file() const
  {
    const std::size_t header = minor == 4 ? 375 : 227;
    const std::size_t record = extra.empty() ? 0 : 54 + extra.size();
    std::string bytes(header + record + step * count, '\0');
    std::memcpy(&bytes[0], "LASF", 4);
    bytes[24] = 1;
    bytes[25] = static_cast<char>(minor);
    put<std::uint16_t>(bytes, 94, static_cast<std::uint16_t>(header));
    put<std::uint32_t>(bytes, 96, static_cast<std::uint32_t>(header + record));
    put<std::uint32_t>(bytes, 100, extra.empty() ? 0 : 1);
    bytes[104] = static_cast<char>(format);
    put<std::uint16_t>(bytes, 105, static_cast<std::uint16_t>(step));
    if (minor == 4)
      put<std::uint64_t>(bytes, 247, count);
    else
      put<std::uint32_t>(bytes, 107, static_cast<std::uint32_t>(count));
    const double scales[] = {0.001, 0.001, 0.25}, offsets[] = {691000, 5334000, 0};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      put(bytes, 131 + 8 * axis, scales[axis]);
      put(bytes, 155 + 8 * axis, offsets[axis]);
    }
    if (!extra.empty()) {
      std::memcpy(&bytes[header + 2], "LASF_Spec", 9);
      put<std::uint16_t>(bytes, header + 18, 4);
      put<std::uint16_t>(bytes, header + 20, static_cast<std::uint16_t>(extra.size()));
      bytes.replace(header + 54, extra.size(), extra);
    }
    for (std::size_t i = 0; i < count; ++i)
      putPoint(bytes, header + record + i * step, static_cast<int>(i));
    return bytes;
  }

private:
  void
  putPoint(std::string& bytes, std::size_t at, int i) const
  {
    put<std::int32_t>(bytes, at, 234000 + 1000 * i);
    put<std::int32_t>(bytes, at + 4, 567000 - 2000 * i);
    put<std::int32_t>(bytes, at + 8, i);
    put<std::uint16_t>(bytes, at + 12, static_cast<std::uint16_t>(100 * i));
    bytes[at + 14] = static_cast<char>(format < 6 ? 0xd1 : 0x21); // first of two
    bytes[at + 17] = static_cast<char>(30 + i);
    if (format < 6) {
      bytes[at + 16] = -5;
      bytes[at + 15] = static_cast<char>(0x60 | (i + 1)); // flags above 5 bits of class
      put<std::uint16_t>(bytes, at + 18, 7);
    }
    else {
      bytes[at + 15] =
          static_cast<char>(0xe9); // edge, left, channel 2, overlap, synthetic
      bytes[at + 16] = static_cast<char>(200 + i);
      put<std::int16_t>(bytes, at + 18, -5000);
      put<std::uint16_t>(bytes, at + 20, 7);
    }
    if (format == 3) {
      put(bytes, at + 20, 1.5 * i);
      for (std::size_t channel = 0; channel < 3; ++channel)
        put<std::uint16_t>(bytes,
                           at + 28 + 2 * channel,
                           static_cast<std::uint16_t>(color * (channel + 1)));
    }
    if (!extra.empty())
      put<std::int16_t>(bytes, at + step - 2, static_cast<std::int16_t>(-i));
  }
};

std::string
extraDescription(const std::string& name, int type, bool scaled)
{
  std::string about(192, '\0');
  about[2] = static_cast<char>(type);
  about[3] = scaled ? 24 : 0;
  about.replace(4, name.size(), name);
  put(about, 112, 0.5);
  put(about, 136, 10.0);
  return about;
}

std::vector<double>
valuesOf(const CloudFile& file, const std::string& name)
{
  const int index = pcl::getFieldIndex(file.cloud, name);
  std::vector<double> values;
  if (index < 0)
    return values;
  const auto& field = file.cloud.fields[static_cast<std::size_t>(index)];
  for (std::size_t i = 0; i < file.cloud.width; ++i) {
    const auto* bytes = &file.cloud.data[i * file.cloud.point_step + field.offset];
    if (field.datatype == pcl::PCLPointField::FLOAT64) {
      double value;
      std::memcpy(&value, bytes, sizeof(value));
      values.push_back(value);
    }
    else if (field.datatype == pcl::PCLPointField::FLOAT32) {
      float value;
      std::memcpy(&value, bytes, sizeof(value));
      values.push_back(static_cast<double>(value));
    }
    else if (field.datatype == pcl::PCLPointField::UINT8)
      values.push_back(*bytes);
    else if (field.datatype == pcl::PCLPointField::INT16) {
      std::int16_t value;
      std::memcpy(&value, bytes, sizeof(value));
      values.push_back(value);
    }
    else {
      std::uint16_t value;
      std::memcpy(&value, bytes, sizeof(value));
      values.push_back(value);
    }
  }
  return values;
}

} // namespace

TEST_F(LasFiles, PointsAreWhereScaleAndOffsetPutThem)
{
  for (const int minor : {0, 2, 3}) {
    LasMaker maker;
    maker.minor = minor;
    const auto file = loadCloud(write("scan.las", maker.file()));
    EXPECT_EQ(valuesOf(file, "x"), (std::vector<double>{691234, 691235, 691236}));
    EXPECT_EQ(valuesOf(file, "y"), (std::vector<double>{5334567, 5334565, 5334563}));
    EXPECT_EQ(valuesOf(file, "z"), (std::vector<double>{0, 0.25, 0.5}));
    EXPECT_EQ(file.finite_count, 3u);
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3d place =
          (*file.points)[i].getVector3fMap().cast<double>() + file.offset;
      EXPECT_NEAR(place.x(), 691234.0 + static_cast<double>(i), 1e-6);
      EXPECT_NEAR(place.y(), 5334567.0 - 2 * static_cast<double>(i), 1e-6);
    }
  }
}

TEST_F(LasFiles, OtherFieldsAreKept)
{
  const auto file = loadCloud(write("scan.las", LasMaker().file()));
  EXPECT_EQ(valuesOf(file, "intensity"), (std::vector<double>{0, 100, 200}));
  EXPECT_EQ(valuesOf(file, "classification"), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(valuesOf(file, "point_source_id"), (std::vector<double>{7, 7, 7}));
  EXPECT_EQ(valuesOf(file, "gps_time"), (std::vector<double>{0, 1.5, 3}));
  const int rgb = pcl::getFieldIndex(file.cloud, "rgb");
  ASSERT_GE(rgb, 0);
  std::uint32_t color = 0;
  std::memcpy(&color,
              &file.cloud.data[file.cloud.fields[static_cast<std::size_t>(rgb)].offset],
              4);
  EXPECT_EQ(color, 0x112233u);
}

namespace {

std::uint32_t
colorOf(const CloudFile& file)
{
  std::uint32_t color = 0;
  const int rgb = pcl::getFieldIndex(file.cloud, "rgb");
  std::memcpy(
      &color,
      &file.cloud.data[file.cloud.fields.at(static_cast<std::size_t>(rgb)).offset],
      4);
  return color;
}

} // namespace

TEST_F(LasFiles, ColoursOfEightBitsAreTakenAsTheyAre)
{
  LasMaker maker;
  maker.color = 85;
  auto file = loadCloud(write("scan.las", maker.file()));
  EXPECT_EQ(colorOf(file), 0x55aaffu);
  EXPECT_EQ(file.notes,
            std::vector<std::string>{"its colours have 8 bits in fields of 16, none "
                                     "exceeds 255: they are taken as they are"});
  EXPECT_EQ(CloudStream::open(path("scan.las"))->notes(), file.notes);
  maker.color = 86; // of which three times are more than 255
  file = loadCloud(write("scan.las", maker.file()));
  EXPECT_EQ(colorOf(file), 0x000001u);
  EXPECT_TRUE(file.notes.empty());
  maker.color = 0;
  file = loadCloud(write("scan.las", maker.file()));
  EXPECT_EQ(colorOf(file), 0u);
  EXPECT_TRUE(file.notes.empty());
  // some among others of 16 bits, also in parts
  maker.color = 85;
  auto bytes = maker.file();
  put<std::uint16_t>(bytes, bytes.size() - 2, 0xff00);
  file = loadCloud(write("scan.las", bytes));
  EXPECT_EQ(colorOf(file), 0x55aaffu);
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_NE(file.notes[0].find("8 bits in 2 points"), std::string::npos);
  const auto first = CloudStream::open(path("scan.las"))->read(0, 1);
  EXPECT_TRUE(
      std::equal(first.data.begin(), first.data.end(), file.cloud.data.begin()));
}

TEST_F(LasFiles, ColoursOfMoreThanEightBitsAreKept)
{
  LasMaker maker;
  maker.color = 0x1234;
  const auto file = loadCloud(write("scan.las", maker.file()));
  EXPECT_EQ(colorOf(file), 0x122436u);
  EXPECT_EQ(valuesOf(file, "red_16"), (std::vector<double>{0x1234, 0x1234, 0x1234}));
  EXPECT_EQ(valuesOf(file, "green_16"), (std::vector<double>{0x2468, 0x2468, 0x2468}));
  EXPECT_EQ(valuesOf(file, "blue_16"), (std::vector<double>{0x369c, 0x369c, 0x369c}));
  for (const int color : {0x1100, 0x1111, 0x11}) { // 8 bits tell all of them
    maker.color = static_cast<std::uint16_t>(color);
    const auto coarse = loadCloud(write("scan.las", maker.file()));
    EXPECT_EQ(pcl::getFieldIndex(coarse.cloud, "red_16"), -1) << color;
  }
}

TEST_F(LasFiles, ReturnsFlagsAndAnglesAreKept)
{
  using Values = std::vector<double>;
  auto file = loadCloud(write("scan.las", LasMaker().file()));
  const auto expectField = [&file](const char* name, const Values& values) {
    EXPECT_EQ(valuesOf(file, name), values) << name;
  };
  expectField("return_number", {1, 1, 1});
  expectField("number_of_returns", {2, 2, 2});
  expectField("scan_direction_flag", {1, 1, 1});
  expectField("edge_of_flight_line", {1, 1, 1});
  expectField("classification_flags", {3, 3, 3});
  expectField("user_data", {30, 31, 32});
  expectField("scan_angle", {-5, -5, -5});
  LasMaker maker;
  maker.minor = 4;
  maker.format = 8;
  maker.step = 38;
  auto bytes = maker.file();
  put<std::uint16_t>(bytes, 375 + 36, 777);
  file = loadCloud(write("scan.las", bytes));
  expectField("return_number", {1, 1, 1});
  expectField("number_of_returns", {2, 2, 2});
  expectField("scan_direction_flag", {1, 1, 1});
  expectField("edge_of_flight_line", {1, 1, 1});
  expectField("classification_flags", {9, 9, 9});
  expectField("scanner_channel", {2, 2, 2});
  expectField("user_data", {30, 31, 32});
  EXPECT_NEAR(valuesOf(file, "scan_angle")[1], -30, 1e-4);
  expectField("nir", {777, 0, 0});
}

TEST_F(LasFiles, PointsThatAreWithheldHaveNoPlace)
{
  auto bytes = LasMaker().file();
  bytes[227 + 34 + 15] = static_cast<char>(0x80 | 2); // of the second point
  const auto file = loadCloud(write("scan.las", bytes));
  EXPECT_EQ(file.cloud.width, 3u);
  EXPECT_EQ(file.finite_count, 2u);
  EXPECT_TRUE(std::isnan((*file.points)[1].x));
  EXPECT_EQ(
      file.notes,
      std::vector<std::string>{"points that are flagged as withheld are left out: 1"});
  const auto stream = CloudStream::open(path("scan.las"));
  EXPECT_EQ(stream->notes(), file.notes);
  EXPECT_EQ(stream->read(0, 3).data, file.cloud.data);
  LasMaker maker;
  maker.minor = 4;
  maker.format = 6;
  maker.step = 30;
  bytes = maker.file();
  bytes[375 + 15] = 4;
  EXPECT_EQ(loadCloud(write("scan.las", bytes)).finite_count, 2u);
}

TEST_F(LasFiles, PointsThatTheHeaderDoesNotPromiseAreNamed)
{
  auto bytes = LasMaker().file();
  put<std::uint32_t>(bytes, 107, 0);
  auto file = loadCloud(write("scan.las", bytes));
  EXPECT_EQ(file.cloud.width, 3u);
  EXPECT_EQ(file.notes,
            std::vector<std::string>{
                "its header promises no points; the 3 that it holds are read"});
  put<std::uint32_t>(bytes, 107, 2);
  file = loadCloud(write("scan.las", bytes));
  EXPECT_EQ(file.cloud.width, 2u);
  EXPECT_EQ(file.notes,
            std::vector<std::string>{
                "points beyond the number that its header promises are left out: 1"});
  // records behind the points are none
  LasMaker maker;
  maker.minor = 4;
  maker.format = 6;
  maker.step = 30;
  bytes = maker.file();
  put<std::uint64_t>(bytes, 235, bytes.size());
  bytes += std::string(100, 'x');
  EXPECT_TRUE(loadCloud(write("scan.las", bytes)).notes.empty());
}

TEST_F(LasFiles, MoreExtraBytesThanPointsHaveAreLeftOut)
{
  LasMaker maker;
  maker.step = 36;
  maker.extra =
      extraDescription("tilt", 4, false) + extraDescription("depth", 9, false);
  const auto file = loadCloud(write("scan.las", maker.file()));
  EXPECT_EQ(valuesOf(file, "tilt"), (std::vector<double>{0, -1, -2}));
  EXPECT_EQ(file.notes,
            std::vector<std::string>{"it describes more extra bytes than its points "
                                     "have: from 'depth' on they are left out"});
}

TEST_F(LasFiles, LongFormatsHaveClassesOfEightBits)
{
  LasMaker maker;
  maker.minor = 4;
  maker.format = 6;
  maker.step = 30;
  const auto file = loadCloud(write("scan.las", maker.file()));
  EXPECT_EQ(valuesOf(file, "classification"), (std::vector<double>{200, 201, 202}));
  EXPECT_TRUE(valuesOf(file, "gps_time").size() == 3);
  EXPECT_EQ(promisedPoints(path("scan.las")), 3u);
}

TEST_F(LasFiles, ExtraDimensionsHaveTheirOwnNames)
{
  for (const bool scaled : {false, true}) {
    LasMaker maker;
    maker.step = 36;
    maker.extra = extraDescription("tilt (deg)", 4, scaled);
    const auto file = loadCloud(write("scan.las", maker.file()));
    EXPECT_EQ(valuesOf(file, "tilt__deg_"),
              scaled ? (std::vector<double>{10, 9.5, 9})
                     : (std::vector<double>{0, -1, -2}));
  }
}

TEST_F(LasFiles, OneRecordDescribesTheExtraBytes)
{
  // a second one would describe the same bytes once more, as would thousands
  LasMaker maker;
  maker.step = 36;
  maker.extra = extraDescription("tilt", 4, false);
  auto bytes = maker.file();
  constexpr std::size_t header = 227, record = 54 + 192;
  auto second = bytes.substr(header, record);
  second.replace(54 + 4, 4, "more");
  bytes.insert(header + record, second);
  put<std::uint32_t>(bytes, 96, header + 2 * record);
  put<std::uint32_t>(bytes, 100, 2);
  const auto file = loadCloud(write("scan.las", bytes));
  EXPECT_EQ(valuesOf(file, "tilt"), (std::vector<double>{0, -1, -2}));
  EXPECT_TRUE(valuesOf(file, "more").empty());
}

TEST_F(LasFiles, DimensionsBehindOnesOfSeveralValuesAreKept)
{
  LasMaker maker;
  maker.step = 34 + 6 + 2;
  maker.extra = extraDescription("direction", 24, false) + // three of 16 bits
                extraDescription("tilt", 4, false);
  const auto file = loadCloud(write("scan.las", maker.file()));
  EXPECT_EQ(valuesOf(file, "tilt"), (std::vector<double>{0, -1, -2}));
  EXPECT_TRUE(file.notes.empty());
}

TEST_F(LasFiles, DamagedFilesAreRefusedInOneLine)
{
  const auto refused = [&](std::string bytes, const std::string& what) {
    try {
      loadCloud(write("scan.las", bytes));
      ADD_FAILURE() << "was read: " << what;
    } catch (const ToolError& error) {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos)
          << error.what();
    }
  };
  auto bytes = LasMaker().file();
  refused(bytes.substr(0, bytes.size() - 1), "promises 3 points");
  refused(bytes.substr(0, 180), "header of this LAS file");
  auto far = bytes;
  put<std::uint32_t>(far, 96, 1000000); // where the points begin
  put<std::uint32_t>(far, 100, 1000);   // records before them
  put<std::uint32_t>(far, 107, 0);
  refused(far, "promises 1000000 bytes before its points");
  bytes[104] = 11;
  refused(bytes, "header of this LAS file");
  bytes = LasMaker().file();
  put<std::uint16_t>(bytes, 105, 20); // shorter than its format
  refused(bytes, "header of this LAS file");
  bytes = LasMaker().file();
  bytes[24] = 2;
  refused(bytes, "header of this LAS file");
  bytes = LasMaker().file();
  put<double>(bytes, 139, 0); // all y are the same
  refused(bytes, "has the scale 0");
  LasMaker none;
  none.count = 0;
  refused(none.file(), "empty");
}

TEST_F(LasFiles, AreReadInPartsAlike)
{
  const auto file = loadCloud(write("scan.las", LasMaker().file()));
  const auto stream = CloudStream::open(path("scan.las"));
  ASSERT_TRUE(stream);
  EXPECT_EQ(stream->pointCount(), file.points->size());
  const auto part = stream->read(1, 2);
  EXPECT_EQ(part.width, 2u);
  EXPECT_EQ(part.fields.size(), file.cloud.fields.size());
  EXPECT_TRUE(std::equal(part.data.begin(),
                         part.data.end(),
                         file.cloud.data.begin() + file.cloud.point_step));
}
