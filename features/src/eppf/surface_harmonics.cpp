/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "eppf/harmonic_sums.h"
#include "eppf/soft_bin.h"

#include <pcl/features/pair_counting.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace pcl::indoor {

namespace {

constexpr double reach = 0.6;         // of the shells, in scales
constexpr double floor_value = 0.002; // see surfaceHarmonics()
constexpr double unit = 1048576.0;    // sums are integers of its reciprocal

/** \brief Points of a block, one array per quantity. */
struct HarmonicBlock {
  explicit HarmonicBlock(std::size_t point_count, const HarmonicBins& bins)
  : size(point_count)
  , directions(size, 3)
  , weights(Eigen::ArrayXXf::Zero(size, 3 * bins.shells))
  , functions(size, bins.functionCount())
  {}

  Eigen::Index size;
  Eigen::ArrayXXf directions; // x, y, z
  Eigen::ArrayXXf weights;    // of the axes of each shell
  Eigen::ArrayXXf functions;  // of the directions
};

/** \brief Real spherical harmonics of unit vectors, of which Y_00 = 1.
 *
 * Y_lm = q_lm(z) cos(m phi) sin^m(theta), where q_lm follows from q_{l-1,m} and
 * q_{l-2,m}, and sin^m(theta) exp(i m phi) = (x + i y)^m.
 */
void
findFunctions(int degree, HarmonicBlock& block)
{
  const auto x = block.directions.col(0);
  const auto y = block.directions.col(1);
  const auto z = block.directions.col(2);
  auto& functions = block.functions;
  Eigen::ArrayXf cosine = Eigen::ArrayXf::Ones(block.size);
  Eigen::ArrayXf sine = Eigen::ArrayXf::Zero(block.size);
  Eigen::ArrayXf one(block.size), two(block.size); // of degree l - 1 and l - 2
  double first = 1.0;                              // q_mm
  for (int m = 0; m <= degree; ++m) {
    if (m > 0) {
      const Eigen::ArrayXf next = x * cosine - y * sine;
      sine = x * sine + y * cosine;
      cosine = next;
      first *= m == 1 ? std::sqrt(3.0) : std::sqrt((2.0 * m + 1.0) / (2.0 * m));
    }
    two.setZero();
    one.setConstant(static_cast<float>(first));
    for (int l = m; l <= degree; ++l) {
      if (l > m) {
        const double square = static_cast<double>(l) * l;
        const double before = square - 2.0 * l + 1.0; // (l - 1)^2
        const double factor = std::sqrt((4.0 * square - 1.0) / (square - m * m));
        const double lower = std::sqrt((before - m * m) / (4.0 * before - 1.0));
        two = static_cast<float>(factor) * (z * one - static_cast<float>(lower) * two);
        one.swap(two);
      }
      functions.col(l * l + l + m) = one * cosine;
      if (m > 0)
        functions.col(l * l + l - m) = one * sine;
    }
  }
}

std::uint64_t
rounded(double value)
{
  return static_cast<std::uint64_t>(std::llround(unit * value));
}

} // namespace

HarmonicSums::HarmonicSums(const PrincipalFrame& frame,
                           double scale,
                           const HarmonicBins& bins)
: center_(frame.center.cast<float>())
, axes_(frame.axes.cast<float>())
, bins_(bins)
, shells_per_metre_(static_cast<float>(bins.shells / (reach * std::max(scale, 1e-30))))
, distances_per_metre_(
      static_cast<float>(bins.distances / (reach * std::max(scale, 1e-30))))
{}

void
HarmonicSums::add(const std::vector<OrientedPoint>& points,
                  std::size_t first,
                  std::size_t last,
                  std::uint64_t* sums) const
{
  HarmonicBlock block(last - first, bins_);
  std::vector<float> distances(bins_.distances);
  for (std::size_t k = first; k < last; ++k) {
    const auto row = static_cast<Eigen::Index>(k - first);
    const Eigen::Vector3f offset = axes_ * (points[k].position - center_);
    const Eigen::Vector3f normal = axes_ * points[k].normal;
    const float distance = offset.norm();
    block.directions.row(row) = offset / std::max(distance, 1e-30f);
    const auto soft = [distance](float per_metre, int count) {
      const auto last_bin = static_cast<float>(count);
      return SoftBin(std::min(distance * per_metre, last_bin), count, 1.0f);
    };
    if (bins_.shells > 0) {
      const auto shell = soft(shells_per_metre_, bins_.shells);
      for (int side = 0; side < 2; ++side)
        for (int axis = 0; axis < 3; ++axis)
          block.weights(row, 3 * shell.bin[side] + axis) +=
              shell.share[side] * normal[axis] * normal[axis];
    }
    if (bins_.distances > 0) {
      const auto near = soft(distances_per_metre_, bins_.distances);
      for (int side = 0; side < 2; ++side)
        distances[near.bin[side]] += near.share[side];
    }
  }
  findFunctions(bins_.degree, block);
  const auto function_count = static_cast<Eigen::Index>(bins_.functionCount());
  for (int shell = 0; shell < bins_.shells; ++shell) {
    const float* const a = &block.weights(0, 3 * shell);
    const float* const b = &block.weights(0, 3 * shell + 1);
    const float* const c = &block.weights(0, 3 * shell + 2);
    std::uint64_t* const own = sums + 4 * shell * function_count;
    for (Eigen::Index f = 0; f < function_count; ++f) {
      const float* const value = &block.functions(0, f);
      float along_a = 0.0f, along_b = 0.0f, along_c = 0.0f;
#pragma omp simd reduction(+ : along_a, along_b, along_c)
      for (Eigen::Index k = 0; k < block.size; ++k) {
        along_a += value[k] * a[k];
        along_b += value[k] * b[k];
        along_c += value[k] * c[k];
      }
      own[f] += rounded(along_a);
      own[function_count + f] += rounded(along_b);
      own[2 * function_count + f] += rounded(along_c);
    }
  }
  for (int k = 0; k < bins_.distances; ++k)
    sums[4 * bins_.shells * function_count + k] += rounded(distances[k]);
}

