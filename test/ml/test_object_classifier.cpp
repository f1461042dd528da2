/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/exceptions.h>
#include <pcl/features/eppf_histogram.h>
#include <pcl/ml/network_designs.h>
#include <pcl/ml/network_inference.h>
#include <pcl/ml/object_classifier.h>
#include <pcl/ml/upright_profile.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <set>

namespace pcl::indoor {
namespace {

/** Points of an ellipsoid with their normals. */
std::vector<OrientedPoint>
ellipsoid(const Eigen::Vector3f& radii, std::size_t count, std::uint32_t seed)
{
  std::mt19937 random(seed);
  const auto number = [&random] {
    return static_cast<float>(random() % 2001) / 1000.0f - 1.0f;
  };
  std::vector<OrientedPoint> points;
  while (points.size() < count) {
    const Eigen::Vector3f place(number(), number(), number());
    if (place.norm() > 1.0f || place.norm() < 0.1f)
      continue;
    const Eigen::Vector3f unit = place.normalized();
    points.push_back(
        {unit.cwiseProduct(radii), unit.cwiseQuotient(radii).normalized()});
  }
  return points;
}

std::vector<ClassifierObject>
someObjects()
{
  std::vector<ClassifierObject> objects;
  for (std::uint32_t k = 0; k < 21; ++k)
    objects.push_back(
        {ellipsoid({1.0f, 0.2f + 0.1f * k, 0.5f}, 200, k), {k % 2 == 0, 0.1f * k}});
  return objects;
}

ClassifierModel
someModel(ClassifierInputKind kind, std::size_t network_count, int draws)
{
  ClassifierModel model;
  model.classes = {"a", "b", "c"};
  model.input.kind = kind;
  model.input.pair_count = 500;
  model.input.draws = draws;
  model.input.point_count = 64;
  model.input.context = kind != ClassifierInputKind::Points;
  const auto count = static_cast<int>(inputValueCount(model.input));
  for (std::size_t k = 0; k < network_count; ++k) {
    model.networks.push_back(perceptron(3, {count, {8}, 0.5f}));
    initializeWeights(model.networks.back(), static_cast<std::uint32_t>(k));
    for (float& value : model.networks.back().layers[1].weights[0].values)
      value = 20.0f;
  }
  return model;
}

std::vector<double>
softmax(const std::vector<float>& scores)
{
  std::vector<double> values(scores.begin(), scores.end());
  for (double& value : values)
    value = std::exp(value);
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  for (double& value : values)
    value /= sum;
  return values;
}

TEST(ClassifierInputValues, AreTheDescriptorAndTheContext)
{
  const auto object = someObjects()[4];
  ClassifierInput input;
  input.pair_count = 700;
  input.scale = 3.0;
  for (const auto kind : {ClassifierInputKind::PairHarmonics,
                          ClassifierInputKind::EPPF,
                          ClassifierInputKind::EPPFShort}) {
    input.kind = kind;
    input.context = false;
    const auto bins = classifierInput(object.points, object.place, input, 5);
    ASSERT_EQ(bins.size(), kind == ClassifierInputKind::EPPFShort ? 540u : 1200u);
    EXPECT_EQ(bins.size(), inputValueCount(input));
    auto options = kind == ClassifierInputKind::PairHarmonics ? pairHarmonicsOptions()
                   : kind == ClassifierInputKind::EPPF        ? thesisEPPFOptions()
                                                              : shortEPPFOptions();
    options.pair_count = 700;
    options.scale = 3.0;
    options.seed = 5;
    EXPECT_EQ(bins, eppfHistogram(object.points, options));
    EXPECT_NE(bins, classifierInput(object.points, object.place, input, 6));
    input.context = true;
    auto both = classifierInput(object.points, object.place, input, 5);
    EXPECT_EQ(both.size(), inputValueCount(input));
    auto expected = bins;
    const auto context = contextValues(object.points, object.place);
    expected.insert(expected.end(), context.begin(), context.end());
    const auto profile = uprightProfile(
        object.points, object.place.is_known ? object.place.floor_distance : 0.0f);
    expected.insert(expected.end(), profile.begin(), profile.end());
    EXPECT_EQ(both, expected);
  }
}

TEST(ClassifierInputValues, PointsAreInTheUnitSphere)
{
  ClassifierInput input;
  input.kind = ClassifierInputKind::Points;
  input.point_count = 1024;
  EXPECT_EQ(inputValueCount(input), 3072u);
  auto points = ellipsoid({3.0f, 2.0f, 1.0f}, 1024, 1);
  for (auto& point : points)
    point.position += Eigen::Vector3f(10, 20, 30);
  const auto values = classifierInput(points, {}, input, 1);
  ASSERT_EQ(values.size(), 3072u);
  double largest = 0.0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::set<std::vector<float>> places;
  for (std::size_t k = 0; k < 1024; ++k) {
    const Eigen::Vector3d place(values[k], values[1024 + k], values[2048 + k]);
    largest = std::max(largest, place.norm());
    sum += place;
    places.insert({values[k], values[1024 + k], values[2048 + k]});
  }
  EXPECT_NEAR(largest, 1.0, 1e-5);
  EXPECT_NEAR(sum.norm() / 1024, 0.0, 1e-5);
  std::set<std::vector<float>> given;
  for (const auto& point : points)
    given.insert({point.position.x(), point.position.y(), point.position.z()});
  EXPECT_EQ(places.size(), given.size()); // as many are wanted as there are: each once
  EXPECT_EQ(classifierInput(points, {}, input, 1), values);
  EXPECT_NE(classifierInput(points, {}, input, 2), values);
  points.resize(10); // each comes 102 or 103 times
  const auto repeated = classifierInput(points, {}, input, 1);
  for (std::size_t k = 0; k < 10; ++k) {
    const auto count =
        std::count(repeated.begin(), repeated.begin() + 1024, repeated[k]);
    EXPECT_TRUE(count == 102 || count == 103) << count;
  }
}

TEST(ObjectClassifier, AveragesDrawsAndNetworks)
{
  const auto model = someModel(ClassifierInputKind::PairHarmonics, 2, 3);
  const auto object = someObjects()[3];
  std::vector<double> expected(3, 0.0);
  for (std::uint32_t seed = 1; seed <= 3; ++seed)
    for (const auto& network : model.networks) {
      const auto input =
          classifierInput(object.points, object.place, model.input, seed);
      const auto own = softmax(networkScores(network, {input})[0]);
      for (std::size_t k = 0; k < 3; ++k)
        expected[k] += own[k] / 6.0;
    }
  const auto found = classifyObjects({object}, model)[0];
  ASSERT_EQ(found.probabilities.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(found.probabilities[k], expected[k], 1e-5);
  EXPECT_EQ(found.best(),
            std::max_element(expected.begin(), expected.end()) - expected.begin());
}

TEST(ObjectClassifier, DependsOnNoThreadsAndNoOtherObjects)
{
  const auto objects = someObjects();
  for (const auto kind :
       {ClassifierInputKind::PairHarmonics, ClassifierInputKind::Points}) {
    const auto model = someModel(kind, 2, 2);
    const auto expected = classifyObjects(objects, model, 1);
    ASSERT_EQ(expected.size(), objects.size());
    for (const unsigned int threads : {0u, 3u}) {
      const auto found = classifyObjects(objects, model, threads);
      for (std::size_t k = 0; k < objects.size(); ++k)
        EXPECT_EQ(found[k].probabilities, expected[k].probabilities);
    }
    for (const std::size_t k : {0u, 7u, 20u})
      EXPECT_EQ(classifyObjects({objects[k]}, model)[0].probabilities,
                expected[k].probabilities);
    EXPECT_NE(expected[0].probabilities, expected[7].probabilities);
  }
}

TEST(ObjectClassifier, WhatCannotBeDescribedHasNoClass)
{
  auto objects = someObjects();
  objects.resize(3);
  const auto points = objects[0].points;
  objects[1].points.clear();
  objects[2].points.assign(50, points[0]);
  for (const auto kind :
       {ClassifierInputKind::PairHarmonics, ClassifierInputKind::Points}) {
    const auto model = someModel(kind, 1, 2);
    const auto found = classifyObjects(objects, model, 2);
    EXPECT_GE(found[0].best(), 0);
    for (const std::size_t k : {1u, 2u}) {
      EXPECT_TRUE(found[k].probabilities.empty());
      EXPECT_EQ(found[k].best(), -1);
    }
    EXPECT_TRUE(classifyObjects({}, model).empty());
  }
}

TEST(ObjectClassifier, LargeScoresDoNotOverflow)
{
  auto model = someModel(ClassifierInputKind::PairHarmonics, 1, 1);
  model.networks[0].layers.back().weights[1].values = {1e4f, 2e4f, -1e4f};
  const auto found = classifyObjects({someObjects()[0]}, model)[0];
  EXPECT_EQ(found.probabilities, (std::vector<float>{0, 1, 0}));
}

TEST(ObjectClassifier, SaysWhatIsWrongWithAModel)
{
  const auto model = someModel(ClassifierInputKind::PairHarmonics, 1, 1);
  EXPECT_EQ(findProblem(model), "");
  const auto wrong = [&model](auto change) {
    auto changed = model;
    change(changed);
    EXPECT_THROW(classifyObjects({}, changed), BadArgumentException);
    return findProblem(changed);
  };
  EXPECT_NE(wrong([](auto& m) { m.classes = {"a"}; }), "");
  EXPECT_NE(wrong([](auto& m) { m.classes[1] = ""; }), "");
  EXPECT_NE(wrong([](auto& m) { m.classes[1] = "a"; }), "");
  EXPECT_NE(wrong([](auto& m) { m.classes.push_back("d"); }), "");
  EXPECT_NE(wrong([](auto& m) { m.networks.clear(); }), "");
  EXPECT_NE(wrong([](auto& m) { m.networks[0].layers.clear(); }), "");
  EXPECT_NE(wrong([](auto& m) { m.networks[0].layers.back().weights.clear(); }), "");
  EXPECT_NE(wrong([](auto& m) { m.input.draws = 0; }), "");
  EXPECT_NE(wrong([](auto& m) { m.input.pair_count = 0; }), "");
  EXPECT_NE(wrong([](auto& m) { m.input.point_count = 0; }), "");
  EXPECT_NE(wrong([](auto& m) { m.input.scale = -1; }), "");
  EXPECT_NE(wrong([](auto& m) { m.input.scale = NAN; }), "");
  EXPECT_NE(wrong([](auto& m) { m.input.context = false; }), ""); // 16 values fewer
  EXPECT_NE(wrong([](auto& m) { m.input.kind = ClassifierInputKind::EPPFShort; }), "");
  EXPECT_NE(wrong([](auto& m) { m.input.kind = ClassifierInputKind::Points; }), "");
  auto untrained = model;
  untrained.networks[0].layers.back().weights.clear();
  EXPECT_EQ(findProblem(untrained, false), "");
}

} // namespace
} // namespace pcl::indoor
