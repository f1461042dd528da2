/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scanner/depth_sensor.h"

#include "scanner/option_check.h"

#include <pcl/simulation/random_draw.h>

#include <Eigen/Geometry>

#include <cmath>

namespace pcl::indoor {

namespace {

void
requireLegal(const DepthCameraOptions& o)
{
  requireOption(o.width >= 1, "width", o.width, "at least 1");
  requireOption(o.height >= 1, "height", o.height, "at least 1");
  requireOption(o.focal_length > 0, "focal_length", o.focal_length, "positive");
  requireOption(o.baseline > 0, "baseline", o.baseline, "positive");
  requireOption(o.noise >= 0, "noise", o.noise, "at least 0 pixels");
  requireOption(o.step > 0, "step", o.step, "positive");
  requireOption(o.min_range >= 0, "min_range", o.min_range, "at least 0 m");
  requireOption(o.max_range > o.min_range, "max_range", o.max_range, "above min_range");
  requireOption(o.patch >= 1, "patch", o.patch, "at least 1 pixel");
  requireOption(o.distortion >= 0, "distortion", o.distortion, "at least 0 pixels");
  requireOption(o.edge_noise >= 0, "edge_noise", o.edge_noise, "at least 0 pixels");
  const auto requireShare = [](double share, const char* name) {
    requireOption(share >= 0 && share <= 1, name, share, "from 0 to 1");
  };
  requireShare(o.least_cosine, "least_cosine");
  requireShare(o.mixed, "mixed");
  requireShare(o.dark, "dark");
}

/** Errors that change smoothly from pixel to pixel, with standard deviation 1. */
class PatchNoise {
public:
  PatchNoise(int width, int height, int patch, RandomDraw draw)
  : patch_(patch)
  , nodes_(height / patch + 2, width / patch + 2)
  {
    for (Eigen::Index i = 0; i < nodes_.size(); ++i)
      nodes_(i) = draw.gaussian();
  }

  double
  at(int u, int v) const
  {
    const double x = static_cast<double>(u % patch_) / patch_,
                 y = static_cast<double>(v % patch_) / patch_;
    const Eigen::Vector2d across(1 - x, x), down(1 - y, y);
    const double sum = down.dot(nodes_.block<2, 2>(v / patch_, u / patch_) * across);
    return sum / (across.norm() * down.norm());
  }

private:
  int patch_;
  Eigen::MatrixXd nodes_;
};

/** Which triangles return no light: glass, and those of parts that are dark. */
std::vector<char>
blindTriangles(const Building& building, const DepthCameraOptions& options)
{
  std::vector<char> is_blind;
  for (const auto& surface : building.surfaces) {
    const auto part = surface.labels.part;
    const bool is_dark =
        part > 0 && mixSeed(options.seed, part) < options.dark * 4294967296.0;
    is_blind.push_back(surface.isGlass() || is_dark);
  }
  return is_blind;
}

} // namespace

CameraFrame
frameOf(const CameraPose& pose)
{
  const Eigen::Vector3d way = pose.target - pose.position;
  if (!(way.norm() > 0))
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "the camera's target is where the camera is");
  CameraFrame frame{pose.position, {}};
  auto& axes = frame.axes;
  axes.col(2) = way.normalized();
  const Eigen::Vector3d right = axes.col(2).cross(Eigen::Vector3d::UnitZ());
  axes.col(0) = right.norm() > 1e-6 ? Eigen::Vector3d(right.normalized())
                                    : Eigen::Vector3d(Eigen::Vector3d::UnitX());
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return frame;
}

DepthSensor::DepthSensor(const Building& building, const DepthCameraOptions& options)
: building_(building)
, options_((requireLegal(options), options))
, tracer_(building.triangles)
, is_blind_(blindTriangles(building, options))
{}

