/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "building/part_maker.h"

#include <pcl/exceptions.h>

#include <algorithm>

namespace pcl {
namespace indoor {

namespace {

std::vector<FurnitureClass>
allClasses()
{
  std::vector<FurnitureClass> classes;
  for (const auto& family : {seatingClasses(),
                             tableClasses(),
                             storageClasses(),
                             structureClasses(),
                             fixtureClasses(),
                             chairVariants(),
                             loungeVariants(),
                             tableVariants(),
                             storageVariants(),
                             kitchenClasses(),
                             bathroomClasses(),
                             lampClasses(),
                             deviceClasses(),
                             decorationClasses(),
                             clutterClasses(),
                             vesselClasses()})
    classes.insert(classes.end(), family.begin(), family.end());
  return classes;
}

std::vector<FurnitureClass>
shapesOf(const std::string& category)
{
  std::vector<FurnitureClass> shapes;
  for (const auto& shape : allClasses())
    if (shape.name == category)
      shapes.push_back(shape);
  if (shapes.empty())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "there is no furniture class '" << category << "'");
  return shapes;
}

} // namespace

std::vector<std::string>
furnitureCategories()
{
  std::vector<std::string> names;
  for (const auto& c : allClasses())
    names.emplace_back(c.name);
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

int
furnitureVariants(const std::string& category)
{
  return static_cast<int>(shapesOf(category).size());
}

FurnitureModel
makeFurniture(const std::string& category,
              std::uint32_t seed,
              const std::optional<Eigen::Vector3d>& size,
              int variant)
{
  const auto shapes = shapesOf(category);
  if (variant < 0 || variant >= static_cast<int>(shapes.size()))
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "the variant of a " << category << " must lie within 0 and "
                                            << shapes.size() - 1 << ", not "
                                            << variant);
  const auto& found = shapes[static_cast<std::size_t>(variant)];
  RandomDraw draw(seed);
  Eigen::Vector3d extent;
  for (int axis = 0; axis < 3; ++axis) // drawn in any case: size changes nothing else
    extent[axis] = draw.uniform(found.smallest[axis], found.largest[axis]);
  if (size)
    extent = *size;
  if (!(extent.minCoeff() > 0.0))
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "the size of a " << category << " must be positive, not "
                                         << extent.transpose() << " m");
  PartMaker make(extent);
  found.build(make, extent, draw);
  return make.take();
}

} // namespace indoor
} // namespace pcl
