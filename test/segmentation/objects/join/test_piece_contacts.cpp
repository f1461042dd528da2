/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "segmentation/objects/join/piece_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

bool
areNeighbors(std::uint64_t key_a, std::uint64_t key_b)
{
  const Eigen::Vector3i apart = cellIndex(key_a) - cellIndex(key_b);
  return apart.cwiseAbs().maxCoeff() <= 1;
}

/** What contacts of all pairs of voxels hold, and bends. */
std::map<PieceNumbers, PieceContact>
contactsOf(const Scene& scene)
{
  std::map<PieceNumbers, PieceContact> contacts;
  const auto of = [&](std::uint32_t a, std::uint32_t b) -> PieceContact& {
    return contacts[std::minmax(a, b)];
  };
  const auto frame = frameOf(scene);
  const auto& voxels = scene.voxels;
  const auto& pieces = scene.piece_of_voxel;
  std::map<PieceNumbers, std::set<std::uint32_t>> touching; // by piece and other piece
  Labels loose;
  for (std::uint32_t v = 0; v < voxels.size(); ++v)
    if (scene.plane_of_voxel[v] == 0)
      loose.push_back(v);
  for (const auto v : loose)
    for (const auto w : loose) {
      if (pieces[v] == pieces[w] ||
          !areNeighbors(voxels.cells.keys[v], voxels.cells.keys[w]))
        continue;
      touching[{pieces[v], pieces[w]}].insert(v);
      if (v < w) {
        const Eigen::Vector3f middle =
            frame * (voxels.centroids[v] + voxels.centroids[w]) / 2;
        of(pieces[v], pieces[w]).places.add(middle.cast<double>());
      }
    }
  for (const auto& [pair, members] : touching) {
    auto& contact = of(pair.first, pair.second);
    (pair.first < pair.second ? contact.first_voxels : contact.second_voxels) =
        static_cast<double>(members.size());
  }
  std::vector<std::uint32_t> piece_of_supervoxel(scene.supervoxels.size());
  for (const auto v : loose)
    piece_of_supervoxel[scene.supervoxels.label_of_voxel[v]] = pieces[v];
  for (const auto& edge : scene.edges) {
    const auto a = piece_of_supervoxel[edge.source],
               b = piece_of_supervoxel[edge.target];
    if (a == b)
      continue;
    auto& contact = of(a, b);
    const double bend = bendDegrees(scene.supervoxels.centroids[edge.source],
                                    scene.supervoxels.normals[edge.source],
                                    scene.supervoxels.centroids[edge.target],
                                    scene.supervoxels.normals[edge.target]);
    for (std::uint32_t i = 0; i < edge.contacts; ++i) {
      contact.bends += 1;
      contact.bend_sum += bend;
      contact.bend_squares += bend * bend;
      contact.concave_bends += bend > 0;
    }
  }
  return contacts;
}

/** The number of cells and the gap of each pair that is near. */
void
addNear(const Scene& scene, std::map<PieceNumbers, PieceContact>& contacts)
{
  struct Share {
    Eigen::Vector3d place{0, 0, 0}, normal{0, 0, 0};
    double count = 0;
  };
  const auto frame = frameOf(scene);
  std::vector<Eigen::Vector3f> positions;
  Labels loose;
  for (std::uint32_t v = 0; v < scene.voxels.size(); ++v)
    if (scene.plane_of_voxel[v] == 0) {
      loose.push_back(v);
      positions.push_back(frame * scene.voxels.centroids[v]);
    }
  const auto cells = groupByCell(positions, 3 * voxel_size);
  std::map<PieceNumbers, Share> shares; // by cell and piece
  for (std::size_t i = 0; i < loose.size(); ++i) {
    auto& share = shares[{cells.cell_of_point[i], scene.piece_of_voxel[loose[i]]}];
    share.place += positions[i].cast<double>();
    share.normal += (frame * scene.voxels.normals[loose[i]]).cast<double>();
    ++share.count;
  }
  for (auto& entry : shares) {
    entry.second.place /= entry.second.count;
    entry.second.normal.normalize();
  }
  for (const auto& [key_a, a] : shares)
    for (const auto& [key_b, b] : shares) {
      if (key_a.second >= key_b.second ||
          !areNeighbors(cells.keys[key_a.first], cells.keys[key_b.first]))
        continue;
      const Eigen::Vector3d between = a.place - b.place;
      auto& contact = contacts[{key_a.second, key_b.second}];
      contact.gap = contact.near_cells == 0 ? between.norm()
                                            : std::min(contact.gap, between.norm());
      ++contact.near_cells;
      contact.near_in_line += std::abs(between.dot(a.normal)) < 0.5 * voxel_size &&
                              std::abs(between.dot(b.normal)) < 0.5 * voxel_size;
    }
}

