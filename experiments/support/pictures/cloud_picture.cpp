/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/cloud_picture.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace pcl::indoor::tool {
namespace {

constexpr float pi = 3.14159265f;
constexpr float hidden = std::numeric_limits<float>::quiet_NaN();

/** 0 (edge-on) to 1 (facing); 1 without a normal. */
float
facing(const Eigen::Vector3f& normal, const Eigen::Vector3f& to_camera)
{
  const float cosine = normal.dot(to_camera);
  return std::isfinite(cosine) && normal.squaredNorm() > 0 ? std::abs(cosine) : 1;
}

Color
shaded(Color color, float shade)
{
  const auto part = [&](std::uint8_t channel) {
    return static_cast<std::uint8_t>(static_cast<float>(channel) *
                                     (0.45f + 0.55f * shade));
  };
  return {part(color.red), part(color.green), part(color.blue)};
}

/** Fit x and y of the points that are not hidden into the picture, y upwards. */
void
fitIntoPicture(int width, int height, std::vector<Eigen::Vector3f>& screen)
{
  // All but a few: outliers would make the rest small.
  constexpr double cut_off = 0.003;
  Eigen::AlignedBox2f box;
  for (int axis = 0; axis < 2; ++axis) {
    std::vector<float> values;
    for (const auto& place : screen)
      if (std::isfinite(place.x()))
        values.push_back(place[axis]);
    if (values.empty())
      return;
    std::sort(values.begin(), values.end());
    const auto cut =
        static_cast<std::size_t>(cut_off * static_cast<double>(values.size()));
    box.min()[axis] = values[cut];
    box.max()[axis] = values[values.size() - 1 - cut];
  }
  const Eigen::Vector2f size = box.sizes().cwiseMax(1e-6f);
  const float scale = 0.96f * std::min(static_cast<float>(width) / size.x(),
                                       static_cast<float>(height) / size.y());
  const Eigen::Vector2f middle = box.center();
  for (auto& place : screen) {
    place.x() = static_cast<float>(width) / 2 + scale * (place.x() - middle.x());
    place.y() = static_cast<float>(height) / 2 - scale * (place.y() - middle.y());
  }
}

} // namespace

CloudView::CloudView(int width, int height)
: width_(width)
, height_(height)
, point_of_pixel_(static_cast<std::size_t>(width) * height, -1)
, shade_of_pixel_(point_of_pixel_.size(), 0)
{}

CloudView
CloudView::fromAbove(const std::vector<Eigen::Vector3f>& points,
                     const std::vector<Eigen::Vector3f>& normals,
                     int width,
                     int height)
{
  const Eigen::Matrix3f turn =
      (Eigen::AngleAxisf(-0.2f * pi, Eigen::Vector3f::UnitX()) *
       Eigen::AngleAxisf(0.17f * pi, Eigen::Vector3f::UnitZ()))
          .toRotationMatrix();
  // After the turn, the camera looks along -z from above: x right, y up.
  const Eigen::Vector3f to_camera = turn.transpose() * Eigen::Vector3f::UnitZ();
  CloudView view(width, height);
  std::vector<Eigen::Vector3f> screen;
  std::vector<float> shades;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Eigen::Vector3f place = turn * points[i];
    place.z() *= -1; // depth
    if (!place.allFinite() || normals[i].dot(to_camera) < -0.05f)
      place.setConstant(hidden);
    screen.push_back(place);
    shades.push_back(facing(normals[i], to_camera));
  }
  fitIntoPicture(width, height, screen);
  view.fill(screen, shades);
  return view;
}

CloudView
CloudView::fromCamera(const std::vector<Eigen::Vector3f>& points,
                      const std::vector<Eigen::Vector3f>& normals,
                      int width,
                      int height)
{
  CloudView view(width, height);
  std::vector<Eigen::Vector3f> screen;
  std::vector<float> shades;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& p = points[i];
    if (p.allFinite() && p.z() > 0)
      screen.emplace_back(p.x() / p.z(), -p.y() / p.z(), p.z());
    else
      screen.emplace_back(hidden, hidden, hidden);
    shades.push_back(facing(normals[i], -p.normalized()));
  }
  fitIntoPicture(width, height, screen);
  view.fill(screen, shades);
  return view;
}

/** Each pixel shows the nearest of the points whose squares cover it. */
void
CloudView::fill(const std::vector<Eigen::Vector3f>& screen,
                const std::vector<float>& shades)
{
  const auto count = std::max<std::size_t>(screen.size(), 1);
  const float pixels_per_point =
      static_cast<float>(point_of_pixel_.size()) / static_cast<float>(count);
  const int reach =
      std::clamp(static_cast<int>(std::lround(std::sqrt(pixels_per_point))), 1, 6);
  std::vector<float> depth(point_of_pixel_.size(),
                           std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < screen.size(); ++i) {
    if (!screen[i].allFinite())
      continue;
    const int column = static_cast<int>(std::floor(screen[i].x()));
    const int row = static_cast<int>(std::floor(screen[i].y()));
    for (int y = std::max(0, row - reach); y <= std::min(height_ - 1, row + reach); ++y)
      for (int x = std::max(0, column - reach);
           x <= std::min(width_ - 1, column + reach);
           ++x) {
        const auto pixel = static_cast<std::size_t>(y) * width_ + x;
        if (!(screen[i].z() < depth[pixel]))
          continue;
        depth[pixel] = screen[i].z();
        point_of_pixel_[pixel] = static_cast<std::int64_t>(i);
        shade_of_pixel_[pixel] = shades[i];
      }
  }
}

PixelImage
CloudView::draw(const std::vector<std::uint32_t>& labels) const
{
  PixelImage picture(width_, height_);
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      const auto pixel = static_cast<std::size_t>(y) * width_ + x;
      if (point_of_pixel_[pixel] >= 0)
        picture.set(
            x,
            y,
            shaded(labelColor(labels[point_of_pixel_[pixel]]), shade_of_pixel_[pixel]));
    }
  return picture;
}

std::size_t
CloudView::coveredPixels() const
{
  return static_cast<std::size_t>(std::count_if(point_of_pixel_.begin(),
                                                point_of_pixel_.end(),
                                                [](auto point) { return point >= 0; }));
}

std::vector<std::uint32_t>
namedAsTruth(const std::vector<std::uint32_t>& truth,
             const std::vector<std::uint32_t>& predicted)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> overlaps;
  std::uint32_t last = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    last = std::max(last, truth[i]);
    ++overlaps[{truth[i], predicted[i]}];
  }
  std::vector<std::tuple<std::size_t, std::uint32_t, std::uint32_t>> pairs;
  for (const auto& entry : overlaps)
    if (entry.first.first > 0 && entry.first.second > 0)
      pairs.emplace_back(entry.second, entry.first.first, entry.first.second);
  std::sort(pairs.rbegin(), pairs.rend());
  std::map<std::uint32_t, std::uint32_t> name{{0, 0}}, segment_of;
  for (const auto& [size, true_label, label] : pairs)
    if (!name.count(label) && segment_of.emplace(true_label, label).second)
      name[label] = true_label;
  std::vector<std::uint32_t> names;
  for (const auto label : predicted)
    names.push_back(name.emplace(label, last + 1).second ? ++last : name[label]);
  return names;
}

} // namespace pcl::indoor::tool
