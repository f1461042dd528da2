/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/enclosure.h"
#include "rooms/space/grid_cut.h"

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace pcl::indoor;

namespace {

using Grid = VoxelMap<std::uint8_t>;

Grid
randomGrid(std::mt19937& rng, int largest, unsigned one_in)
{
  Grid grid;
  const auto side = [&] { return 1 + static_cast<int>(rng() % largest); };
  grid.shape = {side(), side(), side()};
  for (std::size_t v = 0; v < grid.shape.size(); ++v)
    grid.values.push_back(rng() % one_in == 0 ? 1 + rng() % 200 : 0);
  return grid;
}

/** \brief Walk from a voxel along its discretised line until something is occupied. */
bool
meetsOccupied(
    const Grid& grid, int x, int y, int z, const Eigen::Vector2d& direction, int sense)
{
  const bool along_x = std::abs(direction.x()) >= std::abs(direction.y());
  const double slope =
      along_x ? direction.y() / direction.x() : direction.x() / direction.y();
  const auto shift = [&](int i) {
    return static_cast<int>(std::floor(i * slope + 0.5));
  };
  const int start = along_x ? x : y;
  const int line = (along_x ? y : x) - shift(start);
  for (int i = start + sense;; i += sense) {
    const int across = line + shift(i);
    const int px = along_x ? i : across;
    const int py = along_x ? across : i;
    if (!grid.shape.contains(px, py, z))
      return false;
    if (grid.at(px, py, z))
      return true;
  }
}

/** \brief The same along a direction that need not be level. */
bool
meetsOccupied(const Grid& grid,
              const Eigen::Vector3i& start,
              const Eigen::Vector3d& direction,
              int sense)
{
  int major = 0;
  direction.cwiseAbs().maxCoeff(&major);
  const Eigen::Vector3d slope = direction / direction[major];
  const auto shift = [&](int i) {
    Eigen::Vector3i place;
    for (int axis = 0; axis < 3; ++axis)
      place[axis] = static_cast<int>(std::floor(i * slope[axis] + 0.5));
    return place;
  };
  for (int i = start[major] + sense;; i += sense) {
    const Eigen::Vector3i place = start - shift(start[major]) + shift(i);
    if (!grid.shape.contains(place.x(), place.y(), place.z()))
      return false;
    if (grid.at(place.x(), place.y(), place.z()))
      return true;
  }
}

std::uint8_t
bitsByWalking(const Grid& grid,
              int x,
              int y,
              int z,
              const std::vector<Eigen::Vector2d>& directions)
{
  if (grid.at(x, y, z))
    return 0;
  int bits = 0;
  for (int other = 0; other < grid.shape.nz; ++other)
    if (grid.at(x, y, other))
      bits |= other < z ? ENCLOSED_BELOW : ENCLOSED_ABOVE;
  for (std::size_t i = 0; i < directions.size(); ++i)
    if (meetsOccupied(grid, x, y, z, directions[i], 1) &&
        meetsOccupied(grid, x, y, z, directions[i], -1))
      bits |= ENCLOSED_ALONG_DIRECTION << i;
  return static_cast<std::uint8_t>(bits);
}

std::vector<Eigen::Vector3d>
inSpace(const std::vector<Eigen::Vector2d>& level)
{
  std::vector<Eigen::Vector3d> directions;
  for (const auto& direction : level)
    directions.emplace_back(direction.x(), direction.y(), 0.0);
  return directions;
}

/** \brief A house with one room: floor, ceiling and walls, with free space around. */
Grid
house(int thickness_around)
{
  Grid grid;
  const int n = 12 + 2 * thickness_around;
  grid.shape = {n, n, 10};
  grid.values.assign(grid.shape.size(), 0);
  const int low = thickness_around;
  const int high = n - 1 - thickness_around;
  for (int x = low; x <= high; ++x)
    for (int y = low; y <= high; ++y)
      for (int z = 1; z <= 8; ++z)
        grid.at(x, y, z) =
            x == low || x == high || y == low || y == high || z == 1 || z == 8;
  return grid;
}

} // namespace

TEST(Enclosure, EqualsWalkingAlongTheLines)
{
  std::mt19937 rng(21);
  for (int trial = 0; trial < 150; ++trial) {
    const Grid grid = randomGrid(rng, 14, 5 + rng() % 20);
    std::vector<Eigen::Vector2d> directions;
    for (unsigned i = rng() % 6; i > 0; --i) {
      const double angle = 0.001 * static_cast<double>(rng() % 6284);
      directions.emplace_back(0.5 * std::cos(angle), 0.5 * std::sin(angle));
    }
    if (trial % 5 == 0)
      directions = {{1, 0}, {0, 1}, {1, 1}, {-1, 1}};
    const auto bits = enclosure(grid, inSpace(directions), 1 + trial % 3);
    for (int x = 0; x < grid.shape.nx; ++x)
      for (int y = 0; y < grid.shape.ny; ++y)
        for (int z = 0; z < grid.shape.nz; ++z)
          ASSERT_EQ(int{bits.at(x, y, z)},
                    int{bitsByWalking(grid, x, y, z, directions)})
              << "trial " << trial << " voxel " << x << " " << y << " " << z;
  }
}

TEST(Enclosure, SenseAndLengthOfADirectionDoNotMatter)
{
  std::mt19937 rng(22);
  const Grid grid = randomGrid(rng, 20, 10);
  const Eigen::Vector3d direction(0.3, -0.8, 0.0);
  EXPECT_EQ(enclosure(grid, {direction}).values,
            enclosure(grid, {-7.0 * direction}).values);
}

