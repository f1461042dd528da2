/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/storeys/storeys.h"
#include "rooms/storeys/unseen_slabs.h"
#include "support/bits_of.h"

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace pcl::indoor;

namespace {

/** \brief Points on the surfaces of a building, 5 cm apart. */
class Building {
public:
  /** \brief A room: floor, ceiling and walls, seen from inside. */
  void
  addRoom(const Eigen::Vector3d& low, const Eigen::Vector3d& high)
  {
    addFloor(low.x(), low.y(), high.x(), high.y(), low.z());
    addFloor(low.x(), low.y(), high.x(), high.y(), high.z());
    addWalls(low, high);
  }

  void
  addWalls(const Eigen::Vector3d& low, const Eigen::Vector3d& high)
  {
    for (double z = low.z(); z <= high.z(); z += step) {
      for (double x = low.x(); x <= high.x(); x += step) {
        add(x, low.y(), z);
        add(x, high.y(), z);
      }
      for (double y = low.y(); y <= high.y(); y += step) {
        add(low.x(), y, z);
        add(high.x(), y, z);
      }
    }
  }

  /** \brief A horizontal surface with an optional slope along x. */
  void
  addFloor(double x0, double y0, double x1, double y1, double z, double slope = 0.0)
  {
    for (double x = x0; x <= x1; x += step)
      for (double y = y0; y <= y1; y += step)
        add(x, y, z + slope * (x - x0));
  }

  /** \brief Take away what lies in a box. */
  void
  clear(const Eigen::Vector3d& low, const Eigen::Vector3d& high)
  {
    std::vector<Eigen::Vector3f> rest;
    for (const auto& p : points)
      if ((p.cast<double>().array() < low.array()).any() ||
          (p.cast<double>().array() > high.array()).any())
        rest.push_back(p);
    points.swap(rest);
  }

  /** \brief A straight flight along x: treads 27 cm deep and a level underside below
   * each. */
  void
  addFlight(double x, double y0, double y1, double low, double high)
  {
    const int treads = static_cast<int>(std::lround((high - low) / 0.18));
    for (int k = 1; k < treads; ++k) {
      const double z = low + k * (high - low) / treads;
      addFloor(x + 0.27 * k, y0, x + 0.27 * (k + 1), y1, z);
      addFloor(x + 0.27 * k, y0, x + 0.27 * (k + 1), y1, z - 0.15);
    }
  }

  void
  shake(double noise)
  {
    std::mt19937 rng(51);
    for (auto& p : points)
      for (int axis = 0; axis < 3; ++axis)
        p[axis] += static_cast<float>(noise * (rng() % 2001 / 1000.0 - 1.0));
  }

  std::vector<Eigen::Vector3f> points;

private:
  static constexpr double step = 0.05;

  void
  add(double x, double y, double z)
  {
    points.push_back(Eigen::Vector3d(x, y, z).cast<float>());
  }
};

struct Split {
  OccupancyGrid grid;
  Storeys storeys;

  explicit Split(const Building& building, double yaw = 0.0)
  {
    OccupancyGridOptions options;
    options.yaw = yaw;
    grid = occupancyGrid(building.points, options);
    storeys = findStoreys(grid.grid, {}, 0, unseenSlabs(grid));
    refineBorders(building.points, grid, storeys);
  }

  std::size_t
  count() const
  {
    return storeys.heights.size();
  }

  int
  at(double x, double y, double z) const
  {
    const Eigen::Vector3d local = grid.toGrid({x, y, z});
    const Eigen::Vector3i cell = voxelAt(grid.grid, local);
    return storeys.storeyAt(cell.x(), cell.y(), local.z());
  }
};

/** \brief Two storeys of 12 m x 8 m, with a slab of 15 cm: thinner than a voxel. */
Building
twoStoreys()
{
  Building building;
  building.addRoom({0, 0, 0}, {6, 8, 2.6});
  building.addRoom({6.2, 0, 0}, {12, 8, 2.6});
  building.addRoom({0, 0, 2.75}, {6, 8, 5.3});
  building.addRoom({6.2, 0, 2.75}, {12, 8, 5.3});
  return building;
}

} // namespace

