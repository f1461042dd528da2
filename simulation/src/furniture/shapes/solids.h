/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "furniture/part_maker.h"

#include <Eigen/Geometry>

#include <functional>
#include <string>
#include <vector>

namespace pcl::indoor {

using Size = Eigen::Vector3d;
using Path = std::vector<Eigen::Vector3d>;

/** \brief Points on an ellipse in the plane of two half axes, angles in radians. */
Path
arc(const Eigen::Vector3d& middle,
    const Eigen::Vector3d& first_axis,
    const Eigen::Vector3d& second_axis,
    double from,
    double to,
    int pieces = 8);

/** \brief Add a body through rings of equally many points, closed by fans at its ends.
 */
void
skin(PartMaker& make, const std::string& name, const std::vector<Path>& rings);

/** \brief Add a bent bar of a round (many sides) or square (4) cross-section.
 * \param[in] path its middle line, no point twice, metres */
void
tube(PartMaker& make,
     const std::string& name,
     const Path& path,
     double radius,
     int sides = 6);

/** \brief A place on a surface for u and v from -1 to 1. */
using SheetShape = std::function<Eigen::Vector3d(double u, double v)>;

/** \brief Of how many quads a sheet is made along u and v, and its thickness, metres.
 */
struct SheetGrid {
  int columns, rows;
  double thickness;
};

/** \brief Add a thin body around a surface: cloth, bent plywood, a leaf. */
void
sheet(PartMaker& make,
      const std::string& name,
      const SheetGrid& grid,
      const SheetShape& shape);

/** \brief A flat place in space with the half axes of its extent. */
struct Patch {
  Eigen::Vector3d middle, right, up;
};

/** \brief Add a stuffed cushion: thick in its middle, thin at its seam. */
void
pillow(PartMaker& make, const std::string& name, const Patch& patch, double thickness);

/** \brief Add a box all of whose edges are rounded. */
void
roundBox(PartMaker& make,
         const std::string& name,
         const Rectangle& base,
         double z0,
         double z1,
         double radius);

/** \brief Add a ball stretched to half axes. */
void
ellipsoid(PartMaker& make,
          const std::string& name,
          const Eigen::Vector3d& middle,
          const Eigen::Vector3d& half);

/** \brief A radius at a height. */
struct Turn {
  double radius, z;
};

/** \brief Add a body of revolution about an upright axis, like Section in loft(). */
void
lathe(PartMaker& make,
      const std::string& name,
      const Eigen::Vector2d& middle,
      const std::vector<Turn>& profile,
      int sides = 14);

/** \brief An upright box by its lowest and highest corner. */
struct Corners {
  Eigen::Vector3d low, high;
};

/** \brief Add boards side by side or above each other: a row of bars, slats, shelves.
 * \param[in] first the first one's extent
 * \param[in] step from one to the next, metres */
void
row(PartMaker& make,
    const std::string& name,
    const Corners& first,
    const Eigen::Vector3d& step,
    int count);

/** \brief Add an upright box. */
void
block(PartMaker& make, const std::string& name, const Corners& box);

/** \brief Leaves, a stem and what else grows: blades bent out of one place. */
void
blades(PartMaker& make,
       const std::string& name,
       const Eigen::Vector3d& root,
       const Eigen::Vector3d& reach,
       int count,
       double width,
       RandomDraw& draw);

/** \brief Doors, drawers or bays on a front: how its face is divided. */
struct Front {
  int columns = 1, rows = 1;
  bool drawers = false;
  int handle = 0; ///< 0 none, 1 bars, 2 knobs, 3 recessed rails
  double z0 = 0.0, z1 = 1.0;
};

/** \brief Add door leaves or drawers with handles on the last 4 cm of a depth. */
void
front(PartMaker& make, const Size& size, const Front& face);

/** \brief Add sides, boards and, if wanted, a rear: what one can put objects into.
 * \param[in] bays,rows of its openings */
void
openCase(PartMaker& make, const Corners& box, int bays, int rows, bool back);

/** \brief Add the four rings of a hob around a place. */
void
rings(PartMaker& make, double x, double y, double z, double reach);

/** \brief How something stands. */
enum class Legs {
  Straight, ///< square, at the corners
  Tapered,  ///< thinner below
  Splayed,  ///< round, slanting outwards
  Hairpin,  ///< two thin rods each
  Sled,     ///< bent runners on both sides
  Pedestal, ///< a column on a disc
  Star,     ///< five arms
  Castors,  ///< five arms with wheels
  Panels,   ///< boards on both sides
  Trestle,  ///< two slanted pairs
  Crossed,  ///< an X on both sides
  Columns,  ///< two columns on feet
  Plinth,   ///< a block set back
  Skirt     ///< closed to the floor
};

/** \brief Add what carries a piece from the floor up to a height.
 * \param[in] half half of the width and depth that it stands on, metres */
void
legs(PartMaker& make,
     Legs kind,
     const Eigen::Vector2d& half,
     double height,
     RandomDraw& draw);

/** \brief A shape that is stretched to exactly its size when it is built.
 * \param[in] like the earlier shape of its class in whose place random plans use it */
FurnitureClass
fitted(const char* name,
       const Size& smallest,
       const Size& largest,
       const FurnitureRecipe& build,
       int like = 0);

/** \brief A fitted shape whose recipe is told a style. */
template <class Style>
FurnitureClass
styled(const char* name,
       const Size& smallest,
       const Size& largest,
       const Style& style,
       void (*build)(PartMaker&, const Size&, RandomDraw&, const Style&),
       int like = 0)
{
  const auto recipe = [style,
                       build](PartMaker& make, const Size& size, RandomDraw& draw) {
    build(make, size, draw, style);
  };
  return fitted(name, smallest, largest, recipe, like);
}

} // namespace pcl::indoor
