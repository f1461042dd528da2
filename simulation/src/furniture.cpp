/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "part_maker.h"

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
                             fixtureClasses()})
    classes.insert(classes.end(), family.begin(), family.end());
  return classes;
}

} // namespace

std::vector<std::string>
furnitureCategories()
{
  std::vector<std::string> names;
  for (const auto& c : allClasses())
    names.emplace_back(c.name);
  std::sort(names.begin(), names.end());
  return names;
}

FurnitureModel
makeFurniture(const std::string& category,
              std::uint32_t seed,
              const std::optional<Eigen::Vector3d>& size)
{
  const auto classes = allClasses();
  const auto found = std::find_if(classes.begin(), classes.end(), [&](const auto& c) {
    return c.name == category;
  });
  if (found == classes.end())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "there is no furniture class '" << category << "'");
  RandomDraw draw(seed);
  Eigen::Vector3d extent;
  for (int axis = 0; axis < 3; ++axis) // drawn in any case: size changes nothing else
    extent[axis] = draw.uniform(found->smallest[axis], found->largest[axis]);
  if (size)
    extent = *size;
  if (!(extent.minCoeff() > 0.0))
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "the size of a " << category << " must be positive, not "
                                         << extent.transpose() << " m");
  PartMaker make(extent);
  found->build(make, extent, draw);
  return make.take();
}

} // namespace indoor
} // namespace pcl
