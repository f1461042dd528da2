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
constexpr double border = 12.0;
constexpr Color grey{205, 205, 205};

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

  double
  pixelsPerMetre() const
  {
    return 1.0 / frame_.pixel;
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

PixelImage
imageOf(const StoreyView& view, std::uint32_t other)
{
  PixelImage image(view.width, view.height);
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      const auto category = view.category[static_cast<std::size_t>(y) * view.width + x];
      if (category > 0)
        image.set(x, y, category == other ? grey : labelColor(category));
    }
  return image;
}

SvgDrawing
viewsOf(const Plan& plan, std::uint32_t other)
{
  std::vector<SvgDrawing> storeys;
  for (std::uint32_t storey = 0; storey < plan.storeyCount(); ++storey) {
    const auto image = imageOf(plan.view(storey), other);
    storeys.emplace_back(image.width(), image.height());
    storeys.back().image({0.0, 0.0}, image);
  }
  return stackedStoreys(storeys, 0.0, border);
}

/** One line per class that occurs: its colour, its name, its number of objects. */
SvgDrawing
legendOf(const SceneClasses& classes, std::uint32_t other)
{
  constexpr double line_height = 32.0, square = 22.0;
  constexpr TextStyle style{Anchor::Start, 20.0};
  std::vector<std::size_t> counts(classes.names.size(), 0);
  for (const auto& object : classes.objects)
    ++counts[object.category];
  std::vector<std::pair<Color, std::string>> lines;
  double width = 100.0;
  for (std::uint32_t k = 1; k < counts.size(); ++k)
    if (counts[k] > 0 && k != other) {
      lines.emplace_back(labelColor(k),
                         classes.names[k] + " (" + std::to_string(counts[k]) + ")");
      width = std::max(width, SvgDrawing::textWidth(lines.back().second, style));
    }
  lines.emplace_back(grey, "structure, other");
  SvgDrawing legend(square + 8.0 + width,
                    line_height * static_cast<double>(lines.size()));
  double y = 0.5 * line_height;
  for (const auto& [color, text] : lines) {
    legend.rectangle({0.0, y - 0.5 * square}, {square, square}, color);
    legend.text({square + 8.0, y}, text, style);
    y += line_height;
  }
  return legend;
}

} // namespace

SvgDrawing
drawClasses(const Scene& scene, const PointCloud<PointXYZ>& points)
{
  const auto other = otherClass(scene.classes.names);
  const Plan plan(scene, points, other);
  const auto views = viewsOf(plan, other);
  const auto legend = legendOf(scene.classes, other);
  const double left = 2.0 * border + views.width();
  SvgDrawing drawing(left + legend.width() + border,
                     2.0 * border + std::max(views.height(), legend.height() + 50.0));
  drawing.drawing({border, border}, views);
  drawing.drawing({left, border}, legend);
  drawing.scaleBar({left, 2.5 * border + legend.height()}, plan.pixelsPerMetre(), 20.0);
  return drawing;
}

} // namespace pcl::indoor::tool
