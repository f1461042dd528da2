/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cloud_file.h"
#include "files/cloud_formats.h"
#include "files/cloud_stream.h"
#include "files/tool_error.h"
#include "formats/e57/e57_pages.h"
#include "support/e57_writer.h"
#include "support/expect_part.h"
#include "support/folder_test.h"

#include <pcl/common/io.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;
using test::E57Column;
using test::e57Doubles;
using test::e57Floats;
using test::E57TestScan;
using test::e57Wholes;
using test::E57Writer;

namespace {

std::vector<double>
randomReals(std::size_t count, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(static_cast<double>(random()) / 4294967296.0 * 20.0 - 10.0);
  return values;
}

/** Whole numbers of a range, its ends among them. */
std::vector<std::int64_t>
randomWholes(std::size_t count, std::int64_t least, std::int64_t largest, unsigned seed)
{
  std::mt19937_64 random(seed);
  const auto range =
      static_cast<std::uint64_t>(largest) - static_cast<std::uint64_t>(least);
  std::vector<std::int64_t> values = {largest, least};
  while (values.size() < count)
    values.push_back(static_cast<std::int64_t>(
        static_cast<std::uint64_t>(least) +
        (range == ~std::uint64_t{0} ? random() : random() % (range + 1))));
  return values;
}

/** Cartesian coordinates as doubles. */
std::vector<E57Column>
places(std::size_t count, unsigned seed)
{
  return {e57Doubles("cartesianX", randomReals(count, seed)),
          e57Doubles("cartesianY", randomReals(count, seed + 1)),
          e57Doubles("cartesianZ", randomReals(count, seed + 2))};
}

E57TestScan
scanWith(const std::vector<E57Column>& others, std::size_t count = 100)
{
  E57TestScan scan{"hall", places(count, 1)};
  scan.columns.insert(scan.columns.end(), others.begin(), others.end());
  return scan;
}

std::string
poseText(const Eigen::Quaterniond& turn, const Eigen::Vector3d& shift)
{
  const auto element = [](const char* name, double value) {
    char text[100];
    std::snprintf(
        text, sizeof(text), "<%s type=\"Float\">%.17e</%s>", name, value, name);
    return std::string(text);
  };
  return "<pose type=\"Structure\"><rotation type=\"Structure\">" +
         element("w", turn.w()) + element("x", turn.x()) + element("y", turn.y()) +
         element("z", turn.z()) + "</rotation><translation type=\"Structure\">" +
         element("x", shift.x()) + element("y", shift.y()) + element("z", shift.z()) +
         "</translation></pose>\n";
}

class E57Files : public test::FolderTest {
protected:
  CloudFile
  load(const std::vector<E57TestScan>& scans)
  {
    return loadCloud(write("scan.e57", E57Writer().file(scans)), {}, 1);
  }

  std::string
  refusal(const std::string& bytes)
  {
    try {
      loadCloud(write("scan.e57", bytes), {}, 1);
    } catch (const ToolError& error) {
      const std::string text = error.what(), start = path("scan.e57") + ": ";
      EXPECT_EQ(text.substr(0, start.size()), start);
      EXPECT_EQ(text.find('\n'), text.npos);
      return text.substr(std::min(start.size(), text.size()));
    }
    return "it was read";
  }

  std::string
  refusal(const E57TestScan& scan)
  {
    return refusal(E57Writer().file({scan}));
  }

  /** The file with a text of its description replaced by another of the same length. */
  std::string
  changed(const E57TestScan& scan, const std::string& text, std::string other)
  {
    auto bytes = E57Writer().file({scan});
    const auto at = bytes.find(text);
    EXPECT_NE(at, bytes.npos);
    other.resize(text.size(), ' ');
    bytes.replace(at, text.size(), other);
    E57Writer::sign(bytes);
    return bytes;
  }
};

std::vector<std::string>
namesOf(const CloudFile& file)
{
  std::vector<std::string> names;
  for (const auto& field : file.cloud.fields)
    names.push_back(field.name);
  return names;
}

std::uint8_t
typeOf(const CloudFile& file, const std::string& name)
{
  return file.cloud
      .fields[static_cast<std::size_t>(pcl::getFieldIndex(file.cloud, name))]
      .datatype;
}

} // namespace

