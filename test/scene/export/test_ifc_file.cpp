/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/ifc_file.h"

#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

using namespace pcl::indoor::tool;
using pcl::indoor::test::SmallScene;

namespace {

/** The entities of a file by their numbers. */
class Step {
public:
  explicit Step(const std::string& text)
  {
    std::istringstream stream(text);
    const std::regex entity(R"(#(\d+)=([A-Z0-9]+)\((.*)\);)");
    std::smatch parts;
    for (std::string line; std::getline(stream, line);)
      if (std::regex_match(line, parts, entity))
        lines_[std::stoul(parts[1])] = {parts[2], parts[3]};
  }

  std::size_t
  count(const std::string& entity) const
  {
    return all(entity).size();
  }

  /** The attributes of all of a kind, in their order. */
  std::vector<std::string>
  all(const std::string& entity) const
  {
    std::vector<std::string> found;
    for (const auto& [number, line] : lines_)
      if (line.first == entity)
        found.push_back(line.second);
    return found;
  }

  /** What an entity of a kind with a name is called by others. */
  std::string
  refOf(const std::string& entity, const std::string& name) const
  {
    for (const auto& [number, line] : lines_)
      if (line.first == entity &&
          line.second.find("'" + name + "'") != std::string::npos)
        return "#" + std::to_string(number);
    return "none";
  }

  const std::map<std::size_t, std::pair<std::string, std::string>>&
  lines() const
  {
    return lines_;
  }

private:
  std::map<std::size_t, std::pair<std::string, std::string>> lines_;
};

bool
has(const std::vector<std::string>& attributes, const std::string& part)
{
  return std::any_of(attributes.begin(), attributes.end(), [&](const auto& text) {
    return text.find(part) != std::string::npos;
  });
}

Step
smallFile()
{
  return Step(ifcText(savedScene(SmallScene::json())));
}

} // namespace

TEST(IfcFile, HasAsManyElementsAsTheScene)
{
  const auto file = smallFile();
  for (const auto& [entity, count] :
       std::map<std::string, std::size_t>{{"IFCPROJECT", 1},
                                          {"IFCSITE", 1},
                                          {"IFCBUILDING", 1},
                                          {"IFCBUILDINGSTOREY", 2},
                                          {"IFCSPACE", 3},
                                          {"IFCSLAB", 3},
                                          {"IFCWALL", 2},
                                          {"IFCOPENINGELEMENT", 2},
                                          {"IFCDOOR", 2},
                                          {"IFCWINDOW", 1},
                                          {"IFCSTAIR", 1},
                                          {"IFCFURNITURE", 2},
                                          {"IFCARBITRARYPROFILEDEFWITHVOIDS", 2}})
    EXPECT_EQ(file.count(entity), count) << entity;
}

TEST(IfcFile, ColumnsStandOnTheirStorey)
{
  auto scene = SmallScene::json();
  scene["columns"] = {SmallScene::column(false), SmallScene::column(true)};
  const Step file(ifcText(savedScene(scene)));
  EXPECT_EQ(file.count("IFCCOLUMN"), 2u);
  const auto round = file.refOf("IFCCOLUMN", "column 2");
  bool is_contained = false;
  for (const auto& relation : file.all("IFCRELCONTAINEDINSPATIALSTRUCTURE"))
    is_contained |= relation.find(round + ",") != std::string::npos ||
                    relation.find(round + ")") != std::string::npos;
  EXPECT_TRUE(is_contained);
}

TEST(IfcFile, LongNamesOfSpacesSayWhatTheyAreFor)
{
  const auto spaces = smallFile().all("IFCSPACE");
  ASSERT_EQ(spaces.size(), 3u);
  EXPECT_NE(spaces[0].find(",$,.ELEMENT.,"), std::string::npos) << spaces[0];
  EXPECT_NE(spaces[1].find(",'kitchen',.ELEMENT.,"), std::string::npos) << spaces[1];
  EXPECT_NE(spaces[2].find(",$,.ELEMENT.,"), std::string::npos) << spaces[2];
}

TEST(IfcFile, EveryReferenceIsThere)
{
  const auto file = smallFile();
  const std::regex reference("#(\\d+)");
  std::size_t found = 0;
  for (const auto& [number, line] : file.lines())
    for (std::sregex_iterator at(line.second.begin(), line.second.end(), reference),
         end;
         at != end;
         ++at, ++found)
      EXPECT_LT(std::stoul((*at)[1]), number) << line.first; // and written before
  EXPECT_GT(found, 300u);
}