/** A plate of 10 x 10 voxels along two edges, a place in the middle of each. */
void
addPlate(const Eigen::Vector3f& corner,
         const Eigen::Vector3f& u,
         const Eigen::Vector3f& v,
         std::uint32_t piece,
         std::vector<std::pair<Eigen::Vector3f, std::uint32_t>>& places)
{
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j)
      places.emplace_back(
          corner + static_cast<float>(voxel_size) *
                       (static_cast<float>(i) * u + static_cast<float>(j) * v),
          piece);
}

} // namespace

TEST(PieceContacts, AreThoseOfAllPairsOfVoxels)
{
  auto scene = twoBoxes(leaning);
  for (const std::uint32_t count : {2u, 5u, 20u}) {
    scene.setPieces(count, [&](auto supervoxel) { return supervoxel * 13 % count; });
    auto expected = contactsOf(scene);
    addNear(scene, expected);
    const auto graph = scene.graph();
    ASSERT_EQ(graph.contacts.size(), expected.size());
    auto entry = expected.begin();
    for (const auto& contact : graph.contacts) {
      const auto& [pair, brute] = *entry++;
      ASSERT_EQ(std::make_pair(contact.first, contact.second), pair);
      EXPECT_EQ(contact.first_voxels, brute.first_voxels);
      EXPECT_EQ(contact.second_voxels, brute.second_voxels);
      expectNear(contact.places, brute.places);
      EXPECT_EQ(contact.bends, brute.bends);
      EXPECT_NEAR(contact.bend_sum, brute.bend_sum, 1e-6 * (1 + brute.bends));
      EXPECT_NEAR(contact.bend_squares, brute.bend_squares, 1e-4 * (1 + brute.bends));
      EXPECT_EQ(contact.concave_bends, brute.concave_bends);
      EXPECT_NEAR(contact.gap, brute.gap, 1e-6);
      EXPECT_EQ(contact.near_cells, brute.near_cells);
      EXPECT_EQ(contact.near_in_line, brute.near_in_line);
    }
  }
}

TEST(PieceContacts, HaveTwoSidesThatAreAlike)
{
  auto scene = twoBoxes();
  constexpr std::uint32_t count = 8;
  scene.setPieces(count, [](std::uint32_t supervoxel) { return supervoxel % count; });
  const auto graph = scene.graph();
  ASSERT_GT(graph.contacts.size(), 10u);
  scene.setPieces(count,
                  [](std::uint32_t supervoxel) { return 7 - supervoxel % count; });
  const auto other = scene.graph();
  ASSERT_EQ(other.contacts.size(), graph.contacts.size());
  for (const auto& contact : graph.contacts) {
    const auto found = std::find_if(
        other.contacts.begin(), other.contacts.end(), [&](const auto& candidate) {
          return candidate.first == 7 - contact.second &&
                 candidate.second == 7 - contact.first;
        });
    ASSERT_NE(found, other.contacts.end());
    EXPECT_EQ(found->first_voxels, contact.second_voxels);
    EXPECT_EQ(found->second_voxels, contact.first_voxels);
    expectNear(found->places, contact.places);
    EXPECT_DOUBLE_EQ(found->bends, contact.bends);
    EXPECT_NEAR(found->bend_sum, contact.bend_sum, 1e-6 * (1 + contact.bends));
    EXPECT_DOUBLE_EQ(found->gap, contact.gap);
    EXPECT_EQ(found->near_cells, contact.near_cells);
    EXPECT_EQ(found->near_in_line, contact.near_in_line);
  }
}

TEST(PieceContacts, AddUpToThoseOfAUnion)
{
  auto scene = twoBoxes();
  scene.setPieces(6, [](std::uint32_t supervoxel) { return supervoxel % 6; });
  const auto graph = scene.graph();
  scene.setPieces(6, [](std::uint32_t supervoxel) { // 5 goes up in 0
    return supervoxel % 6 == 5 ? 0 : supervoxel % 6;
  });
  const auto united = scene.graph();
  for (std::uint32_t other = 1; other < 5; ++other) {
    const auto between = [&](const PieceGraph& of, std::uint32_t a, std::uint32_t b) {
      return *std::find_if(of.contacts.begin(), of.contacts.end(), [&](const auto& c) {
        return c.first == a && c.second == b;
      });
    };
    auto sum = between(graph, other, 5); // the other is the first of this one
    sum.second = 0;
    const auto added = between(graph, 0, other);
    const auto gap = std::min(sum.gap, added.gap);
    sum += added;
    const auto direct = between(united, 0, other);
    EXPECT_EQ(sum.second_voxels, direct.first_voxels) << "those of the union";
    EXPECT_GE(sum.first_voxels, direct.second_voxels) << "some touch both";
    EXPECT_LT(sum.first_voxels, 2 * direct.second_voxels);
    expectNear(sum.places, direct.places);
    EXPECT_DOUBLE_EQ(sum.bends, direct.bends);
    EXPECT_NEAR(sum.bend_sum, direct.bend_sum, 1e-6 * sum.bends);
    EXPECT_NEAR(sum.bend_squares, direct.bend_squares, 1e-6 * sum.bend_squares);
    EXPECT_DOUBLE_EQ(sum.concave_bends, direct.concave_bends);
    EXPECT_EQ(sum.gap, gap);
  }
}

