/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "thesis/objects/lab_color.h"

#include <cmath>

namespace pcl {
namespace indoor {

Eigen::Vector3f
labOfRgb(const Eigen::Vector3f& rgb)
{
  const Eigen::Vector3d linear = (rgb.cast<double>() / 255).unaryExpr([](double c) {
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  });
  Eigen::Matrix3d to_xyz;
  to_xyz << 0.4124, 0.3576, 0.1805, //
      0.2126, 0.7152, 0.0722,       //
      0.0193, 0.1192, 0.9505;
  const Eigen::Vector3d white = to_xyz * Eigen::Vector3d::Ones();
  const Eigen::Vector3d f =
      (to_xyz * linear).cwiseQuotient(white).unaryExpr([](double t) {
        constexpr double d = 6.0 / 29;
        return t > d * d * d ? std::cbrt(t) : t / (3 * d * d) + 4.0 / 29;
      });
  return Eigen::Vector3d(116 * f.y() - 16, 500 * (f.x() - f.y()), 200 * (f.y() - f.z()))
      .cast<float>();
}

} // namespace indoor
} // namespace pcl
