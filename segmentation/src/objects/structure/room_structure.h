/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/graph/surface_voxels.h"

#include <pcl/segmentation/object_segmentation.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace pcl::indoor {

/** Voxels from a surface within which what is seen may be the same surface: its points
 * and normals are noisy, and scans are misregistered. */
constexpr int near_surface_voxels = 2;

/** Voxels within which it is taken for the same: a voxel, and half of one for noise. */
constexpr double same_surface_voxels = 1.5;

/** \brief A plane around a room. */
struct StructurePlane {
  Eigen::Vector3d normal;            ///< unit length, into the room
  double offset = 0;                 ///< normal * x = offset for x in the plane
  std::vector<std::uint32_t> voxels; ///< that it was fitted to

  /** \brief Get the signed distance, positive on the side of the room. */
  double
  heightOf(const Eigen::Vector3d& position) const
  {
    return normal.dot(position) - offset;
  }
};

/** \brief Tell whether two unit normals are at right angles, give or take 17 degrees.
 */
inline bool
areAcross(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::abs(a.dot(b)) < 0.3;
}

/** \brief Tell floor and ceiling, up to 45 degrees from level, from walls.
 * \param[in] up against gravity, unit length */
StructureKind
kindOf(const StructurePlane& plane, const Eigen::Vector3f& up);

/** \brief Find the planes that enclose a room: floor, ceiling and walls.
 *
 * Flat regions are grown over touching voxels, and those in one plane put together. A
 * plane belongs to the structure
 * - if it reaches from one side of the room to the other, at least 1.5 m, and nothing
 *   was seen behind it. A desk is none, as the floor lies behind it; nor is a cabinet's
 *   front, which is lower than the room;
 * - if it is level and at most 5 cm above the lowest such plane of 0.5 m^2 with nothing
 *   below it, or has 0.5 m^2, nothing below it, and goes on with one that is a floor. A
 *   floor is found in parts and between furniture, and one that drifts;
 * - if it stands upright, has 1.5 m^2, is at least 0.7 times as high as all that was
 *   seen, of which at most 10 % lie behind it, and nothing right behind it: a part of a
 *   wall, unless it lies up to 0.4 m behind a larger plane, as a door in its recess.
 *
 * All but floors have at least 2 % of the voxels.
 *
 * A plane that reaches so in both directions, as floors and ceilings do, may be shorter
 * than 1.5 m, and what lies up to 0.3 m behind it does not count: another layer, or the
 * roof. One that lies along none of the room's three directions must reach so along all
 * of them. What a camera sees of a room ends anywhere: there, a plane also belongs to
 * the structure if at least 90 % of all that is seen lies before it.
 *
 * The cost is linear in the number of voxels, but for comparing flat regions with each
 * other.
 * \param[in] voxels with normals, most of them into the room, and curvatures
 * \param[in] voxel_size of the voxels, metres
 * \param[in] up against gravity, unit length
 * \param[in] capture whether it is a camera's view
 * \return the largest plane first; may be empty
 */
std::vector<StructurePlane>
findRoomStructure(const SurfaceVoxels& voxels,
                  double voxel_size,
                  const Eigen::Vector3f& up = Eigen::Vector3f::UnitZ(),
                  Capture capture = Capture::Scan);

/** \brief Get three orthogonal directions that fit the planes: the normals of the first
 * and of the next that is orthogonal to it.
 * \return one direction per column; the axes if there are no planes
 */
Eigen::Matrix3d
axesOf(const std::vector<StructurePlane>& planes);

/** \brief Tell which points lie in the planes of the structure.
 * The tolerance of a plane follows from the deviations of its own points, and is at
 * most one voxel: what is flat against a wall stays apart from it if the noise allows.
 * \param[in] points that the voxels were made of
 * \return the number of its plane, from 1, for each point; 0 for all others
 */
std::vector<std::uint32_t>
pointsOfStructure(const std::vector<Eigen::Vector3f>& points,
                  const SurfaceVoxels& voxels,
                  const std::vector<StructurePlane>& planes,
                  double voxel_size);

/** \brief Gather points into voxels that hold points of one plane only.
 * Voxels of different planes, and those of the planes and of other points, are no
 * neighbours.
 * \param[in] plane_of_point as given by pointsOfStructure()
 * \param[out] plane_of_voxel the same per voxel
 */
SurfaceVoxels
separateVoxels(const std::vector<Eigen::Vector3f>& points,
               const std::vector<std::uint32_t>& plane_of_point,
               double voxel_size,
               std::vector<std::uint32_t>& plane_of_voxel);

} // namespace pcl::indoor
