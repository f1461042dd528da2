/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// The files of test/fuzz/corpus/laz were written by LASzip 3.5.0 (its LASwritePoint),
// 150 points of LazPoints each, in chunks of 50 where no other way is in the name:
// "variable" has chunks of 10 and of 60 points, "pointwise" none, and version 1 of all
// items; "streamed" tells where its table of chunks is at its end.
#include "files/cloud_file.h"
#include "files/cloud_stream.h"
#include "files/tool_error.h"
#include "formats/las/las_source.h"
#include "formats/reader_threads.h"
#include "support/folder_test.h"
#include "support/laz_points.h"

#include <gtest/gtest.h>

#include "io/formats/put_value.h"

#include <sys/resource.h>

#include <cstring>
#include <random>
#include <vector>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;
using pcl::indoor::test::put;

namespace {

constexpr int point_count = 150;
constexpr std::size_t header_size = 375;

struct Peer {
  const char* name;
  int format, extra_bytes;
};

constexpr Peer peers[] = {{"format_0", 0, 0},
                          {"format_1", 1, 0},
                          {"format_1_streamed", 1, 1},
                          {"format_2", 2, 0},
                          {"format_3", 3, 3},
                          {"format_3_version_1", 3, 0},
                          {"format_5_pointwise", 5, 2},
                          {"format_5_variable", 5, 0},
                          {"format_6", 6, 0},
                          {"format_7", 7, 2},
                          {"format_8_variable", 8, 0},
                          {"format_10", 10, 1}};

std::string
peerPath(const std::string& name)
{
  return std::string(LAZ_CORPUS) + "/" + name + ".laz";
}

std::string
peerBytes(const std::string& name)
{
  return test::bytesOf(peerPath(name));
}

std::string
recordsOf(const std::string& path)
{
  const auto file = openLas(path);
  std::string records(file.header.points * file.header.step, '\0');
  file.source->read(0, file.header.points, records.data());
  return records;
}

/** The LAS file with the header of a LAZ file and these records. */
std::string
lasFile(std::string header, const std::string& records)
{
  header.resize(header_size);
  header[104] = static_cast<char>(header[104] & 0x3f);
  const std::uint32_t begin = header_size, none = 0;
  std::memcpy(&header[96], &begin, sizeof(begin));
  std::memcpy(&header[100], &none, sizeof(none)); // records of variable length
  return header + records;
}

std::uint64_t
tablePlace(const std::string& bytes)
{
  std::uint32_t begin = 0;
  std::uint64_t place = 0;
  std::memcpy(&begin, &bytes[96], sizeof(begin));
  std::memcpy(&place, &bytes[begin], sizeof(place));
  return place;
}

class LazFiles : public test::FolderTest {
protected:
  /** What loadCloud() says of a file; both ways to read it must refuse it. */
  std::string
  refusal(const std::string& bytes)
  {
    const auto file = write("scan.laz", bytes);
    EXPECT_EQ(CloudStream::open(file), nullptr);
    try {
      loadCloud(file);
    } catch (const ToolError& error) {
      return std::string(error.what()).substr(file.size());
    }
    return "it was read";
  }
};

} // namespace

TEST_F(LazFiles, HoldTheRecordsThatTheyWereMadeOf)
{
  for (const auto& peer : peers)
    EXPECT_EQ(recordsOf(peerPath(peer.name)),
              test::LazPoints(peer.format, peer.extra_bytes).records(point_count))
        << peer.name;
}

TEST_F(LazFiles, AreReadFromAnyPointOn)
{
  std::mt19937 random(1);
  for (const auto& peer : peers) {
    const auto records = recordsOf(peerPath(peer.name));
    const auto file = openLas(peerPath(peer.name));
    const auto step = file.header.step;
    for (int part = 0; part < 100; ++part) {
      const auto first = random() % point_count;
      const auto count = 1 + random() % (point_count - first);
      std::string bytes(count * step, '\0');
      file.source->read(first, count, bytes.data());
      ASSERT_EQ(bytes, records.substr(first * step, count * step)) << peer.name;
    }
  }
}

