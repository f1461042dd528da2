/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "export/ifc_shapes.h"
#include "export/step_file.h"

#include <string>
#include <utility>
#include <vector>

namespace pcl::indoor::tool {

/** \brief What every element of an IFC file has. */
struct IfcElement {
  std::string entity; ///< for example IFCWALL
  std::string kind;   ///< of the scene's list, for the GlobalId: "wall"
  std::string number; ///< in that list, for name and GlobalId
  std::string type;   ///< ObjectType, and in the name instead of the kind; empty = none
  StepEntity placement, shape;
  std::vector<std::string> more; ///< attributes of this entity beyond a product's
};

/** \brief A value with its name and type, for example {"Height", "IFCQUANTITYLENGTH",
 * "2.5"}. */
struct IfcValue {
  std::string name, type, value;
};

/** \brief A length, metres. */
inline IfcValue
ifcLength(const std::string& name, double metres)
{
  return {name, "IFCQUANTITYLENGTH", stepReal(metres)};
}

/** \brief An area, m^2. */
inline IfcValue
ifcArea(const std::string& name, double square_metres)
{
  return {name, "IFCQUANTITYAREA", stepReal(square_metres)};
}

/** \brief A volume, m^3. */
inline IfcValue
ifcVolume(const std::string& name, double cubic_metres)
{
  return {name, "IFCQUANTITYVOLUME", stepReal(cubic_metres)};
}

/** \brief A yes or no. */
inline IfcValue
ifcFlag(const std::string& name, bool value)
{
  return {name, "IFCBOOLEAN", value ? ".T." : ".F."};
}

/** \brief Elements of an IFC file and the relations between them. */
class IfcElements {
public:
  /** \param[in] seed of all GlobalIds */
  IfcElements(StepFile& file, std::string seed);

  StepEntity
  add(const IfcElement& element);

  /** \brief A GlobalId and no owner history, as every rooted entity begins.
   * \param[in] name unique within the file */
  std::string
  root(const std::string& name) const;

  /** \brief Say that some are parts of a whole, or in a place: of an entity such as
   * IFCRELAGGREGATES. Without parts nothing is said. */
  void
  relate(const std::string& relation,
         StepEntity whole,
         const std::vector<StepEntity>& parts);

  /** \brief The same with one part, in the order of IFCRELVOIDSELEMENT. */
  void
  relateOne(const std::string& relation, StepEntity whole, StepEntity part);

  /** \brief Lengths, areas and volumes of an element, metres. */
  void
  addQuantities(StepEntity element,
                const std::string& set,
                const std::vector<IfcValue>& values);

  void
  addProperties(StepEntity element,
                const std::string& set,
                const std::vector<IfcValue>& values);

private:
  void
  define(StepEntity element, const std::string& set, const std::string& definition);

  StepFile& file_;
  std::string seed_;
};

} // namespace pcl::indoor::tool
