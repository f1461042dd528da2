/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/furniture.h>
#include <pcl/simulation/polygon.h>
#include <pcl/simulation/random_draw.h>

#include <functional>

namespace pcl::indoor {

/** \brief An upright rectangle's extent in x and y. */
struct Rectangle {
  double x0, y0, x1, y1;
};

/** \brief An outline at a height: a share of an extent, 1 an ellipse, 0.3 a rounded
 * rectangle. */
struct Section {
  double scale, z, corner = 1.0;
};

/** \brief Collects the parts of one piece of furniture. */
class PartMaker {
public:
  /** \param[in] size of the piece, metres
   * \param[in] cuts whether lofts, bars and slabs are cut back to it */
  explicit PartMaker(const Eigen::Vector3d& size, bool cuts = true)
  : cuts_(cuts)
  {
    model_.size = size;
  }

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

  /** \brief Add a body through sections around a vertical axis. Sections that go up
   * make its outside, sections that go down the inside of something hollow. What would
   * reach beyond the piece is cut back to its size.
   */
  void
  loft(const std::string& name,
       const Rectangle& extent,
       const std::vector<Section>& sections,
       int sides = 16);

  /** \brief Add a round bar between two points, also cut back to the size. */
  void
  rod(const std::string& name,
      const Eigen::Vector3d& from,
      const Eigen::Vector3d& to,
      double radius,
      int sides = 6);

  /** \brief Add a convex, counter-clockwise outline between two heights. */
  void
  slab(const std::string& name, const Polygon& outline, double z0, double z1);

  /** \brief Add something soft: a rectangle's extent with round edges. */
  void
  cushion(const std::string& name, const Rectangle& r, double z0, double z1)
  {
    const double h = z1 - z0;
    loft(name,
         r,
         {{0.85, z0, 0.3},
          {1.0, z0 + 0.3 * h, 0.3},
          {1.0, z0 + 0.6 * h, 0.3},
          {0.85, z0 + 0.92 * h, 0.35},
          {0.0, z1, 0.5}});
  }

  /** \brief Add a vessel that is open above; scales of its bottom and its top. */
  void
  vessel(const std::string& name,
         const Rectangle& r,
         double z0,
         double z1,
         double bottom,
         double top,
         double corner = 1.0)
  {
    const double floor = z0 + 0.1 * (z1 - z0);
    loft(name,
         r,
         {{bottom, z0, corner},
          {top, z1, corner},
          {0.9 * top, z1, corner},
          {0.88 * bottom, floor, corner}});
  }

  /** \brief Add a vessel whose inside and bottom are parts of their own.
   * \param[in] sections of its outer side, from its foot to its rim
   * \param[in] thickness of its wall and floor, metres */
  void
  hollow(const std::string& name,
         const Rectangle& r,
         const std::vector<Section>& sections,
         double thickness);

  /** \brief Add a shade that is open below; the scale of its top. */
  void
  shade(const Rectangle& r, double z0, double z1, double top)
  {
    loft("shade",
         r,
         {{0.9 * top, z1 - 0.1 * (z1 - z0)},
          {0.93, z0},
          {1.0, z0},
          {0.4 + 0.6 * top, 0.4 * z0 + 0.6 * z1},
          {top, z1}});
  }

  /** \brief Add a part of triangles that enclose it; they are turned outwards. What
   * reaches beyond the piece stays so: see fit(). */
  void
  add(const std::string& name, std::vector<Triangle> triangles);

  /** \brief Stretch all parts to fill exactly the size of the piece. */
  void
  fit();

  /** \brief Join the last \a count parts to one, called \a name. */
  void
  join(int count, const std::string& name);

  FurnitureModel
  take()
  {
    return std::move(model_);
  }

private:
  Eigen::Vector3d
  cutBack(const Eigen::Vector3d& p) const;

  FurnitureModel model_;
  bool cuts_;
};

using FurnitureRecipe =
    std::function<void(PartMaker&, const Eigen::Vector3d&, RandomDraw&)>;

/** \brief One shape of a class of furniture: between which sizes it varies, and how it
 * is built. Several shapes may have one name; their order is that of the variants. */
struct FurnitureClass {
  const char* name;
  Eigen::Vector3d smallest, largest;
  FurnitureRecipe build;
  bool fitted = false; ///< stretched to its size in the end, instead of cut back to it
  int like = 0;        ///< if fitted: lived-in rooms may have it in place of this shape
};

/** \brief In place of FurnitureClass::like: rooms have the shape only where they ask
 * for its number. */
constexpr int by_number = -1;

/** \brief Doors side by side on the front of a body of a size, with handles or without.
 * They fill the last 0.04 m of its depth.
 */
void
fronts(PartMaker& make,
       const Eigen::Vector3d& size,
       int doors,
       double z0,
       double z1,
       bool handles);

/** \brief How many parts of about a length fill another. */
int
partsIn(double length, double each, int least = 1);

/** \brief Four square bars that stand upright on the floor.
 * \param[in] places their lowest corners, metres
 * \param[in] thickness of a bar, metres */
void
cornerPosts(PartMaker& make,
            const std::string& name,
            const Rectangle& places,
            double thickness,
            double height);

/** \brief The outline of a ball that stands on the floor, for loft(). */
std::vector<Section>
ballSections(double height);

/** \brief Four round legs that stand apart by \a splay more below than above. */
void
roundLegs(PartMaker& make, double x, double y, double radius, double z, double splay);

} // namespace pcl::indoor