TEST(PieceContacts, OnlyGapsThatWereSeenCount)
{
  PieceContact touching, near, nearer;
  near.gap = 0.1;
  near.near_cells = 3;
  near.near_in_line = 1;
  nearer.gap = 0.05;
  nearer.near_cells = 2;
  auto sum = touching;
  sum += near;
  EXPECT_EQ(sum.gap, 0.1);
  sum += touching;
  EXPECT_EQ(sum.gap, 0.1);
  sum += nearer;
  EXPECT_EQ(sum.gap, 0.05);
  sum += near;
  EXPECT_EQ(sum.gap, 0.05);
  EXPECT_EQ(sum.near_cells, 8);
  EXPECT_EQ(sum.near_in_line, 2);
}

TEST(PieceContacts, NearPiecesAreInLineOrNot)
{
  const Eigen::Vector3f x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const auto contactsAt = [&](const Eigen::Vector3f& corner) {
    std::vector<std::pair<Eigen::Vector3f, std::uint32_t>> places{
        {{0, 0, 0}, 2}}; // so that the others are in the middle of voxels
    addPlate({0.045f, 0.015f, 0.015f}, x, y, 0, places);
    addPlate(corner, x, y, 1, places);
    return sceneOf(places, 3, z).graph().contacts;
  };
  const auto beside = contactsAt({0.045f + 0.34f, 0.015f, 0.015f}); // of 0.3 m
  ASSERT_EQ(beside.size(), 1u);
  EXPECT_EQ(beside[0].first_voxels, 0);
  EXPECT_EQ(beside[0].places.count, 0);
  EXPECT_EQ(beside[0].bends, 0);
  EXPECT_GT(beside[0].near_cells, 0);
  EXPECT_EQ(beside[0].near_in_line, beside[0].near_cells);
  EXPECT_GE(beside[0].gap, 0.06);
  EXPECT_LT(beside[0].gap, 0.18);
  const auto above = contactsAt({0.045f, 0.015f, 0.015f + 0.09f});
  ASSERT_EQ(above.size(), 1u);
  EXPECT_EQ(above[0].near_in_line, 0);
  EXPECT_NEAR(above[0].gap, 0.09, 1e-6);
  EXPECT_TRUE(contactsAt({0.045f, 0.015f, 0.015f + 0.21f}).empty());
  // Next to each other: 10 pairs of voxels face to face, and 18 corner to corner.
  const auto touching = contactsAt({0.045f + 0.3f, 0.015f, 0.015f});
  ASSERT_EQ(touching.size(), 1u);
  EXPECT_EQ(touching[0].first_voxels, 10);
  EXPECT_EQ(touching[0].second_voxels, 10);
  EXPECT_EQ(touching[0].places.count, 28);
  expectNear(touching[0].places.covariance().diagonal().tail<1>(),
             Eigen::VectorXd::Zero(1),
             1e-9);
}

TEST(PieceContacts, PlanesHaveNoContacts)
{
  auto scene = twoBoxes();
  scene.setPieces(2, [](std::uint32_t supervoxel) { return supervoxel % 2; });
  for (const auto& contact : scene.graph().contacts) {
    EXPECT_EQ(contact.first, 0u);
    EXPECT_EQ(contact.second, 1u);
  }
  std::fill(scene.plane_of_voxel.begin(), scene.plane_of_voxel.end(), 1);
  scene.supervoxels = growSupervoxels(
      scene.voxels, std::vector<std::uint8_t>(scene.voxels.size(), 1), 4, {}, 1);
  scene.edges.clear();
  const auto planes = scene.graph();
  EXPECT_TRUE(planes.contacts.empty());
  for (const auto& piece : planes.pieces)
    EXPECT_EQ(piece.positions.count, 0);
}
