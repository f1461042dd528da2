/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/furniture.h>
#include <pcl/simulation/random_draw.h>

namespace pcl {
namespace indoor {

/** \brief An upright rectangle's extent in x and y. */
struct Rectangle {
  double x0, y0, x1, y1;
};

/** \brief Collects the parts of one piece of furniture. */
class PartMaker {
public:
  explicit PartMaker(const Eigen::Vector3d& size) { model_.size = size; }

  /** \brief Add a part whose bottom and top are rectangles at heights z0 and z1. */
  void
  frustum(const std::string& name,
          const Rectangle& bottom,
          double z0,
          const Rectangle& top,
          double z1);

  /** \brief Add an upright box. */
  void
  box(const std::string& name, const Rectangle& base, double z0, double z1)
  {
    frustum(name, base, z0, base, z1);
  }

  /** \brief Add a cylinder, cone or prism around a vertical axis. */
  void
  prism(const std::string& name,
        const Eigen::Vector2d& center,
        double bottom_radius,
        double z0,
        double top_radius,
        double z1,
        int sides = 16);

  /** \brief Join the last \a count parts to one, called \a name. */
  void
  join(int count, const std::string& name);

  FurnitureModel
  take()
  {
    return std::move(model_);
  }

private:
  FurnitureModel model_;
};

using FurnitureRecipe = void (*)(PartMaker&, const Eigen::Vector3d&, RandomDraw&);

/** \brief A class of furniture: between which sizes it varies, and how it is built. */
struct FurnitureClass {
  const char* name;
  Eigen::Vector3d smallest, largest;
  FurnitureRecipe build;
};

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

} // namespace indoor
} // namespace pcl
