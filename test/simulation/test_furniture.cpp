/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/simulation/furniture.h>
#include <pcl/simulation/ray_tracer.h>

#include <Eigen/Geometry>
#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>

namespace {

using namespace pcl::indoor;

constexpr float float_rounding =
    1e-5f; // metres, of coordinates of a few metres in float

void
expectInside(const FurnitureModel& model, const std::string& what)
{
  const Eigen::Vector3f upper(static_cast<float>(model.size.x() / 2) + float_rounding,
                              static_cast<float>(model.size.y() / 2) + float_rounding,
                              static_cast<float>(model.size.z()) + float_rounding);
  const Eigen::Vector3f lower(-upper.x(), -upper.y(), -float_rounding);
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

/** The parts, the sides of a hollow vessel together. */
std::vector<FurniturePart>
bodiesOf(const FurnitureModel& model)
{
  std::vector<FurniturePart> bodies;
  for (const auto& part : model.parts)
    if (part.name != "inside" && part.name != "bottom")
      bodies.push_back(part);
    else
      bodies.back().triangles.insert(
          bodies.back().triangles.end(), part.triangles.begin(), part.triangles.end());
  return bodies;
}

TEST(Furniture, PartsAreClosedWithNormalsOutwards)
{
  for (const auto& category : furnitureCategories())
    for (int variant = 0; variant < furnitureVariants(category); ++variant)
      for (std::uint32_t seed = 0; seed < 8; ++seed)
        for (const auto& part :
             bodiesOf(makeFurniture(category, seed, std::nullopt, variant))) {
          const std::string what =
              category + " " + std::to_string(variant) + ", " + part.name;
          EXPECT_FALSE(part.name.empty());
          EXPECT_TRUE(isClosed(part.triangles)) << what;
          EXPECT_GT(enclosedVolume(part.triangles), 0.0) << what;
        }
}

// From above one sees the inside and the bottom of a vessel and its rim, from the side
// its outside alone.
TEST(Furniture, VesselsHaveAnInsideAndABottom)
{
  for (const auto* category : {"bowl", "mug"})
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
      const auto model = makeFurniture(category, seed);
      ASSERT_GE(model.parts.size(), 3u);
      EXPECT_EQ(model.parts[0].name, category);
      EXPECT_EQ(model.parts[1].name, "inside");
      EXPECT_EQ(model.parts[2].name, "bottom");
      std::vector<Triangle> triangles;
      std::vector<std::size_t> part_of_triangle;
      for (std::size_t p = 0; p < 3; ++p)
        for (const auto& triangle : model.parts[p].triangles) {
          triangles.push_back(triangle);
          part_of_triangle.push_back(p);
        }
      Eigen::AlignedBox3f box;
      for (const auto& t : model.parts[0].triangles)
        box.extend(t.a);
      const Eigen::Vector3f middle = box.center();
      const RayTracer tracer(triangles);
      const auto seen = [&](const Eigen::Vector3f& from, const Eigen::Vector3f& way) {
        const auto hit = tracer.trace(from, way);
        return hit.triangle < 0 ? 9 : part_of_triangle[hit.triangle];
      };
      const float high = box.max().z();
      const Eigen::Vector3f above(middle.x() + 0.001f, middle.y() + 0.002f, 2 * high);
      EXPECT_EQ(seen(above, {0, 0, -1}), 2u) << category << ' ' << seed;
      const Eigen::Vector3f inner(above.x(), above.y(), 0.95f * high);
      for (const float side : {-1.0f, 1.0f}) {
        EXPECT_EQ(seen(inner, {side, 0, 0}), 1u) << category << ' ' << seed;
        EXPECT_EQ(seen({side * 2, inner.y(), inner.z()}, {-side, 0, 0}), 0u);
      }
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

// As many clearly different shapes as the guide says.
TEST(Furniture, ClassesHaveManyShapes)
{
  const std::map<std::string, int> least{
      {"armchair", 12}, {"bath", 9},          {"bed", 12},   {"bookcase", 9},
      {"cabinet", 12},  {"ceiling_lamp", 18}, {"chair", 21}, {"clutter", 15},
      {"desk", 9},      {"floor_lamp", 12},   {"fridge", 6}, {"kitchen_unit", 12},
      {"plant", 9},     {"sink", 12},         {"sofa", 12},  {"stool", 12},
      {"table", 15},    {"toilet", 9},        {"tv", 8},     {"wardrobe", 9}};
  for (const auto& category : furnitureCategories()) {
    const auto found = least.find(category);
    EXPECT_GE(furnitureVariants(category), found == least.end() ? 3 : found->second)
        << category;
  }
}

TEST(Furniture, TrianglesAreFewAndHaveAnArea)
{
  constexpr std::size_t most = 8000; // ray tracing takes longer and longer
  for (const auto& category : furnitureCategories())
    for (int variant = 0; variant < furnitureVariants(category); ++variant) {
      std::size_t count = 0, flat = 0;
      for (const auto& part : makeFurniture(category, 3, std::nullopt, variant).parts) {
        count += part.triangles.size();
        for (const auto& t : part.triangles)
          flat += (t.b - t.a).cross(t.c - t.a).norm() > 0 ? 0 : 1;
      }
      EXPECT_LE(count, most) << category << ' ' << variant;
      EXPECT_LE(20 * flat, count) << category << ' ' << variant;
    }
}

// Depths along rays from the front, the side and above, as shares of the size.
std::vector<float>
profileOf(const FurnitureModel& model)
{
  constexpr int pieces = 14;
  std::vector<Triangle> triangles;
  const Eigen::Array3f scale = model.size.cast<float>().array().inverse();
  const auto unit = [&](const Eigen::Vector3f& p) -> Eigen::Vector3f {
    return (p.array() * scale).matrix() - Eigen::Vector3f(0, 0, 0.5f);
  };
  for (const auto& part : model.parts)
    for (const auto& t : part.triangles)
      triangles.push_back({unit(t.a), unit(t.b), unit(t.c)});
  const RayTracer tracer(triangles);
  std::vector<float> depths;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < pieces; ++i)
      for (int k = 0; k < pieces; ++k) {
        Eigen::Vector3f from = Eigen::Vector3f::Zero(), way = Eigen::Vector3f::Zero();
        from[axis] = 1;
        way[axis] = -1;
        from[(axis + 1) % 3] = (i + 0.5f) / pieces - 0.5f;
        from[(axis + 2) % 3] = (k + 0.5f) / pieces - 0.5f;
        depths.push_back(std::min(2.0f, tracer.trace(from, way).distance));
      }
  return depths;
}

TEST(Furniture, ShapesOfAClassDiffer)
{
  constexpr float clearly = 0.015f; // of the size along a ray: panels of doors count
  for (const auto& category : furnitureCategories()) {
    std::vector<std::vector<float>> profiles;
    for (int variant = 0; variant < furnitureVariants(category); ++variant)
      profiles.push_back(profileOf(makeFurniture(category, 3, std::nullopt, variant)));
    for (std::size_t a = 0; a < profiles.size(); ++a)
      for (std::size_t b = a + 1; b < profiles.size(); ++b) {
        std::size_t other = 0;
        for (std::size_t i = 0; i < profiles[a].size(); ++i)
          other += std::abs(profiles[a][i] - profiles[b][i]) > clearly ? 1 : 0;
        EXPECT_GE(other, profiles[a].size() / 50)
            << category << ": " << a << " and " << b;
      }
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
