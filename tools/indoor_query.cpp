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
answerOf(const Options& options)
{
  if (!options.route.empty()) {
    const auto route = sceneRoute(readSavedScene(options.scene), options.route);
    return options.json ? jsonText(route) : routeTable(route).text();
  }
  const auto scene = readScene(options.scene);
  try {
    if (options.rooms) {
      const auto rooms = matchingRooms(scene, options.query);
      return options.json ? jsonText(rooms) : roomTable(rooms).text();
    }
    const auto objects = matchingObjects(scene, options.query);
    return options.json
               ? jsonText(objects)
               : objectTable(objects, options.query.nearest.has_value()).text();
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