std::vector<double>
HarmonicSums::values(const std::uint64_t* sums, std::size_t point_count) const
{
  const auto value = [&](std::uint64_t sum) {
    return static_cast<double>(static_cast<std::int64_t>(sum)) /
           (unit * static_cast<double>(point_count));
  };
  std::vector<double> result(bins_.size());
  const std::size_t function_count = bins_.functionCount();
  const std::size_t coefficient_count = 4 * bins_.shells * function_count;
  for (std::size_t bin = 0; bin < bins_.size(); ++bin)
    result[bin] = value(sums[bin]);
  for (std::size_t bin = 0; bin < coefficient_count; ++bin)
    if (bin / function_count % 4 == 3)
      for (std::size_t axis = 1; axis <= 3; ++axis)
        result[bin] += result[bin - axis * function_count];
  double sum = 0.0;
  for (auto& bin : result) {
    bin = std::abs(bin) + floor_value;
    sum += bin;
  }
  for (auto& bin : result)
    bin /= sum;
  return result;
}

PrincipalFrame
principalFrame(const std::vector<OrientedPoint>& points, double middle_share)
{
  assert(!points.empty());
  const Eigen::Vector3d origin = points.front().position.cast<double>();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Vector3d squares = Eigen::Vector3d::Zero();
  Eigen::Vector3d products = Eigen::Vector3d::Zero(); // yz, zx, xy
  for (const auto& point : points) {
    const Eigen::Vector3d offset = point.position.cast<double>() - origin;
    const double x = offset.x(), y = offset.y(), z = offset.z();
    sum += offset;
    squares += Eigen::Vector3d(x * x, y * y, z * z);
    products += Eigen::Vector3d(y * z, z * x, x * y);
  }
  const auto count = static_cast<double>(points.size());
  Eigen::Matrix3d moment;
  moment << squares.x(), products.z(), products.y(), products.z(), squares.y(),
      products.x(), products.y(), products.x(), squares.z();
  moment -= sum * sum.transpose() / count;
  PrincipalFrame frame;
  frame.center = origin + sum / count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moment);
  frame.axes = solver.eigenvectors().rowwise().reverse().transpose(); // descending
  if (middle_share > 0.0) {
    const Eigen::Matrix3f axes = frame.axes.cast<float>();
    const Eigen::Vector3f center = frame.center.cast<float>();
    Eigen::Array3f lower = Eigen::Array3f::Zero(), upper = Eigen::Array3f::Zero();
    for (const auto& point : points) {
      const Eigen::Array3f place = (axes * (point.position - center)).array();
      lower = lower.min(place);
      upper = upper.max(place);
    }
    const Eigen::Vector3d middle = (lower + upper).matrix().cast<double>() / 2.0;
    frame.center += middle_share * (frame.axes.transpose() * middle);
  }
  return frame;
}

std::vector<double>
surfaceHarmonics(const std::vector<OrientedPoint>& points,
                 const PrincipalFrame& frame,
                 double scale,
                 const HarmonicBins& bins,
                 unsigned int number_of_threads)
{
  assert(!points.empty() && bins.size() > 0);
  const HarmonicSums harmonics(frame, scale, bins);
  constexpr std::size_t block_size = HarmonicSums::block_size;
  const auto sums =
      countBlocks(blockCount(points.size(), block_size),
                  bins.size(),
                  number_of_threads,
                  [&](std::size_t block, std::vector<std::uint64_t>& own) {
                    const auto [first, last] =
                        blockRange(block, points.size(), block_size);
                    harmonics.add(points, first, last, own.data());
                  });
  return harmonics.values(sums.data(), points.size());
}

} // namespace pcl::indoor
