/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// fuzz_readers CORPUS AMOUNT [SEED [READER]]
//
// Gives every reader the files of the corpus and changed ones. The amount is of seconds
// for all readers, or of files for each ("2000x"). A reader may refuse a file by an
// exception of ours; anything else is a defect, and the file stays in the working
// folder as fuzz_input.*
//
// fuzz_readers CORPUS FILE
//
// Gives one file to the reader of its ending.
#include "amount.h"
#include "cloud_parts.h"
#include "command_line/options.h"
#include "dataset_files.h"
#include "files/cloud_file.h"
#include "files/cloud_formats.h"
#include "files/sampled_surface.h"
#include "formats/mesh_file.h"
#include "formats/ply/ply_file.h"
#include "mutation.h"
#include "objects/join/boosted_trees.h"
#include "scene/category_names.h"
#include "support/e57_writer.h"
#include "support/folder_test.h" // for bytesOf
#include "work_files.h"

#include <pcl/console/print.h>
#include <pcl/exceptions.h>
#include <pcl/ml/model_file.h>
#include <pcl/ml/voxel_network.h>
#include <pcl/simulation/building.h>
#include <pcl/simulation/plan.h>

#include <boost/crc.hpp>

#include <unistd.h> // for alarm

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <new>
#include <sstream>

using namespace pcl::indoor;
using namespace pcl::indoor::fuzz;
namespace fs = std::filesystem;

namespace {

constexpr unsigned most_seconds = 10; // for one file; then the alarm ends the program

/** Something that reads files of one kind. */
struct Reader {
  std::string kind; ///< folder in the corpus and ending of its files
  std::function<void(const std::string& path)> read;
  std::function<void(std::string& bytes)> repair = [](std::string&) {};
  std::vector<std::string> made = {}; ///< files in place of the folder in the corpus
};

void
readJoining(const std::string& path)
{
  std::ifstream stream(path);
  const auto trees = BoostedTrees::read(stream);
  const std::vector<float> features(trees.featureCount(), 0.5f);
  static_cast<void>(trees.probability(features.data()));
}

void
readPlanFile(const std::string& path)
{
  static_cast<void>(buildBuilding(readPlan(path), path));
}

/** All that tools take from a cloud. What was taken must be the same in parts, and
 * after it was written and read again. */
void
readCloud(const std::string& path)
{
  static_cast<void>(tool::promisedPoints(path));
  const auto stream = tool::CloudStream::open(path);
  if (stream)
    static_cast<void>(bytesOf(*stream)); // also of a file that is refused
  auto file = tool::loadCloud(path);
  if (stream)
    requireTheSame(*stream, file);
  if (file.has_normals)
    tool::readNormals(file);
  if (tool::hasField(file.cloud, "label")) {
    const auto labels = tool::readLabels(file, "label");
    tool::appendField(file.cloud, "label", labels);
    tool::appendRealField(file.cloud, "other", {labels.begin(), labels.end()});
  }
  const std::string again = "fuzz_again.pcd";
  tool::saveCloud(again, file.cloud, file.pose);
  const auto other = tool::loadCloud(again);
  if (other.finite_count != file.finite_count || other.offset != file.offset)
    throw std::logic_error("a cloud is not what it was written as");
  fs::remove(again);
}

/** Points are drawn on the faces of one in so many files: it takes as long as reading a
 * hundred of them. */
void
readPlyFile(const std::string& path)
{
  constexpr unsigned drawn = 16;
  static unsigned count = 0;
  readCloud(path);
  if (count++ % drawn == 0)
    tool::loadSurface(path);
}

/** What was taken must be the same after it was written and read again. */
void
readModelFile(const std::string& path)
{
  const auto bytes = modelBytes(loadModel(path), false);
  if (modelBytes(modelFromBytes(bytes), false) != bytes)
    throw std::logic_error("a model is not what it was written as");
}

/** Checksums that fit, so that what they protect is reached, too. */
void
repairModel(std::string& bytes)
{
  const auto first = bytes.find('\n');
  const auto second = first == bytes.npos ? bytes.npos : bytes.find('\n', first + 1);
  if (second == bytes.npos || bytes.size() < second + 9)
    return;
  const std::size_t weights = second + 1, end = bytes.size() - 8;
  const auto put = [&bytes](std::size_t at, std::size_t from, std::size_t to) {
    boost::crc_32_type crc;
    crc.process_bytes(&bytes[from], to - from);
    for (unsigned k = 0; k < 4; ++k)
      bytes[at + k] = static_cast<char>(crc.checksum() >> 8 * k);
  };
  put(end, 0, weights);
  put(end + 4, weights, end);
}

/** The checksum at the end fits. */
void
repairNetwork(std::string& bytes)
{
  if (bytes.size() < 4)
    return;
  const std::size_t end = bytes.size() - 4;
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), end);
  for (unsigned k = 0; k < 4; ++k)
    bytes[end + k] = static_cast<char>(crc.checksum() >> 8 * k);
}

