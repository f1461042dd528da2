/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/ifc_elements.h"

#include <utility>

namespace pcl::indoor::tool {

IfcElements::IfcElements(StepFile& file, std::string seed)
: file_(file)
, seed_(std::move(seed))
{}

std::string
IfcElements::root(const std::string& name) const
{
  return stepGlobalId(seed_ + "\n" + name) + ",$";
}

StepEntity
IfcElements::add(const IfcElement& element)
{
  const auto number = element.number.empty() ? "" : " " + element.number;
  const auto name = (element.type.empty() ? element.kind : element.type) + number;
  std::string text = element.entity + "(" + root(element.kind + number) + "," +
                     stepText(name) + ",$," +
                     (element.type.empty() ? "$" : stepText(element.type)) + "," +
                     stepRef(element.placement) + "," + stepRef(element.shape);
  for (const auto& attribute : element.more)
    text += "," + attribute;
  return file_.add(text + ")");
}

void
IfcElements::relate(const std::string& relation,
                    StepEntity whole,
                    const std::vector<StepEntity>& parts)
{
  if (parts.empty())
    return;
  const auto begin = relation + "(" + root(relation + " " + stepRef(whole)) + ",$,$,";
  const bool parts_first = relation == "IFCRELCONTAINEDINSPATIALSTRUCTURE";
  file_.add(begin +
            (parts_first ? stepList(parts) + "," + stepRef(whole)
                         : stepRef(whole) + "," + stepList(parts)) +
            ")");
}

void
IfcElements::relateOne(const std::string& relation, StepEntity whole, StepEntity part)
{
  file_.add(relation + "(" + root(relation + " " + stepRef(part)) + ",$,$," +
            stepRef(whole) + "," + stepRef(part) + ")");
}

void
IfcElements::define(StepEntity element,
                    const std::string& set,
                    const std::string& definition)
{
  file_.add("IFCRELDEFINESBYPROPERTIES(" +
            root("definition " + set + " " + stepRef(element)) + ",$,$,(" +
            stepRef(element) + ")," + stepRef(file_.add(definition)) + ")");
}

void
IfcElements::addQuantities(StepEntity element,
                           const std::string& set,
                           const std::vector<IfcValue>& values)
{
  std::vector<StepEntity> quantities;
  for (const auto& value : values)
    quantities.push_back(
        file_.share(value.type + "('" + value.name + "',$,$," + value.value + ",$)"));
  define(element,
         set,
         "IFCELEMENTQUANTITY(" + root(set + " " + stepRef(element)) + ",'" + set +
             "',$,$," + stepList(quantities) + ")");
}

void
IfcElements::addProperties(StepEntity element,
                           const std::string& set,
                           const std::vector<IfcValue>& values)
{
  std::vector<StepEntity> properties;
  for (const auto& value : values)
    properties.push_back(file_.share("IFCPROPERTYSINGLEVALUE('" + value.name + "',$," +
                                     value.type + "(" + value.value + "),$)"));
  define(element,
         set,
         "IFCPROPERTYSET(" + root(set + " " + stepRef(element)) + ",'" + set + "',$," +
             stepList(properties) + ")");
}

} // namespace pcl::indoor::tool