TEST_F(LazFiles, AreTheCloudsOfTheirLasFiles)
{
  for (const auto& peer : peers) {
    const auto las =
        lasFile(peerBytes(peer.name),
                test::LazPoints(peer.format, peer.extra_bytes).records(point_count));
    const auto expected = loadCloud(write("scan.las", las));
    const auto file = loadCloud(peerPath(peer.name));
    EXPECT_EQ(file.cloud.data, expected.cloud.data) << peer.name;
    EXPECT_EQ(file.cloud.fields.size(), expected.cloud.fields.size());
    EXPECT_EQ(file.notes, expected.notes) << peer.name;
    const auto stream = CloudStream::open(peerPath(peer.name));
    ASSERT_TRUE(stream) << peer.name;
    EXPECT_EQ(stream->read(0, point_count).data, expected.cloud.data) << peer.name;
    EXPECT_EQ(stream->notes(), expected.notes);
  }
}

TEST_F(LazFiles, AreTheSameByAnyNumberOfThreads)
{
  for (const auto& peer : peers) {
    std::vector<std::string> records;
    for (const int threads : {1, 2, 8}) {
      setReaderThreads(threads);
      records.push_back(recordsOf(peerPath(peer.name)));
    }
    EXPECT_EQ(records[1], records[0]) << peer.name;
    EXPECT_EQ(records[2], records[0]) << peer.name;
  }
  setReaderThreads(0);
}

TEST_F(LazFiles, AreKnownByTheirContent)
{
  const auto bytes = peerBytes("format_7");
  for (const char* name : {"scan.laz", "scan.copc.laz", "scan.las", "scan.xyz", "scan"})
    EXPECT_EQ(loadCloud(write(name, bytes)).cloud.width, point_count + 0u) << name;
}

TEST_F(LazFiles, DamagedBytesAreNoPoints)
{
  // of 50 changes of a bit few are not noticed, as those of the first point, which is
  // not compressed, or of numbers whose bits are not modelled
  for (const auto& peer : peers) {
    if (std::string(peer.name) == "format_5_pointwise") // has no end to compare with
      continue;
    const auto bytes = peerBytes(peer.name);
    std::mt19937 random(1);
    int noticed = 0;
    for (int trial = 0; trial < 50; ++trial) {
      auto damaged = bytes;
      const auto begin = header_size + 200,
                 place = begin + random() % (bytes.size() - begin);
      damaged[place] = static_cast<char>(damaged[place] ^ 1 << random() % 8);
      try {
        recordsOf(write("scan.laz", damaged));
      } catch (const ToolError& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        ++noticed;
      }
    }
    EXPECT_GT(noticed, 25) << peer.name;
  }
}

TEST_F(LazFiles, DamagedFilesAreRefusedInOneLine)
{
  const auto refused = [&](const std::string& bytes, const std::string& what) {
    const auto text = refusal(bytes);
    EXPECT_NE(text.find(what), std::string::npos) << text;
  };
  const auto whole = peerBytes("format_3");
  for (const char* name : {"format_3", "format_8_variable", "format_1_streamed"}) {
    const auto bytes = peerBytes(name);
    refused(bytes.substr(0, bytes.size() - 1), "chunks");
    refused(bytes.substr(0, 1200), "no table of its chunks");
  }
  auto bytes = peerBytes("format_5_pointwise");
  refused(bytes.substr(0, bytes.size() - 9), "chunk 1 of 1: its bytes end before");
  bytes = whole;
  put<std::uint64_t>(bytes, 247, 151); // points, of which three chunks hold 150
  refused(bytes, "promises 151 points, it has 150");
  put<std::uint64_t>(bytes, 247, 149);
  refused(bytes, "chunk 3 of 3: its points do not end where it ends");
  bytes = whole;
  put<std::uint32_t>(bytes, tablePlace(whole) + 4, 0x7fffffff); // chunks
  refused(bytes, "table of the chunks of this LAZ file is damaged");
  put<std::uint32_t>(bytes, tablePlace(whole) + 4, 2);
  refused(bytes, "table of the chunks of this LAZ file is damaged");
  bytes = whole;
  put<std::uint32_t>(bytes, tablePlace(whole), 1); // version
  refused(bytes, "table of the chunks of this LAZ file is damaged");
  const std::size_t layout = header_size + 54;
  bytes = whole;
  put<std::uint16_t>(bytes, layout, 4);
  refused(bytes, "compressed in a way that is not known (compressor 4, coder 0)");
  bytes = whole;
  put<std::uint16_t>(bytes, layout + 34 + 4, 3);
  refused(bytes, "by a version of LASzip that is not known");
  put<std::uint16_t>(bytes, layout + 34, 3);
  refused(bytes, "not compressed as those of its point format");
  bytes = whole;
  put<std::uint16_t>(bytes, layout + 32, 300); // items
  refused(bytes, "tells how it is compressed is damaged");
  bytes = whole;
  bytes[header_size + 2] = 'x';
  refused(bytes, "does not tell how it is compressed");
}

