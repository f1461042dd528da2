/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/dominant_directions.h"

#include "rooms/space/sphere_modes.h"

#include <pcl/exceptions.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::indoor {

namespace {

constexpr double axis_cone = 0.14; // radius of the neighbourhood of an axis whose
                                   // normals support it, radians; larger for noisier
                                   // normals, which then tells frames apart less well
constexpr double frame_support = 0.02; // share of all weight that a frame explains and
                                       // no stronger one does
constexpr double axis_contrast = 1.5;  // the normals around an axis are so many times
                                       // denser than those in the ring around them: a
                                       // curved wall has no axis

void
requireValid(const std::vector<Eigen::Vector3d>& normals,
             const std::vector<double>& weights)
{
  if (!weights.empty() && weights.size() != normals.size())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        weights.size()
                            << " weights do not fit " << normals.size() << " normals.");
  for (const double weight : weights)
    if (!(weight >= 0.0) || !std::isfinite(weight))
      PCL_THROW_EXCEPTION(BadArgumentException,
                          "A weight must not be negative, not " << weight << ".");
}

bool
isNearAxis(const Eigen::Matrix3d& axes, const Eigen::Vector3d& direction, double cosine)
{
  return (axes.transpose() * direction).cwiseAbs().maxCoeff() >= cosine;
}

/** \brief The frame of two nearly orthogonal directions, the first of which counts. */
Eigen::Matrix3d
frameOf(const Eigen::Vector3d& first, const Eigen::Vector3d& second)
{
  Eigen::Matrix3d axes;
  axes.col(0) = first;
  axes.col(1) = (second - first * first.dot(second)).normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

/** \brief All frames that modes suggest: by pairs at right angles, and by single modes,
 * which are completed by the vertical.
 */
std::vector<Eigen::Matrix3d>
candidateFrames(const std::vector<WeightedDirection>& modes, double tolerance)
{
  std::vector<Eigen::Matrix3d> candidates;
  for (const auto& first : modes) {
    const Eigen::Vector3d upright = std::abs(first.direction.z()) < 0.9
                                        ? Eigen::Vector3d::UnitZ()
                                        : Eigen::Vector3d::UnitX();
    candidates.push_back(frameOf(first.direction, upright));
    for (const auto& second : modes)
      if (std::abs(second.direction.dot(first.direction)) <= std::sin(tolerance))
        candidates.push_back(frameOf(first.direction, second.direction));
  }
  return candidates;
}

/** \brief How well a frame explains modes, some of which are not explained yet. The
 * more axes have a mode, the better: two strong modes of different frames may be at
 * right angles by chance, three are not.
 */
double
fit(const Eigen::Matrix3d& axes,
    const std::vector<WeightedDirection>& modes,
    const std::vector<char>& explained,
    double tolerance)
{
  double sum = 0.0;
  int axes_with_mode = 0;
  bool explains_more = false;
  for (int axis = 0; axis < 3; ++axis) {
    double best = 0.0;
    for (std::size_t m = 0; m < modes.size(); ++m) {
      const double dot = std::abs(modes[m].direction.dot(axes.col(axis)));
      const double deviation = std::acos(std::min(1.0, dot)) / tolerance;
      if (deviation >= 1.0)
        continue;
      best = std::max(best, modes[m].weight * (1.0 - deviation * deviation));
      explains_more = explains_more || !explained[m];
    }
    sum += best;
    axes_with_mode += best > 0.0;
  }
  return explains_more ? sum * axes_with_mode : 0.0;
}

/** \brief Weight near a frame's axes and not near the axes of the frames before it. */
double
ownSupport(const std::vector<WeightedDirection>& histogram,
           const std::vector<ManhattanFrame>& frames,
           std::size_t frame,
           double cosine)
{
  double support = 0.0;
  for (const auto& bin : histogram) {
    if (!isNearAxis(frames[frame].axes, bin.direction, cosine))
      continue;
    const bool taken =
        std::any_of(frames.begin(), frames.begin() + frame, [&](const auto& other) {
          return isNearAxis(other.axes, bin.direction, cosine);
        });
    support += taken ? 0.0 : bin.weight;
  }
  return support;
}

/** \brief Take the best candidate in turn, until nothing is left to explain. */
std::vector<ManhattanFrame>
framesOfModes(const std::vector<WeightedDirection>& histogram,
              const std::vector<WeightedDirection>& modes)
{
  const double tolerance = axis_cone / 2.0; // modes are known better than normals
  const auto candidates = candidateFrames(modes, tolerance);
  std::vector<char> explained(modes.size(), 0);
  std::vector<ManhattanFrame> frames;
  for (;;) {
    double best = 0.0;
    ManhattanFrame frame;
    for (const auto& axes : candidates) {
      const double quality = fit(axes, modes, explained, tolerance);
      if (quality > best) {
        best = quality;
        frame.axes = axes;
      }
    }
    if (best == 0.0)
      return frames;
    const double cosine = std::cos(axis_cone);
    for (std::size_t m = 0; m < modes.size(); ++m)
      explained[m] |= isNearAxis(frame.axes, modes[m].direction, cosine);
    frames.push_back(frame);
    if (ownSupport(histogram, frames, frames.size() - 1, cosine) < frame_support)
      frames.pop_back();
  }
}

/** \brief The rotation closest to the normals near a frame's axes; normals that are
 * closer to an axis of another frame do not count, unless both share this axis.
 */
Eigen::Matrix3d
refined(const std::vector<WeightedDirection>& histogram,
        const std::vector<ManhattanFrame>& frames,
        std::size_t frame,
        double cone)
{
  const double cosine = std::cos(cone);
  const double shared = std::cos(cone / 2.0);
  const Eigen::Matrix3d& axes = frames[frame].axes;
  Eigen::Matrix3d sums = Eigen::Matrix3d::Zero();
  for (const auto& bin : histogram) {
    const Eigen::Vector3d dots = axes.transpose() * bin.direction;
    int axis = 0;
    const double dot = dots.cwiseAbs().maxCoeff(&axis);
    if (dot < cosine)
      continue;
    bool elsewhere = false;
    for (const auto& other : frames) {
      int other_axis = 0;
      const double other_dot =
          (other.axes.transpose() * bin.direction).cwiseAbs().maxCoeff(&other_axis);
      elsewhere = elsewhere ||
                  (other_dot > dot &&
                   std::abs(other.axes.col(other_axis).dot(axes.col(axis))) < shared);
    }
    if (!elsewhere)
      sums.col(axis) += (dots[axis] < 0.0 ? -bin.weight : bin.weight) * bin.direction;
  }
  // The rotation R that maximises trace(R' * sums); axes without normals follow.
  for (int axis = 0; axis < 3; ++axis)
    sums.col(axis) += 1e-9 * axes.col(axis);
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(
      sums, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0.0)
    u.col(2) = -u.col(2);
  return u * svd.matrixV().transpose();
}

void
refineAll(const std::vector<WeightedDirection>& histogram,
          double cone,
          std::vector<ManhattanFrame>& frames)
{
  for (int turn = 0; turn < 20; ++turn) {
    double change = 0.0;
    for (std::size_t f = 0; f < frames.size(); ++f) {
      const Eigen::Matrix3d axes = refined(histogram, frames, f, cone);
      change = std::max(change, (axes - frames[f].axes).norm());
      frames[f].axes = axes;
    }
    if (change < 1e-6)
      return;
  }
}

/** \brief Sort by all support, count each normal for the strongest frame that explains
 * it, and drop the frames that have too few of their own.
 */
void
rank(const std::vector<WeightedDirection>& histogram,
     std::vector<ManhattanFrame>& frames)
{
  const double cosine = std::cos(axis_cone);
  for (auto& frame : frames) {
    frame.axis_support.setZero();
    for (const auto& bin : histogram) {
      int axis = 0;
      if ((frame.axes.transpose() * bin.direction).cwiseAbs().maxCoeff(&axis) >= cosine)
        frame.axis_support[axis] += bin.weight;
    }
  }
  std::stable_sort(frames.begin(), frames.end(), [](const auto& a, const auto& b) {
    return a.axis_support.sum() > b.axis_support.sum();
  });
  for (std::size_t f = 0; f < frames.size();) {
    frames[f].support = ownSupport(histogram, frames, f, cosine);
    if (frames[f].support < frame_support)
      frames.erase(frames.begin() + f);
    else
      ++f;
  }
  std::stable_sort(frames.begin(), frames.end(), [](const auto& a, const auto& b) {
    return a.support > b.support;
  });
}

/** \brief The horizontal axes of a frame; at right angles, the stronger one first. */
std::vector<HorizontalDirection>
horizontalPair(const ManhattanFrame& frame)
{
  constexpr double max_tilt = 0.17; // radians; the axes of roofs lean more
  std::vector<HorizontalDirection> pair;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(frame.axes(2, axis)) <= std::sin(max_tilt))
      pair.push_back(
          {frame.axes.col(axis).head<2>().normalized(), frame.axis_support[axis]});
  std::stable_sort(pair.begin(), pair.end(), [](const auto& a, const auto& b) {
    return a.support > b.support;
  });
  if (pair.empty())
    return pair;
  pair.resize(2, {Eigen::Vector2d::Zero(), 0.0});
  pair[1].direction = {-pair[0].direction.y(), pair[0].direction.x()};
  for (auto& direction : pair) {
    const double x = direction.direction.x();
    if (x < 0.0 || (x == 0.0 && direction.direction.y() < 0.0))
      direction.direction = -direction.direction;
  }
  return pair;
}

} // namespace

