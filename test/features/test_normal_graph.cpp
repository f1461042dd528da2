/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "support/labelled_points.h"

#include <pcl/exceptions.h>
#include <pcl/features/normal_graph.h>
#include <pcl/features/normal_orientation.h>
#include <pcl/features/sign_graph.h>

#include <gtest/gtest.h>

using namespace pcl::indoor;

namespace {

using Signs = std::vector<std::int8_t>;

std::vector<SignEdge>
randomGraph(std::uint32_t nodes, int edge_count, std::mt19937& rng)
{
  std::vector<SignEdge> edges;
  for (int i = 0; i < edge_count; ++i)
    edges.push_back({static_cast<std::uint32_t>(rng() % nodes),
                     static_cast<std::uint32_t>(rng() % nodes),
                     static_cast<float>(rng() % 2001) / 1000 - 1});
  return edges;
}

/** The summed strengths of the edges that signs do not satisfy. */
double
signEnergy(const std::vector<std::int8_t>& signs, const std::vector<SignEdge>& edges)
{
  double energy = 0;
  for (const auto& edge : edges)
    if (signs[edge.source] * signs[edge.target] * edge.weight < 0)
      energy += std::abs(edge.weight);
  return energy;
}

double
leastEnergy(std::uint32_t nodes, const std::vector<SignEdge>& edges)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t bits = 0; bits < (1u << nodes); ++bits) {
    Signs signs;
    for (std::uint32_t node = 0; node < nodes; ++node)
      signs.push_back((bits >> node) & 1 ? 1 : -1);
    least = std::min(least, signEnergy(signs, edges));
  }
  return least;
}

/** Components by repeated passes over the edges. */
std::vector<std::uint32_t>
componentsBruteForce(std::uint32_t nodes, const std::vector<SignEdge>& edges)
{
  std::vector<std::uint32_t> component(nodes);
  for (std::uint32_t i = 0; i < nodes; ++i)
    component[i] = i;
  for (std::uint32_t pass = 0; pass < nodes; ++pass)
    for (const auto& edge : edges) {
      const auto lower = std::min(component[edge.source], component[edge.target]);
      component[edge.source] = component[edge.target] = lower;
    }
  for (auto& label : component)
    ++label; // renamed() keeps 0
  return test::renamed(component);
}

/** All pairs nearer than a distance. */
Adjacency
neighborsOf(const std::vector<Eigen::Vector3f>& points, float distance)
{
  Adjacency adjacency;
  adjacency.offsets.push_back(0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points.size(); ++j)
      if (i != j && (points[i] - points[j]).norm() < distance)
        adjacency.targets.push_back(static_cast<std::uint32_t>(j));
    adjacency.offsets.push_back(static_cast<std::uint32_t>(adjacency.targets.size()));
  }
  return adjacency;
}

double
shareOfRight(const std::vector<Eigen::Vector3f>& normals,
             const std::vector<Eigen::Vector3f>& truth)
{
  std::size_t right = 0;
  for (std::size_t i = 0; i < normals.size(); ++i)
    right += normals[i].dot(truth[i]) > 0;
  return static_cast<double>(right) / static_cast<double>(normals.size());
}

/** Closed on five sides, open below; normals flipped at random. */
test::LabelledPoints
box(std::vector<Eigen::Vector3f>& flipped)
{
  std::mt19937 rng(11);
  test::LabelledPoints scene;
  scene.addBox({0, 0, 0}, {0.6f, 0.5f, 0.4f}, 1, 0.03f, 0.003f, rng);
  flipped = scene.normals;
  for (auto& normal : flipped)
    normal *= rng() % 2 ? 1.0f : -1.0f;
  return scene;
}

} // namespace

TEST(FindSigns, GrantsAllWishesThatCanBeGranted)
{
  std::mt19937 rng(1);
  for (int trial = 0; trial < 200; ++trial) {
    const std::uint32_t nodes = 1 + rng() % 40;
    auto edges = randomGraph(nodes, static_cast<int>(rng() % 120), rng);
    Signs truth;
    for (std::uint32_t i = 0; i < nodes; ++i)
      truth.push_back(rng() % 2 ? 1 : -1);
    for (auto& edge : edges)
      edge.weight = std::abs(edge.weight) *
                    static_cast<float>(truth[edge.source] * truth[edge.target]);
    EXPECT_EQ(signEnergy(findSigns(nodes, edges), edges), 0) << trial;
  }
}

