/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <nlohmann/json.hpp>

#include <initializer_list>
#include <string>
#include <vector>

namespace pcl::indoor::test {

using SceneJson = nlohmann::ordered_json;

/** A scene of two storeys, written by hand, as scene.json has it: rooms 1 (4 m by 3 m)
 * and 2 (the same with a pillar's hole) side by side with a wall of 20 cm and a door
 * between them, room 3 above room 1 with stairs to it; a window in a wall that was seen
 * from room 1, a closed door without a wall at the end of room 2, which is a kitchen.
 * Places are at an offset of (100, 200, 10). */
class SmallScene {
public:
  static SceneJson
  json()
  {
    SceneJson scene = {
        {"format", "pcl_indoor scene"},
        {"version", 2},
        {"input", "small.pcd"},
        {"offset", {100, 200, 10}},
        {"coordinate_unit", "m"},
        {"axes", {{"x", {1, 0, 0}}, {"y", {0, 1, 0}}, {"up", {0, 0, 1}}}},
        {"storeys",
         {{{"storey", 0}, {"floor", 10.0}, {"ceiling", 12.5}},
          {{"storey", 1}, {"floor", 13.0}, {"ceiling", 15.5}}}},
        {"categories", {"none", "chair", "stairs"}}};
    const SceneJson left = ring({{0, 0}, {4, 0}, {4, 3}, {0, 3}}, 0);
    scene["rooms"] = {
        room(1, 0, 12.0, SceneJson::array({left})),
        room(2,
             0,
             11.75,
             SceneJson::array({ring({{4.2, 0}, {8.2, 0}, {8.2, 3}, {4.2, 3}}, 0),
                               ring({{5.5, 1}, {5.5, 1.5}, {6, 1.5}, {6, 1}}, 0)})),
        room(
            3, 1, 12.0, SceneJson::array({ring({{0, 0}, {4, 0}, {4, 3}, {0, 3}}, 3)}))};
    scene["rooms"][1]["name"] = "kitchen";
    scene["rooms"][1]["name_probability"] = 0.8;
    scene["rooms"][2]["name"] = "unknown";
    scene["rooms"][2]["name_probability"] = 0.3;
    scene["walls"] = {wall(1, {4.1, 3, 0}, {4.1, 0, 0}, {1, 2}),
                      wall(2, {0, 0, 0}, {4, 0, 0}, {1})};
    scene["walls"][0]["thickness"] = 0.2;
    scene["openings"] = {opening(1, "door", {1, 2}, {4.1, 1.5, 0}, {0.9, 2.0, 0.0}),
                         opening(2, "window", {0, 1}, {2, 0, 1}, {1.2, 1.0, 1.0}),
                         opening(3, "door", {0, 2}, {8.2, 1.5, 0}, {1.0, 2.1, 0.0})};
    scene["openings"][0]["wall"] = 1;
    scene["openings"][0]["open"] = true;
    scene["openings"][1]["wall"] = 2;
    scene["objects"] = {object(1, 1, "chair", {1, 2, 0.5}, {0.6, 0.5, 1.0}),
                        object(2, 1, "stairs", {0.5, 1.5, 1.5}, {2.8, 0.9, 3.0}),
                        object(3, 0, "chair", {20, 2, 3.5}, {0.6, 0.5, 1.0})};
    scene["objects"].push_back(object(4, 2, "none", {6, 1, 0}, {4, 3, 0.01}));
    scene["objects"][3]["structure"] = "floor";
    return scene;
  }

  /** A column of json(), in its second room. */
  static SceneJson
  column(bool is_round)
  {
    return {{"column", 1},
            {"storey", 0},
            {"room", 2},
            {"position", {105.75, 201.25, 10}},
            {"size", {0.5, is_round ? 0.5 : 0.25, 2.5}},
            {"yaw_degrees", 90.0},
            {"round", is_round}};
  }

  /** The same as version 1 has it. */
  static SceneJson
  versionOne()
  {
    auto scene = json();
    scene["version"] = 1;
    scene.erase("walls");
    scene["openings"].erase(1);
    for (auto& opening : scene["openings"])
      for (const char* key : {"kind", "height", "sill", "head", "open", "wall"})
        opening.erase(key);
    return scene;
  }

private:
  using Place = std::vector<double>;

  static SceneJson
  place(const Place& local)
  {
    return {local[0] + 100, local[1] + 200, local[2] + 10};
  }

  static SceneJson
  ring(const std::vector<Place>& corners, double z)
  {
    SceneJson line = SceneJson::array();
    for (const auto& corner : corners)
      line.push_back(place({corner[0], corner[1], z}));
    return line;
  }

  static SceneJson
  room(int number, int storey, double area, const SceneJson& footprint)
  {
    return {{"room", number},
            {"storey", storey},
            {"area", area},
            {"height", 2.5},
            {"volume", 2.5 * area},
            {"footprint", footprint}};
  }

  static SceneJson
  wall(int number, const Place& begin, const Place& end, const std::vector<int>& rooms)
  {
    return {{"wall", number},
            {"storey", 0},
            {"rooms", rooms},
            {"begin", place(begin)},
            {"end", place(end)},
            {"height", 2.5}};
  }

  /** \param[in] size width, height and sill */
  static SceneJson
  opening(int number,
          const std::string& kind,
          const std::vector<int>& rooms,
          const Place& position,
          const Place& size)
  {
    return {{"opening", number},
            {"kind", kind},
            {"rooms", rooms},
            {"storey", 0},
            {"position", place(position)},
            {"width", size[0]},
            {"height", size[1]},
            {"sill", size[2]},
            {"head", size[2] + size[1]},
            {"area", size[0] * size[1]},
            {"open", false}};
  }

  static SceneJson
  object(int number,
         int room,
         const std::string& name,
         const Place& center,
         const Place& size)
  {
    SceneJson object = {{"object", number},
                        {"room", room},
                        {"structure", "none"},
                        {"category", 1},
                        {"class", name},
                        {"confidence", 0.75},
                        {"upright_box",
                         {{"center", place(center)},
                          {"size", size},
                          {"yaw_degrees", name == "stairs" ? 90.0 : 0.0}}}};
    if (room > 0)
      object["storey"] = 0;
    return object;
  }
};

} // namespace pcl::indoor::test
