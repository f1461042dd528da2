/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <nlohmann/json.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace pcl_indoor_ros {

/** \brief Makes the visualization_msgs/MarkerArray of a scene: outlines and names of
 * rooms, frames of openings, boxes and names of objects. */
template <typename MarkerArray>
class SceneMarkers {
public:
  using Json = nlohmann::ordered_json;
  using Marker = typename decltype(MarkerArray::markers)::value_type;
  using Header = decltype(Marker::header);

  /** \param[in] scene as scene.schema.json has it, in metres
   * \param[in] origin of the header's frame, in that of the scan's file */
  SceneMarkers(const Json& scene, const Eigen::Vector3d& origin, const Header& header)
  : scene_(scene)
  , origin_(origin)
  , header_(header)
  {
    const auto& axes = scene.at("axes");
    axes_ << vectorOf(axes.at("x")), vectorOf(axes.at("y")), vectorOf(axes.at("up"));
  }

  /** \brief Those of an earlier scene are deleted first.
   * \throws nlohmann::json::exception if the scene is not whole */
  MarkerArray
  make()
  {
    result_ = {};
    add("", 0, 0).action = Marker::DELETEALL;
    for (const auto& room : scene_.at("rooms"))
      addRoom(room);
    for (const auto& opening : scene_.at("openings"))
      addOpening(opening);
    for (const auto& object : scene_.at("objects"))
      if (object.at("structure") == "none")
        addObject(object);
    return std::move(result_);
  }

private:
  using Color = std::array<float, 3>;

  static Eigen::Vector3d
  vectorOf(const Json& json)
  {
    return {
        json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
  }

  Eigen::Vector3d
  placeOf(const Json& json) const
  {
    return vectorOf(json) - origin_;
  }

  Eigen::Vector3d
  up() const
  {
    return axes_.col(2);
  }

  /** Neighbouring numbers have colours far apart. */
  static Color
  colorOf(int number)
  {
    const double hue = std::fmod(0.618034 * number, 1.0);
    Color color;
    for (int i = 0; i < 3; ++i)
      color[i] = static_cast<float>(
          0.6 + 0.35 * std::cos(2.0 * M_PI * (hue - static_cast<double>(i) / 3.0)));
    return color;
  }

  Marker&
  add(const std::string& name_space, int id, int type, const Color& color = {1, 1, 1})
  {
    auto& marker = result_.markers.emplace_back();
    marker.header = header_;
    marker.ns = name_space;
    marker.id = id;
    marker.type = type;
    marker.action = Marker::ADD;
    marker.pose.orientation.w = 1.0;
    marker.color.r = color[0];
    marker.color.g = color[1];
    marker.color.b = color[2];
    marker.color.a = 1.0f;
    return marker;
  }

  template <typename Point>
  static void
  set(Point& point, const Eigen::Vector3d& place)
  {
    point.x = place.x();
    point.y = place.y();
    point.z = place.z();
  }

  static void
  addLine(Marker& marker, const Eigen::Vector3d& from, const Eigen::Vector3d& to)
  {
    set(marker.points.emplace_back(), from);
    set(marker.points.emplace_back(), to);
  }

  void
  addText(const std::string& name_space,
          int id,
          const Eigen::Vector3d& place,
          const std::string& text)
  {
    auto& marker = add(name_space, id, Marker::TEXT_VIEW_FACING);
    set(marker.pose.position, place);
    marker.scale.z = 0.25; // height of a letter, metres
    marker.text = text;
  }

  void
  addRoom(const Json& room)
  {
    const int number = room.at("room").get<int>();
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    int corners = 0;
    auto& marker = add("rooms", number, Marker::LINE_LIST, colorOf(number));
    marker.scale.x = 0.05; // width of a line, metres
    for (const auto& ring : room.at("footprint"))
      for (std::size_t i = 0; i < ring.size(); ++i) {
        addLine(marker, placeOf(ring[i]), placeOf(ring[(i + 1) % ring.size()]));
        middle += placeOf(ring[i]);
        ++corners;
      }
    if (corners == 0) { // lines without points are an error in RViz
      result_.markers.pop_back();
      return;
    }
    auto text = std::to_string(number);
    if (const auto name = room.value("name", "unknown"); name != "unknown")
      text += " " + name;
    addText("room_names", number, middle / corners + 0.2 * up(), text);
  }

  /** Of its wall, or of the nearest side of its rooms. */
  Eigen::Vector3d
  directionOf(const Json& opening) const
  {
    if (opening.contains("wall")) {
      const auto& wall = scene_.at("walls").at(opening["wall"].get<std::size_t>() - 1);
      return (vectorOf(wall.at("end")) - vectorOf(wall.at("begin"))).normalized();
    }
    const auto place = vectorOf(opening.at("position"));
    Eigen::Vector3d best = axes_.col(0);
    double least = INFINITY;
    for (const auto& number : opening.at("rooms"))
      if (number.get<std::size_t>() > 0)
        for (const auto& ring :
             scene_.at("rooms").at(number.get<std::size_t>() - 1).at("footprint"))
          for (std::size_t i = 0; i < ring.size(); ++i) {
            const auto begin = vectorOf(ring[i]);
            const Eigen::Vector3d side = vectorOf(ring[(i + 1) % ring.size()]) - begin;
            const double length = side.squaredNorm();
            if (!(length > 0.0))
              continue;
            const double along =
                std::min(1.0, std::max(0.0, side.dot(place - begin) / length));
            const double distance = (begin + along * side - place).norm();
            if (distance < least) {
              least = distance;
              best = side.normalized();
            }
          }
    return best;
  }

  void
  addOpening(const Json& opening)
  {
    const auto kind = opening.at("kind").get<std::string>();
    const Color color = kind == "window" ? Color{0.3f, 0.6f, 1.0f}
                        : kind == "door" ? Color{0.9f, 0.5f, 0.1f}
                                         : Color{0.5f, 0.9f, 0.4f};
    auto& marker =
        add(kind + "s", opening.at("opening").get<int>(), Marker::LINE_LIST, color);
    marker.scale.x = 0.04;
    const Eigen::Vector3d half =
        0.5 * opening.at("width").get<double>() * directionOf(opening);
    const Eigen::Vector3d rise = opening.at("height").get<double>() * up();
    const auto foot = placeOf(opening.at("position"));
    addLine(marker, foot - half, foot + half);
    addLine(marker, foot + half, foot + half + rise);
    addLine(marker, foot + half + rise, foot - half + rise);
    addLine(marker, foot - half + rise, foot - half);
  }

  void
  addObject(const Json& object)
  {
    const int number = object.at("object").get<int>();
    const auto& box = object.at("upright_box");
    const auto center = placeOf(box.at("center"));
    const auto size = vectorOf(box.at("size"));
    const double yaw = box.at("yaw_degrees").get<double>() * M_PI / 180.0;
    const Eigen::Quaterniond turn(
        axes_ * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix());
    auto& marker =
        add("objects", number, Marker::CUBE, colorOf(object.value("category", 0)));
    set(marker.pose.position, center);
    marker.pose.orientation.x = turn.x();
    marker.pose.orientation.y = turn.y();
    marker.pose.orientation.z = turn.z();
    marker.pose.orientation.w = turn.w();
    set(marker.scale, size.cwiseMax(0.001)); // none of a side of 0 is shown
    marker.color.a = 0.5f;
    auto text = std::to_string(number);
    if (const auto name = object.value("class", "none"); name != "none")
      text += " " + name;
    addText("object_names", number, center + (0.5 * size.z() + 0.15) * up(), text);
  }

  const Json& scene_;
  Eigen::Vector3d origin_;
  Header header_;
  Eigen::Matrix3d axes_;
  MarkerArray result_;
};

} // namespace pcl_indoor_ros