TEST(FindSigns, IsNearTheLeastEnergy)
{
  std::mt19937 rng(2);
  double found = 0, least = 0, untouched = 0;
  int exact = 0;
  constexpr int trials = 200;
  for (int trial = 0; trial < trials; ++trial) {
    const std::uint32_t nodes = 4 + rng() % 8;
    const auto edges = randomGraph(nodes, static_cast<int>(3 * nodes), rng);
    const double energy = signEnergy(findSigns(nodes, edges), edges);
    const double bound = leastEnergy(nodes, edges);
    EXPECT_GE(energy, bound - 1e-6) << trial;
    found += energy;
    least += bound;
    untouched += signEnergy(Signs(nodes, 1), edges);
    exact += energy < bound + 1e-6;
  }
  // Random wishes are the hardest: normals of a surface hardly contradict each other.
  EXPECT_LT(found, 1.1 * least);
  EXPECT_GT(untouched, 2 * least);
  EXPECT_GT(exact, trials / 2);
}

TEST(FindSigns, NoSingleFlipLowersTheEnergy)
{
  std::mt19937 rng(4);
  for (int trial = 0; trial < 30; ++trial) {
    const auto edges = randomGraph(60, 300, rng);
    auto signs = findSigns(60, edges);
    const double energy = signEnergy(signs, edges);
    for (auto& sign : signs) {
      sign = static_cast<std::int8_t>(-sign);
      EXPECT_GE(signEnergy(signs, edges), energy - 1e-4) << trial;
      sign = static_cast<std::int8_t>(-sign);
    }
  }
}

TEST(FindSigns, NumbersTheComponents)
{
  std::mt19937 rng(3);
  for (int trial = 0; trial < 50; ++trial) {
    auto edges = randomGraph(30, 25, rng);
    // No wishes of 0, and none that cancel each other out: those connect nothing.
    for (std::size_t i = 0; i < edges.size(); ++i)
      edges[i].weight = (edges[i].weight < 0 ? -1.0f : 1.0f) *
                        (1 + 0.01f * std::sqrt(static_cast<float>(i)));
    std::vector<std::uint32_t> component;
    const auto signs = findSigns(30, edges, &component);
    for (auto& label : component)
      ++label;
    const auto expected = componentsBruteForce(30, edges);
    EXPECT_EQ(component, expected) << trial;
    std::vector<bool> seen(31, false);
    for (std::size_t i = 0; i < signs.size(); ++i) {
      if (!seen[component[i]]) {
        EXPECT_EQ(signs[i], 1);
      }
      seen[component[i]] = true;
    }
  }
}

TEST(FindSigns, SmallAndBadInput)
{
  EXPECT_TRUE(findSigns(0, {}).empty());
  EXPECT_EQ(findSigns(2, {}), (Signs{1, 1}));
  EXPECT_EQ(findSigns(2, {{0, 1, -1}}), (Signs{1, -1}));
  EXPECT_EQ(findSigns(1, {{0, 0, -1}}), (Signs{1})); // cannot be granted
  EXPECT_EQ(findSigns(3, {{0, 1, 0}, {1, 2, -2}}), (Signs{1, 1, -1}));
  EXPECT_THROW(findSigns(2, {{0, 2, 1}}), pcl::BadArgumentException);
  // A chain whose edges grow stronger has one mutual pair per round.
  std::vector<SignEdge> chain;
  for (std::uint32_t i = 0; i < 500; ++i)
    chain.push_back({i, i + 1, -static_cast<float>(i + 1)});
  EXPECT_EQ(signEnergy(findSigns(501, chain), chain), 0);
}

