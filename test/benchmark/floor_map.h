/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include "thesis/rooms/field_connectivity.h"
#include "thesis/rooms/potential_field.h"
#include "thesis/rooms/visibility_vectors.h"

#include <random>

/** A storey of rooms with doors and furniture: its voxels, field map and pixels. */
struct FloorMap {
  pcl::indoor::VoxelMap<std::uint8_t> occupancy, interior;
  pcl::indoor::PixelMap<float> field;
  pcl::indoor::PixelMap<int> heights;
  std::vector<std::size_t> pixels;
  std::vector<Eigen::Vector3i> highest; // of each pixel

  /** \param[in] edge voxels along x and y, 20 cm each; rooms are 3.6 to 7.2 m wide */
  explicit FloorMap(int edge, int nz = 16)
  {
    std::mt19937 rng(7);
    occupancy.shape = {edge, edge, nz};
    occupancy.voxel_size = 0.2;
    occupancy.values.assign(occupancy.shape.size(), 0);
    const std::vector<int> walls_x = wallPlaces(edge, rng);
    const std::vector<int> walls_y = wallPlaces(edge, rng);
    for (const int wall : walls_x)
      addWall(wall, true, walls_y, rng);
    for (const int wall : walls_y)
      addWall(wall, false, walls_x, rng);
    for (int k = edge * edge / 400; k > 0; --k) // furniture up to 1.6 m
      addBox(static_cast<int>(rng() % edge), static_cast<int>(rng() % edge), rng);
    for (int x = 0; x < edge; ++x)
      for (int y = 0; y < edge; ++y)
        occupancy.at(x, y, 0) = occupancy.at(x, y, nz - 1) = 1;
    interior = occupancy;
    for (auto& value : interior.values)
      value = !value;
    field = pcl::indoor::fieldMap(pcl::indoor::potentialField(occupancy), interior);
    heights = pcl::indoor::highestFreeVoxel(interior);
    for (int x = 0; x < edge; ++x)
      for (int y = 0; y < edge; ++y)
        if (heights.at(x, y) >= 0) {
          pixels.push_back(field.index(x, y));
          highest.emplace_back(x, y, heights.at(x, y));
        }
  }

private:
  static std::vector<int>
  wallPlaces(int edge, std::mt19937& rng)
  {
    std::vector<int> places;
    for (int place = 0; place < edge; place += 18 + static_cast<int>(rng() % 19))
      places.push_back(place);
    places.push_back(edge - 1);
    return places;
  }

  void
  addWall(int place, bool along_y, const std::vector<int>& crossings, std::mt19937& rng)
  {
    const int edge = occupancy.shape.nx, lintel = occupancy.shape.nz - 5;
    for (int k = 0; k < edge; ++k)
      for (int z = 0; z < occupancy.shape.nz; ++z)
        (along_y ? occupancy.at(place, k, z) : occupancy.at(k, place, z)) = 1;
    for (std::size_t c = 0; c + 1 < crossings.size(); ++c) {
      if (place == 0 || place == edge - 1 || rng() % 3 == 0)
        continue;
      const int width = crossings[c + 1] - crossings[c];
      const int door = crossings[c] + 2 + static_cast<int>(rng() % width) % 12;
      for (int k = door; k < std::min(door + 5, crossings[c + 1] - 1); ++k)
        for (int z = 0; z < lintel; ++z)
          (along_y ? occupancy.at(place, k, z) : occupancy.at(k, place, z)) = 0;
    }
  }

  void
  addBox(int x0, int y0, std::mt19937& rng)
  {
    const int height = 2 + static_cast<int>(rng() % 7);
    for (int x = x0; x < std::min(x0 + 4, occupancy.shape.nx); ++x)
      for (int y = y0; y < std::min(y0 + 3, occupancy.shape.ny); ++y)
        for (int z = 0; z < height; ++z)
          occupancy.at(x, y, z) = 1;
  }
};