TEST_F(LazFiles, LongPointsTakeNoMemoryBeforeTheyAreDecoded)
{
  constexpr std::size_t begin = 227, record = 54, layout = 34, items = 2 * 6;
  std::string bytes(begin + record + layout + items, '\0');
  std::memcpy(&bytes[0], "LASF", 4);
  bytes[24] = 1; // version 1.2
  bytes[25] = 2;
  put<std::uint16_t>(bytes, 94, begin);
  put<std::uint32_t>(bytes, 96, static_cast<std::uint32_t>(bytes.size()));
  put<std::uint32_t>(bytes, 100, 1); // records of variable length
  put<std::uint8_t>(bytes, 104, 0x80);
  put<std::uint16_t>(bytes, 105, 0xffff); // bytes of a point
  put<std::uint32_t>(bytes, 107, 40000);  // points
  for (std::size_t axis = 0; axis < 3; ++axis)
    put(bytes, 131 + 8 * axis, 0.001);
  std::memcpy(&bytes[begin + 2], "laszip encoded", 14);
  put<std::uint16_t>(bytes, begin + 18, 22204);
  put<std::uint16_t>(bytes, begin + 20, layout + items);
  const std::size_t about = begin + record;
  put<std::uint16_t>(bytes, about, 1); // all points are one chunk
  const std::uint16_t numbers[] = {2, 6, 20, 2, 0, 0xffff - 20, 2};
  std::memcpy(&bytes[about + 32], numbers, sizeof(numbers));
  const auto most = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss; // kB
  };
  const auto before = most();
  EXPECT_NE(refusal(bytes).find("chunk 1 of 1: its bytes end before"),
            std::string::npos);
  EXPECT_LT(most() - before, 1 << 20); // all of them are 2.6 GB
}

TEST_F(LazFiles, LayersLieAboutTheirSizes)
{
  const auto whole = peerBytes("format_6");
  std::uint32_t begin = 0;
  std::memcpy(&begin, &whole[96], sizeof(begin));
  const std::size_t chunk = begin + 8, sizes = chunk + 30 + 4;
  auto bytes = whole;
  put<std::uint32_t>(bytes, sizes + 4, 0xffffffff);
  EXPECT_NE(refusal(bytes).find("chunk 1 of 3: its bytes end before"),
            std::string::npos);
  bytes = whole;
  put<std::uint32_t>(bytes, sizes, 0);
  EXPECT_NE(refusal(bytes).find("chunk 1 of 3: "), std::string::npos);
  bytes = whole;
  put<std::uint32_t>(bytes, chunk + 30, 49); // points
  EXPECT_NE(refusal(bytes).find("chunk 1 of 3: it has fewer points"),
            std::string::npos);
}

TEST_F(LazFiles, PointsOfWholeChunksBeyondThePromisedOnesAreLeftOut)
{
  auto bytes = peerBytes("format_3");
  put<std::uint64_t>(bytes, 247, 100);
  const auto file = loadCloud(write("scan.laz", bytes));
  EXPECT_EQ(file.cloud.width, 100u);
  const std::vector<std::string> expected = {
      "points beyond the number that its header "
      "promises are left out: those of whole chunks"};
  EXPECT_EQ(std::vector<std::string>(file.notes.begin(), file.notes.begin() + 1),
            expected);
}
