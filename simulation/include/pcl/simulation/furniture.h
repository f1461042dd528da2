/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/simulation/ray_tracer.h> // for Triangle

#include <optional>
#include <string>
#include <vector>

namespace pcl::indoor {

/** \brief One part of a piece of furniture, such as a seat or a leg. */
struct FurniturePart {
  std::string name;
  std::vector<Triangle> triangles;
  bool glass = false;
};

/** \brief A piece of furniture in its own frame.
 *
 * The middle of the footprint is the origin, z is up from its lowest point, the front
 * faces +y. All parts lie within size: |x| <= size.x / 2, |y| <= size.y / 2,
 * 0 <= z <= size.z.
 */
struct FurnitureModel {
  Eigen::Vector3d size = Eigen::Vector3d::Zero(); ///< width, depth, height, metres
  std::vector<FurniturePart> parts;
};

/** \brief Names of the classes that makeFurniture() knows, sorted. */
PCL_INDOOR_EXPORTS std::vector<std::string>
furnitureCategories();

/** \brief How many shapes a class has.
 * \throws BadArgumentException if the category is unknown
 */
PCL_INDOOR_EXPORTS int
furnitureVariants(const std::string& category);

/** \brief Build a piece of furniture.
 * \param[in] category one of furnitureCategories()
 * \param[in] seed the same seed gives the same piece; another one another variation
 * \param[in] size width, depth, height in metres, positive; default: drawn from the
 * seed
 * \param[in] variant which shape of the class, 0 to furnitureVariants() - 1
 * \throws BadArgumentException if the category or variant is unknown or a size is not
 * positive
 */
PCL_INDOOR_EXPORTS FurnitureModel
makeFurniture(const std::string& category,
              std::uint32_t seed,
              const std::optional<Eigen::Vector3d>& size = std::nullopt,
              int variant = 0);

/** \brief Build stairs of two flights side by side with a landing between them.
 *
 * They begin at the front (+y) on the right (+x), turn to the left on a landing along
 * the rear, and end at the front on the left.
 * \param[in] size width, depth and height of all, metres; the handrail ends 1 m above
 * the last step
 */
PCL_INDOOR_EXPORTS FurnitureModel
makeHalfTurnStairs(const Eigen::Vector3d& size);

/** \brief Build a door: a frame that lines the hole, a leaf and two handles.
 *
 * The hole spans |x| <= width / 2 and the wall |y| <= depth / 2; the leaf turns
 * towards +y. An open leaf reaches beyond the wall.
 * \param[in] width of the hole, metres
 * \param[in] height of the hole, metres
 * \param[in] depth of the wall, metres
 * \param[in] leaf_angle radians, 0 closed
 * \param[in] hinge_left hinge at +x, which is left when looking from +y to the door
 */
PCL_INDOOR_EXPORTS FurnitureModel
makeDoor(double width, double height, double depth, double leaf_angle, bool hinge_left);

/** \brief Build a window: a frame with one bar per metre of width, and a pane of glass.
 * The measures are those of makeDoor().
 * \param[in] frame_width of frame and bars, seen from the room, metres
 * \param[in] frame_depth of these, metres; at most the wall's
 */
PCL_INDOOR_EXPORTS FurnitureModel
makeWindow(double width,
           double height,
           double depth,
           double frame_width = 0.06,
           double frame_depth = 0.08);

} // namespace pcl::indoor
