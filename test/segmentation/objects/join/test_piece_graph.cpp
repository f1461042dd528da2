/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "segmentation/objects/join/piece_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

/** The voxels of each piece. */
std::vector<Labels>
membersOf(const Scene& scene)
{
  std::vector<Labels> members(scene.piece_count);
  for (std::uint32_t v = 0; v < scene.voxels.size(); ++v)
    if (scene.plane_of_voxel[v] == 0)
      members[scene.piece_of_voxel[v]].push_back(v);
  return members;
}

template <std::size_t n>
void
expectNear(const std::array<float, n>& a,
           const std::array<float, n>& b,
           float tolerance)
{
  for (std::size_t i = 0; i < n; ++i)
    EXPECT_NEAR(a[i], b[i], tolerance) << "direction " << i;
}

/** The reach of all places but one of each hundred. */
float
reachOf(const Labels& members,
        const Scene& scene,
        const Eigen::Vector3f& direction_in_scene)
{
  std::vector<float> heights;
  for (const auto v : members)
    heights.push_back(direction_in_scene.dot(scene.voxels.centroids[v]));
  std::sort(heights.begin(), heights.end());
  return heights[heights.size() - 1 - heights.size() / 100] + 0.015f;
}

} // namespace

TEST(VectorMoments, AreThoseOfTheVectors)
{
  std::mt19937 rng(1);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Eigen::Vector3d> vectors;
    VectorMoments moments, of_half;
    for (int i = 0; i < 1 + trial; ++i) {
      const auto random = [&] { return static_cast<double>(rng() % 2001) / 1000 - 1; };
      const double x = random(), y = random(), z = random();
      vectors.emplace_back(x, y, z);
      (i % 2 ? of_half : moments).add(vectors.back());
    }
    moments += of_half;
    const auto n = static_cast<double>(vectors.size());
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const auto& vector : vectors)
      mean += vector / n;
    for (const auto& vector : vectors)
      covariance += (vector - mean) * (vector - mean).transpose() / n;
    EXPECT_DOUBLE_EQ(moments.count, n);
    expectNear(moments.mean(), mean, 1e-12);
    expectNear(moments.covariance(), covariance, 1e-12);
  }
}

