/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "report/report_page.h"

#include "export/plan_boxes.h" // for boxFromAbove
#include "pictures/plan_svg.h"
#include "pictures/svg_drawing.h" // for xmlText
#include "report/report_cloud.h"
#include "text/base64.h"
#include "text/program_version.h"

#include <algorithm>
#include <map>

namespace pcl::indoor::tool {

extern const char* const report_template; // made of the files in scene/report

namespace {

using Json = nlohmann::ordered_json;

/** JSON that may stand in a script of a page: nothing in it ends the script. */
std::string
jsonInPage(const Json& json)
{
  std::string text;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace))
    if (c == '<')
      text += "\\u003c"; // stands in texts only
    else
      text += c;
  return text;
}

/** Put values in place of {{NAME}}; what is put in stays as it is. */
std::string
filled(const std::string& page, const std::map<std::string, std::string>& values)
{
  std::string text;
  std::size_t begin = 0;
  for (auto at = page.find("{{"); at != page.npos; at = page.find("{{", at + 2)) {
    const auto end = page.find("}}", at);
    const auto value = values.find(page.substr(at + 2, end - at - 2));
    if (end == page.npos || value == values.end())
      continue;
    text += page.substr(begin, at - begin) + value->second;
    begin = end + 2;
  }
  return text + page.substr(begin);
}

} // namespace

std::vector<PlanObject>
objectsFromAbove(const Scene& scene)
{
  const Eigen::Vector3d shift = scene.frame.origin();
  std::vector<std::pair<double, PlanObject>> drawn;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const auto& object = scene.objects[i];
    if (object.structure != 0 || object.room == 0)
      continue;
    auto box = object.upright;
    box.center -= shift;
    drawn.emplace_back(box.size.x() * box.size.y(),
                       PlanObject{static_cast<std::uint32_t>(i + 1),
                                  scene.rooms[object.room - 1].storey,
                                  boxFromAbove(box)});
  }
  std::stable_sort(drawn.begin(), drawn.end(), [](const auto& a, const auto& b) {
    return a.first > b.first;
  });
  std::vector<PlanObject> sorted;
  for (auto& shape : drawn)
    sorted.push_back(std::move(shape.second));
  return sorted;
}

std::string
reportPage(const ReportInput& input)
{
  const auto& frame = input.scene.frame;
  auto cloud = thinnedCloud(input.scene, input.upright);
  cloud["metres_per_unit"] = frame.metres_per_unit;
  const Eigen::Vector3d origin = frame.buildingToFile().translation();
  cloud["translation"] = {origin.x(), origin.y(), origin.z()};
  return filled(report_template,
                {{"TITLE", xmlText(input.json.at("input").get<std::string>())},
                 {"VERSION", programVersion()},
                 {"FIELD", base64(input.field)},
                 {"SCENE", jsonInPage(input.json)},
                 {"PLANS", jsonInPage(storeySvgs(input.plan))},
                 {"CLOUD", jsonInPage(cloud)}});
}

} // namespace pcl::indoor::tool