TEST(Crc32c, IsThatOfTheStandard)
{ // RFC 3720, appendix B.4
  std::string ascending;
  for (char i = 0; i < 32; ++i)
    ascending += i;
  EXPECT_EQ(crc32c(std::string(32, '\0').data(), 32), 0x8a9136aau);
  EXPECT_EQ(crc32c(std::string(32, '\xff').data(), 32), 0x62a8ab43u);
  EXPECT_EQ(crc32c(ascending.data(), 32), 0x46dd794eu);
  EXPECT_EQ(crc32c("123456789", 9), 0xe3069283u);
  EXPECT_EQ(crc32c("", 0), 0u);
}

TEST_F(E57Files, RealsAreReadAsTheyAre)
{
  const auto x = randomReals(1000, 1), y = randomReals(1000, 2);
  std::vector<float> z;
  for (const double value : randomReals(1000, 3))
    z.push_back(static_cast<float>(value));
  const auto file = load({{"hall",
                           {e57Doubles("cartesianX", x),
                            e57Floats("cartesianZ", z),
                            e57Doubles("cartesianY", y)}}});
  EXPECT_EQ(namesOf(file), (std::vector<std::string>{"x", "y", "z"}));
  EXPECT_EQ(readNumbers(file, "x"), x);
  EXPECT_EQ(readNumbers(file, "y"), y);
  EXPECT_EQ(readNumbers(file, "z"), std::vector<double>(z.begin(), z.end()));
  EXPECT_TRUE(file.notes.empty());
}

TEST_F(E57Files, WholeNumbersOfAllWidthsAreReadAsTheyAre)
{
  for (unsigned bits = 1; bits <= 64; ++bits) {
    const auto least =
        bits == 64 ? std::numeric_limits<std::int64_t>::min()
                   : -static_cast<std::int64_t>(std::uint64_t{1} << (bits - 1)) / 2 - 3;
    const auto largest =
        bits == 64 ? std::numeric_limits<std::int64_t>::max()
                   : static_cast<std::int64_t>(static_cast<std::uint64_t>(least) +
                                               (~std::uint64_t{0} >> (64 - bits)));
    const auto values = randomWholes(333, least, largest, bits);
    const auto column = e57Wholes("las:someNumber", least, largest, values);
    ASSERT_EQ(column.bits, bits);
    const auto file = load({scanWith({column}, 333)});
    const auto read = readNumbers(file, "some_number");
    for (std::size_t i = 0; i < values.size(); ++i)
      ASSERT_EQ(read[i], static_cast<double>(values[i]))
          << bits << " bits, value " << i;
    EXPECT_EQ(readNumbers(file, "x"), randomReals(333, 1));
  }
}

TEST_F(E57Files, ScaledNumbersHaveScaleAndOffset)
{
  const auto raw = randomWholes(500, -50000, 123456, 5);
  const auto column = e57Wholes(
      "cartesianX", -50000, 123456, raw, "scale=\"1.25e-3\" offset=\"691000.5\"");
  const auto others = places(500, 7);
  const auto file = load({{"hall", {column, others[1], others[2]}}});
  const auto x = readNumbers(file, "x");
  for (std::size_t i = 0; i < raw.size(); ++i)
    EXPECT_EQ(x[i], static_cast<double>(raw[i]) * 1.25e-3 + 691000.5);
  EXPECT_GT(file.offset.x(), 690000); // large coordinates lose nothing
  EXPECT_NEAR((*file.points)[0].x + file.offset.x(), x[0], 1e-5);
}

