/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::indoor {

/** \brief A cube around all but the outermost hundredths of some points, cut into cells
 * that hold some points where there is a surface. */
struct SampleCells {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double edge = 0.0; ///< of the cube; 0 = all points lie at one place
  double size = 0.0; ///< of a cell

  bool
  contains(const Eigen::Vector3f& point) const;

  /** \brief The place of a point along an axis in cells of a size. REQUIRES:
   * contains().
   */
  std::uint64_t
  place(const Eigen::Vector3f& point, int axis, double cell_size) const;
};

/** \brief A piece of surface that fills a cube of two by two by two cells. */
struct SurfacePiece {
  Eigen::Vector3d normal; ///< unit length, of either sign
  Eigen::Vector3d place;
};

/** \brief Free space between two points of a column of cells. */
struct Gap {
  std::uint64_t column = 0; ///< its places along x and y, 32 bits each
  float low = 0.0f, high = 0.0f;
};

/** \brief So many points tell what holds for most of a scan. */
constexpr std::size_t sample_size = 15000;

/** \brief Some sample_size points, chosen by the bits of their coordinates: the same in
 * any order; sorted. */
std::vector<Eigen::Vector3f>
samplePoints(const std::vector<Eigen::Vector3f>& points);

/** \brief The cells around points that are sampled as others whose cells are known. */
SampleCells
cubeAround(const std::vector<Eigen::Vector3f>& sample, double cell_size);

/** \brief Cells that hold some points where there is a surface; of size 0 if all points
 * lie at one place. */
SampleCells
cellsOf(const std::vector<Eigen::Vector3f>& sample);

std::vector<SurfacePiece>
surfacePieces(const std::vector<Eigen::Vector3f>& sample, const SampleCells& cells);

/** \brief The free space of columns of cells along z. */
struct FreeSpace {
  std::vector<Gap> gaps; ///< longer than two cells, by column and from below
  std::size_t columns = 0;
  double cell_size = 0.0; ///< width of the columns

  /** \brief The length of which half of the free space of the columns has at least as
   * much: the height of rooms if z points up; 0 = not known. */
  double
  length() const;
};

FreeSpace
freeSpaceOf(const std::vector<Eigen::Vector3f>& sample, const SampleCells& cells);

} // namespace pcl::indoor
