/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/catalogue.h"

#include <pcl/exceptions.h>

#include <map>
#include <utility>

namespace pcl::indoor {

namespace {

using Catalogue = std::map<std::string, std::vector<FurnitureClass>>;

void
add(Catalogue& catalogue, const std::vector<std::vector<FurnitureClass>>& families)
{
  for (const auto& family : families)
    for (const auto& shape : family)
      catalogue[shape.name].push_back(shape);
}

const Catalogue&
plainCatalogue()
{
  static const Catalogue catalogue = [] {
    Catalogue classes;
    add(classes,
        {seatingClasses(),
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
         vesselClasses()});
    return classes;
  }();
  return catalogue;
}

const Catalogue&
wholeCatalogue()
{
  static const Catalogue catalogue = [] {
    Catalogue classes = plainCatalogue();
    add(classes,
        {seatShapes(),
         loungeShapes(),
         tableShapes(),
         storageShapes(),
         kitchenShapes(),
         bathroomShapes(),
         lampShapes(),
         deviceShapes(),
         decorationShapes(),
         vesselShapes(),
         clothShapes(),
         looseShapes(),
         structureShapes(),
         bedShapes(),
         wardrobeShapes(),
         applianceShapes(),
         screenShapes(),
         plantShapes(),
         wareShapes()});
    return classes;
  }();
  return catalogue;
}

} // namespace

const std::vector<FurnitureClass>&
shapesOf(const std::string& category)
{
  const auto found = wholeCatalogue().find(category);
  if (found == wholeCatalogue().end())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "there is no furniture class '" << category << "'");
  return found->second;
}

int
plainShapes(const std::string& category)
{
  const auto found = plainCatalogue().find(category);
  return found == plainCatalogue().end() ? 0 : static_cast<int>(found->second.size());
}

std::vector<std::string>
furnitureCategories()
{
  std::vector<std::string> names;
  for (const auto& entry : wholeCatalogue())
    names.push_back(entry.first);
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
  const auto& shapes = shapesOf(category);
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
  PartMaker make(extent, !found.fitted);
  found.build(make, extent, draw);
  if (found.fitted)
    make.fit();
  return make.take();
}

} // namespace pcl::indoor
