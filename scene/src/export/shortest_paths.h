/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstddef>
#include <vector>

namespace pcl::indoor::tool {

/** \brief A line of a graph that is passed in both directions. */
struct WeightedLine {
  std::size_t a = 0, b = 0; ///< points
  double length = 0.0;
};

/** \brief The shortest paths from one point of a graph. */
struct PathsFrom {
  std::vector<double> lengths;       ///< to each point; infinite if there is no path
  std::vector<std::size_t> previous; ///< point on the path to each; itself at the start

  /** \brief The points of the path to one, from the start on; empty if there is none.
   */
  std::vector<std::size_t>
  to(std::size_t point) const;
};

/** \brief Shortest paths in a graph, by Dijkstra. */
class ShortestPaths {
public:
  ShortestPaths(std::size_t point_count, const std::vector<WeightedLine>& lines);

  /** \brief Of paths of the same length, that over the points of smaller numbers. */
  PathsFrom
  from(std::size_t start) const;

private:
  struct Way {
    std::size_t to;
    double length;
  };

  std::vector<std::vector<Way>> ways_;
};

} // namespace pcl::indoor::tool