TEST_F(E57Files, PartsAreThoseOfTheWhole)
{
  E57Writer writer;
  for (const std::size_t points : {1, 20, 300, 0}) {
    writer.points = points > 0 ? points : 50;
    writer.are_apart = points == 0;
    const auto scan =
        scanWith({e57Wholes("intensity", 0, 1000, randomWholes(900, 0, 1000, 4)),
                  e57Wholes("rowIndex", 0, 4, randomWholes(900, 0, 4, 5))},
                 900);
    const auto name = write("scan.e57", writer.file({scan, scanWith({}, 30), scan}));
    const auto file = loadCloud(name, {}, 1);
    const auto stream = CloudStream::open(name);
    ASSERT_TRUE(stream);
    ASSERT_EQ(stream->pointCount(), 1830u);
    EXPECT_EQ(promisedPoints(name), 1830u);
    ASSERT_EQ(stream->notes().size(), 1u);
    EXPECT_EQ(stream->notes()[0], file.notes[0]); // others are of the places
    std::mt19937 random(6);
    for (int trial = 0; trial < 200; ++trial) {
      const auto first = random() % 1830, count = 1 + random() % (1830 - first);
      pcl::indoor::test::expectPart(*stream, file.cloud, first, count);
    }
  }
}

TEST_F(E57Files, ScansAreMovedByTheirPosesAndHaveStations)
{
  const Eigen::Quaterniond turns[] = {
      Eigen::Quaterniond::Identity(),
      Eigen::Quaterniond(0.5, -0.5, 0.5, 0.5),
      Eigen::Quaterniond(2, 0.2, -1, 3)}; // of any length
  const Eigen::Vector3d shifts[] = {{0, 0, 0}, {691234.5, 5334567.25, 500}, {1, -2, 3}};
  std::vector<E57TestScan> scans;
  for (unsigned s = 0; s < 3; ++s)
    scans.push_back({s == 1 ? "" : "scan " + std::string(1, static_cast<char>('a' + s)),
                     places(50 + s, 10 * s),
                     poseText(turns[s], shifts[s])});
  const auto file = load(scans);
  const CloudPlaces found(file.cloud);
  ASSERT_EQ(found.size(), 153u);
  const auto stations = readLabels(file, "station");
  std::size_t i = 0;
  for (unsigned s = 0; s < 3; ++s) {
    const auto x = randomReals(50 + s, 10 * s), y = randomReals(50 + s, 10 * s + 1),
               z = randomReals(50 + s, 10 * s + 2);
    const auto turn = turns[s].normalized();
    for (std::size_t k = 0; k < x.size(); ++k, ++i) {
      const Eigen::Vector3d expected =
          turn * Eigen::Vector3d(x[k], y[k], z[k]) + shifts[s];
      EXPECT_LT((found.at(i) - expected).norm(), 2e-9); // a step of 5334567
      EXPECT_EQ(stations[i], s + 1);
    }
  }
  ASSERT_EQ(file.stations.size(), 3u);
  EXPECT_EQ(file.stations[0].name, "scan a");
  EXPECT_EQ(file.stations[1].name, "scan 2");
  EXPECT_FALSE(file.stations[0].position); // nothing tells it from a file without poses
  EXPECT_EQ(file.stations[1].position, shifts[1]);
  EXPECT_EQ(file.stations[2].position, shifts[2]);
}

TEST_F(E57Files, AScanInRowsAndColumnsWasMadeAtItsOrigin)
{
  const auto rows = e57Wholes("rowIndex", 0, 99, randomWholes(100, 0, 99, 1));
  const auto columns = e57Wholes("columnIndex", 0, 9, randomWholes(100, 0, 9, 2));
  const auto file = load({scanWith({rows, columns})});
  ASSERT_EQ(file.stations.size(), 1u);
  EXPECT_EQ(file.stations[0].position, Eigen::Vector3d(0, 0, 0));
  EXPECT_FALSE(hasField(file.cloud, "station"));
  const auto row = readLabels(file, "row"), column = readLabels(file, "column");
  for (std::size_t i = 0; i < 100; ++i) {
    EXPECT_EQ(row[i], rows.stored[i]);
    EXPECT_EQ(column[i], columns.stored[i]);
  }
}

