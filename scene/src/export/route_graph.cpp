/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/route_graph.h"

#include "export/geojson_file.h"
#include "formats/json_text.h" // for rounded

namespace pcl::indoor::tool {
namespace {

using Json = nlohmann::ordered_json;

Json
pointJson(const DoorNode& node)
{
  return {rounded(node.position.x()), rounded(node.position.y())};
}

Json
nodeFeature(const DoorNode& node, std::size_t id)
{
  Json metadata = {{"kind", nameOf(node.kind)}};
  if (node.number > 0)
    metadata["number"] = node.number;
  if (node.room > 0)
    metadata["room"] = node.room;
  return geoFeature(
      "Point", pointJson(node), {{"id", id}, {"frame", "map"}, {"metadata", metadata}});
}

} // namespace

const char*
nameOf(DoorNodeKind kind)
{
  constexpr const char* names[] = {"room", "opening", "stairs", "corner", "place"};
  return names[static_cast<int>(kind)];
}

nlohmann::ordered_json
routeGraph(const DoorGraph& graph, std::uint32_t storey)
{
  Json json = {{"type", "FeatureCollection"}, {"name", "graph"}};
  json["features"] = Json::array();
  for (std::size_t i = 0; i < graph.nodes.size(); ++i)
    if (graph.nodes[i].storey == storey)
      json["features"].push_back(nodeFeature(graph.nodes[i], i));
  std::size_t id = graph.nodes.size();
  for (const auto& line : graph.lines) {
    const auto &a = graph.nodes[line.a], &b = graph.nodes[line.b];
    if (a.storey != storey || b.storey != storey)
      continue;
    for (const bool back : {false, true}) {
      const Json ends = {pointJson(back ? b : a), pointJson(back ? a : b)};
      json["features"].push_back(geoFeature("MultiLineString",
                                            Json::array({ends}),
                                            {{"id", id++},
                                             {"startid", back ? line.b : line.a},
                                             {"endid", back ? line.a : line.b},
                                             {"cost", rounded(line.length)},
                                             {"overridable", true}}));
    }
  }
  return json;
}

} // namespace pcl::indoor::tool
