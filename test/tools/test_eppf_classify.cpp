/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Runs pcl_eppf_classify, found by PCL_INDOOR_TOOLS, and looks at what it says.
#include "support/folder_test.h"
#include "support/run_tool.h"

#include <pcl/io/pcd_io.h>
#include <pcl/ml/model_file.h>
#include <pcl/ml/network_designs.h>
#include <pcl/ml/object_classifier.h>
#include <pcl/ml/point_nn.h>
#include <pcl/point_types.h>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

using namespace pcl::indoor;

namespace {

using pcl::indoor::test::bytesOf;

/** Points of a ball, or of a long box. */
pcl::PointCloud<pcl::PointXYZ>
objectOf(bool is_ball, std::uint32_t seed)
{
  std::mt19937 random(seed);
  const auto number = [&random] {
    return static_cast<float>(random() % 2001) / 1000.0f - 1.0f;
  };
  pcl::PointCloud<pcl::PointXYZ> cloud;
  while (cloud.size() < 400) {
    Eigen::Vector3f place(number(), number(), number());
    if (is_ball)
      place = place.normalized();
    else {
      place[static_cast<Eigen::Index>(random() % 3)] = random() % 2 == 0 ? 1.0f : -1.0f;
      place = place.cwiseProduct(Eigen::Vector3f(4.0f, 1.0f, 0.5f));
    }
    if (place.allFinite())
      cloud.push_back({place.x(), place.y(), place.z()});
  }
  return cloud;
}

/** A folder with objects/ball and objects/beam, three files each, and a model. */
class EppfClassify : public pcl::indoor::test::FolderTest {
protected:
  void
  SetUp() override
  {
    FolderTest::SetUp();
    for (const std::string name : {"ball", "beam"}) {
      std::filesystem::create_directories(path("objects/" + name));
      for (std::uint32_t k = 0; k < 3; ++k)
        pcl::io::savePCDFileBinary(path("objects/" + name + "/" + std::to_string(k)) +
                                       ".pcd",
                                   objectOf(name == "ball", k));
    }
    std::ofstream(path("model"), std::ios::binary) << modelBytes(knownModel());
  }

  /** A network that knows of nothing but "vase", with probabilities that are known. */
  static ClassifierModel
  knownModel()
  {
    ClassifierModel model;
    model.classes = {"ball", "beam", "vase", "cup"};
    model.input.pair_count = 500;
    model.networks = {
        perceptron(4, {static_cast<int>(inputValueCount(model.input)), {}, 0.0f})};
    initializeWeights(model.networks[0], 1);
    auto& last = model.networks[0].layers.back();
    std::fill(last.weights[0].values.begin(), last.weights[0].values.end(), 0.0f);
    last.weights[1].values = {std::log(0.2f), std::log(0.1f), std::log(0.6f), -80.0f};
    return model;
  }

  int
  run(const std::string& arguments) const
  {
    return pcl::indoor::test::runTool(
        "pcl_eppf_classify", arguments, path("said"), path("complaint"));
  }

  nlohmann::json
  json() const
  {
    return nlohmann::json::parse(bytesOf(path("result.json")));
  }

  void
  expectComplaint(const std::string& arguments, const std::string& part) const
  {
    const int status = run(arguments);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1) << arguments;
    const auto complaint = bytesOf(path("complaint"));
    EXPECT_NE(complaint.find(part), std::string::npos) << complaint;
    EXPECT_EQ(std::count(complaint.begin(), complaint.end(), '\n'), 1) << complaint;
    EXPECT_EQ(bytesOf(path("said")), "");
  }
};

TEST_F(EppfClassify, SaysWhatTheModelSays)
{
  const auto file = path("objects/ball/1.pcd");
  ASSERT_EQ(run(path("model") + " " + file + " -json " + path("result.json")), 0);
  const auto list = json();
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0]["file"], file);
  EXPECT_EQ(list[0]["class"], "vase");
  EXPECT_NEAR(list[0]["confidence"].get<double>(), 0.6667, 1e-4);
  ASSERT_EQ(list[0]["top"].size(), 3u);
  EXPECT_EQ(list[0]["top"][1]["class"], "ball");
  EXPECT_NEAR(list[0]["top"][1]["confidence"].get<double>(), 0.2222, 1e-4);
  EXPECT_EQ(list[0]["top"][2]["class"], "beam");
  EXPECT_FALSE(list[0].contains("true_class"));
  const auto said = bytesOf(path("said"));
  EXPECT_NE(said.find("vase   66.7 %      ball 22.2 %, beam 11.1 %"), std::string::npos)
      << said;
  EXPECT_EQ(said.find("of known class"), std::string::npos) << said;
}

