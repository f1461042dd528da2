/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scanner/path_drift.h"

#include "scanner/ray_echo.h" // for typical_range

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

PathDrift::PathDrift(const CarriedPath& path, double drift, RandomDraw draw)
: errors_(path.size())
{
  constexpr double reference_way = 10.0; // metres
  const Eigen::Vector4d scale(drift, drift, 0.5 * drift, drift / typical_range);
  std::vector<Eigen::Vector4d> walk(path.size(), Eigen::Vector4d::Zero());
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double root = std::sqrt((path[i].way - path[i - 1].way) / reference_way);
    walk[i] = walk[i - 1];
    for (int k = 0; k < 4; ++k)
      walk[i][k] += root * scale[k] * draw.gaussian();
  }
  const double length = path.back().way;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double share = length > 0 ? path[i].way / length : 0.0;
    const Eigen::Vector4d left = walk[i] - share * walk.back();
    errors_[i] = {left.head<3>(), left[3]};
  }
  if (path.size() > 1)
    step_ = path[1].time - path[0].time;
}

PoseError
PathDrift::at(double time) const
{
  const double last = static_cast<double>(errors_.size() - 1);
  const double index = std::max(0.0, std::min(last, time / step_));
  const auto i = static_cast<std::size_t>(index);
  const auto j = std::min(i + 1, errors_.size() - 1);
  const double share = index - static_cast<double>(i);
  const PoseError &a = errors_[i], &b = errors_[j];
  return {a.shift + share * (b.shift - a.shift), a.turn + share * (b.turn - a.turn)};
}

} // namespace pcl::indoor