TEST(VectorMoments, WeightsAreNumbersOfVectors)
{
  const Eigen::Vector3d a(1, -2, 3), b(0.5, 0.25, -1);
  VectorMoments weighted, repeated;
  weighted.add(a, 3);
  weighted.add(b, 2);
  for (const auto& vector : {a, a, a, b, b})
    repeated.add(vector);
  expectNear(weighted, repeated);
  EXPECT_EQ(VectorMoments().mean(), Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(VectorMoments().covariance(), Eigen::Matrix3d(Eigen::Matrix3d::Zero()));
}

TEST(PieceGraph, PiecesAreTheSumsOfTheirVoxels)
{
  auto scene = twoBoxes(leaning);
  scene.setPieces(6, [](std::uint32_t supervoxel) { return supervoxel * 7 % 6; });
  const auto graph = scene.graph();
  const auto members = membersOf(scene);
  const auto frame = frameOf(scene);
  ASSERT_EQ(graph.pieces.size(), 7u);
  EXPECT_EQ(graph.pieces[6].positions.count, 0) << "the planes'";
  std::size_t large = 0;
  for (std::uint32_t p = 0; p < 6; ++p) {
    VectorMoments positions, normals;
    for (const auto v : members[p]) {
      positions.add((frame * scene.voxels.centroids[v]).cast<double>());
      normals.add((frame * scene.voxels.normals[v]).cast<double>());
    }
    const auto& piece = graph.pieces[p];
    expectNear(piece.positions, positions);
    expectNear(piece.normals, normals);
    EXPECT_EQ(piece.parts, 1);
    large += members[p].size() >= 100;
    for (std::size_t d = 0; d < 16; ++d) {
      const float angle = static_cast<float>(d) * static_cast<float>(M_PI) / 8;
      const Eigen::Vector3f direction(std::cos(angle), std::sin(angle), 0);
      EXPECT_NEAR(piece.outline[d],
                  reachOf(members[p], scene, frame.transpose() * direction),
                  1e-5);
    }
    for (const int axis : {0, 1, 2}) { // directions 0 to 5 are -x -y -z +z +y +x
      const Eigen::Vector3f direction = frame.row(axis).transpose();
      EXPECT_NEAR(piece.hull[axis], reachOf(members[p], scene, -direction), 1e-5);
      EXPECT_NEAR(piece.hull[5 - axis], reachOf(members[p], scene, direction), 1e-5);
    }
  }
  EXPECT_GT(large, 0u) << "some have outliers";
}

TEST(PieceGraph, VotesAreTheSumsOfThoseOfTheVoxels)
{
  auto scene = twoBoxes(leaning);
  scene.setPieces(6, [](std::uint32_t supervoxel) { return supervoxel * 7 % 6; });
  EXPECT_FALSE(scene.graph().has_votes);
  EXPECT_TRUE(scene.graph().pieces[0].votes.classes.empty());
  const Eigen::Vector3f middle(0.3f, 0.2f, 0.1f);
  scene.points = scene.voxels.centroids; // twice, with votes that differ
  scene.votes.class_count = 4;
  auto& cells = scene.voxels.cells.cell_of_point;
  cells.clear();
  for (const bool is_object : {false, true})
    for (std::uint32_t v = 0; v < scene.voxels.size(); ++v) {
      if (is_object)
        scene.points.push_back(scene.points[v]);
      cells.push_back(v);
      scene.votes.voxel_of_point.push_back(
          static_cast<std::uint32_t>(scene.votes.to_middle.size()));
      scene.votes.to_middle.push_back(middle - scene.points[v]);
      const std::vector<float> probabilities = {
          0.0f, is_object ? 0.0f : 1.0f, 0.0f, is_object ? 1.0f : 0.0f};
      scene.votes.probabilities.insert(
          scene.votes.probabilities.end(), probabilities.begin(), probabilities.end());
    }
  listPoints(scene.voxels.cells);
  auto graph = scene.graph();
  EXPECT_TRUE(graph.has_votes);
  const Eigen::Vector3d expected = (frameOf(scene) * middle).cast<double>();
  graph.pieces[0] += graph.pieces[1];
  for (const std::uint32_t p : {0, 2, 3}) {
    const auto& piece = graph.pieces[p];
    const double half = 0.5 * piece.positions.count;
    EXPECT_GT(half, 0.0);
    EXPECT_EQ(piece.votes.classes, (std::vector<double>{0.0, half, 0.0, half}));
    EXPECT_EQ(piece.votes.middles.count, piece.positions.count);
    EXPECT_LT((piece.votes.middles.mean() - expected).norm(), 1e-5);
    EXPECT_LT(piece.votes.middles.covariance().norm(), 1e-5);
  }
}

TEST(PieceGraph, TheFloorIsBelowAllButTheLowestVoxels)
{
  auto scene = twoBoxes(leaning);
  scene.setPieces(1, [](std::uint32_t) { return 0u; });
  std::vector<float> heights; // those of the floor's plane, too
  for (const auto& centroid : scene.voxels.centroids)
    heights.push_back(scene.up.dot(centroid));
  std::sort(heights.begin(), heights.end());
  const auto graph = scene.graph();
  EXPECT_NEAR(graph.floor, heights[(heights.size() - 1) / 200], 1e-5);
  EXPECT_NEAR(graph.floor, 0, 0.01);
  EXPECT_DOUBLE_EQ(graph.voxel_size, voxel_size);
}

TEST(PieceGraph, ColumnsAreThoseOfAllVoxels)
{
  auto scene = twoBoxes(leaning);
  scene.setPieces(1, [](std::uint32_t) { return 0u; });
  const auto frame = frameOf(scene);
  std::vector<Eigen::Vector3f> voxels; // those of the floor's plane, too
  for (const auto& centroid : scene.voxels.centroids)
    voxels.push_back(frame * centroid);
  const auto graph = scene.graph();
  const RoomColumns all(voxels, graph.floor, voxel_size);
  const auto& outline = graph.pieces[0].outline;
  EXPECT_GT(all.areaOfFloor(outline), 0.05) << "between the boxes";
  EXPECT_EQ(graph.columns.areaOfFloor(outline), all.areaOfFloor(outline));
}

TEST(PieceGraph, PiecesAddUpToTheirUnion)
{
  auto scene = twoBoxes(leaning);
  const auto count = static_cast<std::uint32_t>(scene.supervoxels.size());
  scene.setPieces(count, [](std::uint32_t supervoxel) { return supervoxel; });
  const auto graph = scene.graph();
  std::size_t compared = 0;
  for (const auto& contact : graph.contacts) {
    auto sum = graph.pieces[contact.first];
    sum += graph.pieces[contact.second];
    if (sum.positions.count >= 100 || compared == 20) // outliers are left out
      continue;
    ++compared;
    scene.setPieces(count, [&](std::uint32_t supervoxel) {
      return supervoxel == contact.second ? contact.first : supervoxel;
    });
    const auto direct = scene.graph().pieces[contact.first];
    expectNear(sum.positions, direct.positions);
    expectNear(sum.normals, direct.normals);
    expectNear(sum.hull, direct.hull, 1e-6f);
    expectNear(sum.outline, direct.outline, 1e-6f);
    EXPECT_EQ(sum.parts, 2);
  }
  EXPECT_EQ(compared, 20u);
}

TEST(PieceGraph, NothingInNothing)
{
  const auto graph = sceneOf({}, 0, {0, 0, 1}).graph();
  EXPECT_TRUE(graph.pieces.empty());
  EXPECT_TRUE(graph.contacts.empty());
  EXPECT_EQ(graph.floor, 0);
  const auto one = sceneOf({{{0, 0, 3}, 1}, {{1, 2, 3}, 0}}, 2, {0, 0, 1}).graph();
  ASSERT_EQ(one.pieces.size(), 2u);
  EXPECT_EQ(one.pieces[0].positions.count, 1);
  EXPECT_EQ(one.floor, 3);
  EXPECT_TRUE(one.contacts.empty());
}