TEST_F(EppfClassify, OfClassFoldersShowsTheAccuracy)
{
  ASSERT_EQ(run(path("model") + " " + path("objects")), 0);
  const auto said = bytesOf(path("said"));
  EXPECT_NE(said.find("6 objects of known class: 0.0 % right"), std::string::npos)
      << said;
}

TEST_F(EppfClassify, NearestLeavesAFileItselfOut)
{
  const auto arguments = "-nearest " + path("objects") + " " + path("objects") +
                         " -json " + path("result.json");
  ASSERT_EQ(run(arguments + " -threads 1"), 0);
  EXPECT_NE(bytesOf(path("said")).find("6 objects of known class: 100.0 % right"),
            std::string::npos)
      << bytesOf(path("said"));
  const auto list = json();
  ASSERT_EQ(list.size(), 6u);
  for (const auto& object : list) {
    EXPECT_EQ(object["class"], object["true_class"]);
    EXPECT_GT(object["confidence"], 0.5);
    EXPECT_LT(object["confidence"], 1.0); // 1 if it were compared with itself
    ASSERT_EQ(object["top"].size(), 2u);
    EXPECT_EQ(object["top"][0]["confidence"], object["confidence"]);
  }
  ASSERT_EQ(run(arguments + " -threads 3 -quiet"), 0);
  EXPECT_EQ(json(), list);
}

TEST_F(EppfClassify, NearestByPointNNSaysWhatThePointsSay)
{
  ASSERT_EQ(run("-nearest " + path("objects") + " -descriptor point_nn " +
                path("objects") + " -json " + path("result.json")),
            0);
  std::vector<std::vector<float>> descriptors;
  std::vector<int> labels;
  for (const bool is_ball : {true, false})
    for (std::uint32_t k = 0; k < 3; ++k) {
      std::vector<Eigen::Vector3f> points;
      for (const auto& point : objectOf(is_ball, k))
        points.push_back(point.getVector3fMap());
      descriptors.push_back(pointNNDescriptor(points));
      labels.push_back(is_ball ? 0 : 1);
    }
  const auto list = json();
  ASSERT_EQ(list.size(), 6u);
  for (std::size_t k = 0; k < 6; ++k) {
    PointNNMemory others{descriptors, labels};
    const auto place = static_cast<std::ptrdiff_t>(k);
    others.descriptors.erase(others.descriptors.begin() + place);
    others.labels.erase(others.labels.begin() + place);
    const auto scores = pointNNScores(descriptors[k], others, 2);
    const auto best = static_cast<std::size_t>(scores[1] > scores[0]);
    EXPECT_EQ(list[k]["class"], best == 0 ? "ball" : "beam");
    EXPECT_NEAR(list[k]["confidence"].get<double>(), scores[best], 1e-4);
  }
}

TEST_F(EppfClassify, WhatCannotBeDescribedHasNoClass)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  cloud.resize(30, {1.0f, 2.0f, 3.0f});
  pcl::io::savePCDFileASCII(path("place.pcd"), cloud);
  ASSERT_EQ(
      run(path("model") + " " + path("place.pcd") + " -json " + path("result.json")),
      0);
  const auto list = json();
  ASSERT_EQ(list.size(), 1u);
  EXPECT_TRUE(list[0]["class"].is_null());
  EXPECT_EQ(list[0]["confidence"], 0.0);
  EXPECT_TRUE(list[0]["top"].empty());
}

TEST_F(EppfClassify, RefusesDamagedModelsAndMissingArguments)
{
  auto bytes = bytesOf(path("model"));
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  std::ofstream(path("damaged"), std::ios::binary) << bytes;
  const auto object = " " + path("objects/ball/0.pcd");
  expectComplaint("-descriptor point_nn " + path("model") + " " + path("objects"),
                  "goes with -nearest only");
  expectComplaint(path("damaged") + object, "damaged: is a damaged model");
  expectComplaint(path("objects/ball/1.pcd") + object, "is no model");
  expectComplaint(path("none") + object, "none: no such file");
  expectComplaint(path("model"), "at least one object");
  expectComplaint(path("model") + " " + path("said"), "said: ");
  expectComplaint("-nearest " + path("objects/ball") + object, "names its class");
  expectComplaint("-nearest " + path("none") + object, "none: no such folder");
}

} // namespace