TEST(NormalGraph, AgreementIsCarriedOverEdges)
{
  const Eigen::Vector3f up(0, 0, 1), right(1, 0, 0), zero(0, 0, 0);
  EXPECT_NEAR(sideAgreement({0, 0, 0}, up, {1, 0, 0}, up), 1, 1e-6f);
  EXPECT_NEAR(sideAgreement({0, 0, 0}, up, {1, 0, 0}, -up), -1, 1e-6f);
  // Top and side of a box, both outwards; half, because the step is steep.
  EXPECT_NEAR(sideAgreement({0, 0, 0}, up, {1, 0, -1}, right), 0.5f, 1e-6f);
  EXPECT_NEAR(sideAgreement({0, 0, 0}, up, {1, 0, -1}, -right), -0.5f, 1e-6f);
  // Floor and wall, both towards the room.
  EXPECT_NEAR(sideAgreement({0, 0, 0}, up, {1, 0, 1}, -right), 0.5f, 1e-6f);
  // Two layers of one surface.
  EXPECT_EQ(sideAgreement({0, 0, 0}, up, {0, 0, 1}, up), 0);
  EXPECT_EQ(sideAgreement({0, 0, 0}, up, {0, 0, 0}, up), 0);
  EXPECT_EQ(sideAgreement({0, 0, 0}, zero, {1, 0, 0}, up), 0);
  EXPECT_EQ(sideAgreement({0, 0, 0}, up * std::nanf(""), {1, 0, 0}, up), 0);
}

TEST(OrientConsistently, ABoxTurnsAsAWhole)
{
  std::vector<Eigen::Vector3f> flipped;
  const auto scene = box(flipped);
  const auto neighbors = neighborsOf(scene.points, 0.06f);
  auto normals = flipped;
  orientConsistently(scene.points, neighbors, {}, normals);
  EXPECT_EQ(shareOfRight(normals, scene.normals), 0); // towards the middle
  normals = flipped;
  orientConsistently(scene.points, neighbors, {{0.3f, 0.25f, 9}}, normals);
  EXPECT_EQ(shareOfRight(normals, scene.normals), 1); // the top decides
}

TEST(OrientNormals, GoesEachWay)
{
  std::vector<Eigen::Vector3f> flipped;
  const auto scene = box(flipped);
  const auto neighbors = neighborsOf(scene.points, 0.06f);
  const std::vector<Eigen::Vector3f> above{{0.3f, 0.25f, 9}};
  FreeSpaceOptions free_space;
  const auto oriented = [&](NormalOrientation how, const auto& viewpoint) {
    auto normals = flipped;
    orientNormals(how, scene.points, neighbors, viewpoint, free_space, normals);
    return normals;
  };
  auto expected = flipped;
  orientTowards(above.front(), scene.points, expected);
  EXPECT_EQ(oriented(NormalOrientation::Viewpoint, above), expected);
  EXPECT_EQ(oriented(NormalOrientation::Automatic, above), expected);
  expected = flipped;
  orientConsistently(scene.points, neighbors, above, expected);
  EXPECT_EQ(oriented(NormalOrientation::Graph, above), expected);
  expected = flipped;
  orientTowardsFreeSpace(scene.points, neighbors, free_space, expected);
  EXPECT_EQ(oriented(NormalOrientation::FreeSpace, above), expected);
  const std::vector<Eigen::Vector3f> unknown;
  EXPECT_EQ(oriented(NormalOrientation::Automatic, unknown), expected);
  EXPECT_THROW(oriented(NormalOrientation::Viewpoint, unknown),
               pcl::BadArgumentException);
}

TEST(OrientConsistently, SmallAndBadInput)
{
  std::vector<Eigen::Vector3f> normals;
  Adjacency none;
  none.offsets = {0};
  orientConsistently({}, none, {}, normals);
  EXPECT_TRUE(normals.empty());
  EXPECT_THROW(orientConsistently({{0, 0, 0}}, none, {}, normals),
               pcl::BadArgumentException);
  none.offsets = {0, 0};
  normals = {{0, 0, 1}};
  orientConsistently({{0, 0, 0}}, none, {{0, 0, -3}}, normals);
  EXPECT_EQ(normals[0].z(), -1);
}
