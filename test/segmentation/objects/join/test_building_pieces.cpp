/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/join/building_pieces.h"

#include <gtest/gtest.h>

using namespace pcl::indoor;

namespace {

TEST(BuildingPieces, AreWhatTheirVoxelsAreMostlyTakenFor)
{
  PieceGraph graph;
  graph.pieces.resize(5);
  graph.pieces[0].votes.classes = {0.0, 3.0, 1.0, 4.0}; // half of all: a wall
  graph.pieces[1].votes.classes = {0.0, 3.0, 0.0, 7.0};
  graph.pieces[2].votes.classes = {5.0, 0.0, 0.0, 1.0};
  graph.pieces[3].votes.classes = {0.0, 0.0, 1.0, 0.0};
  graph.pieces[4].votes.classes = {0.0, 0.0, 0.0, 0.0}; // one of a plane
  EXPECT_EQ(buildingPieces(graph), std::vector<StructureKind>(5, StructureKind::None));
  graph.has_votes = true;
  EXPECT_EQ(buildingPieces(graph),
            (std::vector<StructureKind>{StructureKind::Wall,
                                        StructureKind::None,
                                        StructureKind::Floor,
                                        StructureKind::Ceiling,
                                        StructureKind::None}));

  graph.contacts.resize(3);
  graph.contacts[0].first = 0;
  graph.contacts[0].second = 1;
  graph.contacts[1].first = 1;
  graph.contacts[1].second = 4;
  graph.contacts[2].first = 1;
  graph.contacts[2].second = 3;
  leaveAlone(buildingPieces(graph), graph);
  ASSERT_EQ(graph.contacts.size(), 1u);
  EXPECT_EQ(graph.contacts[0].second, 4u);
}

} // namespace
