/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "furniture/part_maker.h" // for FurnitureClass

#include <string>
#include <vector>

namespace pcl::indoor {

/** \brief All shapes of a class; first those that plain random plans draw from.
 * \throws BadArgumentException if there is no such class */
const std::vector<FurnitureClass>&
shapesOf(const std::string& category);

/** \brief How many shapes of a class plain random plans draw from; 0 for classes that
 * only lived-in rooms have. */
int
plainShapes(const std::string& category);

/** \brief The classes of each family; makeFurniture() puts them together. */
std::vector<FurnitureClass>
seatingClasses();
std::vector<FurnitureClass>
tableClasses();
std::vector<FurnitureClass>
storageClasses();
std::vector<FurnitureClass>
structureClasses();
std::vector<FurnitureClass>
fixtureClasses();
std::vector<FurnitureClass>
chairVariants();
std::vector<FurnitureClass>
loungeVariants();
std::vector<FurnitureClass>
tableVariants();
std::vector<FurnitureClass>
storageVariants();
std::vector<FurnitureClass>
kitchenClasses();
std::vector<FurnitureClass>
bathroomClasses();
std::vector<FurnitureClass>
lampClasses();
std::vector<FurnitureClass>
deviceClasses();
std::vector<FurnitureClass>
decorationClasses();
std::vector<FurnitureClass>
clutterClasses();
std::vector<FurnitureClass>
vesselClasses();

/** \brief The shapes that lived-in rooms have besides, each a row of a table. */
std::vector<FurnitureClass>
seatShapes();
std::vector<FurnitureClass>
loungeShapes();
std::vector<FurnitureClass>
tableShapes();
std::vector<FurnitureClass>
storageShapes();
std::vector<FurnitureClass>
kitchenShapes();
std::vector<FurnitureClass>
bathroomShapes();
std::vector<FurnitureClass>
bedShapes();
std::vector<FurnitureClass>
wardrobeShapes();
std::vector<FurnitureClass>
applianceShapes();
std::vector<FurnitureClass>
screenShapes();
std::vector<FurnitureClass>
plantShapes();
std::vector<FurnitureClass>
wareShapes();
std::vector<FurnitureClass>
lampShapes();
std::vector<FurnitureClass>
deviceShapes();
std::vector<FurnitureClass>
decorationShapes();
std::vector<FurnitureClass>
vesselShapes();
std::vector<FurnitureClass>
clothShapes();
std::vector<FurnitureClass>
looseShapes();
std::vector<FurnitureClass>
structureShapes();

} // namespace pcl::indoor