std::vector<ManhattanFrame>
manhattanFrames(const std::vector<Eigen::Vector3d>& normals,
                const std::vector<double>& weights)
{
  requireValid(normals, weights);
  const auto histogram = sphereHistogram(normals, weights);
  const auto modes =
      sphereModes(histogram, axis_cone, frame_support / 4.0, axis_contrast);
  auto frames = framesOfModes(histogram, modes);
  refineAll(histogram, axis_cone, frames);
  rank(histogram, frames);
  return frames;
}

std::vector<HorizontalDirection>
horizontalDirections(const std::vector<ManhattanFrame>& frames)
{
  std::vector<std::vector<HorizontalDirection>> pairs;
  for (const auto& frame : frames) {
    pairs.push_back(horizontalPair(frame));
    if (pairs.back().empty())
      pairs.pop_back();
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) {
    return a[0].support + a[1].support > b[0].support + b[1].support;
  });
  std::vector<HorizontalDirection> directions;
  for (const auto& pair : pairs) {
    const bool known =
        std::any_of(directions.begin(), directions.end(), [&](const auto& other) {
          return std::abs(other.direction.dot(pair[0].direction)) >=
                 std::cos(same_direction);
        });
    if (!known)
      directions.insert(directions.end(), pair.begin(), pair.end());
  }
  if (directions.empty())
    directions = {{Eigen::Vector2d::UnitX(), 0.0}, {Eigen::Vector2d::UnitY(), 0.0}};
  return directions;
}

} // namespace pcl::indoor
