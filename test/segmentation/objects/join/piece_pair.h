/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/join/joining_features.h"
#include "segmentation/objects/join/joining_feature_names.h"
#include "segmentation/objects/join/outline_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace pcl::indoor {
namespace test {

constexpr double pair_voxel_size = 0.03;

/** A piece of these places, each of them that many voxels. */
inline Piece
pieceOf(const Places& places,
        const Places& normals,
        double voxels = 1,
        float margin = 0)
{
  Piece piece;
  for (const auto& place : places)
    piece.positions.add(place.cast<double>(), voxels);
  for (const auto& normal : normals)
    piece.normals.add(normal.cast<double>(),
                      piece.positions.count / static_cast<double>(normals.size()));
  piece.hull = DirectionHulls().kDopOf(places, margin);
  piece.outline = outlineOf(places, margin);
  return piece;
}

/** Two pieces as they are described. */
struct PiecePair {
  Piece a, b;
  PieceContact contact{};
  double floor = 0;
  RoomColumns columns{};
  double touching_a = 0, touching_b = 0, contacts_a = 1, contacts_b = 1;

  JoiningFeatures
  features() const
  {
    PieceGraph graph;
    graph.voxel_size = pair_voxel_size;
    graph.floor = floor;
    graph.columns = columns;
    const PairDescription description(graph);
    const auto shape_a = description.shapeOf(a), shape_b = description.shapeOf(b);
    return description.describe({a, shape_a, touching_a, contacts_a},
                                {b, shape_b, touching_b, contacts_b},
                                contact);
  }
};

inline std::size_t
indexOf(const std::string& name)
{
  const auto& names = joiningFeatureNames();
  const auto found = std::find(names.begin(), names.end(), name);
  EXPECT_NE(found, names.end()) << name;
  return static_cast<std::size_t>(found - names.begin());
}

} // namespace test
} // namespace pcl::indoor