TEST(FindStoreys, OneStorey)
{
  Building building;
  building.addRoom({0, 0, 0}, {6, 8, 2.6});
  building.addRoom({6.2, 0, 0}, {12, 8, 3.4});
  building.addFloor(1, 1, 3, 2, 0.75); // a table
  const Split split(building);
  ASSERT_EQ(split.count(), 1u);
  EXPECT_TRUE(split.storeys.borders.empty());
  EXPECT_NEAR(split.storeys.heights[0].floor, 0.0, 0.1);
  EXPECT_EQ(split.at(3, 3, 2.5), 0);
}

TEST(FindStoreys, AFloorOfWhichMostIsMissing)
{
  Building building;
  building.addRoom({0, 0, 0}, {6, 8, 2.6});
  building.addRoom({6.2, 0, 0}, {12, 8, 2.6});
  building.clear({2, 0.1, -0.1}, {5.9, 7.9, 0.1});
  building.clear({6.3, 0.1, -0.1}, {11.9, 7.9, 0.1});
  const Split split(building); // most columns hold the ceiling alone
  ASSERT_EQ(split.count(), 1u);
  EXPECT_NEAR(split.storeys.heights[0].floor, 0.0, 0.1);
  EXPECT_NEAR(split.storeys.heights[0].ceiling, 2.6, 0.1);
}

TEST(FindStoreys, TwoStoreysAndTheSlabBetweenThemAtAnyYaw)
{
  for (const double yaw : {0.0, 0.3, 0.8}) {
    const Split split(twoStoreys(), yaw);
    ASSERT_EQ(split.count(), 2u);
    EXPECT_NEAR(split.storeys.heights[0].floor, 0.0, 0.15);
    EXPECT_NEAR(split.storeys.heights[0].ceiling, 2.6, 0.2);
    EXPECT_NEAR(split.storeys.heights[1].floor, 2.75, 0.2);
    EXPECT_NEAR(split.storeys.heights[1].ceiling, 5.3, 0.2);
    for (double x = 0.1; x < 12; x += 0.3)
      for (double y = 0.1; y < 8; y += 0.3) {
        EXPECT_EQ(split.at(x, y, 0.0), 0);
        EXPECT_EQ(split.at(x, y, 2.6), 0) << x << " " << y; // the ceiling's points
        EXPECT_EQ(split.at(x, y, 2.75), 1) << x << " " << y;
        EXPECT_EQ(split.at(x, y, 5.3), 1);
      }
  }
}

TEST(FindStoreys, WallsTellStoreysWhoseFloorOrCeilingWasNotSeen)
{
  for (const bool is_seen : {false, true}) {
    Building
        building; // from the ground no floor is seen, and no ceiling below the roof
    building.addFloor(0.0, 0.0, 8.0, 6.0, 2.5);
    building.addFloor(0.0, 0.0, 8.0, 6.0, 2.8);
    building.addWalls({0.0, 0.0, 0.0}, {8.0, 6.0, 5.3});
    if (is_seen) {
      building.addFloor(0.0, 0.0, 8.0, 6.0, 0.0);
      building.addFloor(0.0, 0.0, 8.0, 6.0, 5.3);
    }
    const Split split(building);
    ASSERT_EQ(split.storeys.heights.size(), 2u) << is_seen;
    EXPECT_NEAR(split.storeys.heights[0].ceiling, 2.5, 0.15);
    EXPECT_NEAR(split.storeys.heights[1].floor, 2.8, 0.15);
  }
}

TEST(FindStoreys, AFlatRoofBesideAHigherPartIsNoFloor)
{
  Building building;
  building.addRoom({0.0, 0.0, 0.0}, {8.0, 6.0, 2.5});
  building.addRoom({8.2, 0.0, 0.0}, {14.0, 6.0, 6.0});
  EXPECT_EQ(Split(building).storeys.heights.size(), 1u);
}

TEST(FindStoreys, AHallOverTwoStoreysBelongsToItsFloor)
{
  Building building = twoStoreys();
  building.addRoom({12.3, 0, 0}, {20, 8, 5.3});
  const Split split(building);
  ASSERT_EQ(split.count(), 2u);
  for (double z = 0.15; z < 5.3; z += 0.2) {
    EXPECT_EQ(split.at(16, 4, z), 0) << z;
    EXPECT_EQ(split.at(20, 4, z), 0) << z; // its outer wall
    EXPECT_EQ(split.at(3, 4, z), z > 2.7) << z;
    EXPECT_EQ(split.at(6, 4, z), z > 2.7) << z; // a wall between rooms
  }
}