std::vector<Reader>
allReaders()
{
  const auto pngs = wholePngs();
  return {
      {"pcd", readCloud},
      {"ply", readPlyFile},
      {"off", [](const auto& path) { tool::readMesh(path); }},
      {"plan", readPlanFile},
      {"obj", [](const auto& path) { tool::readMesh(path); }},
      {"stl", [](const auto& path) { tool::readMesh(path); }},
      {"glb", [](const auto& path) { tool::readMesh(path); }},
      {"names", [](const auto& path) { tool::readCategoryNames(path); }},
      {"classes", [](const auto& path) { tool::readClassMap(path); }},
      {"model", readModelFile, repairModel},
      {"network",
       [](const auto& path) {
         classifyVoxels({{0, 0, 0}}, loadVoxelNetwork(path));
       },
       repairNetwork},
      {"joining", readJoining},
      {"las", readCloud},
      {"laz", readCloud},
      {"e57", readCloud, test::E57Writer::sign},
      {"ptx", readCloud},
      {"xyz", readCloud},
      {"zip", readCloud},
      {"gz", readCloud},
      {"work", readWorkFile, [](std::string&) {}, wholeWorkFiles()},
      {"record", readRecord, repairWorkFile, wholeWorkFiles()},
      {"colors", [](const auto& path) { tool::readColorPng(path); }, repairPng, pngs},
      {"numbers",
       [](const auto& path) { tool::readNumberPng(path); },
       repairPng,
       {pngs.begin(), pngs.end() - 1}},
      {"segs", readSegments, [](std::string&) {}, {scan_segments}},
      {"groups", readGroups, [](std::string&) {}, {scan_groups}},
      {"depths", readDepths, repairPng, {pngs[1]}},
      {"camera", readCamera, [](std::string&) {}, {camera_matrix}}};
}

/** Why the reader refuses a file; empty if it takes it. What it may refuse it by is
 * caught. */
std::string
refusal(const Reader& reader, const std::string& path)
{
  alarm(most_seconds);
  try {
    reader.read(path);
    return "";
  } catch (const tool::ToolError& error) {
    return error.what();
  } catch (const pcl::PCLException& error) {
    return error.what();
  }
}

/** How a reader went. */
struct Tally {
  std::size_t files = 0, taken = 0;
  double seconds = 0;

  void
  print(const std::string& name) const
  {
    const auto share = [this](double part, double whole) {
      return files == 0 ? 0.0 : part / whole;
    };
    std::printf("%-8s %10zu %10.1f %10.0f %9.1f %%\n",
                name.c_str(),
                files,
                seconds,
                share(static_cast<double>(files), seconds),
                100 * share(static_cast<double>(taken), static_cast<double>(files)));
    std::fflush(stdout);
  }
};

/** The files of a reader, in the order of their names. */
std::vector<std::string>
corpusFiles(const Reader& reader, const std::string& corpus)
{
  std::vector<std::string> paths, files;
  for (const auto& entry : fs::directory_iterator(corpus + "/" + reader.kind))
    paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  for (const auto& path : paths)
    files.push_back(test::bytesOf(path));
  return files;
}

/** Gives a reader changed files for some time. */
Tally
fuzzOne(const Reader& reader,
        const std::string& corpus,
        const Amount& amount,
        Random& random)
{
  const auto seeds = reader.made.empty() ? corpusFiles(reader, corpus) : reader.made;
  const std::string path = "fuzz_input." + reader.kind;
  for (const auto& seed : seeds) {
    std::ofstream(path, std::ios::binary) << seed;
    if (const auto reason = refusal(reader, path); !reason.empty())
      std::printf("refused, although it is in the corpus: %s\n", reason.c_str());
  }
  const auto now = std::chrono::steady_clock::now;
  const auto begin = now();
  std::chrono::duration<double> passed(0);
  Tally tally;
  for (; amount.wantsMore(tally.files, passed.count());
       ++tally.files, passed = now() - begin) {
    const auto& seed = seeds[below(random, seeds.size())];
    auto bytes = mutated(seed, seeds[below(random, seeds.size())], random);
    reader.repair(bytes);
    std::ofstream(path, std::ios::binary) << bytes;
    tally.taken += refusal(reader, path).empty();
  }
  alarm(0);
  fs::remove(path);
  tally.seconds = passed.count();
  return tally;
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc < 3) {
    std::printf("Syntax is: fuzz_readers CORPUS AMOUNT|FILE [SEED [READER]]\n");
    return 1;
  }
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  const std::string ending = fs::path(argv[2]).extension().string();
  auto readers = allReaders();
  if (fs::is_regular_file(argv[2])) {
    for (const auto& reader : readers)
      if (ending == "." + reader.kind)
        std::printf("refused because: %s\n", refusal(reader, argv[2]).c_str());
    return 0;
  }
  Random random(argc > 3 ? static_cast<unsigned>(std::stoul(argv[3])) : 1u);
  const auto amount = Amount::parse(argv[2], readers.size());
  std::printf("%-8s %10s %10s %10s %11s\n",
              "reader",
              "files",
              "seconds",
              "per second",
              "taken");
  Tally all;
  for (const auto& reader : readers) {
    if (argc > 4 && reader.kind != argv[4])
      continue;
    const auto tally = fuzzOne(reader, argv[1], amount, random);
    tally.print(reader.kind);
    all.files += tally.files;
    all.taken += tally.taken;
    all.seconds += tally.seconds;
  }
  all.print("all");
  return 0;
}
