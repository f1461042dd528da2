/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/graph/surface_graph.h"
#include "objects/graph/surface_voxels.h"
#include "objects/join/direction_hull.h"
#include "objects/join/outline_kdop.h"
#include "objects/join/piece_frame.h"
#include "objects/join/room_columns.h"
#include "objects/structure/object_scene.h"
#include "objects/vector_moments.h"

#include <pcl/indoor/voxel_classes.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** \brief What the voxels of a piece were taken for. */
struct PieceVotes {
  std::vector<double> classes; ///< of each, the sum of the probabilities of its voxels
  VectorMoments middles;       ///< of the objects its voxels are part of, metres

  PieceVotes&
  operator+=(const PieceVotes& other);
};

/** \brief What is known of a connected piece of surface, or of several that were
 * joined. Two of them can be added. In a PieceFrame: z is up. */
struct Piece {
  VectorMoments positions; ///< of its voxels, metres
  VectorMoments normals;   ///< of its voxels, unit vectors
  KDop50 hull{};
  KDop16 outline{};
  double parts = 1; ///< pieces that were joined
  PieceVotes votes; ///< empty if nobody voted

  Piece&
  operator+=(const Piece& other);
};

/** \brief How two pieces touch, or nearly touch. Contacts can be added: sums of all
 * values, and the smaller of the two gaps. */
struct PieceContact {
  std::uint32_t first = 0, second = 0; ///< the pieces
  double first_voxels = 0;             ///< voxels of the first that touch the second
  double second_voxels = 0;
  VectorMoments places; ///< of pairs of voxels that touch, metres
  double bends = 0;     ///< touching pairs of supervoxels, see bendDegrees()
  double bend_sum = 0, bend_squares = 0, concave_bends = 0;
  double gap = 0;          ///< least distance of the pieces' cells, metres
  double near_cells = 0;   ///< pairs of cells, three voxels wide, that are near
  double near_in_line = 0; ///< of them, those that lie in each other's tangent plane

  /** \brief Add another between the same pieces. */
  PieceContact&
  operator+=(const PieceContact& other);
};

/** \brief Pieces of a scanned room and all pairs of them that are near. */
struct PieceGraph {
  double voxel_size = 0;  ///< metres
  double floor = 0;       ///< height of the floor, metres
  RoomColumns columns;    ///< of all voxels, also those of planes
  bool has_votes = false; ///< of VoxelClasses
  std::vector<Piece> pieces;
  std::vector<PieceContact> contacts; ///< first < second, ascending
};

/** \brief What pieces are made of. */
struct PieceSurface {
  const ObjectScene& scene;
  /** 0 ... piece_count - 1; those of planes are not looked at */
  const std::vector<std::uint32_t>& piece_of_voxel;
  std::uint32_t piece_count = 0;
  const Supervoxels& supervoxels;
  const std::vector<SurfaceEdge>& edges; ///< between supervoxels
  const VoxelClasses& votes;             ///< of the points; empty if nobody voted
};

/** \brief Describe the pieces of a room and their contacts. Pieces touch where their
 * voxels are neighbours, and are near where they are at most about six voxels apart.
 * Floor, ceiling and walls have no contacts. The cost is linear in the number of
 * voxels.
 */
PieceGraph
pieceGraph(const PieceSurface& surface, const PieceFrame& frame);

} // namespace pcl::indoor
