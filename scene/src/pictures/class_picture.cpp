/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/class_picture.h"

#include "scene/category_names.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::indoor::tool {
namespace {

constexpr int storey_size = 1400;      // pixels of the longer side of a storey
constexpr float finest_pixel = 0.02f;  // metres
constexpr float below_ceiling = 0.25f; // metres that are cut off above
constexpr int space_between = 12;      // pixels
constexpr Color grey{205, 205, 205};
constexpr Color black{0, 0, 0};

/** A view of one storey from above: per pixel its highest point, of named objects if
 * there are any. */
struct StoreyView {
  int width = 0, height = 0;
  std::vector<float> top;
  std::vector<std::uint32_t> category;
};

struct Frame {
  float left = std::numeric_limits<float>::infinity(), lower = left;
  float right = -left, upper = -left;
  float pixel = finest_pixel; // metres
};

/** Rooms with their storeys and what of them is shown. */
class Plan {
public:
  Plan(const Scene& scene, const PointCloud<PointXYZ>& points, std::uint32_t other)
  : scene_(scene)
  , points_(points)
  , other_(other)
  , ceilings_(scene.rooms.size(), -std::numeric_limits<float>::infinity())
  {
    for (const auto& room : scene.rooms)
      storeys_ = std::max(storeys_, room.storey + 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!isShown(i))
        continue;
      auto& ceiling = ceilings_[scene.room_of_point[i] - 1];
      ceiling = std::max(ceiling, points[i].z);
      frame_.left = std::min(frame_.left, points[i].x);
      frame_.lower = std::min(frame_.lower, points[i].y);
      frame_.right = std::max(frame_.right, points[i].x);
      frame_.upper = std::max(frame_.upper, points[i].y);
    }
    const float longer =
        std::max(frame_.right - frame_.left, frame_.upper - frame_.lower);
    frame_.pixel = std::max(finest_pixel, longer / storey_size);
  }

  std::uint32_t
  storeyCount() const
  {
    return scene_.rooms.empty() ? 0 : storeys_;
  }

  StoreyView
  view(std::uint32_t storey) const
  {
    StoreyView view;
    view.width = static_cast<int>((frame_.right - frame_.left) / frame_.pixel) + 1;
    view.height = static_cast<int>((frame_.upper - frame_.lower) / frame_.pixel) + 1;
    const auto size = static_cast<std::size_t>(view.width) * view.height;
    view.top.assign(size, -std::numeric_limits<float>::infinity());
    view.category.assign(size, 0);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (!isShown(i))
        continue;
      const auto room = scene_.room_of_point[i] - 1;
      const auto& point = points_[i];
      if (scene_.rooms[room].storey != storey ||
          point.z > ceilings_[room] - below_ceiling)
        continue;
      const int x = static_cast<int>((point.x - frame_.left) / frame_.pixel);
      const int y = static_cast<int>((frame_.upper - point.y) / frame_.pixel);
      const auto pixel = static_cast<std::size_t>(y) * view.width + x;
      const auto object = scene_.object_of_point[i] - 1;
      const auto category = scene_.objects[object].structure != 0
                                ? other_ // grey, too
                                : scene_.classes.objects[object].category;
      const bool is_named = category != other_,
                 shows_named =
                     view.category[pixel] > 0 && view.category[pixel] != other_;
      if (is_named > shows_named ||
          (is_named == shows_named && point.z > view.top[pixel])) {
        view.top[pixel] = point.z;
        view.category[pixel] = category;
      }
    }
    return view;
  }

private:
  /** Points that are in a room and an object; these are finite. */
  bool
  isShown(std::size_t i) const
  {
    return scene_.room_of_point[i] > 0 && scene_.object_of_point[i] > 0;
  }

  const Scene& scene_;
  const PointCloud<PointXYZ>& points_;
  std::uint32_t other_;
  std::vector<float> ceilings_; // of each room, the highest point
  std::uint32_t storeys_ = 0;
  Frame frame_;
};

/** One line per class that occurs: its colour, its name, its number of objects. */
Picture
legendOf(const SceneClasses& classes, std::uint32_t other)
{
  std::vector<std::size_t> counts(classes.names.size(), 0);
  for (const auto& object : classes.objects)
    ++counts[object.category];
  std::vector<std::string> lines;
  std::vector<Color> colors;
  for (std::uint32_t k = 1; k < counts.size(); ++k)
    if (counts[k] > 0 && k != other) {
      lines.push_back(classes.names[k] + " " + std::to_string(counts[k]));
      colors.push_back(labelColor(k));
    }
  constexpr int scale = 2;
  const int step = 2 * Picture::textHeight(scale);
  int width = 1;
  for (const auto& line : lines)
    width = std::max(width, Picture::textWidth(line, scale));
  Picture legend(width + 3 * step,
                 step * static_cast<int>(std::max<std::size_t>(lines.size(), 1)));
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const int y = static_cast<int>(k) * step;
    legend.fillRectangle(space_between, y, step - 4, step - 4, colors[k]);
    legend.drawText(space_between + step + 4, y + 4, lines[k], black, scale);
  }
  return legend;
}

} // namespace

Picture
drawClasses(const Scene& scene, const PointCloud<PointXYZ>& points)
{
  const auto& names = scene.classes.names;
  const auto other = static_cast<std::uint32_t>(
      std::find(names.begin(), names.end(), other_class) - names.begin());
  const auto legend = legendOf(scene.classes, other);
  const Plan plan(scene, points, other);
  std::vector<StoreyView> views;
  int width = 1, height = space_between;
  for (std::uint32_t storey = plan.storeyCount(); storey-- > 0;) {
    views.push_back(plan.view(storey));
    width = std::max(width, views.back().width);
    height += views.back().height + space_between;
  }
  Picture picture(width + legend.width() + 2 * space_between,
                  std::max(height, legend.height() + 2 * space_between));
  int row = space_between;
  for (const auto& view : views) {
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x) {
        const auto category =
            view.category[static_cast<std::size_t>(y) * view.width + x];
        if (category > 0)
          picture.set(space_between + x,
                      row + y,
                      category == other ? grey : labelColor(category));
      }
    row += view.height + space_between;
  }
  picture.paste(legend, width + space_between, space_between);
  return picture;
}

} // namespace pcl::indoor::tool