TEST(FindStoreys, AStairwellIsCutAtTheSlab)
{
  Building building = twoStoreys();
  building.clear({1, 1, 2.5}, {3.2, 5, 2.8});
  for (int tread = 0; tread < 13; ++tread)
    building.addFloor(
        1.1, 1.1 + 0.28 * tread, 2.1, 1.38 + 0.28 * tread, 0.2 * (tread + 1));
  const Split split(building);
  ASSERT_EQ(split.count(), 2u);
  for (double z = 0.15; z < 5.3; z += 0.2) {
    EXPECT_EQ(split.at(2.6, 3, z), z > 2.7) << z;
    EXPECT_EQ(split.at(1.5, 3, z), z > 2.7) << z;
  }
}

TEST(FindStoreys, ABasementUnderAPartOfTheHouse)
{
  Building building;
  building.addRoom({0, 0, 0}, {6, 8, 2.6});
  building.addRoom({6.2, 0, 0}, {12, 8, 2.6});
  building.addRoom({0, 0, -2.6}, {6, 8, -0.3});
  const Split split(building);
  ASSERT_EQ(split.count(), 2u);
  EXPECT_EQ(split.at(3, 4, -1.0), 0);
  EXPECT_EQ(split.at(3, 4, 0.0), 1);
  EXPECT_EQ(split.at(9, 4, 0.0), 1); // the same storey, without a slab
  EXPECT_EQ(split.at(9, 4, 2.5), 1);
}

TEST(FindStoreys, ASlopedRoofAndARoomThatIsSomewhatHigher)
{
  Building building;
  building.addRoom({0, 0, 0}, {8, 8, 2.6});
  building.addWalls({0, 0, 2.8}, {8, 8, 4.0});
  building.addFloor(0, 0, 8, 8, 2.8);
  building.addFloor(0, 0, 4, 8, 4.0, 0.6); // the two sides of the roof
  building.addFloor(4, 0, 8, 8, 6.4, -0.6);
  building.addFloor(
      8.2, 0, 12, 3, 0.0); // a small annex, its sloped ceiling above 2.7 m
  building.addFloor(8.2, 0, 12, 3, 3.2, 0.15);
  building.addWalls({8.2, 0, 0}, {12, 3, 3.2});
  const Split split(building);
  ASSERT_EQ(split.count(), 2u);
  EXPECT_EQ(split.at(4, 4, 2.6), 0);
  EXPECT_EQ(split.at(4, 4, 6.3), 1);
  EXPECT_EQ(split.at(0.3, 4, 4.0), 1);
  EXPECT_EQ(split.at(10, 1.5, 3.4), 0); // no storey above it
}

TEST(FindStoreys, LevelsThatDifferBetweenWings)
{
  Building building;
  building.addRoom({0, 0, 0}, {8, 8, 2.6});
  building.addRoom({0, 0, 2.9}, {8, 8, 5.5});
  building.addRoom({8.3, 0, 0}, {16, 8, 4.0});
  building.addRoom({8.3, 0, 4.3}, {16, 8, 7.0});
  const Split split(building);
  EXPECT_NE(split.at(4, 4, 1.0), split.at(4, 4, 4.5));
  EXPECT_NE(split.at(12, 4, 1.0), split.at(12, 4, 5.5));
  EXPECT_EQ(split.at(12, 4, 0.1), split.at(12, 4, 3.9)); // not cut at 2.75
  EXPECT_EQ(split.at(4, 4, 3.0), split.at(4, 4, 5.4));
}

/** \brief Three storeys, 10 m x 8 m, with an opening of 1.2 m x 5 m in both slabs. */
Building
threeStoreysWithWells()
{
  Building building;
  for (const double floor : {0.0, 2.9, 5.8})
    building.addRoom({0, 0, floor}, {10, 8, floor + 2.6});
  for (const double slab : {2.6, 5.5})
    building.clear({2.0, 3.0, slab - 0.1}, {7.0, 4.2, slab + 0.4});
  return building;
}

