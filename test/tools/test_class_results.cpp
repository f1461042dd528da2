/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Runs pcl_segment_collection and pcl_indoor_pipeline on the simulated flat and looks
// at the segments that are saved and at the classes that objects get.
#include "files/cloud_file.h"
#include "objects/object_files.h"
#include "pictures/svg_raster.h"
#include "support/folder_test.h"
#include "support/run_tool.h"

#include <pcl/conversions.h>
#include <pcl/ml/model_file.h>
#include <pcl/ml/network_designs.h>
#include <pcl/ml/object_classifier.h>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

using namespace pcl::indoor::tool;
namespace fs = std::filesystem;

namespace {

using pcl::indoor::test::bytesOf;

struct SimulatedFlat {
  static bool
  make(const std::string& folder)
  {
    return pcl::indoor::test::runTool("pcl_scan_simulation",
                                      PCL_INDOOR_PLANS "/flat.json " + folder +
                                          "/flat.pcd -json " + folder +
                                          "/flat.json -quiet") == 0;
  }
};

class ClassResults : public pcl::indoor::test::PreparedFolderTest<SimulatedFlat> {
protected:
  int
  run(const std::string& tool, const std::string& arguments) const
  {
    return pcl::indoor::test::runTool(tool, arguments + " -quiet", path("said"));
  }

  std::set<std::string>
  foldersOf(const std::string& folder) const
  {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(path(folder)))
      names.insert(entry.path().filename().string());
    return names;
  }

  /** A model that takes every object for what its biases say. */
  std::string
  saveModel(const std::vector<std::string>& classes, const std::vector<float>& biases)
  {
    pcl::indoor::ClassifierModel model;
    model.classes = classes;
    model.input.pair_count = 100;
    model.input.context = true;
    pcl::indoor::PerceptronOptions options;
    options.input_count = static_cast<int>(pcl::indoor::inputValueCount(model.input));
    options.hidden = {};
    auto network = pcl::indoor::perceptron(static_cast<int>(classes.size()), options);
    pcl::indoor::initializeWeights(network, 1);
    auto& weights = network.layers.back().weights[0].values;
    std::fill(weights.begin(), weights.end(), 0.0f);
    network.layers.back().weights[1].values = biases;
    model.networks = {network};
    saveText(path("constant.model"), pcl::indoor::modelBytes(model));
    return path("constant.model");
  }
};

} // namespace

TEST_F(ClassResults, SegmentsLieInTheFoldersOfTheirClasses)
{
  ASSERT_EQ(
      run("pcl_segment_collection",
          path("flat.pcd") + " " + path("segments") + " -names " + path("flat.json")),
      0)
      << bytesOf(path("said"));
  const auto folders = foldersOf("segments");
  for (const auto* name : {"floor", "ceiling", "wall", "door", "bed", "sofa"})
    EXPECT_EQ(folders.count(name), 1u) << name;
  for (const auto& entry : fs::directory_iterator(path("segments") + "/floor")) {
    const auto file = loadCloud(entry.path().string());
    EXPECT_TRUE(file.has_normals);
    const auto place = readPlace(file);
    EXPECT_TRUE(place.is_known);
    EXPECT_NEAR(place.floor_distance, 0.0f, 0.1f);
  }
}

TEST_F(ClassResults, ClassesGatherCategoriesAndTheRestIsOther)
{
  std::ofstream(path("classes.json")) << R"({"rest": ["bed", "sofa", "armchair"]})";
  const auto common = path("flat.pcd") + " " + path("objects") + " -names " +
                      path("flat.json") + " -classes " + path("classes.json") +
                      " -object_field object";
  ASSERT_EQ(run("pcl_segment_collection", common), 0) << bytesOf(path("said"));
  EXPECT_EQ(foldersOf("objects"), (std::set<std::string>{"other", "rest"}));
  const auto names = nlohmann::json::parse(bytesOf(path("flat.json")));
  std::size_t expected = 0;
  for (const auto& object : names["objects"])
    expected += std::set<std::string>{"bed", "sofa", "armchair"}.count(
        object["category"].get<std::string>());
  EXPECT_EQ(objectFilesIn(path("objects") + "/rest").size(), expected);

  fs::remove_all(path("objects"));
  ASSERT_EQ(run("pcl_segment_collection", common + " -max_other 2"), 0);
  EXPECT_EQ(objectFilesIn(path("objects") + "/other").size(), 2u);
}

