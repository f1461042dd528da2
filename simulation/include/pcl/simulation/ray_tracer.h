/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <Eigen/Core>

#include <vector>

#include <cstdint>
#include <limits>

namespace pcl::indoor {

/** \brief A triangle; its normal (b - a) x (c - a) points out of the solid. */
struct Triangle {
  Eigen::Vector3f a, b, c;
};

/** \brief Where a ray first meets a triangle. */
struct RayHit {
  float distance = std::numeric_limits<float>::infinity(); ///< in lengths of direction
  int triangle = -1;                                       ///< -1: nothing was hit
};

/** \brief Finds the first triangle along a ray, by a hierarchy of bounding boxes.
 *
 * The hierarchy has four children per node and is split by the surface area heuristic;
 * a ray costs about the logarithm of the number of triangles. Both sides of a triangle
 * stop a ray. Tracing does not change the object: any number of threads may trace.
 */
class PCL_INDOOR_EXPORTS RayTracer {
public:
  /** \param[in] triangles in metres; none is fine: then nothing is ever hit */
  explicit RayTracer(const std::vector<Triangle>& triangles);

  /** \brief Find the nearest triangle.
   * \param[in] origin start of the ray
   * \param[in] direction need not be a unit vector, but must not be zero
   * \param[in] min_distance nearer hits do not count, in lengths of \a direction
   * \param[in] max_distance farther hits do not count, in lengths of \a direction
   * \return the nearest hit; of equally near triangles the one with the smallest number
   */
  RayHit
  trace(const Eigen::Vector3f& origin,
        const Eigen::Vector3f& direction,
        float min_distance = 0.0f,
        float max_distance = std::numeric_limits<float>::infinity()) const;

private:
  static constexpr int width = 4;

  struct Node {            // children side by side, so that one test serves four
    float lower[3][width]; // an empty child has lower > upper
    float upper[3][width];
    std::int32_t child[width]; // inner: node number
    std::int32_t count[width]; // leaf: number of triangles from child on; inner: 0
  };

  struct PackedTriangle {
    float corner[3], edge_b[3], edge_c[3];
    std::int32_t number;
  };

  struct Builder;

  std::vector<Node> nodes_;
  std::vector<PackedTriangle> triangles_;
};

/** \brief Distance along a ray to one triangle (Moeller and Trumbore), or infinity. */
PCL_INDOOR_EXPORTS float
intersect(const Eigen::Vector3f& origin,
          const Eigen::Vector3f& direction,
          const Triangle& triangle);

} // namespace pcl::indoor
