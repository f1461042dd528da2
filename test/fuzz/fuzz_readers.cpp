/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// fuzz_readers CORPUS AMOUNT [SEED]: gives every reader the files of the corpus and
// changed ones; the amount is of seconds for all, or of files for each ("2000x").
// A reader may refuse a file by an exception of ours; anything else is a defect, and
// the file stays in the working folder as fuzz_input.*
// fuzz_readers CORPUS FILE: gives one file to the reader of its ending
#include "amount.h"
#include "command_line/options.h"
#include "files/cloud_file.h"
#include "files/mesh_file.h"
#include "files/ply_file.h"
#include "mutation.h"
#include "objects/category_names.h"
#include "support/folder_test.h" // for bytesOf

#include <pcl/console/print.h>
#include <pcl/exceptions.h>
#include <pcl/ml/model_file.h>
#include <pcl/segmentation/objects/boosted_trees.h>
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
using pcl::indoor::test::bytesOf;

namespace {

constexpr unsigned most_seconds = 20; // for one file; then the alarm ends the program

/** Something that reads files of one kind. */
struct Reader {
  std::string kind; ///< folder in the corpus and ending of its files
  std::function<void(const std::string& path)> read;
  std::function<void(std::string& bytes)> repair = [](std::string&) {};
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

void
readPlyFile(const std::string& path)
{
  tool::plyMesh(tool::loadCloud(path));
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

std::vector<Reader>
allReaders()
{
  return {{"pcd", [](const auto& path) { tool::loadCloud(path); }},
          {"ply", readPlyFile},
          {"off", [](const auto& path) { tool::readMesh(path); }},
          {"plan", readPlanFile},
          {"obj", [](const auto& path) { tool::readMesh(path); }},
          {"names", [](const auto& path) { tool::readCategoryNames(path); }},
          {"classes", [](const auto& path) { tool::readClassMap(path); }},
          {"model", [](const auto& path) { loadModel(path); }, repairModel},
          {"joining", readJoining}};
}

/** Whether the reader has taken the file; what it may refuse it by is caught. */
bool
isTaken(const Reader& reader, const std::string& path)
{
  alarm(most_seconds);
  try {
    reader.read(path);
    return true;
  } catch (const tool::ToolError&) {
  } catch (const pcl::PCLException&) {
  }
  return false;
}

/** Gives a reader changed files for some time; prints how it went. */
void
fuzzOne(const Reader& reader,
        const std::string& corpus,
        const Amount& amount,
        Random& random)
{
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(corpus + "/" + reader.kind))
    files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  std::vector<std::string> seeds;
  for (const auto& file : files) {
    seeds.push_back(bytesOf(file));
    if (!isTaken(reader, file))
      std::printf("%s: refused, although it is in the corpus\n", file.c_str());
  }
  const std::string path = "fuzz_input." + reader.kind;
  const auto now = std::chrono::steady_clock::now;
  const auto begin = now();
  std::chrono::duration<double> passed(0);
  std::size_t count = 0, taken = 0;
  for (; amount.wantsMore(count, passed.count()); ++count, passed = now() - begin) {
    const auto& seed = seeds[below(random, seeds.size())];
    auto bytes = mutated(seed, seeds[below(random, seeds.size())], random);
    reader.repair(bytes);
    std::ofstream(path, std::ios::binary) << bytes;
    taken += isTaken(reader, path);
  }
  alarm(0);
  fs::remove(path);
  std::printf("%-8s %8zu files, %6.0f per second, %5.1f %% taken\n",
              reader.kind.c_str(),
              count,
              static_cast<double>(count) / passed.count(),
              100.0 * static_cast<double>(taken) / static_cast<double>(count));
  std::fflush(stdout);
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc < 3) {
    std::printf("Syntax is: fuzz_readers CORPUS AMOUNT|FILE [SEED]\n");
    return 1;
  }
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  const std::string ending = fs::path(argv[2]).extension().string();
  auto readers = allReaders();
  if (fs::is_regular_file(argv[2])) {
    for (const auto& reader : readers)
      if (ending == "." + reader.kind)
        std::printf("%s\n", isTaken(reader, argv[2]) ? "taken" : "refused");
    return 0;
  }
  Random random(argc > 3 ? static_cast<unsigned>(std::stoul(argv[3])) : 1u);
  const auto amount = Amount::parse(argv[2], readers.size());
  for (const auto& reader : readers)
    fuzzOne(reader, argv[1], amount, random);
  return 0;
}