void
expectThreeStoreys(const Split& split)
{
  ASSERT_EQ(split.count(), 3u);
  for (const double y : {1.5, 3.6, 6.0}) { // beside and in the well
    EXPECT_EQ(split.at(8, y, 1.0), 0);
    EXPECT_EQ(split.at(4, y, 2.3), 0);
    EXPECT_EQ(split.at(4, y, 3.3), 1);
    EXPECT_EQ(split.at(4, y, 5.2), 1);
    EXPECT_EQ(split.at(4, y, 6.3), 2);
  }
}

TEST(FindStoreys, StairsDoNotChainSlabs)
{
  Building building = threeStoreysWithWells();
  for (const double floor : {0.0, 2.9})
    building.addFlight(2.2, 3.1, 4.1, floor, floor + 2.9);
  expectThreeStoreys(Split(building));
}

TEST(FindStoreys, StairsWithLandingsDoNotChainSlabs)
{
  Building building = threeStoreysWithWells();
  for (const double floor : {0.0, 2.9}) {
    building.addFlight(2.2, 3.0, 3.6, floor, floor + 1.45);
    building.addFloor(4.4, 3.0, 5.6, 4.2, floor + 1.45);
    building.addFloor(4.4, 3.0, 5.6, 4.2, floor + 1.25);
    building.addFlight(2.2, 3.6, 4.2, floor + 1.45, floor + 2.9);
  }
  expectThreeStoreys(Split(building));
}

TEST(FindStoreys, ARampDoesNotChainSlabs)
{
  Building building = threeStoreysWithWells();
  for (const double floor : {0.0, 2.9}) {
    building.addFloor(10, 3.0, 34, 4.2, floor, 2.9 / 24);
    building.addFloor(10, 3.0, 34, 4.2, floor - 0.25, 2.9 / 24);
  }
  building.addFloor(10, 3.0, 34, 4.2, 8.4);
  expectThreeStoreys(Split(building));
}

TEST(FindStoreys, FurnitureAndLampsDoNotMoveALevel)
{
  Building building = threeStoreysWithWells();
  for (double x = 0.5; x < 9.0; x += 1.5) {
    building.addFloor(x, 0.5, x + 1.2, 2.5, 2.9 + 0.75); // tables
    building.addFloor(x, 5.5, x + 0.3, 5.8, 2.3);        // lamps
  }
  expectThreeStoreys(Split(building));
}

TEST(FindStoreys, AnOpeningBesideAGalleryIsCutAHallIsNot)
{
  for (const double edge : {2.0, 6.5}) { // of 10 m, up to where the slab goes
    Building building;
    building.addRoom({0, 0, 0}, {10, 8, 5.5});
    building.addFloor(0, 0, edge, 8, 2.6);
    building.addFloor(0, 0, edge, 8, 2.9);
    const Split split(building);
    ASSERT_EQ(split.count(), 2u);
    EXPECT_EQ(split.at(1, 4, 4.0), 1);
    EXPECT_EQ(split.at(9, 4, 1.0), 0);
    EXPECT_EQ(split.at(9, 4, 4.0), edge > 5 ? 1 : 0);
  }
}

TEST(FindStoreys, AMezzanineIsAStoreyAGalleryIsNot)
{
  Building building;
  building.addRoom({0, 0, 0}, {20, 10, 6.0});
  building.addFloor(0, 0, 6, 10, 2.8);
  building.addFloor(0, 0, 6, 10, 3.0);
  building.addFloor(14, 0, 20, 1.0, 2.9); // 6 m^2
  const Split split(building);
  ASSERT_EQ(split.count(), 2u);
  EXPECT_EQ(split.at(3, 5, 1.0), 0);
  EXPECT_EQ(split.at(3, 5, 4.0), 1);
  EXPECT_EQ(split.at(12, 5, 4.0), 0);
  EXPECT_EQ(split.at(17, 0.5, 4.0), 0);
}

TEST(FindStoreys, NoisyPointsWithoutFloorAndCeiling)
{
  Building building;
  building.addWalls({0, 0, 0}, {8, 8, 6.0});
  building.shake(0.3);
  EXPECT_EQ(Split(building).count(), 1u);
}

