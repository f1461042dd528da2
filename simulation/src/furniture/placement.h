/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/building.h>
#include <pcl/simulation/furniture.h>

namespace pcl::indoor {

/** \brief Where furniture stands, with its size known and its height settled. */
struct FurniturePlacement {
  std::uint32_t room = 0;      ///< number of the room that its points belong to
  std::uint32_t stands_in = 0; ///< number of the room that holds it
  Eigen::Vector3d position;    ///< middle of its bottom, metres
  FurnitureModel model;
};

/** \brief Build a piece of furniture and find its place.
 * \param[in] item the piece
 * \param[in] seed of its variation
 * \param[in] building with its rooms and wells
 * \param[in] storey_number of the storey that lists the piece
 * \param[in] storey the same
 * \param[in] source what error messages call the plan
 * \throws PlanError if it stands in no room, reaches through a wall, below the floor or
 * above the ceiling
 */
FurniturePlacement
placeFurniture(const FurniturePlan& item,
               std::uint32_t seed,
               const Building& building,
               std::size_t storey_number,
               const StoreyPlan& storey,
               const std::string& source);

} // namespace pcl::indoor
