/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Runs pcl_joining_examples on a simulated home and looks at the examples it saves, and
// pcl_noise_resilient_lccp at several levels.
#include "files/cloud_file.h"
#include "support/folder_test.h"
#include "support/run_tool.h"

#include <gtest/gtest.h>

#include <sys/wait.h> // for WIFEXITED

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

using namespace pcl::indoor::tool;
namespace fs = std::filesystem;

namespace {

using pcl::indoor::test::bytesOf;

constexpr std::size_t feature_count = 86;

/** A pair of pieces. */
struct Example {
  float is_one = 0;
  float weight = 0;
  std::array<float, feature_count> features;
};

struct SimulatedHome {
  static bool
  make(const std::string& folder)
  {
    return pcl::indoor::test::runTool(
               "pcl_scan_simulation",
               "random:home:8 " + folder + "/home.pcd -json " + folder +
                   "/home.json -rays_per_pose 20000 -leaf 0.03 -quiet") == 0;
  }
};

class JoiningResults : public pcl::indoor::test::PreparedFolderTest<SimulatedHome> {
protected:
  std::string
  scan() const
  {
    return path("home.pcd");
  }

  std::string
  names() const
  {
    return path("home.json");
  }

  int
  run(const std::string& input,
      const std::string& options,
      const std::string& tool = "pcl_joining_examples") const
  {
    const int status = pcl::indoor::test::runTool(
        tool, input + " " + path("out") + " " + options + " -quiet", path("said"));
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  /** The bytes that the tool saves; it must succeed and print nothing. */
  std::string
  saved(const std::string& options, const std::string& input = "home.pcd") const
  {
    fs::remove(path("out"));
    EXPECT_EQ(run(path(input), options), 0) << bytesOf(path("said"));
    EXPECT_EQ(bytesOf(path("said")), "");
    EXPECT_TRUE(fs::exists(path("out")));
    return bytesOf(path("out"));
  }

  /** The tool must stop with one line that holds the text, and save nothing. */
  void
  expectRefusal(const std::string& options,
                const std::string& text,
                const std::string& input = "home.pcd") const
  {
    EXPECT_EQ(run(path(input), options), 1) << options;
    const auto said = bytesOf(path("said"));
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    EXPECT_NE(said.find(text), std::string::npos) << said;
    EXPECT_EQ(said.find(".h"), std::string::npos) << said; // no place in the source
    EXPECT_EQ(said.find(".cpp"), std::string::npos) << said;
    EXPECT_FALSE(fs::exists(path("out")));
  }

  std::vector<Example>
  examples(const std::string& options) const
  {
    static_assert(sizeof(Example) == (2 + feature_count) * sizeof(float));
    const auto bytes = saved(options);
    EXPECT_EQ(bytes.size() % sizeof(Example), 0u);
    std::vector<Example> result(bytes.size() / sizeof(Example));
    if (!result.empty())
      std::memcpy(result.data(), bytes.data(), result.size() * sizeof(Example));
    return result;
  }

  /** One tree that always says the same. */
  std::string
  saveTrees(const std::string& name, std::size_t features, double log_odds) const
  {
    std::ofstream(path(name)) << "trees " << features << " 0 1\n1\n0 0 " << log_odds;
    return path(name);
  }
};

/** How many of the pairs are one object; expects every example to be sound. */
std::size_t
soundOnes(const std::vector<Example>& examples)
{
  std::size_t ones = 0;
  for (const auto& example : examples) {
    EXPECT_TRUE(example.is_one == 0 || example.is_one == 1) << example.is_one;
    EXPECT_TRUE(std::isfinite(example.weight) && example.weight > 0) << example.weight;
    for (std::size_t f = 0; f < feature_count; ++f)
      EXPECT_TRUE(std::isfinite(example.features[f])) << f;
    ones += example.is_one == 1;
  }
  return ones;
}

} // namespace

TEST_F(JoiningResults, ExamplesAreSound)
{
  const auto all = examples("-share 1 -votes");
  ASSERT_GT(all.size(), 200u);
  const auto ones = soundOnes(all);
  EXPECT_GT(ones, 50u);
  EXPECT_LT(ones, all.size() - 50);
  for (std::size_t f = 0; f < feature_count; ++f) {
    const auto has_first = [&](const Example& example) {
      return example.features[f] == all.front().features[f];
    };
    EXPECT_FALSE(std::all_of(all.begin(), all.end(), has_first))
        << "feature " << f << " says nothing";
  }
}

TEST_F(JoiningResults, AnOrganisedScanIsOneView)
{
  ASSERT_EQ(pcl::indoor::test::runTool("pcl_scan_simulation",
                                       "random:table:7 " + path("table.pcd") +
                                           " -view 0.6,0.5,1.5 -quiet"),
            0);
  const auto bytes = saved("-share 1 -room_field none", "table.pcd");
  ASSERT_EQ(bytes.size() % sizeof(Example), 0u);
  std::vector<Example> all(bytes.size() / sizeof(Example));
  ASSERT_GT(all.size(), 20u);
  std::memcpy(all.data(), bytes.data(), bytes.size());
  const auto ones = soundOnes(all);
  EXPECT_GT(ones, 5u);
  EXPECT_LT(ones, all.size() - 5);
  fs::remove(path("out"));
  expectRefusal("-room_field none", "none"); // the home is no view
}

TEST_F(JoiningResults, SameCallGivesTheSameAndAnotherSeedDoesNot)
{
  const auto bytes = saved("-seed 3");
  EXPECT_FALSE(bytes.empty());
  EXPECT_EQ(saved("-seed 3"), bytes);
  EXPECT_NE(saved("-seed 4"), bytes);
}

TEST_F(JoiningResults, ShareSaysHowManyAreSaved)
{
  const auto model = " -model " + saveTrees("half.txt", feature_count, 0.0);
  const auto all = static_cast<double>(examples("-share 1" + model).size());
  EXPECT_NEAR(
      static_cast<double>(examples("-share 0.3" + model).size()) / all, 0.3, 0.06);
  EXPECT_LT(examples("-share 0.3").size(), examples("-share 1").size());
  EXPECT_EQ(saved("-share 0"), "");
}

TEST_F(JoiningResults, TreesDecideWhatIsJoined)
{
  // all that touch are joined, against none: then no pair is judged again
  const auto joined =
      examples("-share 1 -model " + saveTrees("yes.txt", feature_count, 2.0));
  const auto apart =
      examples("-share 1 -model " + saveTrees("no.txt", feature_count, -9.0));
  soundOnes(joined);
  EXPECT_GT(apart.size(), 100u);
  EXPECT_GT(joined.size(), apart.size());
}

TEST_F(JoiningResults, PartsOfChosenCategoriesCountAsObjects)
{
  const auto whole = examples("-share 1");
  const auto parts =
      examples("-share 1 -part_categories chair,sofa,armchair -names " + names());
  EXPECT_LT(soundOnes(parts), soundOnes(whole));
  EXPECT_GT(soundOnes(parts), 0u);
}

TEST_F(JoiningResults, VotesAreAskedForIfWanted)
{
  constexpr std::size_t likeness = 74; // the first of those on votes
  for (const bool asked : {false, true}) {
    const auto pairs = examples(asked ? "-votes" : "");
    ASSERT_FALSE(pairs.empty());
    EXPECT_EQ(
        std::any_of(pairs.begin(),
                    pairs.end(),
                    [](const Example& pair) { return pair.features[likeness] > 0.0f; }),
        asked);
  }
}

TEST_F(JoiningResults, ObjectsAreSavedWithTheirFits)
{
  constexpr std::size_t row = 2 + 30;
  const auto bytes =
      saved("-objects -model " + saveTrees("yes.txt", feature_count, 2.0));
  ASSERT_EQ(bytes.size() % (row * sizeof(float)), 0u);
  std::vector<float> values(bytes.size() / sizeof(float));
  std::memcpy(values.data(), bytes.data(), bytes.size());
  std::size_t objects = 0, whole = 0;
  for (std::size_t at = 0; at < values.size(); at += row) {
    const bool is_object = values[at] == 1;
    ASSERT_TRUE(is_object || values[at] == 0);
    ASSERT_GT(values[at + 1], 0);
    ASSERT_LE(values[at + 1], 1);
    for (std::size_t i = at + 2; i < at + row; ++i)
      ASSERT_TRUE(std::isfinite(values[i]));
    objects += is_object;
    whole += is_object && values[at + 1] > 0.8f;
    if (!is_object || values[at + 1] == 1)
      continue;
    EXPECT_GT(values[at + 1], 0.5f) << "what fits less is no object";
    ASSERT_LT(at + row, values.size());
    EXPECT_EQ(values[at + row], 0) << "the rest of it";
    EXPECT_NEAR(values[at + row + 1], 1 - values[at + 1], 1e-6);
  }
  EXPECT_GT(objects, 20u);
  EXPECT_GT(whole, 5u);
}

TEST_F(JoiningResults, WrongOptionsAreRefused)
{
  expectRefusal("-objects", "-objects needs -model");
  expectRefusal("-part_categories chair", "-part_categories needs -names");
  expectRefusal("-part_categories chair -names " + path("missing.json"),
                "missing.json: cannot be opened");
  expectRefusal("-part_categories chair,chiar -names " + names(),
                "-part_categories: 'chiar' is not in ");
  expectRefusal("-room_field r", "no field 'r'");
  expectRefusal("-object_field o", "no field 'o'");
  const auto parts = "-part_categories chair -names " + names();
  expectRefusal(parts + " -part_field p", "no field 'p'");
  expectRefusal(parts + " -category_field c", "no field 'c'");
  expectRefusal("-share 1.5", "-share: ");
}

TEST_F(JoiningResults, WrongTreesAreRefused)
{
  std::ofstream(path("text.txt")) << "Dear reader,";
  std::ofstream(path("cut.txt")) << "trees 66 0 2\n1\n0 0 1\n";
  saveTrees("few.txt", 5, 1.0);
  expectRefusal("-model " + path("missing.txt"), "missing.txt: cannot be opened");
  expectRefusal("-model " + path("text.txt"), "text.txt: Boosted trees: no header");
  expectRefusal("-model " + path("cut.txt"), "cut.txt: Boosted trees: no tree");
  expectRefusal("-model " + path("few.txt"), "few.txt: The trees are for 5 features");
}

TEST_F(JoiningResults, RoomsWithoutFinitePointsHaveNoExamples)
{
  auto file = loadCloud(scan());
  auto rooms = readLabels(file, "room");
  const auto expected = saved("");
  // points beyond all others, in a room of their own and nowhere
  const auto count = rooms.size();
  const auto step = file.cloud.point_step;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (int i = 0; i < 20; ++i) {
    file.cloud.data.insert(
        file.cloud.data.end(), file.cloud.data.begin(), file.cloud.data.begin() + step);
    for (int axis = 0; axis < 3; ++axis)
      std::memcpy(&file.cloud.data[(count + i) * step + file.cloud.fields[axis].offset],
                  &nan,
                  sizeof(nan));
    rooms.push_back(1000);
  }
  file.cloud.width = static_cast<std::uint32_t>(rooms.size());
  file.cloud.height = 1;
  file.cloud.row_step = file.cloud.width * step;
  appendField(file.cloud, "room", rooms);
  saveCloud(path("more.pcd"), file.cloud);
  EXPECT_EQ(saved("", "more.pcd"), expected);
  std::fill(rooms.begin(), rooms.end(), 0);
  appendField(file.cloud, "room", rooms);
  saveCloud(path("none.pcd"), file.cloud);
  fs::remove(path("out"));
  expectRefusal("", "no finite point has a room in the field room", "none.pcd");
}

TEST_F(JoiningResults, SegmentationJoinsLessAtHigherLevels)
{
  const auto count = [&](const std::string& options) {
    EXPECT_EQ(run(scan(), options, "pcl_noise_resilient_lccp"), 0) << options;
    const auto objects = readLabels(loadCloud(path("out")), "object");
    EXPECT_EQ(std::count(objects.begin(), objects.end(), 0u), 0) << options;
    return *std::max_element(objects.begin(), objects.end());
  };
  const auto fewest = count("-level 0.2"), middle = count("");
  const auto most = count("-level 1");
  EXPECT_LT(fewest, middle);
  EXPECT_LT(middle, most);
  EXPECT_EQ(count("-level -1"), middle); // the default
  count("-preset parts");
}