TEST_F(ClassResults, WrongNamesAreRefused)
{
  std::ofstream(path("bad.json")) << R"({"a": ["bed"], "b": ["bed"]})";
  std::ofstream(path("no.json")) << "{";
  const auto common = path("flat.pcd") + " " + path("segments") + " -names ";
  EXPECT_NE(run("pcl_segment_collection",
                common + path("flat.json") + " -classes " + path("bad.json")),
            0);
  EXPECT_NE(bytesOf(path("said")).find("'bed' belongs to two classes"),
            std::string::npos);
  EXPECT_NE(run("pcl_segment_collection", common + path("no.json")), 0);
  EXPECT_NE(run("pcl_segment_collection", common + path("missing.json")), 0);
  EXPECT_FALSE(fs::exists(path("segments")));
}

TEST_F(ClassResults, PipelineWritesWhatTheModelSays)
{
  const auto model = saveModel({"lamp", "other", "thing"}, {0, 1, 3});
  ASSERT_EQ(run("pcl_indoor_pipeline",
                path("flat.pcd") + " " + path("out") + " -model " + model),
            0)
      << bytesOf(path("said"));
  const double sum = 1 + std::exp(1.0) + std::exp(3.0);
  const auto scene = nlohmann::json::parse(bytesOf(path("out") + "/scene.json"));
  EXPECT_EQ(scene["categories"], (nlohmann::json{"none", "lamp", "other", "thing"}));
  std::size_t described = 0;
  for (const auto& object : scene["objects"]) {
    if (object["structure"] != "none") { // floors, walls and ceilings have no class
      EXPECT_EQ(object["class"], "none");
      EXPECT_EQ(object["category"], 0);
      EXPECT_EQ(object["confidence"], 0.0);
      EXPECT_TRUE(object["top"].empty());
      continue;
    }
    const bool is_described = !object["top"].empty();
    described += is_described ? 1 : 0;
    EXPECT_EQ(object["class"], is_described ? "thing" : "other");
    EXPECT_EQ(object["category"], is_described ? 3 : 2);
    EXPECT_NEAR(object["confidence"].get<double>(),
                is_described ? std::exp(3.0) / sum : 0.0,
                1e-4);
    if (is_described) {
      EXPECT_EQ(object["top"].size(), 3u);
      EXPECT_EQ(object["top"][1]["class"], "other");
    }
  }
  EXPECT_GT(described, 10u);

  const auto cloud = loadCloud(path("out") + "/cloud.pcd");
  const auto objects = readLabels(cloud, "object");
  const auto categories = readLabels(cloud, "category");
  EXPECT_TRUE(hasField(cloud.cloud, "confidence"));
  for (std::size_t i = 0; i < objects.size(); ++i)
    ASSERT_EQ(categories[i],
              objects[i] == 0
                  ? 0u
                  : scene["objects"][objects[i] - 1]["category"].get<std::uint32_t>());
  EXPECT_EQ(fs::exists(path("out") + "/classes.png"), canRasterise());
}

TEST_F(ClassResults, BundledModelNamesTheFurniture)
{
  ASSERT_EQ(run("pcl_indoor_pipeline", path("flat.pcd") + " " + path("out")), 0)
      << bytesOf(path("said"));
  const auto scene = nlohmann::json::parse(bytesOf(path("out") + "/scene.json"));
  std::set<std::string> classes;
  for (const auto& object : scene["objects"])
    classes.insert(object["class"].get<std::string>());
  for (const auto* name : {"bed", "door", "sofa"})
    EXPECT_EQ(classes.count(name), 1u) << name;
}

TEST_F(ClassResults, WithoutAModelThereAreNoClasses)
{
  ASSERT_EQ(
      run("pcl_indoor_pipeline", path("flat.pcd") + " " + path("out") + " -model none"),
      0);
  const auto scene = nlohmann::json::parse(bytesOf(path("out") + "/scene.json"));
  EXPECT_FALSE(scene.contains("categories"));
  EXPECT_FALSE(scene["objects"][0].contains("class"));
  EXPECT_FALSE(hasField(loadCloud(path("out") + "/cloud.pcd").cloud, "confidence"));
  EXPECT_FALSE(fs::exists(path("out") + "/classes.png"));
}

TEST_F(ClassResults, ADamagedModelStopsThePipelineBeforeItsWork)
{
  auto bytes = bytesOf(saveModel({"a", "b"}, {0, 1}));
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  std::ofstream(path("damaged.model"), std::ios::binary) << bytes;
  EXPECT_NE(
      run("pcl_indoor_pipeline",
          path("flat.pcd") + " " + path("out") + " -model " + path("damaged.model")),
      0);
  EXPECT_FALSE(fs::exists(path("out")));
  const auto said = bytesOf(path("said"));
  EXPECT_NE(said.find("damaged.model"), std::string::npos) << said;
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
}
