/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/structure/camera_view.h"

#include "objects/graph/surface_voxels.h"

#include <pcl/indoor/quantile.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>
#include <utility>

namespace {

using Points = std::vector<Eigen::Vector3f>;

constexpr double least_in_front = 0.99; // share of a camera's points
constexpr double middle = 10;           // degrees: what the camera looks at
constexpr float always_table = 1.4f;    // metres, half of the points in the middle
constexpr float never_table = 2.0f;     // metres: noise hides small objects
constexpr double around_middle = 15;    // degrees: where small objects are looked for
constexpr double share_of_small = 0.55; // of the voxels around the middle
constexpr int rounds = 5;               // with each tolerance

bool
isWithin(const Eigen::Vector3f& ray, double degrees)
{
  return ray.z() > 0 &&
         ray.head<2>().norm() <= std::tan(degrees * M_PI / 180) * ray.z();
}

/** Whether most of what a camera looks at is too small for the voxels of a room: its
 * surface bends within them. */
bool
seesSmallObjects(const Points& points, const Eigen::Vector3f& camera)
{
  const auto of_rooms =
      pcl::indoor::withSizes(pcl::indoor::ObjectSegmentationOptions());
  const float bent = of_rooms.curvature_threshold;
  Points around;
  for (const auto& point : points)
    if (isWithin(point - camera, around_middle))
      around.push_back(point);
  auto voxels = pcl::indoor::surfaceVoxels(around, {}, of_rooms.voxel_size);
  pcl::indoor::estimateNormals(around, voxels, 1);
  const auto small =
      std::count_if(voxels.curvatures.begin(),
                    voxels.curvatures.end(),
                    [bent](float curvature) { return curvature > bent; });
  return static_cast<double>(small) >
         share_of_small * static_cast<double>(voxels.curvatures.size());
}

/** The columns, or rows, of an image as they are found in the slopes of its rays. */
struct PixelLines {
  double frequency = 0; ///< lines per unit of slope: the focal length, pixels
  double phase = 0;     ///< of a line, in lines
  /** The length of the mean of exp(2 pi i f s): 1 if all slopes s are multiples of one
   * step 1 / f, and next to nothing if they are anywhere. */
  double strength = 0;

  std::int64_t
  lineOf(double slope) const
  {
    return std::llround(frequency * slope - phase);
  }
};

PixelLines
pixelLines(const std::vector<double>& places)
{
  PixelLines lines;
  constexpr double lowest = 50, highest = 3000, step = 0.25; // pixels: focal lengths
  std::vector<std::complex<double>> phases, turns;
  for (const double place : places) {
    phases.push_back(std::polar(1.0, 2 * M_PI * lowest * place));
    turns.push_back(std::polar(1.0, 2 * M_PI * step * place));
  }
  for (double f = lowest; f < highest && !places.empty(); f += step) {
    std::complex<double> sum = 0;
    for (std::size_t i = 0; i < phases.size(); ++i)
      sum += phases[i] *= turns[i];
    const double strength = std::abs(sum) / static_cast<double>(places.size());
    if (strength > lines.strength)
      lines = {f + step, std::arg(sum) / (2 * M_PI), strength};
  }
  return lines;
}

/** The share of the points whose pixel another one has, too: in a scan from all sides
 * objects stand behind each other. */
double
shareInSamePixels(const Points& points,
                  const Eigen::Vector3f& camera,
                  const PixelLines& columns,
                  const PixelLines& rows)
{
  std::vector<std::pair<std::int64_t, std::int64_t>> pixels;
  for (const auto& point : points) {
    const Eigen::Vector3d ray = (point - camera).cast<double>();
    if (std::abs(ray.z()) > 0)
      pixels.emplace_back(columns.lineOf(ray.x() / std::abs(ray.z())),
                          rows.lineOf(ray.y() / std::abs(ray.z())));
  }
  std::sort(pixels.begin(), pixels.end());
  const auto distinct = std::unique(pixels.begin(), pixels.end()) - pixels.begin();
  return pixels.empty()
             ? 1
             : 1 - static_cast<double>(distinct) / static_cast<double>(pixels.size());
}

/** The direction to which normals near it are most parallel, and those across it most
 * across. */
Eigen::Vector3d
turned(const Eigen::Vector3d& up,
       const std::vector<Eigen::Vector3f>& normals,
       double tolerance)
{
  const double parallel = std::cos(tolerance), across = std::sin(tolerance);
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const auto& n : normals) {
    const Eigen::Vector3d normal = n.cast<double>();
    const double cosine = std::abs(normal.dot(up));
    if (cosine > parallel)
      scatter -= normal * normal.transpose();
    else if (cosine < across)
      scatter += normal * normal.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  const Eigen::Vector3d best = solver.eigenvectors().col(0);
  return best.dot(up) < 0 ? Eigen::Vector3d(-best) : best;
}

} // namespace