TEST(FindStoreys, FiveNoisyStoreys)
{
  Building building;
  for (int storey = 0; storey < 5; ++storey)
    building.addRoom({0, 0, 3.0 * storey}, {10, 10, 3.0 * storey + 2.6});
  building.shake(0.04);
  const Split split(building);
  ASSERT_EQ(split.count(), 5u);
  for (int storey = 0; storey < 5; ++storey)
    for (const double z : {-0.04, 1.3, 2.64})
      EXPECT_EQ(split.at(5, 5, 3.0 * storey + z), storey) << z;
}

// a lidar that looked neither up nor down
TEST(FindStoreys, TwoBandsOfWallsAreTwoStoreys)
{
  Building building;
  building.addWalls({0, 0, 0.4}, {8, 5, 2.1});
  building.addWalls({0, 5, 3.4}, {6, 9, 5.0}); // beside it, not above
  const Split split(building);
  ASSERT_EQ(split.count(), 2u);
  EXPECT_EQ(split.at(8, 2, 2.1), 0);
  EXPECT_EQ(split.at(6, 7, 3.4), 1);
  const double border = split.storeys.borders[0].at(1, 1);
  EXPECT_GT(border, 2.1);
  EXPECT_LT(border, 3.4);
  for (const float height : split.storeys.borders[0].values)
    EXPECT_EQ(height, split.storeys.borders[0].at(1, 1));
}

TEST(FindStoreys, StraysBetweenTwoBandsOfWalls)
{
  Building building;
  building.addWalls({0, 0, 0.0}, {8, 5, 2.1});
  building.addWalls({0, 0, 3.1}, {8, 5, 5.0});
  building.addFloor(2, 2, 2.2, 2.2, 2.6); // 25 points at one height
  EXPECT_EQ(Split(building).count(), 2u);
}

TEST(FindStoreys, WallsThatGoOnAreOneStorey)
{
  Building building;
  building.addWalls({0, 0, 0.0}, {8, 5, 2.1});
  building.addWalls({0, 0, 3.1}, {8, 5, 5.0});
  building.addWalls({8, 0, 2.0}, {12, 5, 3.2}); // a hall was seen there
  EXPECT_EQ(Split(building).count(), 1u);
}

TEST(FindStoreys, LowBandsAreNoStoreys)
{
  Building building;
  building.addWalls({0, 0, 0.0}, {8, 5, 2.5});
  building.addWalls({0, 0, 6.0}, {8, 5, 6.6}); // of a high ceiling
  EXPECT_EQ(Split(building).count(), 1u);
}

TEST(UnseenSlabs, EmptyGrid) { EXPECT_TRUE(unseenSlabs({}).empty()); }

TEST(FindStoreys, EmptyGrid)
{
  EXPECT_EQ(findStoreys({}).heights.size(), 1u);
  VoxelMap<std::uint8_t> grid;
  grid.shape = {2, 2, 2};
  grid.voxel_size = 0.2;
  grid.values.assign(8, 0);
  EXPECT_EQ(findStoreys(grid).heights.size(), 1u);
}

TEST(FindStoreys, RefusesBadArguments)
{
  VoxelMap<std::uint8_t> grid;
  grid.shape = {1, 1, 1};
  EXPECT_THROW(findStoreys(grid), pcl::BadArgumentException);
  grid.values = {1};
  EXPECT_THROW(findStoreys(grid), pcl::BadArgumentException); // no voxel size
  grid.voxel_size = 0.2;
  EXPECT_EQ(findStoreys(grid).heights.size(), 1u);
  StoreyOptions options;
  options.min_clearance = 0.0;
  EXPECT_THROW(findStoreys(grid, options), pcl::BadArgumentException);
  options = {};
  options.min_slab_area = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(findStoreys(grid, options), pcl::BadArgumentException);
  Storeys storeys;
  EXPECT_THROW(refineBorders({{0, 0, 0}}, {}, storeys), pcl::BadArgumentException);
}

TEST(Storeys, BordersStayWhereVoxelsAreFinerThanTheirHeightsAreCounted)
{
  OccupancyGrid grid;
  grid.grid.reset({1, 1, 4});
  grid.grid.voxel_size = 0.002;
  grid.cells = {0, 3};
  Storeys storeys;
  storeys.borders.push_back({1, 1, {0.004f}});
  refineBorders({{0.001f, 0.001f, 0.001f}, {0.001f, 0.001f, 0.007f}}, grid, storeys);
  EXPECT_FLOAT_EQ(storeys.borders[0].at(0, 0), 0.004f);
}