TEST(IfcFile, GlobalIdsAreUniqueAndStay)
{
  const auto text = ifcText(savedScene(SmallScene::json()));
  EXPECT_EQ(text, ifcText(savedScene(SmallScene::json())));
  const std::regex id("\\('([0-9A-Za-z_$]{22})',\\$");
  std::set<std::string> ids;
  std::size_t found = 0;
  for (std::sregex_iterator at(text.begin(), text.end(), id), end; at != end; ++at) {
    ids.insert((*at)[1]);
    ++found;
  }
  EXPECT_EQ(ids.size(), found);
  auto changed = SmallScene::json(); // a wall more changes no door's id
  changed["walls"].push_back(changed["walls"][1]);
  changed["walls"][2]["wall"] = 3;
  const auto ids_of = [](const Step& file) {
    std::vector<std::string> doors;
    for (const auto& door : file.all("IFCDOOR"))
      doors.push_back(door.substr(0, 24));
    return doors;
  };
  EXPECT_EQ(ids_of(Step(text)), ids_of(Step(ifcText(savedScene(changed)))));
}

TEST(IfcFile, DoorsFillTheHolesOfTheirWalls)
{
  const auto file = smallFile();
  const auto wall = file.refOf("IFCWALL", "wall 1");
  const auto hole = file.refOf("IFCOPENINGELEMENT", "opening 1");
  EXPECT_TRUE(has(file.all("IFCRELVOIDSELEMENT"), wall + "," + hole));
  EXPECT_TRUE(has(file.all("IFCRELFILLSELEMENT"),
                  hole + "," + file.refOf("IFCDOOR", "door 1")));
  EXPECT_EQ(file.count("IFCRELFILLSELEMENT"), 2u); // one door is in no wall
  EXPECT_TRUE(has(file.all("IFCDOOR"), "2.,0.9,.DOOR."));
  // the hole goes through the wall, from its axis, 1.5 m from its begin
  EXPECT_TRUE(has(file.all("IFCRECTANGLEPROFILEDEF"), ",0.9,0.4"));
  EXPECT_TRUE(has(file.all("IFCCARTESIANPOINT"), "(1.5,0.,0.)"));
}

TEST(IfcFile, QuantitiesAndPropertiesAreTheScenes)
{
  const auto file = smallFile();
  EXPECT_TRUE(has(file.all("IFCQUANTITYAREA"), "'NetFloorArea',$,$,11.75,$"));
  EXPECT_TRUE(has(file.all("IFCQUANTITYLENGTH"), "'Width',$,$,0.2,$"));
  EXPECT_TRUE(has(file.all("IFCPROPERTYSINGLEVALUE"), "'Confidence',$,IFCREAL(0.75)"));
  EXPECT_TRUE(has(file.all("IFCFURNITURE"), ".CHAIR."));
  EXPECT_EQ(file.count("IFCMATERIALLAYER"), 1u); // of the wall whose sides are known
}

TEST(IfcFile, TheOffsetIsTheMapConversion)
{
  auto json = SmallScene::json();
  const Step known(ifcText(savedScene(json), 25832));
  EXPECT_TRUE(has(known.all("IFCPROJECTEDCRS"), "'EPSG:25832'"));
  EXPECT_TRUE(has(known.all("IFCMAPCONVERSION"), "100.,200.,10.,1.,0.,1."));
  EXPECT_EQ(smallFile().count("IFCMAPCONVERSION"), 1u);
  json["offset"] = {0, 0, 0};
  EXPECT_EQ(Step(ifcText(savedScene(json))).count("IFCMAPCONVERSION"), 0u);
}

TEST(IfcFile, OfAPassageWithoutAWallThereIsAVirtualElement)
{
  auto json = SmallScene::json();
  json["openings"][0]["kind"] = "passage";
  EXPECT_EQ(Step(ifcText(savedScene(json))).count("IFCVIRTUALELEMENT"), 0u);
  json["openings"][2]["kind"] = "passage";
  const Step file(ifcText(savedScene(json)));
  EXPECT_EQ(file.count("IFCVIRTUALELEMENT"), 1u);
  EXPECT_EQ(file.count("IFCDOOR"), 0u);
  EXPECT_EQ(file.count("IFCOPENINGELEMENT"), 2u);
}

TEST(IfcFile, AnEmptySceneIsABuilding)
{
  auto json = SmallScene::json();
  for (const char* list : {"storeys", "rooms", "walls", "openings", "objects"})
    json[list] = pcl::indoor::test::SceneJson::array();
  const Step file(ifcText(savedScene(json)));
  EXPECT_EQ(file.count("IFCBUILDING"), 1u);
  EXPECT_EQ(file.count("IFCBUILDINGSTOREY"), 0u);
}
