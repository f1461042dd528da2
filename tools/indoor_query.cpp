/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/options.h"
#include "export/scene_route.h"
#include "formats/json_text.h"
#include "scene/scene_query.h"
#include "text/place_text.h"
#include "text/printable.h"
#include "text/text_table.h"

using namespace pcl::indoor::tool;
using Json = nlohmann::ordered_json;

namespace {

struct Options {
  std::string scene, nearest, route;
  SceneQuery query;
  int room = -1, storey = -1; ///< -1 = any
  double max_size = 0.0;      ///< 0 = any
  std::uint32_t count = 0;
  bool rooms = false;
  bool json = false;
};

OptionParser
makeParser(Options& options)
{
  OptionParser parser("pcl_indoor_query",
                      "Lists the objects of a scene that fulfil all conditions, as a "
                      "table or as JSON, for example the doors next to a place; or the "
                      "shortest way between two places.");
  parser
      .positional(
          "scene.json", options.scene, "the scene, as pcl_indoor_pipeline writes it")
      .text("-class", options.query.object_class, "class of the objects")
      .number("-room",
              options.room,
              "room of the objects, 0 = in no room, -1 = any",
              "",
              Range::atLeast(-1))
      .text("-room_name",
            options.query.room_name,
            "what the room of the objects is for, for example kitchen")
      .flag("-rooms",
            options.rooms,
            "list rooms instead of objects: number, name, storey, size")
      .number("-storey",
              options.storey,
              "storey of the objects, 0 = the lowest, -1 = any",
              "",
              Range::atLeast(-1))
      .number("-min_size",
              options.query.min_size,
              "least length of the longest side",
              "m",
              Range::atLeast(0))
      .number("-max_size",
              options.max_size,
              "greatest length of the longest side, 0 = any",
              "m",
              Range::atLeast(0))
      .text("-nearest",
            options.nearest,
            "X,Y,Z, a place in the frame and unit of the scan: the nearest first, with "
            "their distances")
      .number("-count",
              options.count,
              "list at most so many, 0 = all",
              "objects",
              Range::atLeast(0))
      .text("-route",
            options.route,
            "FROM:TO, each the number of a room or X,Y,Z in the frame and unit of the "
            "scan: the shortest way through doors and over stairs, instead of objects")
      .flag("-structure",
            options.query.with_structure,
            "list floors, walls and ceilings, too")
      .flag("-json", options.json, "write JSON: the objects as they are in the scene");
  parser.expert({"-structure"});
  return parser;
}

void
chooseQuery(Options& options)
{
  auto& query = options.query;
  if (options.room >= 0)
    query.room = static_cast<std::uint32_t>(options.room);
  if (options.storey >= 0)
    query.storey = static_cast<std::uint32_t>(options.storey);
  if (options.max_size > 0.0)
    query.max_size = options.max_size;
  if (query.max_size < query.min_size)
    throw ToolError("-max_size: the value is less than -min_size");
  if (!options.nearest.empty())
    query.nearest = readPlace("-nearest", options.nearest);
  query.count = options.count;
}

std::string
joined(const Json& numbers, const char* between)
{
  std::string text;
  for (const auto& number : numbers)
    text += (text.empty() ? "" : between) + fixedText(number.get<double>(), 2);
  return text;
}

std::string
tableOf(const std::vector<Json>& objects, const SceneQuery& query)
{
  std::vector<std::string> header = {
      "object>", "class", "sure>", "room>", "storey>", "size, m>", "centre>"};
  if (query.nearest)
    header.emplace_back("distance, m>");
  TextTable table(header);
  for (const auto& object : objects) {
    const bool is_thing = object.at("structure") == "none";
    const auto name = object.value("class", "-");
    const auto& box = object.at("upright_box");
    std::vector<std::string> row = {
        object.at("object").dump(),
        is_thing ? name : object["structure"].get<std::string>(),
        is_thing && object.contains("confidence")
            ? fixedText(100.0 * object["confidence"].get<double>(), 0) + " %"
            : "-",
        object.at("room") == 0 ? "-" : object["room"].dump(),
        object.contains("storey") ? object["storey"].dump() : "-",
        joined(box.at("size"), " x "),
        joined(box.at("center"), ", ")};
    if (query.nearest)
      row.push_back(fixedText(object.at("distance").get<double>(), 2));
    table.add(row);
  }
  return table.text();
}

std::string
roomTableOf(const std::vector<Json>& rooms)
{
  TextTable table({"room>", "name", "sure>", "storey>", "area, m^2>", "height, m>"});
  for (const auto& room : rooms)
    table.add({room.at("room").dump(),
               room.value("name", "-"),
               room.contains("name_probability")
                   ? fixedText(100.0 * room["name_probability"].get<double>(), 0) + " %"
                   : "-",
               room.at("storey").dump(),
               fixedText(room.at("area").get<double>(), 2),
               fixedText(room.at("height").get<double>(), 2)});
  return table.text();
}

/** Without the corners where a way turns. */
std::string
routeTableOf(const Json& route)
{
  TextTable table({"step", "number>", "room>", "storey>", "place", "way, m>"});
  for (const auto& step : route.at("steps"))
    if (step["kind"] != "corner")
      table.add({step["kind"].get<std::string>(),
                 step.contains("number") ? step["number"].dump() : "-",
                 step.contains("room") ? step["room"].dump() : "-",
                 step["storey"].dump(),
                 joined(step["position"], ", "),
                 fixedText(step["distance"].get<double>(), 2)});
  return table.text();
}

std::string
answerOf(const Options& options)
{
  if (!options.route.empty()) {
    const auto route = sceneRoute(readSavedScene(options.scene), options.route);
    return options.json ? jsonText(route) : routeTableOf(route);
  }
  const auto scene = readScene(options.scene);
  try {
    if (options.rooms) {
      const auto rooms = matchingRooms(scene, options.query);
      return options.json ? jsonText(rooms) : roomTableOf(rooms);
    }
    const auto objects = matchingObjects(scene, options.query);
    return options.json ? jsonText(objects) : tableOf(objects, options.query);
  } catch (const Json::exception& problem) {
    throw ToolError(options.scene + ": not a whole scene, " + messageOf(problem));
  }
}

} // namespace

int
main(int argc, char** argv)
{
  Options options;
  auto parser = makeParser(options);
  return parser.run(argc, argv, [&](Progress&) {
    chooseQuery(options);
    const auto text = answerOf(options);
    if (std::fputs(text.c_str(), stdout) == EOF || std::fflush(stdout) != 0)
      throw ToolError("the answer cannot be written to stdout");
  });
}
