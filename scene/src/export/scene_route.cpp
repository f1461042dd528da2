/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/scene_route.h"

#include "export/door_graph.h"
#include "export/route_graph.h" // for nameOf
#include "files/tool_error.h"
#include "formats/json_text.h" // for rounded
#include "text/place_text.h"

#include <charconv>

namespace pcl::indoor::tool {
namespace {

using Json = nlohmann::ordered_json;

/** A room's number or the number of a place that is added to a list. */
struct RouteEnd {
  DoorNodeKind kind = DoorNodeKind::Room;
  std::uint32_t number = 0;
};

RouteEnd
endOf(const SavedScene& scene,
      const std::string& text,
      std::vector<Eigen::Vector3d>& places)
{
  RouteEnd end;
  if (text.find(',') == std::string::npos) {
    const auto last = text.data() + text.size();
    const auto read = std::from_chars(text.data(), last, end.number);
    if (read.ec != std::errc() || read.ptr != last || end.number == 0 ||
        end.number > scene.rooms.size())
      throw ToolError("-route: there is no room '" + text + "'");
    return end;
  }
  places.push_back(scene.frame.uprightToFile().inverse() * readPlace("-route", text));
  return {DoorNodeKind::Place, static_cast<std::uint32_t>(places.size())};
}

Json
stepJson(const SavedScene& scene, const DoorNode& node, double so_far)
{
  const Eigen::Vector3d place = scene.frame.uprightToFile() * node.position;
  Json step = {{"kind", nameOf(node.kind)}};
  if (node.kind != DoorNodeKind::Corner && node.kind != DoorNodeKind::Place)
    step["number"] = node.number;
  if (node.room > 0)
    step["room"] = node.room;
  step["storey"] = node.storey;
  step["position"] = Json::array();
  for (const double coordinate : place)
    step["position"].push_back(rounded(coordinate) + 0.0); // no -0
  step["distance"] = rounded(so_far);
  return step;
}

} // namespace

nlohmann::ordered_json
sceneRoute(const SavedScene& scene, const std::string& ends)
{
  const auto colon = ends.find(':');
  if (colon == std::string::npos)
    throw ToolError("-route: '" + ends + "' is not FROM:TO");
  std::vector<Eigen::Vector3d> places;
  const auto from = endOf(scene, ends.substr(0, colon), places);
  const auto to = endOf(scene, ends.substr(colon + 1), places);
  const auto graph = doorGraph(scene, places);
  const auto route = shortestRoute(
      graph, nodeOf(graph, from.kind, from.number), nodeOf(graph, to.kind, to.number));
  if (!route)
    throw ToolError("-route: no way leads from " + ends.substr(0, colon) + " to " +
                    ends.substr(colon + 1));
  Json json = {{"length", rounded(route->length)}, {"steps", Json::array()}};
  double so_far = 0.0;
  for (std::size_t i = 0; i < route->nodes.size(); ++i) {
    const auto& node = graph.nodes[route->nodes[i]];
    if (i > 0)
      so_far += (node.position - graph.nodes[route->nodes[i - 1]].position).norm();
    json["steps"].push_back(stepJson(scene, node, so_far));
  }
  return json;
}

} // namespace pcl::indoor::tool
