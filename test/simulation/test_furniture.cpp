/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/simulation/furniture.h>

#include <Eigen/Geometry>
#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>

namespace {

using namespace pcl::indoor;

constexpr float rounding = 1e-5f; // metres, of coordinates of a few metres in float

void
expectInside(const FurnitureModel& model, const std::string& what)
{
  const Eigen::Vector3f upper(static_cast<float>(model.size.x() / 2) + rounding,
                              static_cast<float>(model.size.y() / 2) + rounding,
                              static_cast<float>(model.size.z()) + rounding);
  const Eigen::Vector3f lower(-upper.x(), -upper.y(), -rounding);
  const Eigen::AlignedBox3f box(lower, upper);
  for (const auto& part : model.parts)
    for (const auto& t : part.triangles)
      for (const auto& corner : {t.a, t.b, t.c})
        EXPECT_TRUE(box.contains(corner))
            << what << ", " << part.name << ": " << corner.transpose() << " beyond "
            << upper.transpose();
}

bool
equal(const FurnitureModel& a, const FurnitureModel& b)
{
  if (a.size != b.size || a.parts.size() != b.parts.size())
    return false;
  for (std::size_t i = 0; i < a.parts.size(); ++i) {
    if (a.parts[i].triangles.size() != b.parts[i].triangles.size())
      return false;
    for (std::size_t k = 0; k < a.parts[i].triangles.size(); ++k) {
      const auto &s = a.parts[i].triangles[k], &t = b.parts[i].triangles[k];
      if (s.a != t.a || s.b != t.b || s.c != t.c)
        return false;
    }
  }
  return true;
}

// The volume inside a closed surface; positive if its normals point outwards.
double
enclosedVolume(const std::vector<Triangle>& triangles)
{
  double volume = 0;
  for (const auto& t : triangles)
    volume += t.a.dot(t.b.cross(t.c)) / 6.0;
  return volume;
}

// Every edge runs as often one way as the other: the surface has no hole.
bool
isClosed(const std::vector<Triangle>& triangles)
{
  using Key = std::array<float, 6>;
  std::map<Key, int> balance;
  for (const auto& t : triangles) {
    const Eigen::Vector3f corners[3] = {t.a, t.b, t.c};
    for (int k = 0; k < 3; ++k) {
      const auto &p = corners[k], &q = corners[(k + 1) % 3];
      ++balance[{p.x(), p.y(), p.z(), q.x(), q.y(), q.z()}];
      --balance[{q.x(), q.y(), q.z(), p.x(), p.y(), p.z()}];
    }
  }
  for (const auto& entry : balance)
    if (entry.second != 0)
      return false;
  return true;
}

TEST(Furniture, EveryClassBuildsInsideItsSize)
{
  const auto categories = furnitureCategories();
  EXPECT_GE(categories.size(), 10u);
  for (const auto& category : categories)
    for (int variant = 0; variant < furnitureVariants(category); ++variant)
      for (std::uint32_t seed = 0; seed < 50; ++seed) {
        const auto model = makeFurniture(category, seed, std::nullopt, variant);
        ASSERT_FALSE(model.parts.empty()) << category;
        expectInside(model, category + " " + std::to_string(variant));
      }
}

// The parts together fill a good part of the size that the piece claims.
TEST(Furniture, EveryShapeIsAsLargeAsItSays)
{
  for (const auto& category : furnitureCategories())
    for (int variant = 0; variant < furnitureVariants(category); ++variant)
      for (std::uint32_t seed = 0; seed < 20; ++seed) {
        const auto model = makeFurniture(category, seed, std::nullopt, variant);
        Eigen::AlignedBox3d box;
        for (const auto& part : model.parts)
          for (const auto& t : part.triangles)
            for (const auto& corner : {t.a, t.b, t.c})
              box.extend(corner.cast<double>());
        for (int axis = 0; axis < 3; ++axis)
          EXPECT_GT(box.sizes()[axis], 0.4 * model.size[axis])
              << category << ' ' << variant << ", seed " << seed << ", axis " << axis;
        EXPECT_LT(box.min().z(), 0.4 * model.size.z()) << category << ' ' << variant;
      }
}

TEST(Furniture, EveryClassBuildsInAGivenSize)
{
  for (const auto& category : furnitureCategories())
    for (int variant = 0; variant < furnitureVariants(category); ++variant) {
      const auto usual = makeFurniture(category, 5, std::nullopt, variant).size;
      for (const double scale : {0.8, 1.0, 1.3}) {
        const Eigen::Vector3d size = scale * usual;
        const auto model = makeFurniture(category, 5, size, variant);
        EXPECT_EQ(model.size, size);
        expectInside(model, category + " " + std::to_string(variant));
      }
    }
}

TEST(Furniture, PartsAreClosedWithNormalsOutwards)
{
  for (const auto& category : furnitureCategories())
    for (int variant = 0; variant < furnitureVariants(category); ++variant)
      for (std::uint32_t seed = 0; seed < 20; ++seed)
        for (const auto& part :
             makeFurniture(category, seed, std::nullopt, variant).parts) {
          const std::string what =
              category + " " + std::to_string(variant) + ", " + part.name;
          EXPECT_FALSE(part.name.empty());
          EXPECT_TRUE(isClosed(part.triangles)) << what;
          EXPECT_GT(enclosedVolume(part.triangles), 0.0) << what;
        }
}

TEST(Furniture, SameSeedSamePieceOtherSeedAnother)
{
  for (const auto& category : furnitureCategories()) {
    EXPECT_TRUE(equal(makeFurniture(category, 3), makeFurniture(category, 3)));
    bool varies = false;
    for (std::uint32_t seed = 4; seed < 10; ++seed)
      varies |= !equal(makeFurniture(category, 3), makeFurniture(category, seed));
    EXPECT_TRUE(varies || category == "stairs") << category; // stairs: one usual size
  }
}

TEST(Furniture, RefusesUnknownClassesAndSizes)
{
  EXPECT_THROW(makeFurniture("throne", 1), pcl::BadArgumentException);
  EXPECT_THROW(makeFurniture("chair", 1, Eigen::Vector3d(0.5, 0.5, 0.0)),
               pcl::BadArgumentException);
  EXPECT_THROW(makeFurniture("chair", 1, Eigen::Vector3d(0.5, -0.5, 1.0)),
               pcl::BadArgumentException);
  for (const int variant : {-1, furnitureVariants("chair")})
    EXPECT_THROW(makeFurniture("chair", 1, std::nullopt, variant),
                 pcl::BadArgumentException);
  EXPECT_THROW(furnitureVariants("throne"), pcl::BadArgumentException);
}

TEST(Furniture, AClosedDoorFillsItsHole)
{
  for (const bool hinge_left : {false, true}) {
    const auto door = makeDoor(0.9, 2.05, 0.2, 0.0, hinge_left);
    ASSERT_GE(door.parts.size(), 2u);
    EXPECT_EQ(door.parts[1].name, "leaf");
    expectInside(door, "door");
    const double leaf = enclosedVolume(door.parts[1].triangles);
    EXPECT_NEAR(leaf, 0.82 * 0.04 * 1.997, 1e-4); // width, thickness, height
  }
}

TEST(Furniture, AnOpenDoorTurnsAboutItsHinge)
{
  for (const bool hinge_left : {false, true}) {
    const auto door = makeDoor(0.9, 2.05, 0.2, M_PI / 2, hinge_left);
    Eigen::AlignedBox3f box;
    for (const auto& t : door.parts[1].triangles)
      box.extend(t.a).extend(t.b).extend(t.c);
    EXPECT_NEAR(box.max().y(), 0.1 + 0.82, 1e-5);            // reaches into the room
    EXPECT_EQ(box.center().x() > 0, hinge_left);             // hangs on the right side
    EXPECT_NEAR(std::abs(box.center().x()), 0.39, 0.03);     // at the frame
    EXPECT_GT(enclosedVolume(door.parts[1].triangles), 0.0); // mirrored right side out
  }
}

TEST(Furniture, AWindowHasGlass)
{
  const auto window = makeWindow(1.6, 1.3, 0.2);
  ASSERT_EQ(window.parts.size(), 2u);
  EXPECT_FALSE(window.parts[0].glass);
  EXPECT_TRUE(window.parts[1].glass);
  expectInside(window, "window");
}

} // namespace
