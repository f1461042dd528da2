/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/hough_accumulator.h>

#include "normals/accumulator_options.h"

#include <pcl/exceptions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

/** Rings of bins around the pole; the last one ends at the equator. */
class Rings {
public:
  explicit Rings(double bin_angle)
  : height_(0.5 * M_PI / std::max(1.0, std::round(0.5 * M_PI / bin_angle)))
  {
    const auto count = static_cast<int>(std::round(0.5 * M_PI / height_));
    for (int ring = 0; ring < count; ++ring) {
      first_.push_back(bins_);
      const double middle = std::sin((ring + 0.5) * height_);
      sectors_.push_back(std::max(1, static_cast<int>(2 * M_PI * middle / bin_angle)));
      bins_ += sectors_.back();
    }
  }

  int
  bins() const
  {
    return bins_;
  }

  int
  binOf(Eigen::Vector3d direction) const
  {
    if (direction.z() < 0)
      direction *= -1;
    const double polar = std::acos(std::min(1.0, direction.z()));
    const auto ring =
        std::min(first_.size() - 1, static_cast<std::size_t>(polar / height_));
    const double turn = 0.5 + std::atan2(direction.y(), direction.x()) / (2 * M_PI);
    return first_[ring] +
           std::min(sectors_[ring] - 1, static_cast<int>(turn * sectors_[ring]));
  }

private:
  double height_; // radians
  int bins_ = 0;
  std::vector<int> first_, sectors_; // one per ring
};

/** Uniformly distributed (Shoemake's method), the same with every standard library. */
Eigen::Matrix3d
randomRotation(std::mt19937& rng)
{
  const auto uniform = [&] { return static_cast<double>(rng()) / 4294967296.0; };
  const double share = uniform(), a = 2 * M_PI * uniform(), b = 2 * M_PI * uniform();
  const double s = std::sqrt(1 - share), t = std::sqrt(share);
  return Eigen::Quaterniond(
             t * std::cos(b), s * std::sin(a), s * std::cos(a), t * std::sin(b))
      .toRotationMatrix();
}

} // namespace

namespace pcl::indoor {

HoughAccumulator::HoughAccumulator(double bin_angle_degrees,
                                   unsigned rotations,
                                   std::uint32_t seed)
: rotations_(rotations)
{
  OptionCheck check;
  checkAccumulator(check, bin_angle_degrees, rotations);
  if (!check.problem().empty())
    PCL_THROW_EXCEPTION(BadArgumentException, check.problem());
  const Rings rings(bin_angle_degrees * M_PI / 180);
  bin_count_ = static_cast<unsigned>(rings.bins());
  std::mt19937 rng(seed);
  std::vector<Eigen::Matrix3d> turns(rotations, Eigen::Matrix3d::Identity());
  for (unsigned copy = 1; copy < rotations; ++copy)
    turns[copy] = randomRotation(rng);

  constexpr double cells_per_bin = 8;
  const auto half = std::ceil(0.5 * cells_per_bin * 90 / bin_angle_degrees);
  half_ = static_cast<float>(half);
  stride_ = 2 * static_cast<std::size_t>(half) + 1;
  table_.reserve(stride_ * stride_ * rotations);
  for (std::size_t row = 0; row < stride_; ++row)
    for (std::size_t column = 0; column < stride_; ++column) {
      const double u = std::min((column + 0.5) / half - 1, 1.0);
      const double v = std::min((row + 0.5) / half - 1, 1.0);
      const double x = (u + v) / 2, y = (u - v) / 2;
      const Eigen::Vector3d direction(x, y, 1 - std::abs(x) - std::abs(y));
      for (const auto& turn : turns)
        table_.push_back(
            static_cast<std::uint16_t>(rings.binOf(turn * direction.normalized())));
    }
}

} // namespace pcl::indoor