TEST_F(E57Files, SphericalCoordinates)
{
  const auto range = randomReals(200, 1), azimuth = randomReals(200, 2),
             elevation = randomReals(200, 3);
  const Eigen::Quaterniond turn(0.6, 0, 0.8, 0);
  const auto file = load({{"hall",
                           {e57Doubles("sphericalRange", range),
                            e57Doubles("sphericalAzimuth", azimuth),
                            e57Doubles("sphericalElevation", elevation)},
                           poseText(turn, {1, 2, 3})}});
  const CloudPlaces found(file.cloud);
  for (std::size_t i = 0; i < range.size(); ++i) {
    const Eigen::Vector3d own(range[i] * std::cos(elevation[i]) * std::cos(azimuth[i]),
                              range[i] * std::cos(elevation[i]) * std::sin(azimuth[i]),
                              range[i] * std::sin(elevation[i]));
    EXPECT_LT((found.at(i) - (turn * own + Eigen::Vector3d(1, 2, 3))).norm(),
              1e-14 * 100);
  }
  ASSERT_EQ(file.stations.size(), 1u);
  EXPECT_EQ(file.stations[0].position, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(file.pose.origin, Eigen::Vector4f(1, 2, 3, 0));
}

TEST_F(E57Files, PointsThatAreFlaggedAreLeftOutAndCounted)
{
  for (const std::int64_t largest : {1, 2}) {
    const auto flags = randomWholes(1000, 0, largest, 9);
    const auto count = static_cast<std::size_t>(
        1000 - std::count(flags.begin(), flags.end(), std::int64_t{0}));
    const auto scan =
        scanWith({e57Wholes("cartesianInvalidState", 0, largest, flags)}, 1000);
    const auto file = load({scan, scan});
    EXPECT_EQ(file.finite_count, 2000 - 2 * count);
    EXPECT_FALSE(hasField(file.cloud, "cartesian_invalid_state"));
    EXPECT_EQ(file.notes[0],
              "points that are flagged as invalid are left out: " +
                  std::to_string(2 * count));
    for (std::size_t i = 0; i < 1000; ++i)
      EXPECT_EQ(std::isnan((*file.points)[i].x), flags[i] != 0);
  }
}

TEST_F(E57Files, ColoursHaveTheLimitsThatAreTold)
{
  const std::string limits =
      "<colorLimits><colorRedMinimum/><colorRedMaximum>65535</colorRedMaximum>"
      "<colorGreenMinimum>10</colorGreenMinimum><colorGreenMaximum>20</"
      "colorGreenMaximum>"
      "<colorBlueMinimum>0</colorBlueMinimum><colorBlueMaximum>1</colorBlueMaximum>"
      "</colorLimits>";
  auto scan =
      scanWith({e57Wholes("colorRed", 0, 65535, {0, 256, 0x7f00, 0xff00, 65535}),
                e57Wholes("colorGreen", 0, 255, {9, 10, 15, 20, 255}),
                e57Doubles("colorBlue", {-1, 1 / 255.0, 0.5, 1, NAN})},
               5);
  auto file = load({scan});
  EXPECT_EQ(readColors(file)->at(0).rgba & 0xffffff, 0x000900u); // limits of the values
  scan.more = limits;
  file = load({scan});
  const std::uint32_t expected[] = {0x000000, 0x010001, 0x7f8080, 0xffffff, 0xffff00};
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_EQ(readColors(file)->at(i).rgba & 0xffffff, expected[i]) << i;
}

TEST_F(E57Files, OtherFieldsKeepTheirValues)
{
  const auto file =
      load({scanWith({e57Wholes("intensity", 0, 4095, {0, 1, 4095}),
                      e57Wholes("isIntensityInvalid", 0, 1, {0, 1, 0}),
                      e57Wholes("returnIndex", 0, 3, {0, 1, 2}),
                      e57Wholes("returnCount", 1, 3, {1, 2, 3}),
                      e57Doubles("timeStamp", {0.5, 1e9, -1}),
                      e57Wholes("las:pointSourceId", 7, 7, {7, 7, 7}),
                      e57Floats("nor:normalX", {1, 0, 0}),
                      e57Floats("nor:normalY", {0, 1, 0}),
                      e57Floats("nor:normalZ", {0, 0, 1}),
                      E57Column{"remark", "type=\"String\"", 8, {'a', 'b', 'c'}}},
                     3)});
  EXPECT_EQ(namesOf(file),
            (std::vector<std::string>{"x",
                                      "y",
                                      "z",
                                      "intensity",
                                      "normal_x",
                                      "normal_y",
                                      "normal_z",
                                      "return_number",
                                      "number_of_returns",
                                      "time"}));
  EXPECT_EQ(file.notes[0], "fields that are left out: las:pointSourceId, remark");
  const auto intensity = readNumbers(file, "intensity");
  EXPECT_EQ(intensity[0], 0);
  EXPECT_TRUE(std::isnan(intensity[1]));
  EXPECT_EQ(intensity[2], 4095);
  EXPECT_EQ(readLabels(file, "return_number"), (std::vector<std::uint32_t>{1, 2, 3}));
  EXPECT_EQ(readLabels(file, "number_of_returns"),
            (std::vector<std::uint32_t>{1, 2, 3}));
  EXPECT_EQ(readNumbers(file, "time"), (std::vector<double>{0.5, 1e9, -1}));
  EXPECT_EQ(typeOf(file, "time"), pcl::PCLPointField::FLOAT64);
  EXPECT_EQ(typeOf(file, "return_number"), pcl::PCLPointField::UINT32);
}

TEST_F(E57Files, NormalsAreTurnedAsTheirScanIs)
{
  auto scan = scanWith({e57Floats("nor:normalX", {1, 0, 0}),
                        e57Floats("nor:normalY", {0, 1, 0}),
                        e57Floats("nor:normalZ", {0, 0, 1})},
                       3);
  scan.more = poseText({0.5, 0.5, 0.5, 0.5}, {5, 0, 0}); // x to y, y to z, z to x
  const auto file = load({scan});
  EXPECT_NEAR(readNumbers(file, "normal_y")[0], 1, 1e-6);
  EXPECT_NEAR(readNumbers(file, "normal_z")[1], 1, 1e-6);
  EXPECT_NEAR(readNumbers(file, "normal_x")[2], 1, 1e-6);
  EXPECT_NEAR(readNumbers(file, "normal_x")[0], 0, 1e-6);
}

TEST_F(E57Files, AWrongBitAnywhereIsNoticed)
{
  const auto whole = E57Writer().file({scanWith({}, 300)});
  ASSERT_GT(whole.size(), 8 * 1024u);
  for (std::size_t page = 0; page < whole.size() / 1024; ++page)
    for (const std::size_t byte : {9, 500, 1019, 1020, 1023}) {
      auto bytes = whole;
      bytes[1024 * page + byte] ^= '\4';
      EXPECT_EQ(refusal(bytes),
                "the file is damaged, the checksum of its page " +
                    std::to_string(page + 1) + " of " +
                    std::to_string(whole.size() / 1024) + " is wrong");
      EXPECT_FALSE(CloudStream::open(path("scan.e57")));
    }
}

TEST_F(E57Files, FilesThatAreCutAreRefused)
{
  const auto whole = E57Writer().file({scanWith({}, 300)});
  for (const std::size_t size : {8, 47, 48, 1023, 1024, 3000, 8 * 1024})
    EXPECT_NE(refusal(whole.substr(0, size)).find("truncated"), std::string::npos)
        << size;
}

TEST_F(E57Files, HeadersThatLieAreRefused)
{
  const auto header = [&](std::size_t at, std::uint64_t value, std::size_t size) {
    auto bytes = E57Writer().file({scanWith({}, 300)});
    std::memcpy(&bytes[at], &value, size);
    E57Writer::sign(bytes);
    return refusal(bytes);
  };
  EXPECT_EQ(header(8, 2, 4), "this E57 file is of version 2.0, 1.0 is read");
  EXPECT_EQ(header(16, 1ull << 40, 8).substr(0, 21), "the file is truncated");
  EXPECT_NE(header(24, 1ull << 63, 8).find("its description would stand at byte 9223"),
            std::string::npos);
  EXPECT_NE(header(24, 1022, 8).find("is within a checksum"), std::string::npos);
  EXPECT_NE(header(32, ~0ull, 8).find("a description of 18446744073709551615 bytes"),
            std::string::npos);
  EXPECT_NE(header(40, 4096, 8).find("have 4096 bytes"), std::string::npos);
}

TEST_F(E57Files, DescriptionsThatLieAreRefused)
{
  const auto scan =
      scanWith({e57Wholes("intensity", 0, 100, randomWholes(100, 0, 100, 1))});
  auto more = scan;
  more.count = 101;
  EXPECT_EQ(
      refusal(more),
      "the file is truncated, its header promises 101 points of 'hall', it has 100");
  more.name = "two\nlines";
  EXPECT_NE(refusal(more).find("101 points of 'two lines'"), std::string::npos);
  more.name = "hall";
  more.count = 0x7fffffff;
  EXPECT_NE(refusal(more).find("promises 2147483647 points"), std::string::npos);
  more.count = 0x7fffffffffffffff;
  EXPECT_EQ(refusal(more), "'hall' has more than 2^31 - 1 points");
  more.count = 0;
  EXPECT_EQ(refusal(more), "the cloud is empty (0 points)");
  EXPECT_EQ(refusal(E57Writer().file({})), "the cloud is empty (0 points)");
  EXPECT_NE(
      refusal(changed(scan, "maximum=\"100\"", "maximum=\"-1\"")).find("less than"),
      std::string::npos);
  EXPECT_NE(refusal(changed(scan, "maximum=\"100\"", "maximum=\"1e\"")).find("'1e'"),
            std::string::npos);
  EXPECT_NE(refusal(changed(scan, "</prototype>", "</prototypf>"))
                .find("is damaged at its byte"),
            std::string::npos);
  EXPECT_NE(
      refusal(changed(scan, "cartesianX", "cartesianW")).find("neither Cartesian"),
      std::string::npos);
  EXPECT_NE(refusal(changed(scan, "fileOffset=\"48\"", "fileOffset=\"49\""))
                .find("no points stand at the place of 'hall'"),
            std::string::npos);
  auto turned = scan;
  turned.more = poseText({0, 0, 0, 0}, {0, 0, 0});
  EXPECT_NE(refusal(turned).find("the pose of 'hall' is none"), std::string::npos);
  E57Writer writer;
  writer.codecs = "<vectorChild><zipCodec/></vectorChild>";
  EXPECT_NE(refusal(writer.file({scan})).find("bitPackCodec"), std::string::npos);
  auto wide = scan;
  for (int f = 0; f < 1000; ++f)
    wide.columns.push_back(e57Wholes("f" + std::to_string(f), 0, 0, {}));
  EXPECT_NE(refusal(wide).find("has 1004 fields of a point"), std::string::npos);
  E57TestScan one{"hall", {}};
  for (const char* name : {"cartesianX", "cartesianY", "cartesianZ"})
    one.columns.push_back(e57Wholes(name, 1, 1, {1, 1}));
  EXPECT_EQ(refusal(one), "the points of 'hall' are all one");
}

TEST_F(E57Files, PacketsThatLieAreRefused)
{
  const auto packet = [&](std::size_t at, std::uint64_t value, std::size_t size) {
    auto bytes = E57Writer().file({scanWith({}, 100)});
    std::memcpy(&bytes[48 + at], &value, size); // the section begins at byte 48
    E57Writer::sign(bytes);
    return refusal(bytes);
  };
  EXPECT_NE(packet(0, 2, 1).find("no points stand"), std::string::npos);
  EXPECT_NE(packet(8, 0, 8).find("it has 0"), std::string::npos);
  EXPECT_NE(packet(16, 1ull << 50, 8).find("a packet of points would stand"),
            std::string::npos);
  EXPECT_NE(packet(16, 0, 8).find("packets stand before"), std::string::npos);
  EXPECT_NE(packet(32, 7, 1).find("a packet is none"), std::string::npos);
  EXPECT_NE(packet(34, 0, 2).find("a packet is none"), std::string::npos);
  EXPECT_NE(packet(34, 0xffff, 2).find("a packet is none"), std::string::npos);
  EXPECT_NE(packet(36, 5, 2).find("5 streams for 3 fields"), std::string::npos);
  EXPECT_NE(packet(38, 0xffff, 2).find("shorter than its content"), std::string::npos);
}

TEST_F(E57Files, ScansThatShareTheirPointsAreRefused)
{
  const std::vector<E57TestScan> scans(10, scanWith({}, 300));
  E57Writer writer;
  EXPECT_EQ(loadCloud(write("scan.e57", writer.file(scans))).cloud.width, 3000u);
  writer.are_shared = true;
  EXPECT_NE(refusal(writer.file(scans)).find("its scans share their points"),
            std::string::npos);
}