namespace pcl::indoor {

Capture
captureOf(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& camera)
{
  const auto in_front =
      std::count_if(points.begin(), points.end(), [&camera](const auto& point) {
        return isWithin(point - camera, pcl::indoor::widest_view);
      });
  if (points.empty() || static_cast<double>(in_front) <
                            least_in_front * static_cast<double>(points.size()))
    return Capture::Scan;
  const float distance = distanceInMiddle(points, camera);
  const bool is_table = distance <= always_table ||
                        (distance <= never_table && seesSmallObjects(points, camera));
  return is_table ? Capture::TableView : Capture::RoomView;
}

bool
arePixels(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& camera)
{
  constexpr std::size_t enough = 1000; // chance gives a periodicity of 0.1 then
  constexpr double least_strength = 0.3;
  constexpr double most_in_same = 0.05; // a view has one point a pixel
  if (points.size() < enough)
    return false;
  std::vector<double> columns, rows;
  for (std::size_t i = 0; i < enough; ++i) {
    const Eigen::Vector3d ray =
        (points[i * points.size() / enough] - camera).cast<double>();
    if (!(std::abs(ray.z()) > 0))
      continue;
    columns.push_back(ray.x() / std::abs(ray.z()));
    rows.push_back(ray.y() / std::abs(ray.z()));
  }
  const auto column_lines = pixelLines(columns), row_lines = pixelLines(rows);
  return column_lines.strength > least_strength &&
         row_lines.strength > least_strength &&
         shareInSamePixels(points, camera, column_lines, row_lines) < most_in_same;
}

CameraView
cameraView(const std::vector<Eigen::Vector3f>& points,
           const Eigen::Vector3f& camera,
           bool is_organized)
{
  CameraView view;
  view.capture = captureOf(points, camera);
  if (view.capture == Capture::Scan && areBehind(points, camera)) {
    view.is_turned = true;
    Points turned_points;
    turned_points.reserve(points.size());
    for (const auto& point : points)
      turned_points.push_back(halfTurned(point));
    view.capture = captureOf(turned_points, halfTurned(camera));
  }
  if (view.capture == Capture::Scan || (!is_organized && !arePixels(points, camera)))
    return {};
  return view;
}

bool
areBehind(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& camera)
{
  const auto behind =
      std::count_if(points.begin(), points.end(), [&camera](const auto& point) {
        return point.z() < camera.z();
      });
  return 2 * static_cast<std::size_t>(behind) > points.size();
}

float
distanceInMiddle(const std::vector<Eigen::Vector3f>& points,
                 const Eigen::Vector3f& camera)
{
  std::vector<float> depths;
  for (const auto& point : points)
    if (isWithin(point - camera, middle))
      depths.push_back(point.z() - camera.z());
  return depths.empty() ? std::numeric_limits<float>::quiet_NaN() : median(depths);
}

Eigen::Vector3f
upOfView(const std::vector<Eigen::Vector3f>& normals)
{
  Eigen::Vector3d up = -Eigen::Vector3d::UnitY();
  std::vector<Eigen::Vector3f> usable;
  for (const auto& normal : normals)
    if (normal.squaredNorm() > 0.5f)
      usable.push_back(normal);
  if (usable.empty())
    return up.cast<float>();
  for (const double degrees : {45, 15})
    for (int round = 0; round < rounds; ++round)
      up = turned(up, usable, degrees * M_PI / 180);
  return up.normalized().cast<float>();
}

} // namespace pcl::indoor