/** One view: what the pixels have in common, and each of them. */
class DepthSensor::View {
public:
  View(const DepthSensor& sensor, const CameraFrame& frame, std::uint32_t seed)
  : sensor_(sensor)
  , options_(sensor.options_)
  , frame_(frame)
  , projector_(frame.position + options_.baseline * frame.axes.col(0))
  , scale_(options_.focal_length * options_.baseline)
  , errors_(options_.width, options_.height, options_.patch, RandomDraw(seed))
  , distortion_(
        options_.width,
        options_.height,
        std::max(1, options_.width / 5), // bumps as wide as a fifth of the image
        RandomDraw(mixSeed(options_.seed, 0x64697374)))
  , draw_(mixSeed(seed, 0x65646765))
  {}

  /** What is in the way of a pixel's ray, without noise of the depth. */
  DepthPixel
  surfaceAt(int u, int v)
  {
    Eigen::Vector3d ray = rayThrough(u, v, options_);
    if (options_.edge_noise > 0)
      for (int k = 0; k < 2; ++k)
        ray[k] += options_.edge_noise / options_.focal_length * draw_.gaussian();
    const Eigen::Vector3d way = frame_.axes * ray; // as long as the depth
    const auto hit = sensor_.tracer_.trace(frame_.position.cast<float>(),
                                           way.cast<float>(),
                                           static_cast<float>(options_.min_range),
                                           static_cast<float>(options_.max_range));
    if (hit.triangle < 0 || sensor_.is_blind_[hit.triangle])
      return {};
    const auto& t = sensor_.building_.triangles[hit.triangle];
    const double cosine =
        (t.b - t.a).cross(t.c - t.a).normalized().dot(way.normalized().cast<float>());
    const double depth = hit.distance;
    if (std::abs(cosine) < options_.least_cosine ||
        !isLit(frame_.position + depth * way))
      return {};
    return {depth, hit.triangle};
  }

  /** Some depths beside an edge become one between those of both sides. */
  void
  mixAtEdges(std::vector<DepthPixel>& pixels)
  {
    constexpr double least = 0.03, most = 0.5; // metres between both sides
    for (std::size_t i = 0; i + 1 < pixels.size(); ++i) {
      const double other = pixels[i + 1].depth;
      const double step = std::abs(other - pixels[i].depth);
      const bool is_row_end = (i + 1) % options_.width == 0;
      if (is_row_end || pixels[i].depth == 0 || other == 0 || step < least ||
          step > most || draw_.uniform() >= options_.mixed)
        continue;
      pixels[i].depth += draw_.uniform() * (other - pixels[i].depth);
    }
  }

  /** What is measured of a depth; 0: nothing. */
  double
  measured(double depth, int u, int v) const
  {
    const double error =
        options_.noise * errors_.at(u, v) +
        (options_.distortion > 0 ? options_.distortion * distortion_.at(u, v) : 0.0);
    const double disparity =
        std::round((scale_ / depth + error) / options_.step) * options_.step;
    return disparity > 0 ? scale_ / disparity : 0.0;
  }

private:
  bool
  isLit(const Eigen::Vector3d& place) const
  {
    constexpr float nearly = 0.999f; // the surface itself is no obstacle
    const Eigen::Vector3f way = (place - projector_).cast<float>();
    return sensor_.tracer_.trace(projector_.cast<float>(), way, 0, nearly).triangle < 0;
  }

  const DepthSensor& sensor_;
  const DepthCameraOptions& options_;
  CameraFrame frame_;
  Eigen::Vector3d projector_;
  double scale_; ///< of disparities: metres times pixels
  PatchNoise errors_, distortion_;
  RandomDraw draw_;
};

std::vector<DepthPixel>
DepthSensor::see(const CameraFrame& frame, std::uint32_t seed) const
{
  View view(*this, frame, seed);
  std::vector<DepthPixel> pixels;
  for (int v = 0; v < options_.height; ++v)
    for (int u = 0; u < options_.width; ++u)
      pixels.push_back(view.surfaceAt(u, v));
  if (options_.mixed > 0)
    view.mixAtEdges(pixels);
  for (int v = 0; v < options_.height; ++v)
    for (int u = 0; u < options_.width; ++u) {
      auto& pixel = pixels[static_cast<std::size_t>(v) * options_.width + u];
      if (pixel.depth > 0)
        pixel.depth = view.measured(pixel.depth, u, v);
      if (pixel.depth == 0)
        pixel = {};
    }
  return pixels;
}

} // namespace pcl::indoor