TEST(EnclosureEvidence, IsEquation31)
{
  const std::uint8_t dom1 = ENCLOSED_ALONG_DIRECTION;
  const std::uint8_t dom2 = ENCLOSED_ALONG_DIRECTION << 1;
  EXPECT_DOUBLE_EQ(enclosureEvidence(0, 2), 0.0);
  EXPECT_DOUBLE_EQ(enclosureEvidence(ENCLOSED_BELOW, 2), 1.5);
  EXPECT_DOUBLE_EQ(enclosureEvidence(ENCLOSED_ABOVE, 2), 0.5);
  EXPECT_DOUBLE_EQ(enclosureEvidence(ENCLOSED_BELOW | ENCLOSED_ABOVE, 2), 2.5);
  EXPECT_DOUBLE_EQ(enclosureEvidence(dom1, 2), 0.5);
  EXPECT_DOUBLE_EQ(enclosureEvidence(dom2, 2), 0.5);
  EXPECT_DOUBLE_EQ(enclosureEvidence(ENCLOSED_BELOW | ENCLOSED_ABOVE | dom1 | dom2, 2),
                   3.5);
  EXPECT_DOUBLE_EQ(enclosureEvidence(dom1 | dom2, 4), 0.5); // all directions: 1
  EXPECT_DOUBLE_EQ(enclosureEvidence(dom1, 0), 0.0);        // not asked for
}

TEST(InteriorGain, CutsAHouseFromTheSpaceAround)
{
  const Grid grid = house(4);
  const auto bits = enclosure(grid, {{1, 0, 0}, {0, 1, 0}});
  const auto gain = interiorGain(grid, bits, 2);
  const GridCut cut = cutGrid(grid.shape, gain, 60);
  for (int x = 0; x < grid.shape.nx; ++x)
    for (int y = 0; y < grid.shape.ny; ++y)
      for (int z = 0; z < grid.shape.nz; ++z) {
        const bool inside = x > 4 && x < 15 && y > 4 && y < 15 && z > 1 && z < 8;
        EXPECT_EQ(cut.inside[grid.shape.index(x, y, z)], inside);
        const int expected = grid.at(x, y, z) ? GRID_CUT_EXCLUDED : 200;
        if (grid.at(x, y, z) || inside) {
          EXPECT_EQ(int{gain[grid.shape.index(x, y, z)]}, expected);
        }
      }
}

TEST(InteriorGain, WeakEvidenceGoesOutside)
{
  // A courtyard: walls around, nothing below or above.
  Grid grid = house(2);
  for (int x = 3; x < 13; ++x)
    for (int y = 3; y < 13; ++y)
      grid.at(x, y, 1) = grid.at(x, y, 8) = 0;
  const auto gain = interiorGain(grid, enclosure(grid, {{1, 0, 0}, {0, 1, 0}}), 2);
  const GridCut cut = cutGrid(grid.shape, gain, 60);
  EXPECT_EQ(std::count(cut.inside.begin(), cut.inside.end(), 1), 0);
}

TEST(Enclosure, EmptyGrid)
{
  EXPECT_TRUE(enclosure({}, {{1, 0, 0}}).values.empty());
  EXPECT_TRUE(interiorGain({}, {}, 1).codes.empty());
}

TEST(Enclosure, RefusesBadArguments)
{
  Grid grid;
  grid.shape = {1, 1, 1};
  EXPECT_THROW(enclosure(grid, {}), pcl::BadArgumentException);
  EXPECT_THROW(interiorGain(grid, grid, 2), pcl::BadArgumentException);
  grid.values = {0};
  EXPECT_THROW(enclosure(grid, {{0, 0, 0}}), pcl::BadArgumentException);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(enclosure(grid, {{nan, 1, 0}}), pcl::BadArgumentException);
  EXPECT_THROW(enclosure(grid, std::vector<Eigen::Vector3d>(6, {1, 0, 0})),
               pcl::BadArgumentException);
  EXPECT_THROW(enclosure(grid, {{1, 0, 0}}, -1), pcl::BadArgumentException);
  EnclosureWeights heavy;
  heavy.below = 1000.0;
  EXPECT_THROW(interiorGain(grid, grid, 2, heavy), pcl::BadArgumentException);
}

TEST(Enclosure, AlongDirectionsInSpaceAgreesWithWalking)
{
  std::mt19937 rng(11);
  const auto component = [&] { return static_cast<double>(rng() % 2001) / 1000 - 1; };
  for (int trial = 0; trial < 60; ++trial) {
    const Grid grid = randomGrid(rng, 12, 12);
    std::vector<Eigen::Vector3d> directions;
    for (int i = 0; i < trial % 4; ++i)
      directions.emplace_back(component(), component(), component());
    if (trial % 5 == 0)
      directions.emplace_back(0.6, 0.0, -0.8);
    const auto bits = enclosure(grid, directions, 1 + trial % 3);
    for (int x = 0; x < grid.shape.nx; ++x)
      for (int y = 0; y < grid.shape.ny; ++y)
        for (int z = 0; z < grid.shape.nz; ++z) {
          int expected = bitsByWalking(grid, x, y, z, {});
          for (std::size_t i = 0; i < directions.size() && !grid.at(x, y, z); ++i)
            if (meetsOccupied(grid, {x, y, z}, directions[i], 1) &&
                meetsOccupied(grid, {x, y, z}, directions[i], -1))
              expected |= ENCLOSED_ALONG_DIRECTION << i;
          ASSERT_EQ(bits.at(x, y, z), expected) << x << ' ' << y << ' ' << z;
        }
  }
}
